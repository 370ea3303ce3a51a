# SPDX-License-Identifier: Apache-2.0
"""What Sphinx does not know by itself: four directives whose content comes from the library.

.. avo-header:: avo/planner.h    the types and functions of a header, in its order, by Doxygen and breathe
.. avo-other-headers::           the same of all headers that no page names
.. avo-help::                    what `avo VERB --help` prints, a section for each verb
.. avo-scene-keys::              the keys of scene files, from `avo schema`
"""
import dataclasses
import json
import pathlib
import re
import subprocess
import xml.etree.ElementTree as ElementTree

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.domains import cpp
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from sphinx.util.nodes import nested_parse_with_titles

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
log = logging.getLogger(__name__)


class Generated(SphinxDirective):
    """A directive that stands for reStructuredText."""

    def run(self):
        place = nodes.container()
        place.document = self.state.document
        lines = StringList(self.text().splitlines(), source=f"<{self.name}>")
        nested_parse_with_titles(self.state, lines, place)
        return place.children

    def avo(self, *words):
        return subprocess.run([self.config.avo_program, *words], check=True, capture_output=True,
                              text=True, env={"LC_ALL": "C.UTF-8", "TERM": "dumb"}).stdout


def heading(text, underline):
    return f"{text}\n{underline * len(text)}\n\n"


def listing(titles, rows):
    return ".. list-table::\n   :header-rows: 1\n\n" + "".join(
        "   * - " + "\n     - ".join(row) + "\n" for row in [titles, *rows]) + "\n"


def escaped(text):
    return "".join("\\" + character if character in "\\*|`_" else character for character in text)


def indented(text, by="   "):
    return "".join(by + line if line.strip() else line for line in text.splitlines(True))


# C++ and C

@dataclasses.dataclass(order=True)
class Entity:
    """A type or a function of a header."""
    file: str
    line: int
    kind: str
    name: str
    project: str
    documented: bool
    names_a_struct: bool  # typedef struct avo_plan {...} avo_plan;
    values: tuple = ()  # of an enumeration without a name: (name, value, meaning)


def words_of(element, *kinds):
    return " ".join("".join(found.itertext()).strip() for found in map(element.find, kinds) if found is not None).strip()


def entities(xml, project):
    """All types and functions that Doxygen has found, in namespaces (C++) or outside of them (C)."""
    found = []
    outer = "namespace*.xml" if list(xml.glob("namespace*.xml")) else "*_8h.xml"
    for scope in (ElementTree.parse(path).getroot().find("compounddef") for path in xml.glob(outer)):
        prefix = f"{scope.findtext('compoundname')}::" if scope.get("kind") == "namespace" else ""
        for inner in scope.findall("innerclass"):
            kind = ElementTree.parse(xml / f"{inner.get('refid')}.xml").getroot().find("compounddef")
            found.append(entity_of(kind, project, kind.findtext("compoundname")))
        for member in scope.iter("memberdef"):
            arguments = member.findtext("argsstring") if prefix and member.get("kind") == "function" else ""
            found.append(entity_of(member, project, prefix + member.findtext("name") + arguments))
    return sorted(entity for entity in found if entity.kind != "define" and not entity.names_a_struct)


def entity_of(element, project, name):
    said = "briefdescription", "detaileddescription"
    location = element.find("location")
    values = tuple((value.findtext("name"), value.findtext("initializer", "").lstrip("= "), words_of(value, *said))
                   for value in element.findall("enumvalue"))
    return Entity(location.get("file"), int(location.get("line")), element.get("kind"), name, project,
                  bool(words_of(element, *said)), words_of(element, "type") == f"struct {name}", values if "@" in name else ())


def parts_of(header):
    """(line, title) of comments such as /* ---- planner */."""
    for number, line in enumerate(header.read_text().splitlines(), 1):
        if title := re.fullmatch(r"/\* -{4,} (.+) \*/", line):
            yield number, title[1].capitalize()


class Header(Generated):
    required_arguments = 1

    def text(self):
        header = self.arguments[0]
        said = f".. code-block:: cpp\n\n   #include <{header}>\n\n"
        shown = [entity for entity in self.config.avo_entities if entity.file.endswith(f"include/{header}")]
        if not shown:
            log.warning("%s declares nothing, or is no public header", header)
            return said
        parts = list(parts_of(ROOT / shown[0].file))
        for entity in shown:
            while parts and parts[0][0] < entity.line:
                said += heading(parts.pop(0)[1], "-")
            said += self.one(entity)
        return said

    def one(self, entity):
        if entity.values:
            return listing(["name", "value", "meaning"], [(f"``{name}``", value, escaped(meaning))
                                                          for name, value, meaning in entity.values])
        if not entity.documented and entity.kind != "function" and entity.project == "avo":
            log.warning("%s:%d: %s has no comment for the manual", entity.file, entity.line, entity.name)
        said = f".. doxygen{entity.kind}:: {entity.name}\n   :project: {entity.project}\n"
        return said + ("   :members:\n   :undoc-members:\n\n" if entity.kind in ("struct", "class") else "\n")


class OtherHeaders(Generated):
    """All headers that no page of the reference names."""

    def text(self):
        named = "".join(path.read_text() for path in (ROOT / "docs/manual/reference").glob("*.rst"))
        names = [str(path.relative_to(INCLUDE)) for path in sorted(INCLUDE.glob("avo*/*.h"))]
        return "".join(f"{heading(name, '-')}.. avo-header:: {name}\n\n" for name in names
                       if name not in ("avo/avo.h", "avo/export.h") and f"avo-header:: {name}\n" not in named)


def remember_ids():
    """Sphinx 5.3 makes the id of a symbol anew whenever it is looked up, a tenth of all time."""
    made_anew = cpp.ASTDeclaration.get_newest_id

    def remembered(declaration):
        if not hasattr(declaration, "newest_id"):
            declaration.newest_id = made_anew(declaration)
        return declaration.newest_id

    cpp.ASTDeclaration.get_newest_id = remembered


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
    if "oneOf" in key:
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
        parts = schema["$defs"]
        robot = parts["robot"]["properties"]
        # a group has all keys of a robot, and few that differ
        parts["group"]["properties"] = {name: key for name, key in parts["group"]["properties"].items()
                                        if key != robot.get(name)}
        shared = parts["robot"]["properties"]
        robots_from = schema["properties"]["robots_from"]
        robots_from["properties"] = {name: key for name, key in robots_from["properties"].items()
                                     if key != shared.get(name)}
        said = heading("The scene", "-") + table(schema)
        for name, part in parts.items():
            said += heading(f"{name.replace('_', ' ').capitalize()}", "-") + table(part)
        return said


# Debian's furo

def mend_furo(app, failure):
    """Its script is a module, which no browser loads from a file; its style has no automatic dark theme."""
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
    app.add_config_value("avo_entities", [], "")
    app.add_directive("avo-header", Header)
    app.add_directive("avo-other-headers", OtherHeaders)
    app.add_directive("avo-help", Help)
    app.add_directive("avo-scene-keys", SceneKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
