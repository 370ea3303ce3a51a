// SPDX-License-Identifier: Apache-2.0
// Conversion of points and words to and from Python: a Vec2 is a pair of floats, an enumerator its
// word in scene files.
#pragma once
#include <initializer_list>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>

#include "avo/avo.h"
#include "avo/vec3.h"
#include "core/removed.h"

namespace avo_python {

/// Throws Error in the words of the scene reader.
[[noreturn]] void refuse_word(const char* name, const std::string& found,
                              const std::vector<std::string_view>& words);

template <typename Enum>
struct Words;

#define AVO_WORDS(Enum, NAME, COUNT, TO_STRING)                              \
  template <>                                                                \
  struct Words<Enum> {                                                       \
    static constexpr const char* name = NAME;                                \
    static constexpr int count = COUNT;                                      \
    static const char* of(int k) { return TO_STRING(static_cast<Enum>(k)); } \
  }

inline const char* fill_word(avo::Fill fill) {
  return fill == avo::Fill::none ? "none" : fill == avo::Fill::solid ? "solid" : "bounds";
}

AVO_WORDS(avo::Method, "method", 9, avo::to_string);
AVO_WORDS(avo::Certificate, "certificate", 3, avo::to_string);
AVO_WORDS(avo::Motion, "motion", 2, avo::to_string);
AVO_WORDS(avo::Clock, "clock", 2, avo::to_string);
AVO_WORDS(avo::RightOfWay, "right_of_way", 2, avo::to_string);
AVO_WORDS(avo::PlanStatus, "status", 7, avo::to_string);
AVO_WORDS(avo::SafetyState, "state", 3, avo::to_string);
AVO_WORDS(avo::AccelerationSet, "acceleration_set", 2, avo::to_string);
AVO_WORDS(avo::AfterGoal, "after_goal", 2, avo::to_string);
AVO_WORDS(avo::Behavior, "behavior", 4, avo::to_string);
AVO_WORDS(avo::Formation, "formation", 5, avo::to_string);
AVO_WORDS(avo::Fill, "fill", 3, fill_word);
#undef AVO_WORDS

/// Returns all words of an enumeration, in its order. Numbers of removed values have none.
template <typename Enum>
std::vector<std::string_view> words() {
  std::vector<std::string_view> all;
  for (int k = 0; k < Words<Enum>::count; ++k)
    if (avo::removed_value(Words<Enum>::name, k) == nullptr) all.emplace_back(Words<Enum>::of(k));
  return all;
}

}  // namespace avo_python

namespace pybind11::detail {

/// Reads a sequence of that many numbers; returns false if it is none of numbers. Throws Error with
/// the allowed `form` if there are more or fewer.
inline bool load_point(handle source, const char* form, std::initializer_list<double*> numbers) {
  if (!PySequence_Check(source.ptr()) || PyUnicode_Check(source.ptr())) return false;
  if (isinstance<array>(source) && reinterpret_borrow<array>(source).dtype().kind() == 'c')
    return false;  // numpy would drop the imaginary parts
  const auto given = reinterpret_borrow<sequence>(source);
  if (given.size() != numbers.size())
    throw avo::Error("point: found " + std::to_string(given.size()) + " numbers, must be " +
                     std::to_string(numbers.size()) + ": " + form);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const object number = given[k];
    if (PyComplex_Check(number.ptr())) return false;
    *numbers.begin()[k] = PyFloat_AsDouble(number.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      return false;
    }
  }
  return true;
}

template <>
struct type_caster<avo::Vec3> {
  PYBIND11_TYPE_CASTER(avo::Vec3, const_name("tuple[float, float, float]"));

  bool load(handle source, bool) {
    return load_point(source, "(x, y, z)", {&value.x, &value.y, &value.z});
  }
  static handle cast(avo::Vec3 v, return_value_policy, handle) {
    return make_tuple(v.x, v.y, v.z).release();
  }
};

template <>
struct type_caster<avo::Vec2> {
  PYBIND11_TYPE_CASTER(avo::Vec2, const_name("tuple[float, float]"));

  bool load(handle source, bool) { return load_point(source, "(x, y)", {&value.x, &value.y}); }
  static handle cast(avo::Vec2 v, return_value_policy, handle) {
    return make_tuple(v.x, v.y).release();
  }
};

template <>
struct type_caster<avo::LayerSet> {
  PYBIND11_TYPE_CASTER(avo::LayerSet, const_name("list[int]"));

  bool load(handle source, bool) {
    if (!PySequence_Check(source.ptr()) || PyUnicode_Check(source.ptr())) return false;
    value = {};
    for (const handle layer : reinterpret_borrow<sequence>(source)) {
      if (!PyLong_Check(layer.ptr())) return false;
      int overflow = 0;
      const long long number = PyLong_AsLongLongAndOverflow(layer.ptr(), &overflow);
      if (overflow != 0 || number < 0 || number > 31)
        throw avo::Error("layers: found " + std::string(str(layer)) + ", must be 0 to 31");
      value.bits |= 1U << static_cast<unsigned>(number);
    }
    return true;
  }
  static handle cast(avo::LayerSet layers, return_value_policy, handle) {
    list numbers;
    for (unsigned k = 0; k < 32; ++k)
      if ((layers.bits >> k & 1U) != 0) numbers.append(k);
    return numbers.release();
  }
};

template <typename Enum>
struct word_caster {
  PYBIND11_TYPE_CASTER(Enum, const_name("str"));

  bool load(handle source, bool) {
    using Words = avo_python::Words<Enum>;
    if (!PyUnicode_Check(source.ptr())) return false;
    const auto word = source.cast<std::string>();
    for (int k = 0; k < Words::count; ++k) {
      if (word != Words::of(k) || avo::removed_value(Words::name, k) != nullptr) continue;
      value = static_cast<Enum>(k);
      return true;
    }
    avo_python::refuse_word(Words::name, word, avo_python::words<Enum>());
  }
  static handle cast(Enum e, return_value_policy, handle) {
    return str(avo_python::Words<Enum>::of(static_cast<int>(e))).release();
  }
};

template <>
struct type_caster<avo::Method> : word_caster<avo::Method> {};
template <>
struct type_caster<avo::Certificate> : word_caster<avo::Certificate> {};
template <>
struct type_caster<avo::Motion> : word_caster<avo::Motion> {};
template <>
struct type_caster<avo::Clock> : word_caster<avo::Clock> {};
template <>
struct type_caster<avo::RightOfWay> : word_caster<avo::RightOfWay> {};
template <>
struct type_caster<avo::PlanStatus> : word_caster<avo::PlanStatus> {};
template <>
struct type_caster<avo::SafetyState> : word_caster<avo::SafetyState> {};
template <>
struct type_caster<avo::AccelerationSet> : word_caster<avo::AccelerationSet> {};
template <>
struct type_caster<avo::AfterGoal> : word_caster<avo::AfterGoal> {};
template <>
struct type_caster<avo::Formation> : word_caster<avo::Formation> {};
template <>
struct type_caster<avo::Behavior> : word_caster<avo::Behavior> {};
template <>
struct type_caster<avo::Fill> : word_caster<avo::Fill> {};

}  // namespace pybind11::detail
