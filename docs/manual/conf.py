# SPDX-License-Identifier: Apache-2.0
# The sources are the documents of the repository, where they are: Sphinx runs in its root, so that
# links between them are the same here and wherever Markdown is shown. See scripts/manual.
import gc
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from generated import ROOT
from headers import entities, split

gc.disable()  # a build is short, and a third of it would go into looking for cycles

project = "avo"
author = "the authors of avo"
extensions = ["myst_parser", "breathe", "avo_manual"]
root_doc = "docs/manual/index"
include_patterns = ["*.md", "bench/*.md", "docs/**"]
exclude_patterns = [".*", "build*", "apps", "figures", "io", "scenarios", "scripts", "src", "tests"]
nitpicky = True
nitpick_ignore_regex = [("(c|cpp):identifier", r"avo(_io|::space)?|std|u?int\d+_t|size_t|byte"), ("py:.*", ".*")]
suppress_warnings = ["ref.python"]  # names that avo and avo.space both have
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
