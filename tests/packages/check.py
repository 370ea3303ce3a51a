#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds and runs users' programs with this library as a package.

usage: check.py static BUILD      the finished build BUILD, installed and moved to another folder
       check.py c_core BUILD      the C library for games alone, installed from the finished build BUILD
       check.py shared BUILD      a build with BUILD_SHARED_LIBS=ON, likewise
       check.py parent BUILD      a project that adds the sources, with a shared library
       check.py libcxx BUILD      the same with a static one, by clang and libc++, from scratch
       check.py odr BUILD         no two types of one name in the library, as linking with -flto sees them
       check.py fused BUILD       no fused multiply-add in the library of BUILD, nor in a build with -march=x86-64-v3

Shared and parent have the settings of BUILD and take its objects where they would be compiled by the
same command (reuse.py). In an installed tree: by find_package and by pkg-config, each with avo, avo_io and avo_c, and a plug-in
that is loaded at run time; the command line, if the build has one; of a shared library also what it
exports. Options: --folder FOLDER, for what is made (it is emptied); --compiler, --flags.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

import symbols

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CONSUMER = HERE / "consumer"
WARNINGS = ["-Wall", "-Wextra", "-Wformat-signedness", "-Wno-unknown-warning-option", "-Werror"]
QUICK = ["-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DAVO_SIMD=OFF"]


def run(*command, **changes):
    """Its output; ends the check where the command fails."""
    done = subprocess.run([str(word) for word in command], env=dict(os.environ, **changes),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}\nexit status {done.returncode}")
    return done.stdout


def expect(condition, message):
    if not condition:
        sys.exit(message)


def configure(arguments, source, build, *options):
    run("cmake", "-G", "Ninja", "-S", source, "-B", build,
        f"-DCMAKE_CXX_COMPILER={arguments.compiler}", f"-DCMAKE_CXX_FLAGS={arguments.flags}", *options)


def settings_of(build, folder):
    """Options of a build in FOLDER with the settings and, where they fit, the objects of BUILD."""
    cache = (build / "CMakeCache.txt").read_text()
    values = re.findall(r"^((?:CMAKE_BUILD_TYPE|CMAKE_CXX_FLAGS\w*|AVO_SIMD|CMAKE_COMPILE_WARNING_AS_ERROR):.*)$", cache, re.M)
    launcher = f"{sys.executable};-S;{HERE / 'reuse.py'};{build.absolute()};{folder}"
    return [f"-D{value}" for value in values] + [f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}"]


def build_all(build, *targets):
    run("cmake", "--build", build, "--parallel", "2", *(["--target", *targets] if targets else []))


def install_and_move(build, folder):
    """The prefix is not the one that the build was configured for, and moves after that."""
    run("cmake", "--install", build, "--prefix", folder / "installed")
    (folder / "installed").rename(folder / "moved")
    return folder / "moved"


def check_find_package(arguments, prefix):
    build = arguments.folder / "find_package"
    configure(arguments, CONSUMER, build, f"-DCMAKE_PREFIX_PATH={prefix}")
    build_all(build)
    print("find_package:", run(build / "core"), end="")
    print("find_package:", run(build / "io", build / "recording.csv"), end="")
    print("find_package:", run(build / "c"), end="")
    plugin = next(build.glob("libplugin.*"))
    print("plug-in:     ", run(sys.executable, "-c", "import ctypes, sys\n"
                               "sys.exit(ctypes.CDLL(sys.argv[1]).cross())", plugin), end="")


def check_pkg_config(arguments, prefix):
    build = arguments.folder / "pkg_config"
    build.mkdir()
    library = next(prefix.rglob("pkgconfig")).parent
    package = {"PKG_CONFIG_PATH": str(library / "pkgconfig")}
    for program, name in (("core", "avo"), ("io", "avo_io")):
        for mode in ([], ["--static"]) if list(library.glob("*.a")) else ([],):
            words = run("pkg-config", *mode, "--cflags", "--libs", name, **package).split()
            run(arguments.compiler, *arguments.flags.split(), CONSUMER / f"{program}.cpp", *words,
                "-o", build / program)
            print("pkg-config:  ", run(build / program, build / "recording.csv",
                                       LD_LIBRARY_PATH=str(library)), end="")
    words = run("pkg-config", "--cflags", "--libs", "avo_c", **package).split()
    run("cc", "-std=c99", *arguments.flags.split(), CONSUMER / "c.c", *words, "-o", build / "c")
    print("pkg-config:  ", run(build / "c", LD_LIBRARY_PATH=str(library)), end="")


