// SPDX-License-Identifier: Apache-2.0
// Edges of all regions are cut where they meet. The pieces with free space on one side alone, put
// together end to end, are the rings. Points are whole numbers, so that equal points are found.
#include "io/export/rings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "avo/error.h"
#include "io/maps/wall_space.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr double kSideways = 2.0;  // units: rounding moves a piece by less

/// Returns the number of units in a meter: a million, or fewer if doubles cannot hold that many.
double units_of(std::span<const avo::StaticObstacle> regions) {
  constexpr double kMostUnits = 1e14;
  double largest = 0.0;  // m
  for (const avo::StaticObstacle& region : regions)
    for (const avo::Chain& chain : region.chains)
      for (const Vec2 p : chain.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  double per_meter = 1e6;
  while (largest * per_meter > kMostUnits) per_meter /= 10.0;
  return per_meter;
}

/// A point in whole units.
struct Node {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const Node&, const Node&) = default;
};

Node node_of(Vec2 point, double per_meter) {
  return {std::llround(point.x * per_meter), std::llround(point.y * per_meter)};
}

Vec2 point_of(Node node) {
  return {static_cast<double>(node.x), static_cast<double>(node.y)};
}

Vec2 between(Node from, Node to) {
  return {static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
}

struct Edge {
  Node a, b;
  std::vector<Node> cuts = {};

  [[nodiscard]] std::int64_t left() const { return std::min(a.x, b.x); }
  [[nodiscard]] std::int64_t right() const { return std::max(a.x, b.x); }
  [[nodiscard]] std::int64_t bottom() const { return std::min(a.y, b.y); }
  [[nodiscard]] std::int64_t top() const { return std::max(a.y, b.y); }
};

// Returns whether the node is on the edge, up to rounding, and is not one of its ends.
bool lies_on(Node node, const Edge& edge) {
  const Vec2 d = between(edge.a, edge.b), p = between(edge.a, node);
  const double along = dot(p, d), square = norm_squared(d);
  return node != edge.a && node != edge.b && along > 0.0 && along < square &&
         std::abs(cross(d, p)) <= 0.75 * std::sqrt(square);
}

void cut(Edge& a, Edge& b) {
  for (const Node node : {b.a, b.b})
    if (lies_on(node, a)) a.cuts.push_back(node);
  for (const Node node : {a.a, a.b})
    if (lies_on(node, b)) b.cuts.push_back(node);
  const Vec2 d = between(a.a, a.b);
  const double from = cross(d, between(a.a, b.a)), to = cross(d, between(a.a, b.b));
  const Vec2 e = between(b.a, b.b);
  if (!(from * to < 0.0) || !(cross(e, between(b.a, a.a)) * cross(e, between(b.a, a.b)) < 0.0))
    return;
  const double part = from / (from - to);
  const Node node{b.a.x + std::llround(part * e.x), b.a.y + std::llround(part * e.y)};
  a.cuts.push_back(node);
  b.cuts.push_back(node);
}

void cut_all(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::pair(a.left(), std::pair(a.a, a.b)) < std::pair(b.left(), std::pair(b.a, b.b));
  });
  std::vector<Edge*> near;  // edges that reach as far to the right
  for (Edge& edge : edges) {
    std::erase_if(near, [&](const Edge* other) { return other->right() + 1 < edge.left(); });
    for (Edge* other : near)
      if (other->bottom() <= edge.top() + 1 && edge.bottom() <= other->top() + 1) cut(*other, edge);
    near.push_back(&edge);
  }
}

using Piece = std::pair<Node, Node>;

