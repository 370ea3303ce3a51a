# SPDX-License-Identifier: Apache-2.0
"""Builds the libraries and the extension avo._avo by CMake in build/python, for the interpreter that runs this."""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
(ROOT / "build").mkdir(exist_ok=True)  # for what setuptools writes, see pyproject.toml


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        tree = self.configured()
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", tree, "--target", "avo_python", "-j", jobs], check=True)
        path = pathlib.Path(self.get_ext_fullpath(extension.name))
        path.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(pathlib.Path(tree) / "python" / "avo" / path.name), str(path))

    def configured(self):
        tree = str(ROOT / "build" / "python")
        options = ["TESTS", "BENCH", "CLI", "C", "INSTALL"]
        ninja = ["-G", "Ninja"] if self.has_ninja() and not (pathlib.Path(tree) / "CMakeCache.txt").exists() else []
        subprocess.run(
            ["cmake", "-S", str(ROOT), "-B", tree, *ninja, "-DCMAKE_BUILD_TYPE=Release", "-DAVO_PYTHON=ON",
             f"-DPython3_EXECUTABLE={sys.executable}", *(f"-DAVO_{option}=OFF" for option in options)],
            check=True)
        return tree

    @staticmethod
    def has_ninja():
        return any((pathlib.Path(folder) / "ninja").exists() for folder in os.get_exec_path())


version = re.search(r"project\(avo VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("avo._avo", [])], cmdclass={"build_ext": BuildByCMake})
