// SPDX-License-Identifier: Apache-2.0
// How what a search has found becomes the neighbors of a robot.
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "core/neighbor_columns.h"
#include "spatial/search.h"

namespace avo::inline sim {

struct World;
struct Worker;

/// The robot in slot B as the robot in slot A senses it there; none where A does not avoid it.
std::optional<Neighbor> sensed_by(const World& world, std::size_t a, std::size_t b, Vec2 position,
                                  Vec2 velocity);

/// Appends the robots of a search in canonical order, where all are alike.
void append_plain(const World& world, std::size_t slot, const Found& hits,
                  const SearchScratch& search, NeighborColumns& to);

/// Appends the neighbors one by one: among moving obstacles, robots first where distances are
/// equal, and where robots are not all alike.
void append_one_by_one(const World& world, std::size_t slot, std::span<const NeighborHit> robots,
                       Worker& worker);

/// Appends the robots of a search as they are sensed, where senses are not exact. Returns whether
/// all of them are sensed as they truly are.
bool append_sighted(const World& world, std::size_t slot, std::size_t query, Worker& worker);

}  // namespace avo::inline sim