def check_examples(arguments, prefix):
    """Circle-100 as docs/packages.md has it built, from C++ and, where it is installed, from C: the pinned hash."""
    build, library = arguments.folder / "pkg_config", next(prefix.rglob("pkgconfig")).parent
    pinned = re.search(r'"circle-100", \{\}, 0, (0x\w+)', (ROOT / "tests/hashes/pinned_runs.cpp").read_text())[1]
    for compiler, source, name in ((arguments.compiler, "examples/circle.cpp", "avo_io"),
                                   ("cc", "bindings/c/examples/circle.c", "avo_c")):
        if not (library / "pkgconfig" / f"{name}.pc").exists():
            continue
        words = run("pkg-config", "--cflags", "--libs", name, PKG_CONFIG_PATH=str(library / "pkgconfig")).split()
        run(compiler, *arguments.flags.split(), *WARNINGS, ROOT / source, *words, "-o", build / "circle")
        said = run(build / "circle", LD_LIBRARY_PATH=str(library))
        expect(f"100 of 100 arrived, 0 collisions, state hash {pinned}" in said, f"{source}: {said}")
        print("example:     ", said, end="")


def check_command_line(prefix):
    program = prefix / "bin" / "avo"
    run(program, "run", "circle-10", "--set", "duration=1")
    print("command line:", run("ldd", program).count(str(prefix.resolve())), "libraries of its own")


def check_installed(arguments, prefix):
    check_find_package(arguments, prefix)
    check_pkg_config(arguments, prefix)
    check_examples(arguments, prefix)
    if (prefix / "bin" / "avo").exists():
        check_command_line(prefix)
    for library in sorted(prefix.rglob("libavo*.so")):
        symbols.check(library)


def check_static(arguments):
    check_installed(arguments, install_and_move(arguments.build, arguments.folder))


def check_c_core(arguments):
    """What a game takes along: one library that needs three others, a header, and what finds them."""
    for component in ("c_core", "c_core_dev"):
        run("cmake", "--install", arguments.build, "--component", component, "--prefix", arguments.folder / "installed")
    prefix = (arguments.folder / "installed").rename(arguments.folder / "moved")
    files = [path for path in prefix.rglob("*") if path.is_file()]
    names = {path.name for path in files if "avo_c_core" not in path.name}
    expect(names == {"avo.h", "space.h"}, f"more than the library, its header and what finds them: {sorted(names)}")
    library = next(path for path in files if ".so." in path.name and not path.is_symlink())
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "--dynamic", library))
    needed = {name for name in needed if not name.startswith("ld-")}  # the loader itself
    expect(needed == {"libc.so.6", "libm.so.6", "libstdc++.so.6"}, f"{library.name} needs {sorted(needed)}")
    symbols.check(library)
    check_game(arguments, prefix, library.parent)


def check_game(arguments, prefix, library):
    build = arguments.folder / "find_package"
    run("cmake", "-G", "Ninja", "-S", HERE / "game", "-B", build, f"-DAVO_SOURCE={ROOT}", f"-DCMAKE_PREFIX_PATH={prefix}")
    build_all(build)
    program = arguments.folder / "game_loop"
    words = run("pkg-config", "--cflags", "--libs", "avo_c_core", PKG_CONFIG_PATH=str(library / "pkgconfig")).split()
    run("cc", "-std=c99", *WARNINGS, ROOT / "examples/game_loop.c", *words, "-lm", "-o", program)
    said = {run(build / "game_loop"), run(program, LD_LIBRARY_PATH=str(library))}
    expect(len(said) == 1 and "0 robots by the player, 0 pairs" in next(iter(said)), f"game_loop: {said}")
    print("game:        ", *said, end="")


def check_shared(arguments):
    build = arguments.folder / "build"
    configure(arguments, ROOT, build, *settings_of(arguments.build, build), "-DBUILD_SHARED_LIBS=ON",
              "-DAVO_TESTS=OFF", f"-DCMAKE_INSTALL_PREFIX={arguments.folder / 'elsewhere'}")
    build_all(build, "avo", "avo_io", "avo_c", "avo_c_core", "avo_cli")  # what is installed
    prefix = install_and_move(build, arguments.folder)
    shutil.rmtree(build)  # nothing may come from there
    check_installed(arguments, prefix)


