# SPDX-License-Identifier: Apache-2.0
"""reStructuredText that is made while the manual is built."""
import pathlib
import subprocess

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective
from sphinx.util.nodes import nested_parse_with_titles

ROOT = pathlib.Path(__file__).resolve().parents[2]


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
