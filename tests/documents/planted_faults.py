#!/usr/bin/env python3
"""planted_faults.py EDVO: check_documents.py must name each fault planted in a copy of the documents."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parent / "check_documents.py"
PAGE = "docs/guide/page.md"
TEXT = """# A page

See [the other heading](#a-heading), [options](../options.md#the-tracker) and `edvo track --out e.txt`.

## A heading

```sh
edvo help evaluate > help.txt
wc -c < /dev/null
echo 'ate   1.50 m'
```
```text
0
ate   1.40 m
```

<!-- not run: it needs a recording -->
```sh
edvo track recording --out estimate.txt
```

```python
from pathlib import Path

print(Path("help.txt").exists())
```
"""

FAULTS = {  # what is planted: (check, text to replace, its replacement, what the check must say)
    "a link to nothing": ("links", "../options.md#", "../option.md#", "option.md#the-tracker does not exist"),
    "an anchor to nothing": ("links", "#the-tracker", "#the-trackers", "no heading #the-trackers"),
    "an anchor of the page itself": ("links", "#a-heading", "#heading", "no heading #heading"),
    "code of an unknown language": ("links", "```python", "```pyhton", "a block of pyhton"),
    "an option that does not exist": ("commands", "recording --out", "recording --output", "--output"),
    "an option in a sentence": ("commands", "`edvo track --out", "`edvo track --output", "no option --output"),
    "a command that does not exist": ("commands", "edvo track recording", "edvo trak recording", "trak"),
    "a value that does not exist": ("commands", "recording --out", "recording --mode stereo --out", "stereo"),
    "a command that fails": ("run", "edvo help evaluate", "edvo help evaluates", "exit code 2"),
    "a failure within a pipe": ("run", "wc -c < /dev/null", "false | wc -c", "exit code 1"),
    "Python that fails": ("run", "help.txt\").exists", "help.txt\").exist", "AttributeError"),
    "another number": ("run", "ate   1.40 m", "ate   1.00 m", "did not print"),
    "another count": ("run", "\n0\n", "\n1\n", "did not print"),
    "another word": ("run", "ate   1.40 m", "rpe   1.40 m", "did not print"),
    "what needs a recording": ("run", "<!-- not run: it needs a recording -->", "", "exit code 3"),
}


def check(kind, root, program):
    arguments = {"links": [], "commands": [program], "run": [program, PAGE, root]}[kind]
    return subprocess.run([sys.executable, CHECK, kind, root, *arguments], capture_output=True, text=True)


def main(program):
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "edvo"
        (copy / "docs/guide").mkdir(parents=True)
        for name in ("assets", "scenarios", "tests", "tools"):
            (copy / name).mkdir()
        (copy / "docs/options.md").write_text("# Options\n\n## The tracker\n")
        for name, (kind, old, new, expected) in {"nothing": ("", "", "", ""), **FAULTS}.items():
            if old not in TEXT:
                print(f"{name}: cannot be planted, the page lacks {old!r}")
                failures += 1
            (copy / PAGE).write_text(TEXT.replace(old, new, 1))
            for what in [kind] if kind else ["links", "commands", "run"]:
                result = check(what, copy, program)
                if result.returncode != (1 if kind else 0) or expected not in result.stdout:
                    print(f"{name}: exit {result.returncode}, {expected!r} expected in\n{result.stdout}{result.stderr}")
                    failures += 1
        shutil.rmtree(copy)
    return failures


if __name__ == "__main__":
    sys.exit(1 if main(sys.argv[1]) else 0)