def check_added(arguments, *options):
    build, prefix = arguments.folder / "build", arguments.folder / "installed"
    configure(arguments, HERE / "parent", build, f"-DAVO_SOURCE={ROOT}", *options)
    build_all(build)
    print("add_subdirectory:", run(build / "core"), end="")
    tests = run("ctest", "--test-dir", build, "-N")
    expect("Total Tests: 1\n" in tests, f"not only its own test:\n{tests}")
    run("cmake", "--install", build, "--prefix", prefix)
    files = [str(path.relative_to(prefix)) for path in prefix.rglob("*") if path.is_file()]
    expect(files == ["bin/core"], f"not only its own file is installed: {files}")


def check_parent(arguments):
    added = arguments.folder / "build" / "avo"
    check_added(arguments, *settings_of(arguments.build, added), "-DBUILD_SHARED_LIBS=ON")


def check_libcxx(arguments):
    arguments.compiler, arguments.flags = "clang++", "-stdlib=libc++"
    check_added(arguments, *QUICK)


def check_fused(arguments):
    """Fused instructions round once where the others round twice, so that bits would depend on flags. The units
    compiled anew are those in which g++ 12 makes such instructions, unless cmake/settings.cmake prevents it."""
    expect_none_fused(next((arguments.build / "src").glob("libavo.[as]*")))
    build = arguments.folder / "build"
    configure(arguments, ROOT, build, "-DCMAKE_BUILD_TYPE=Release", "-DAVO_TESTS=OFF",
              "-DCMAKE_CXX_FLAGS=-march=x86-64-v3")
    targets = run("ninja", "-C", build, "-t", "targets", "all")
    units = r"(?:robots|drive_turns|obstacles|half_planes)(?:_cxx\.cxx|\.cpp)\.o"
    objects = re.findall(rf"^(\S*avo(?:_one_by_one)?\.dir/\S*{units}):", targets, re.M)
    expect(len(objects) == 4, f"units not found: {objects}")
    build_all(build, *objects)
    for unit in objects:
        expect_none_fused(build / unit)


def check_odr(arguments):
    """With its inline namespaces, each layer may use one name for a type of its own. Linking compares all the types: of
    the library, of what reads and draws, of the command line and of C."""
    build = arguments.folder / "build"
    flags = "-O0 -flto=2 -Wodr -Werror=odr"
    configure(arguments, ROOT, build, "-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_CXX_FLAGS_DEBUG={flags}", "-DAVO_TESTS=OFF",
              "-DAVO_SIMD=OFF", "-DBUILD_SHARED_LIBS=ON")
    build_all(build)
    expect_finds_two_types(arguments, flags.split())
    print("odr: one type of each name in the libraries and the command line")


def expect_finds_two_types(arguments, flags):
    """What the check looks for is found where it is."""
    for member in ("double", "float"):
        (arguments.folder / f"{member}.cpp").write_text(
            f"struct Twice {{ {member} value; Twice(); virtual ~Twice(); }};\n"
            f"Twice* make_{member}() {{ return new Twice; }}\n")
    files = [arguments.folder / f"{member}.cpp" for member in ("double", "float")]
    done = subprocess.run([arguments.compiler, *flags, "-shared", "-fPIC", *files, "-o", arguments.folder / "twice.so"],
                          capture_output=True, text=True)
    expect(done.returncode != 0 and "odr" in done.stderr, f"two types were not found: {done.stderr}")


def expect_none_fused(file):
    code = run("objdump", "-d", "--no-show-raw-insn", file)
    expect(code.count("\tmulsd") + code.count("\tvmulsd") > 10, f"{file}: no code was found")
    found = re.findall(r"\bvf(?:n?m(?:add|sub)|maddsub|msubadd)\w*", code)
    expect(not found, f"{file}: {len(found)} fused instructions, such as {found[:1]}")
    print(f"fused: none of {code.count(chr(10))} lines of {file.name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("kind", choices=["static", "c_core", "shared", "parent", "libcxx", "odr", "fused"])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "packages")
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--flags", default="")
    arguments = parser.parse_args()
    arguments.folder = (arguments.folder / arguments.kind).absolute()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    {"static": check_static, "c_core": check_c_core, "shared": check_shared, "parent": check_parent,
     "libcxx": check_libcxx, "odr": check_odr, "fused": check_fused}[arguments.kind](arguments)


if __name__ == "__main__":
    main()
