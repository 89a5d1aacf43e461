#!/usr/bin/env python3
"""Checks what the documents of ROOT say.

  check_documents.py links ROOT                  links and anchors resolve, code has a language that is known
  check_documents.py commands ROOT EDVO          EDVO's own parser accepts every command line of its own
  check_documents.py run ROOT EDVO PAGE MODULES  the blocks of PAGE run, in order, in an empty folder

In `run`, blocks of sh and python are run unless a comment `<!-- not run: REASON -->` stands above them. A block of
text right after one that ran is what it prints, lines left out; `...` stands for any rest of a line, and fractions
may differ by a quarter, for other compilers and libraries. MODULES is the folder of the Python module.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/site"))
import command_lines  # noqa: E402
import documents  # noqa: E402

GUIDE = "docs/guide/"
LANGUAGES = {"sh", "python", "text", "toml", "cmake", "yaml"}
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def check_links(root):
    faults = []
    anchors = {path: documents.anchors(path.read_text()) for path in documents.pages(root)}
    for page in anchors:
        name, text = page.relative_to(root), page.read_text()
        for link in documents.links(text):
            path, _, anchor = link.target.partition("#")
            if re.match(r"^(https?|mailto):", link.target):
                continue
            target = pathlib.Path(os.path.normpath(page.parent / path)) if path else page
            if not target.is_relative_to(root) or not target.exists():
                faults.append(f"{name}:{link.line}: {link.target} does not exist")
            elif anchor and anchor not in anchors.get(target, set()):
                faults.append(f"{name}:{link.line}: {link.target}: there is no heading #{anchor}")
        for block in documents.code_blocks(text):
            if str(name).startswith(GUIDE) and block.language not in LANGUAGES:
                faults.append(f"{name}:{block.line}: a block of {block.language or 'no language'}, "
                              f"expected one of {', '.join(sorted(LANGUAGES))}")
    return faults


def check_commands(root, program):
    faults = []
    options = command_lines.options_of_commands(
        subprocess.run([program, "manual", "--format", "markdown"], check=True, capture_output=True, text=True).stdout)
    seen = {}
    for page in documents.pages(root):
        name = page.relative_to(root)
        blocks = documents.code_blocks(page.read_text())
        for block, after in zip(blocks, [*blocks[1:], None]):
            is_refused = after and after.language == "text" and "exit code 2\n" in after.text  # what `run` holds it to
            if block.language in ("", "sh", "yaml") and not is_refused:
                for words in command_lines.commands(block.text):
                    key = tuple(words)
                    if key not in seen:
                        seen[key] = refusal(program, words)
                    if seen[key]:
                        faults.append(f"{name}:{block.line}: edvo {' '.join(words)}: {seen[key]}")
        if name.name != "CHANGELOG.md":  # it names what is gone, too
            faults += [f"{name}:{line}: {fault}" for line, fault in
                       command_lines.unknown_in_spans(page.read_text(), options)]
    print(f"{len(seen)} different command lines")
    return faults


def refusal(program, words):
    """What the program says of a command line that it does not accept; its inputs do not exist."""
    with tempfile.TemporaryDirectory() as folder:
        limited = ["bash", "-c", 'ulimit -t 2; exec "$@"', "bash", program, *words]
        result = subprocess.run(limited, cwd=folder, env=os.environ | {"XDG_CACHE_HOME": folder}, text=True,
                                stdin=subprocess.DEVNULL, capture_output=True)
    return (result.stderr.strip() or "exit code 2").splitlines()[0] if result.returncode == 2 else ""


def run_page(root, program, page, modules):
    """Runs a page's blocks; returns faults, the first of which ends the page."""
    path = root / page
    blocks = documents.code_blocks(path.read_text())
    prose = path.read_text().split("\n")
    ran = 0
    with tempfile.TemporaryDirectory() as folder:
        environment = prepare_folder(root, program, modules, pathlib.Path(folder))
        for i, block in enumerate(blocks):
            if block.language not in ("sh", "python") or block.not_run:
                continue
            command = (["bash", "-euo", "pipefail", "-c", block.text] if block.language == "sh" else
                       [sys.executable, "-c", block.text])
            result = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            ran += 1
            if result.returncode != 0:
                return [f"{page}:{block.line}: exit code {result.returncode}:\n{block.text}{result.stdout}"]
            after = blocks[i + 1] if i + 1 < len(blocks) else None
            if after and after.language == "text" and follows(prose, block, after):
                missing = missing_line(after.text.splitlines(), result.stdout.splitlines())
                if missing is not None:
                    return [f"{page}:{after.line}: the block above did not print\n{missing}\nbut\n{result.stdout}"]
    print(f"{page}: {ran} of {len(blocks)} blocks ran")
    return []


def prepare_folder(root, program, modules, folder):
    """Makes a folder look like the repository's after it was built; returns the environment to run in."""
    for name in ("assets", "docs", "scenarios", "tests", "tools"):
        (folder / name).symlink_to(root / name)
    return os.environ | {"PATH": f"{pathlib.Path(program).parent}:{os.environ['PATH']}",
                         "PYTHONPATH": str(pathlib.Path(modules).resolve()), "XDG_CACHE_HOME": str(folder / ".cache"),
                         "MPLBACKEND": "Agg", "HOME": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}


def follows(prose, block, after):
    """Whether nothing but empty lines and fences stands between two blocks."""
    between = prose[block.line - 1 + len(block.text.splitlines()):after.line - 1]
    return all(not line.strip() or documents.FENCE.match(line) for line in between)


def missing_line(expected, printed):
    """Returns the first expected line that was not printed after those before it, else None."""
    place = 0
    for line in expected:
        if line.strip() in ("", "..."):
            continue
        while place < len(printed) and not same_line(line, printed[place]):
            place += 1
        if place == len(printed):
            return line
        place += 1
    return None


def same_line(expected, printed):
    words = [re.escape(part) for part in NUMBER.sub("\0", " ".join(expected.split())).split("\0")]
    pattern = re.sub(r"(\\ )?\\\.\\\.\\\.(\\ )?", ".*?", f"({NUMBER.pattern})".join(words))
    match = re.fullmatch(pattern, " ".join(printed.split()))
    numbers = NUMBER.findall(expected)
    return match is not None and all(near(a, b) for a, b in zip(numbers, match.groups()))


def near(expected, printed):
    if "." not in expected and abs(int(float(expected))) < 100:
        return expected == printed
    a, b = float(expected), float(printed)
    return abs(a - b) <= 0.25 * max(abs(a), abs(b))


def main(kind, root, *arguments):
    root = pathlib.Path(root).resolve()
    if arguments:
        arguments = (str(pathlib.Path(arguments[0]).resolve(strict=True)), *arguments[1:])
    faults = {"links": check_links, "commands": check_commands, "run": run_page}[kind](root, *arguments)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) - 1 != {"links": 2, "commands": 3, "run": 5}.get(sys.argv[1] if len(sys.argv) > 1 else "", 0):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
