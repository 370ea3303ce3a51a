# SPDX-License-Identifier: Apache-2.0
# The sources are the documents of the repository, where they are: Sphinx runs in its root, so that
# links between them are the same here and wherever Markdown is shown. See scripts/manual.
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from generated import ROOT
from headers import entities, split

project = "avo"
author = "the authors of avo"
extensions = ["myst_parser", "breathe", "avo_manual"]
root_doc = "docs/manual/index"
include_patterns = ["*.md", "bench/*.md", "docs/**"]
exclude_patterns = [".*", "build*", "apps", "figures", "io", "scenarios", "scripts", "src", "tests"]
nitpicky = True
nitpick_ignore_regex = [("(c|cpp):identifier", r"avo(_io)?|std|u?int\d+_t|size_t|byte"), ("py:.*", ".*")]
toc_object_entries = False  # they would make contents long, and slow

myst_heading_anchors = 4  # as GitHub names them

# breathe
xml = {"avo": ROOT / "build/manual/cpp/xml", "avo_c": ROOT / "build/manual/c/xml"}
avo_entities, breathe_projects = [], {}
for project, folder in xml.items():
    found = entities(folder, project)
    avo_entities += found
    breathe_projects |= split(folder, found) if project == "avo" else {entity.file: str(folder) for entity in found}
breathe_default_project = "include/avo/planner.h"
breathe_domain_by_file_pattern = {"*/avo_c/*": "c"}
breathe_show_include = False

smartquotes = False  # v' is a prime
highlight_language = "none"  # of what names none, formulas for the most part

html_theme = "furo"
html_title = "avo"
html_static_path = ["static"]
html_css_files = ["avo.css"]
html_additional_pages = {"index": "to_contents.html"}
templates_path = ["static"]
html_copy_source = False
html_show_copyright = False


# What a tree may lack: the contents go without it.
OPTIONAL = {"reference/c": "bindings/c/include/avo_c/avo.h", "reference/python": "bindings/python",
            "../c": "docs/c.md", "../python": "docs/python.md", "../packages": "docs/packages.md"}
absent = [name for name, source in OPTIONAL.items() if not (ROOT / source).exists()]
exclude_patterns += [f"docs/manual/{name}.rst" for name in absent]


def without_absent(app, name, source):
    if name == root_doc:
        source[0] = "\n".join(line for line in source[0].splitlines() if line not in absent)
    for guide in ("c", "python"):
        if f"../{guide}" in absent:
            source[0] = source[0].replace(f":doc:`docs/{guide}.md </docs/{guide}>` is its guide.", "")


def setup(app):
    app.connect("source-read", without_absent)
