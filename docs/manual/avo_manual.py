# SPDX-License-Identifier: Apache-2.0
"""What Sphinx does not know by itself: directives whose content comes from the library.

.. avo-header:: avo/planner.h    the types and functions of a header, in its order, by Doxygen and breathe
.. avo-other-headers::           the same of all headers that no page names
.. avo-python::                  the Python package, from its stubs and the built module
.. avo-help::                    what `avo VERB --help` prints, a section for each verb
.. avo-scene-keys::              the keys of scene files, from `avo schema`
"""
import json
import pathlib
import re

from generated import Generated, escaped, heading, indented, listing
from headers import DocumentLinks, Header, OtherHeaders, remember_ids
from stubs import Python


# the command line

class Help(Generated):
    def text(self):
        first = self.avo("--help")
        verbs = first.partition("Subcommands:\n")[2].partition("\n\n")[0]
        said = f".. code-block:: text\n\n{indented(first)}\n"
        for verb in (line.split()[0] for line in verbs.splitlines() if line.startswith("  ") and line[2] != " "):
            said += heading(f"avo {verb}", "-")
            said += f".. code-block:: text\n\n{indented(self.avo(verb, '--help'))}\n"
        return said


# scene files

LARGEST = {1e12, -1e12, 2147483647, 18446744073709551615}  # bounds of all numbers, or of a type: not worth a word


def kind_of(key):
    if "const" in key:
        return f"``{json.dumps(key['const'])}``"
    if "enum" in key:
        return ", ".join(f"``{word}``" for word in key["enum"])
    if "oneOf" in key and "type" not in key:
        return " or ".join(dict.fromkeys(kind_of(one) for one in key["oneOf"]))
    if "prefixItems" in key:
        return "[x, y]"
    if "$ref" in key:
        return key["$ref"].rpartition("/")[2].replace("_", " ")
    if key["type"] == "array":
        return f"list of {kind_of(key['items'])}"
    return {"object": "keys below"}.get(key["type"], key["type"])


def bounds_of(key):
    signs = {"exclusiveMinimum": ">", "minimum": ">=", "exclusiveMaximum": "<", "maximum": "<="}
    return ", ".join(f"{sign} {key[word]:g}" for word, sign in signs.items()
                     if word in key and key[word] not in LARGEST)


def as_yaml(value):
    return value if isinstance(value, str) else json.dumps(value)


def fields(part):
    """(name, schema, is required) of its keys; of alternatives those of all, none of which is required."""
    for name, key in part.get("properties", {}).items():
        yield name, key, name in part.get("required", [])
    for one in part.get("oneOf", []):
        for name, key, _ in fields(one):
            yield name, key, False


def rows(part, prefix=""):
    for name, key, required in fields(part):
        value = ", ".join(filter(None, [kind_of(key), bounds_of(key)]))
        standard = f"``{as_yaml(key['default'])}``" if "default" in key else "required" if required else ""
        yield f"``{prefix}{name}``", value, standard, escaped(key.get("description", ""))
        yield from rows(key, f"{prefix}{name}.")


def table(part):
    return listing(["key", "value", "default", "meaning"], dict.fromkeys(rows(part)))  # alternatives may share a key


class SceneKeys(Generated):
    def text(self):
        schema = json.loads(self.avo("schema"))
        parts, plane = schema["$defs"], schema["else"]
        robot = parts["robot"]["properties"]
        # a group has all keys of a robot, and few that differ
        parts["group"]["properties"] = {name: key for name, key in parts["group"]["properties"].items()
                                        if key != robot.get(name)}
        shared = parts["robot"]["properties"]
        robots_from = plane["properties"]["robots_from"]
        robots_from["properties"] = {name: key for name, key in robots_from["properties"].items()
                                     if key != shared.get(name)}
        said = heading("The scene", "-") + table(plane)
        for name, part in parts.items():
            said += heading(f"{name.replace('_', ' ').capitalize()}", "-") + table(part)
        return said


# Debian's furo

def mend_furo(app, failure):
    """Its script is a module, which no browser loads from a file; its style has no automatic dark theme."""
    if failure is not None:
        return
    scripts = pathlib.Path(app.outdir) / "_static" / "scripts"
    furo = scripts / "furo.js"
    whole = furo.read_text().replace('import Gumshoe from "./gumshoe-patched.js";',
                                     (scripts / "gumshoe-patched.js").read_text())
    furo.write_text(whole)
    style = scripts.parent / "styles" / "furo.css"
    text = style.read_text()
    dark = re.search(r'@media not print \{\s*body\[data-theme="dark"\].*?\}\s*\}', text, re.S)
    if dark and "prefers-color-scheme" not in text:
        automatic = dark[0].replace('[data-theme="dark"]', '[data-theme="auto"]')
        style.write_text(f"{text}\n@media (prefers-color-scheme: dark) {{\n{automatic}\n}}\n")


def setup(app):
    remember_ids()
    app.connect("build-finished", mend_furo)
    app.add_config_value("avo_program", "", "env")
    app.add_config_value("avo_python", "", "env")
    app.add_config_value("avo_entities", [], "")
    app.add_transform(DocumentLinks)
    app.add_directive("avo-header", Header)
    app.add_directive("avo-other-headers", OtherHeaders)
    app.add_directive("avo-python", Python)
    app.add_directive("avo-help", Help)
    app.add_directive("avo-scene-keys", SceneKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
