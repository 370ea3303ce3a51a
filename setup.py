# SPDX-License-Identifier: Apache-2.0
"""Builds avo._avo and the command avo by CMake in build/python, for the interpreter that runs this.

The environment variable CMAKE_ARGS adds arguments of CMake: CMAKE_ARGS=-DAVO_LAB=ON puts the lab into the command.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup  # first: setuptools brings its own distutils
from setuptools.command.build_ext import build_ext
from distutils.command.build_scripts import build_scripts

ROOT = pathlib.Path(__file__).resolve().parent
TREE = ROOT / "build" / "python"
TREE.parent.mkdir(exist_ok=True)  # for what setuptools writes, see pyproject.toml


def configure():
    has_ninja = shutil.which("ninja") and not (TREE / "CMakeCache.txt").exists()
    subprocess.run(
        ["cmake", "-S", str(ROOT), "-B", str(TREE), *(["-G", "Ninja"] if has_ninja else []),
         "-DCMAKE_BUILD_TYPE=Release", "-DAVO_PYTHON=ON", "-DAVO_CLI=ON", f"-DPython3_EXECUTABLE={sys.executable}",
         *(f"-DAVO_{option}=OFF" for option in ("TESTS", "C")), *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
        check=True)


def build(target):
    jobs = str(os.cpu_count() or 1)
    subprocess.run(["cmake", "--build", str(TREE), "--target", target, "-j", jobs], check=True)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        configure()
        build("avo_python")
        path = pathlib.Path(self.get_ext_fullpath(extension.name))
        path.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(TREE / "python" / "avo" / path.name), str(path))


class CommandByCMake(build_scripts):
    """Runs after build_ext, which configures the tree."""

    def run(self):
        build("avo_cli")
        self.mkpath(self.build_dir)
        self.copy_file(str(TREE / "avo"), self.build_dir)


version = re.search(r"project\(avo VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("avo._avo", [])], scripts=["avo"],
      cmdclass={"build_ext": BuildByCMake, "build_scripts": CommandByCMake})
