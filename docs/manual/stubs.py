# SPDX-License-Identifier: Apache-2.0
"""The reference of the Python package: signatures from its stubs and sources, words from the built module as well."""
import ast
import importlib
import inspect
import re
import sys

from generated import ROOT, Generated, escaped, heading, indented

PACKAGE = ROOT / "bindings/python/avo"


class Python(Generated):
    """All that is public, module by module."""

    def text(self):
        if self.config.avo_python not in sys.path:
            sys.path.insert(0, self.config.avo_python)
        modules = {"avo": []}
        for stub in sorted(PACKAGE.glob("*.py*")):
            if stub.suffix not in (".py", ".pyi") or stub.with_suffix(".pyi").exists() and stub.suffix == ".py":
                continue
            name = "avo" if stub.stem.startswith("_") else f"avo.{stub.stem}"
            modules.setdefault(name, []).append(ast.parse(stub.read_text()))
        said = ""
        for name, trees in modules.items():
            words = "".join(paragraphs(ast.get_docstring(tree)) for tree in trees)
            parts = "".join(part for tree in trees for part in public(tree.body, name, importlib.import_module(name)))
            if parts:
                said += heading(name, "-") + f".. py:module:: {name}\n\n{words}{parts}"
        return said


def public(body, owner, found, inside=False):
    """The reStructuredText of the definitions; found: the module or class itself, None where only a stub has it."""
    for node in body:
        name = getattr(node, "name", None) or ast.unparse(getattr(node, "target", ast.Name("_")))
        if name.startswith("_") and name not in ("__init__", "__getitem__", "__len__", "__iter__"):
            continue
        itself = inspect.getattr_static(found, name, None) if found else None
        if isinstance(node, ast.AnnAssign) and not inspect.isdatadescriptor(itself):
            itself = None  # a value, whose docstring is that of its type
        words = paragraphs(ast.get_docstring(node) if has_docstring(node) else words_of(itself))
        if isinstance(node, ast.ClassDef):
            content = words + "".join(public(node.body, f"{owner}.{name}", getattr(found, name, None), True))
            yield f".. py:class:: {owner}.{name}\n\n{indented(content)}\n"
        elif isinstance(node, ast.FunctionDef):
            yield function(node, owner, words, inside)
        elif isinstance(node, ast.AnnAssign):
            kind = "attribute" if inside else "data"
            yield f".. py:{kind}:: {owner}.{name}\n   :type: {ast.unparse(node.annotation)}\n\n{indented(words)}\n"


def function(node, owner, words, inside):
    marks = {ast.unparse(mark) for mark in node.decorator_list}
    returned = ast.unparse(node.returns) if node.returns else ""
    if "property" in marks:
        return f".. py:property:: {owner}.{node.name}\n   :type: {returned}\n\n{indented(words)}\n"
    if any(mark.endswith(".setter") for mark in marks):
        return ""
    if inside and "staticmethod" not in marks:
        node.args.args = node.args.args[1:]  # self or cls
    kind = "method" if inside else "function"
    options = "".join(f"   :{mark}:\n" for mark in ("staticmethod", "classmethod") if mark in marks)
    options += "   :noindex:\n" if any(mark.endswith("overload") for mark in marks) else ""
    arrow = f" -> {returned}" if returned and node.name != "__init__" else ""
    return f".. py:{kind}:: {owner}.{node.name}({ast.unparse(node.args)}){arrow}\n{options}\n{indented(words)}\n"


def has_docstring(node):
    return isinstance(node, (ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node)


def words_of(itself):
    """The docstring, without the lines of signatures with which pybind11 begins it."""
    lines = (inspect.getdoc(itself) or "").splitlines() if itself is not None else []
    made = re.compile(r"(\d+\. )?\w+\(.*\) -> |Overloaded function\.$")
    return "\n".join(line for line in lines if not made.match(line))


def paragraphs(text):
    return "".join(f"{escaped(' '.join(part.split()))}\n\n" for part in (text or "").split("\n\n") if part.strip())
