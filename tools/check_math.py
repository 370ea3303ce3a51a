#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails if a library calls a function of the C library's mathematics that may round differently
elsewhere: check_math.py NM LIBRARY... (ARCHITECTURE.md, "Determinism")

Allowed are those of <math.h> whose result is exact or correctly rounded wherever IEEE 754 holds.
"""
import re
import subprocess
import sys

INEXACT = """
acos acosh asin asinh atan atan2 atanh cbrt cos cosh erf erfc exp exp10 exp2 expm1 gamma hypot
j0 j1 jn lgamma lgamma_r log log10 log1p log2 pow pow10 sin sincos sinh tan tanh tgamma y0 y1 yn
""".split()
# also of float and long double, behind -ffast-math, and of vectors
FORBIDDEN = re.compile(rf"(__)?({'|'.join(INEXACT)})[fl]?(_finite)?|_ZGV[a-e]N\d+v+_.*")


def undefined(nm, library):
    dynamic = ["-D"] if ".so" in library else []
    said = subprocess.run([nm, "-P", "-u", *dynamic, library], check=True, capture_output=True, text=True)
    names = [line.split()[0].split("@")[0] for line in said.stdout.splitlines() if " U" in line]
    if not names:
        sys.exit(f"{library}: {nm} found no undefined symbol, must find some")
    return names


def main():
    nm, *libraries = sys.argv[1:]
    bad = sorted({(library, name) for library in libraries for name in undefined(nm, library)
                  if FORBIDDEN.fullmatch(name)})
    for library, name in bad:
        print(f"{library}: calls {name} of the C library, must use core/elementary.h")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
