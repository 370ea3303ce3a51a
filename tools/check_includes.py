#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails where a source uses a name of the standard library whose header it gets by chance: from a precompiled header,
from another file of its unit, or from another standard header. Headers of the project that it includes may bring it."""
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ("src", "include", "io", "figures", "apps", "bench", "bindings/c")
FOLDERS = (".", "src", "include", "io", "io/include", "figures", "figures/include", "apps", "apps/cli", "bench",
           "bindings/c", "bindings/c/include")  # of quoted includes
NAMES = {  # of those that one header alone has to declare
    "algorithm": "sort stable_sort all_of any_of none_of find find_if find_if_not count_if copy_if copy_n fill fill_n min"
                 " max minmax clamp min_element max_element minmax_element lower_bound upper_bound equal_range unique"
                 " remove_if reverse rotate transform for_each nth_element partition stable_partition binary_search"
                 " push_heap pop_heap make_heap set_difference replace_if adjacent_find generate partial_sort",
    "array": "array", "atomic": "atomic atomic_ref atomic_flag", "bit": "bit_cast countr_zero popcount bit_width endian",
    "charconv": "from_chars to_chars chars_format", "chrono": "chrono", "cmath":
    "sqrt isfinite isnan isinf hypot floor ceil round lround llround sin cos tan atan2 asin acos atan exp log pow fmax fmin"
    " nextafter ldexp frexp copysign fmod trunc remainder log2 log10 fma cbrt signbit ilogb",
    "condition_variable": "condition_variable", "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t"
    " uint64_t", "cstdio": "printf fprintf fopen fclose snprintf fputs fflush FILE", "cstdlib": "getenv exit strtod abort",
    "cstring": "memcpy memcmp strlen memset strcmp", "deque": "deque", "exception": "exception_ptr current_exception",
    "filesystem": "filesystem", "fstream": "ifstream ofstream", "functional": "function reference_wrapper ref cref",
    "iostream": "cout cerr", "iterator": "back_inserter inserter ssize", "limits": "numeric_limits", "map": "map multimap",
    "memory": "unique_ptr shared_ptr weak_ptr make_unique make_shared", "mutex": "mutex lock_guard unique_lock scoped_lock",
    "new": "bad_alloc", "numbers": "numbers", "numeric": "accumulate iota inner_product partial_sum gcd midpoint",
    "optional": "optional nullopt", "queue": "priority_queue", "set": "set multiset", "span": "span",
    "sstream": "ostringstream istringstream stringstream", "stdexcept": "runtime_error invalid_argument logic_error",
    "string": "string to_string stod stoi getline", "string_view": "string_view", "system_error": "errc error_code"
    " system_error", "thread": "thread jthread this_thread", "tuple": "tuple tie make_tuple",
    "unordered_map": "unordered_map unordered_multimap", "unordered_set": "unordered_set",
    "variant": "variant visit holds_alternative get_if monostate", "vector": "vector"}
HEADER = {name: header for header, names in NAMES.items() for name in names.split()}
USED = re.compile(r"\bstd::(\w+)")
NO_CODE = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')


@functools.lru_cache(None)
def text_of(path):
    return path.read_text()


def included(path):
    """The project's headers that it includes; one that the build writes is nowhere."""
    for name in re.findall(r'^\s*#\s*include "([^"]+)"', text_of(path), re.M):
        places = (folder / name for folder in (path.parent, *(ROOT / folder for folder in FOLDERS)))
        yield from [place.resolve() for place in places if place.exists()][:1]


def reached(path):
    """The standard headers that it includes, or that headers of the project bring."""
    seen, waiting, standard = set(), [path], set()
    while waiting:
        file = waiting.pop()
        if file not in seen:
            seen.add(file)
            standard.update(re.findall(r"^\s*#\s*include <([^>]+)>", text_of(file), re.M))
            waiting += included(file)
    return standard


def missing(path):
    """{header: one name that asks for it}"""
    used = {name: HEADER[name] for name in USED.findall(NO_CODE.sub("", text_of(path))) if name in HEADER}
    has = reached(path) if used else set()
    return {header: name for name, header in sorted(used.items()) if header not in has}


def main():
    paths = [path for folder in SOURCES for path in sorted((ROOT / folder).rglob("*.[hc]*")) if path.suffix in (".h", ".cpp")]
    assert len(paths) > 500 and "vector" in reached(ROOT / "src/planner/planner.cpp")
    found = [(path, header, name) for path in paths for header, name in missing(path).items()]
    for path, header, name in found:
        print(f"{path.relative_to(ROOT)}: uses std::{name} and includes no <{header}>")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
