#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a shared library exports: public names, and all that carries AVO_API.

usage: symbols.py LIBRARY...
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def public_text():
    """The public headers without comments, private members and what is AVO_LOCAL."""
    text = ""
    for header in sorted((ROOT / "include").rglob("*.h")):
        lines = re.sub(r"//.*", "", header.read_text())
        lines = re.sub(r"^ private:.*?^};", "};", lines, flags=re.M | re.S)
        text += re.sub(r"[^;{}]*\bAVO_LOCAL\b[^;]*;", "", lines)
    return text


def exported(library):
    """Demangled names, without the arguments of functions."""
    table = subprocess.run(["nm", "-DC", "--defined-only", library], check=True,
                           capture_output=True, text=True).stdout
    return [line.split(maxsplit=2)[2] for line in table.splitlines()]


def name_of(symbol):
    """avo::Horizon::at of avo::Horizon::at(double) const; avo::Error of vtable for avo::Error."""
    symbol = re.sub(r"^(vtable|typeinfo name|typeinfo) for ", "", symbol)
    symbol = symbol.replace("[abi:cxx11]", "").split("(")[0]
    symbol = re.sub(r"<[^<>]*>", "", symbol)
    return symbol.split()[-1]


def check_headers():
    """Every function and class with a body elsewhere says whether it is public."""
    declaration = r"^(?!AVO_|inline|constexpr|template|using|typedef)[A-Za-z_][\w:<>,*& ]*\b\w+\("
    for header in sorted((ROOT / "include").rglob("*.h")):
        bare = re.findall(declaration, header.read_text(), re.M)
        bare += re.findall(r"^class (?!AVO_)\w+[^;\n]*\{", header.read_text(), re.M)
        if bare:
            sys.exit(f"{header.relative_to(ROOT)}: neither AVO_API nor AVO_LOCAL: {bare}")


def check_c(library):
    """The functions of the C headers, and nothing else."""
    header = "\n".join(path.read_text() for path in (ROOT / "bindings/c/include/avo_c").glob("*.h"))
    declared = set(re.findall(r"^AVO_C_API [^;(]*?(\w+)\(", header, re.M))
    symbols = {symbol.split("(")[0] for symbol in exported(library)}
    if symbols != declared:
        sys.exit(f"{library}: exported or declared, but not both: {', '.join(sorted(symbols ^ declared))}")
    print(f"{pathlib.Path(library).name}: {len(symbols)} functions of C, nothing else")


def check(library):
    check_headers()
    if "avo_c" in pathlib.Path(library).name:
        check_c(library)
        return
    words = set(re.findall(r"\w+", public_text()))
    symbols = exported(library)
    stray = [symbol for symbol in symbols
             if not re.match(r"avo(_io)?::", name_of(symbol))
             or not set(re.findall(r"[A-Za-z_]\w*", name_of(symbol))) <= words | {"operator"}]
    if stray:
        sys.exit(f"{library}: exports {len(stray)} symbols that are not public, among them\n  "
                 + "\n  ".join(sorted(stray)[:10]))

    namespace = "avo_io" if "avo_io" in pathlib.Path(library).name else "avo"
    declared = set()
    for header in (ROOT / "include" / namespace).rglob("*.h"):
        declared |= set(re.findall(r"^(?:AVO_API [^;(]*?(?=\w+\()|class AVO_API )(\w+)", header.read_text(),
                                   re.M))
    hidden = declared - {part for symbol in symbols for part in name_of(symbol).split("::")}
    if hidden:
        sys.exit(f"{library}: public, but not exported: {', '.join(sorted(hidden))}")
    print(f"{pathlib.Path(library).name}: {len(symbols)} exported symbols, all public")


if __name__ == "__main__":
    for path in sys.argv[1:]:
        check(path)
