# SPDX-License-Identifier: Apache-2.0
"""The reference of headers: what Doxygen has found of them, shown by breathe."""
import dataclasses
import re
import shutil
import xml.etree.ElementTree as ElementTree

from docutils import nodes
from sphinx import addnodes
from sphinx.domains import cpp
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

from generated import ROOT, Generated, escaped, heading, listing

INCLUDE = ROOT / "include"
log = logging.getLogger(__name__)


@dataclasses.dataclass(order=True)
class Entity:
    """A type or a function of a header."""
    file: str
    line: int
    kind: str
    name: str
    project: str
    comment: str
    names_a_struct: bool  # typedef struct avo_plan {...} avo_plan;
    values: tuple = ()  # of an enumeration without a name: (name, value, meaning)


def words_of(element, *kinds):
    found = [element.find(kind) for kind in kinds]
    return " ".join("".join(one.itertext()).strip() for one in found if one is not None).strip()


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
                  comment=words_of(element, *said), names_a_struct=words_of(element, "type") == f"struct {name}",
                  values=values if "@" in name else ())


def split(xml, found):
    """Folders, one a header, each with an index of its own: breathe looks through all of an index for each name."""
    folders = {}
    shutil.rmtree(xml.parent / "headers", ignore_errors=True)
    for file in sorted({entity.file for entity in found}):
        folder = folders[file] = xml.parent / "headers" / file
        folder.mkdir(parents=True, exist_ok=True)
        names = {entity.name for entity in found if entity.file == file}
        index = ElementTree.parse(xml / "index.xml")
        for compound in list(index.getroot()):
            name, compound_file = compound.findtext("name"), f"{compound.get('refid')}.xml"
            if compound.get("kind") == "namespace":
                scope = ElementTree.parse(xml / compound_file)
                kept = keep_members(scope, file)
                scope.write(folder / compound_file)
                for member in [member for member in compound.findall("member") if member.get("refid") not in kept]:
                    compound.remove(member)
            elif names.isdisjoint({name, name.rpartition("::")[0]}):
                index.getroot().remove(compound)
            else:
                (folder / compound_file).symlink_to(xml / compound_file)
        index.write(folder / "index.xml")
    return {file: str(folder) for file, folder in folders.items()}


def keep_members(scope, file):
    """Leaves those of one header, without the rows of tables, which Sphinx cannot read; their ids."""
    kept = set()
    for section in scope.iter("sectiondef"):
        for member in section.findall("memberdef"):
            if member.find("location").get("file") == file:
                kept.add(member.get("id"))
                rows = member.find("initializer")
                if rows is not None and words_of(member, "initializer").startswith("{"):
                    member.remove(rows)
            else:
                section.remove(member)
    return kept


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
            return f"{escaped(entity.comment)}\n\n" + listing(
                ["name", "value", "meaning"],
                [(f"``{name}``", value, escaped(meaning)) for name, value, meaning in entity.values])
        if not entity.comment and entity.kind != "function" and entity.project == "avo":
            log.warning("%s:%d: %s has no comment for the manual", entity.file, entity.line, entity.name)
        said = f".. doxygen{entity.kind}:: {entity.name}\n   :project: {entity.file}\n"
        return said + ("   :members:\n   :undoc-members:\n\n" if entity.kind in ("struct", "class") else "\n")


class OtherHeaders(Generated):
    """All headers that no page of the reference names."""

    def text(self):
        named = "".join(path.read_text() for path in (ROOT / "docs/manual/reference").glob("*.rst"))
        names = [str(path.relative_to(INCLUDE)) for path in sorted(INCLUDE.glob("avo*/**/*.h"))]
        return "".join(f"{heading(name, '-')}.. avo-header:: {name}\n\n" for name in names
                       if name not in ("avo/avo.h", "avo/export.h") and f"avo-header:: {name}\n" not in named)


class DocumentLinks(SphinxTransform):
    """Where a comment of a header says docs/NAME.md, a link to that document."""
    default_priority = 5  # before references are resolved

    def apply(self):
        if not self.env.docname.startswith("docs/manual/reference/"):
            return
        for text in list(self.document.findall(nodes.Text)):
            if isinstance(text.parent, (nodes.FixedTextElement, nodes.literal)):
                continue
            words = re.split(r"\b(docs/[\w/]+)\.md\b", str(text))
            parts = [self.link(word) if number % 2 else nodes.Text(word) for number, word in enumerate(words)]
            if len(parts) > 1:
                text.parent.replace(text, parts)

    def link(self, document):
        return addnodes.pending_xref("", nodes.inline("", f"{document}.md"), refdomain="std", reftype="doc",
                                     refexplicit=True, reftarget=f"/{document}", refdoc=self.env.docname, refwarn=True)


def remember_ids():
    """Sphinx 5.3 makes the id of a symbol anew whenever it is looked up, a tenth of all time."""
    made_anew = cpp.ASTDeclaration.get_newest_id

    def remembered(declaration):
        if not hasattr(declaration, "newest_id"):
            declaration.newest_id = made_anew(declaration)
        return declaration.newest_id

    cpp.ASTDeclaration.get_newest_id = remembered