/// Returns the pieces between cuts, each once and from the lower node to the higher one.
std::vector<Piece> pieces_of(std::vector<Edge>& edges) {
  std::vector<Piece> pieces;
  for (Edge& edge : edges) {
    const Vec2 d = between(edge.a, edge.b);
    edge.cuts.push_back(edge.a);
    edge.cuts.push_back(edge.b);
    std::sort(edge.cuts.begin(), edge.cuts.end(), [&](Node p, Node q) {
      return std::pair(dot(d, between(edge.a, p)), p) < std::pair(dot(d, between(edge.a, q)), q);
    });
    for (std::size_t k = 0; k + 1 < edge.cuts.size(); ++k) {
      const Node p = edge.cuts[k], q = edge.cuts[k + 1];
      if (p != q) pieces.emplace_back(std::min(p, q), std::max(p, q));
    }
  }
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

/// The next nodes of each node, with free space on the left.
using Borders = std::map<Node, std::vector<Node>>;

Borders borders_of(const std::vector<Piece>& pieces, std::span<const avo::StaticObstacle> regions) {
  const Regions free(regions);
  Borders borders;
  for (const auto& [p, q] : pieces) {
    const Vec2 a = point_of(p), b = point_of(q), d = b - a;
    const Vec2 middle = 0.5 * (a + b), aside = (kSideways / norm(d)) * perpendicular(d);
    const bool left = free.allow(middle + aside), right = free.allow(middle - aside);
    if (left && !right) borders[p].push_back(q);
    if (right && !left) borders[q].push_back(p);
  }
  return borders;
}

// Returns whether `a` comes before `b` when `back` is turned clockwise. It compares half turns,
// then cross products.
bool is_sooner(Vec2 back, Vec2 a, Vec2 b) {
  const auto late = [back](Vec2 v) {
    const double side = cross(back, v);
    return side > 0.0 || (side == 0.0 && dot(back, v) > 0.0);
  };
  return late(a) != late(b) ? late(b) : cross(a, b) < 0.0;
}

/// Takes the next border: it bounds the free space that lies to the left of the last piece, which
/// ends at `here`.
std::optional<Node> take_next(Borders& borders, Node before, Node here) {
  std::vector<Node>& next = borders[here];
  if (next.empty()) return std::nullopt;
  const Vec2 back = between(here, before);
  const auto first = std::min_element(next.begin(), next.end(), [&](Node p, Node q) {
    return is_sooner(back, between(here, p), between(here, q));
  });
  const Node taken = *first;
  next.erase(first);
  return taken;
}

/// Returns the ring without points on straight lines.
Ring ring_of(std::span<const Node> nodes) {
  Ring ring;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node before = nodes[(k + nodes.size() - 1) % nodes.size()];
    const Node after = nodes[(k + 1) % nodes.size()];
    if (cross(between(before, nodes[k]), between(nodes[k], after)) != 0.0)
      ring.push_back(point_of(nodes[k]));
  }
  return ring;
}

/// Returns the rings. Where a chain passes a node a second time, it splits off a ring.
std::vector<Ring> rings_of(Borders borders) {
  std::vector<Ring> rings;
  for (const auto& [start, unused] : borders) {
    while (!unused.empty()) {
      std::vector<Node> path{start};
      std::map<Node, std::size_t> place{{start, 0}};
      Node before = start;
      do {
        const std::optional<Node> next = take_next(borders, before, path.back());
        if (!next)
          throw avo::Error("obstacles: found structures too fine for an area, must be coarser");
        before = path.back();
        const auto [seen, is_new] = place.try_emplace(*next, path.size());
        path.push_back(*next);
        if (is_new) continue;
        const std::size_t from = seen->second;
        const Ring ring = ring_of(std::span(path).subspan(from, path.size() - 1 - from));
        if (ring.size() >= 3) rings.push_back(ring);
        for (std::size_t k = from + 1; k + 1 < path.size(); ++k) place.erase(path[k]);
        path.resize(from + 1);
      } while (path.size() > 1);
    }
  }
  return rings;
}

double area_of(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    twice += cross(ring[k] - ring[0], ring[(k + 1) % ring.size()] - ring[0]);
  return 0.5 * twice;
}

/// Assigns each hole to the smallest part around it.
void assign(std::vector<Ring> holes, std::vector<FreePart>& parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const FreePart& a, const FreePart& b) {
    return area_of(a.outer) < area_of(b.outer);
  });
  for (Ring& hole : holes) {
    const Vec2 point = 0.5 * (hole[0] + hole[1]);
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const FreePart& each) {
      return is_inside(each.outer, point);
    });
    if (part != parts.end()) part->holes.push_back(std::move(hole));
  }
}

}  // namespace

bool is_inside(const Ring& ring, Vec2 point) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 a = ring[k], b = ring[(k + 1) % ring.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    const double side = cross(b - a, point - a);
    if ((side > 0.0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

std::vector<FreePart> free_parts(std::span<const avo::StaticObstacle> regions) {
  const double per_meter = units_of(regions);
  std::vector<avo::StaticObstacle> rounded(regions.begin(), regions.end());  // in units
  std::vector<Edge> edges;
  for (avo::StaticObstacle& region : rounded) {
    for (avo::Chain& chain : region.chains) {
      std::vector<Node> nodes;
      for (const Vec2 point : chain.points) nodes.push_back(node_of(point, per_meter));
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        edges.push_back({nodes[k], nodes[(k + 1) % nodes.size()]});
        chain.points[k] = point_of(nodes[k]);
      }
    }
  }
  cut_all(edges);
  std::vector<FreePart> parts;
  std::vector<Ring> holes;
  for (Ring& ring : rings_of(borders_of(pieces_of(edges), rounded))) {
    const bool outer = area_of(ring) > 0.0;
    for (Vec2& point : ring) point = point / per_meter;
    if (outer)
      parts.push_back({std::move(ring), {}});
    else
      holes.push_back(std::move(ring));
  }
  assign(std::move(holes), parts);
  return parts;
}

}  // namespace avo_io
