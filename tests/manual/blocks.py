# SPDX-License-Identifier: Apache-2.0
"""The blocks of code of a Markdown document, with the marks in comments before them."""
import dataclasses
import re

FENCE = re.compile(r"^(?P<indent> *)```(?P<language>\S*)\s*$")
MARK = re.compile(r"^ *<!-- (?P<name>file|frame|first|exits|prints|not run)(?:: (?P<value>.*?))? -->$")


@dataclasses.dataclass
class Block:
    line: int  # of its first line of code
    language: str
    text: str
    marks: dict


def blocks(path):
    found, marks, block, indent = [], {}, None, ""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        fence, mark = FENCE.match(line), MARK.match(line)
        if block is not None and fence and not fence["language"]:
            found.append(block)
            block, marks = None, {}
        elif block is not None:
            block.text += line.removeprefix(indent) + "\n"
        elif fence:
            joined = {name: "\n".join(values) for name, values in marks.items()}
            block, indent = Block(number + 1, fence["language"], "", joined), fence["indent"]
        elif mark:
            marks.setdefault(mark["name"], []).append(mark["value"] or "")
        elif line.strip():
            assert not marks, f"{path}:{number}: no block follows the mark {marks}"
    assert block is None, f"{path}: a block without an end"
    return found
