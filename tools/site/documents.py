"""Markdown as this repository writes it: headings and their anchors, links, blocks of code."""

import re
from dataclasses import dataclass

PAGES = ["README.md", "CONTRIBUTING.md", "CONVENTIONS.md", "CHANGELOG.md", "docs/**/*.md", "scenarios/README.md",
         "assets/README.md"]
FENCE = re.compile(r"^( *)(`{3,}|~{3,})\s*([\w-]*)")
HEADING = re.compile(r"^(#{1,6}) +(.*?)(?: +#+)?$")
LINK = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\]\()([^()\s]+)(\))")
NOT_RUN = re.compile(r"^<!-- not run: (.+) -->$")


@dataclass
class CodeBlock:
    language: str  # of the fence, or "" of an indented block
    line: int  # of its first line, from 1
    text: str
    not_run: str = ""  # the reason that a comment above it gives


@dataclass
class Link:
    target: str
    line: int


def split_code(text):
    """Returns the lines of `text` with those of code emptied, and its blocks of code."""
    lines, blocks = text.split("\n"), []
    prose = list(lines)
    reason, i = "", 0
    while i < len(lines):
        fence = FENCE.match(lines[i])
        start = i
        if fence:
            end = next((j for j in range(i + 1, len(lines)) if lines[j].strip().startswith(fence[2])), len(lines))
            content = [line[len(fence[1]):] for line in lines[i + 1:end]]
            blocks.append(CodeBlock(fence[3], i + 2, "\n".join(content) + "\n", reason))
            i = end + 1
        elif is_indented_code(lines, i):
            while i < len(lines) and (lines[i].startswith("    ") or not lines[i].strip()):
                i += 1
            content = [line[4:] for line in lines[start:i]]
            blocks.append(CodeBlock("", start + 1, "\n".join(content).rstrip("\n") + "\n", reason))
        else:
            comment = NOT_RUN.match(lines[i])
            reason = comment[1] if comment else reason if not lines[i].strip() else ""
            i += 1
            continue
        prose[start:i] = [""] * len(prose[start:i])
        reason = ""
    return prose, blocks


def is_indented_code(lines, i):
    """Whether line i begins a block by its indentation: after an empty line, and not as a part of a list."""
    if not lines[i].startswith("    ") or not lines[i].strip() or (i > 0 and lines[i - 1].strip()):
        return False
    before = next((line for line in reversed(lines[:i]) if line.strip() and not line.startswith("    ")), "")
    return not re.match(r"^ {0,3}([-*+]|\d+\.) ", before)


def pages(root):
    """The documents of the repository at ROOT."""
    return [path for pattern in PAGES for path in sorted(root.glob(pattern))]


def code_blocks(text):
    return split_code(text)[1]


def links_of_line(line):
    """Matches of LINK; the text of a link may be a code span, its target is none."""
    return LINK.finditer(re.sub(r"`[^`]*`", lambda span: "x" * len(span[0]), line))


def links(text):
    """The targets of links and pictures outside code."""
    found = []
    for number, line in enumerate(split_code(text)[0], 1):
        for match in links_of_line(line):
            found.append(Link(match[2], number))
    return found


def replace_links(text, new_target):
    """Replaces each target of a link or picture outside code by new_target(target)."""
    lines, prose = text.split("\n"), split_code(text)[0]
    for i, line in enumerate(prose):
        for match in reversed(list(links_of_line(line))):
            lines[i] = lines[i][:match.start(2)] + new_target(match[2]) + lines[i][match.end(2):]
    return "\n".join(lines)


def slug(heading):
    """The anchor of a heading, as forges and the site make it."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    plain = re.sub(r"[`*]", "", plain).strip().lower()
    return re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", plain))


def anchors(text):
    """The anchors of all headings; of equal ones the second has -1."""
    found, seen = set(), {}
    for line in split_code(text)[0]:
        heading = HEADING.match(line)
        if heading:
            name = slug(heading[2])
            found.add(f"{name}-{seen[name]}" if name in seen else name)
            seen[name] = seen.get(name, 0) + 1
    return found
