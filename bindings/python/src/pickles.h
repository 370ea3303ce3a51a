// SPDX-License-Identifier: Apache-2.0
// Plain data can be pickled and copied, as the tuple of its fields in order.
#pragma once
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bind.h"

namespace avo_python {

/// The number of its fields; 0: the type has its own conversion to Python. A wrong number does not
/// compile.
template <typename T>
inline constexpr int kFields = 0;
template <>
inline constexpr int kFields<avo::CarBody> = 2;
template <>
inline constexpr int kFields<avo::Footprint> = 4;
template <>
inline constexpr int kFields<avo::Car> = 6;
template <>
inline constexpr int kFields<avo::DifferentialDrive> = 5;
template <>
inline constexpr int kFields<avo::Airplane> = 3;
template <>
inline constexpr int kFields<avo::LoiterCircle> = 2;
template <>
inline constexpr int kFields<avo::Wall> = 3;
template <>
inline constexpr int kFields<avo::Chain> = 2;
template <>
inline constexpr int kFields<avo::StaticObstacle> = 5;
template <>
inline constexpr int kFields<avo::MovingObstacle> = 8;
template <>
inline constexpr int kFields<avo::TimedPlace> = 2;
template <>
inline constexpr int kFields<avo::Robot> = 13;
template <>
inline constexpr int kFields<avo::Detour> = 7;
template <>
inline constexpr int kFields<avo::MeasurementNoise> = 4;
template <>
inline constexpr int kFields<avo::LocalizationNoise> = 3;
template <>
inline constexpr int kFields<avo::SensingModel> = 5;
template <>
inline constexpr int kFields<avo::SensingError> = 2;
template <>
inline constexpr int kFields<avo::ExecutionModel> = 10;
template <>
inline constexpr int kFields<avo::Scenario> = 31;  // but the function, which stays in the process
template <>
inline constexpr int kFields<avo::Queue> = 3;
template <>
inline constexpr int kFields<avo::Follow> = 2;
template <>
inline constexpr int kFields<avo::Patrol> = 2;
template <>
inline constexpr int kFields<avo::Flow> = 2;

/// Returns references to all fields.
template <typename T>
auto fields(T& x) {
  constexpr int n = kFields<std::remove_const_t<T>>;
  if constexpr (n == 2) {
    auto& [a, b] = x;
    return std::tie(a, b);
  } else if constexpr (n == 3) {
    auto& [a, b, c] = x;
    return std::tie(a, b, c);
  } else if constexpr (n == 4) {
    auto& [a, b, c, d] = x;
    return std::tie(a, b, c, d);
  } else if constexpr (n == 5) {
    auto& [a, b, c, d, e] = x;
    return std::tie(a, b, c, d, e);
  } else if constexpr (n == 6) {
    auto& [a, b, c, d, e, f] = x;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (n == 7) {
    auto& [a, b, c, d, e, f, g] = x;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (n == 8) {
    auto& [a, b, c, d, e, f, g, h] = x;
    return std::tie(a, b, c, d, e, f, g, h);
  } else if constexpr (n == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = x;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (n == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = x;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, z, aa, bb, cc, dd, ee,
           ff, gg, hh, function] = x;
    static_cast<void>(function);
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, z, aa, bb, cc,
                    dd, ee, ff, gg, hh);
  }
}

[[noreturn]] inline void refuse_pickle() {
  throw avo::Error("pickle: found another number of fields, must be of this version of avo");
}

template <typename T>
struct Plain {
  static py::object of(const T& x) {
    if constexpr (kFields < T >> 0) {
      return std::apply(
          [](const auto&... field) -> py::object {
            return py::make_tuple(Plain<std::decay_t<decltype(field)>>::of(field)...);
          },
          fields(x));
    } else if constexpr (std::is_same_v<T, avo::NoiseDistribution>) {
      return py::int_(static_cast<int>(x));
    } else {
      return py::cast(x);
    }
  }

  /// Throws Error and py::cast_error if `plain` is not such a tuple.
  static T from(const py::handle& plain) {
    if constexpr (kFields < T >> 0) {
      const auto values = plain.cast<py::tuple>();
      if (values.size() != static_cast<std::size_t>(kFields<T>)) refuse_pickle();
      T x;
      std::size_t k = 0;
      std::apply(
          [&](auto&... field) {
            ((field = Plain<std::decay_t<decltype(field)>>::from(values[k++])), ...);
          },
          fields(x));
      return x;
    } else if constexpr (std::is_same_v<T, avo::NoiseDistribution>) {
      return plain.cast<int>() == 0 ? avo::NoiseDistribution::gaussian
                                    : avo::NoiseDistribution::uniform;
    } else {
      return plain.cast<T>();
    }
  }
};

/// The model, the heading, and the values of the table of fields.
template <>
struct Plain<avo::RobotSetup> {
  static py::object of(const avo::RobotSetup& setup);
  static avo::RobotSetup from(const py::handle& plain);
};

/// The kind of the task, its values, and the robots' ids: no robot of a scene has been led.
template <>
struct Plain<avo::Team> {
  static py::object of(const avo::Team& team) {
    std::vector<std::uint64_t> robots;
    for (const avo::TeamMember& member : team.members) robots.push_back(member.robot.value);
    const py::object task = std::visit(
        [](const auto& one) { return Plain<std::decay_t<decltype(one)>>::of(one); }, team.task);
    return py::make_tuple(team.task.index(), task, robots);
  }
  static avo::Team from(const py::handle& plain) {
    const auto values = plain.cast<py::tuple>();
    if (values.size() != 3) refuse_pickle();
    avo::Team team;
    switch (values[0].cast<int>()) {
      case 0:
        team.task = Plain<avo::Queue>::from(values[1]);
        break;
      case 1:
        team.task = Plain<avo::Follow>::from(values[1]);
        break;
      case 2:
        team.task = Plain<avo::Patrol>::from(values[1]);
        break;
      case 3:
        team.task = Plain<avo::Flow>::from(values[1]);
        break;
      default:
        refuse_pickle();
    }
    for (const std::uint64_t robot : values[2].cast<std::vector<std::uint64_t>>())
      team.members.push_back({{robot}});
    return team;
  }
};

template <typename T>
struct Plain<std::optional<T>> {
  static py::object of(const std::optional<T>& x) {
    return x ? Plain<T>::of(*x) : py::object(py::none());
  }
  static std::optional<T> from(const py::handle& plain) {
    if (plain.is_none()) return std::nullopt;
    return Plain<T>::from(plain);
  }
};

template <typename T>
struct Plain<std::vector<T>> {
  static py::object of(const std::vector<T>& all) {
    py::list list;
    for (const T& x : all) list.append(Plain<T>::of(x));
    return list;
  }
  static std::vector<T> from(const py::handle& plain) {
    std::vector<T> all;
    for (const py::handle x : plain.cast<py::list>()) all.push_back(Plain<T>::from(x));
    return all;
  }
};

/// Returns an argument for def() of a class. `check` throws on values that no such object may have.
template <typename T>
auto pickled(void (*check)(const T&) = nullptr) {
  return py::pickle([](const T& x) { return Plain<T>::of(x).template cast<py::tuple>(); },
                    [check](const py::tuple& plain) {
                      T x = Plain<T>::from(plain);
                      if (check != nullptr) check(x);
                      return x;
                    });
}

}  // namespace avo_python
