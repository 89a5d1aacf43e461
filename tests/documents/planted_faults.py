#!/usr/bin/env python3
"""planted_faults.py EDVO: check_documents.py and build_site.py must name each fault planted in documents and in a
site."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import build_site  # noqa: E402

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

SITE = {  # a site that is whole, as far as build_site.py looks
    "index.html": '<img src="theme/a.svg"><a href="commands/track.html#out">edvo track</a>',
    "commands/track.html": '<h1 id="out">edvo track</h1><a href="../index.html">home</a>',
    "docs/guide/how_it_works.html": '<span class="arithmatex">x</span>',
    "api/classvo_1_1RgbdOdometry.html": '<a href="https://www.doxygen.org">doxygen</a>',
    "theme/a.svg": "<svg/>",
    "theme/a.css": "@font-face { src: url(a.woff2); }",
}

SITE_FAULTS = {  # what is planted: (file, text to replace, its replacement, what the check must say)
    "a page that is not there": ("index.html", "commands/track", "commands/trak", "trak.html#out does not exist"),
    "an anchor that is not there": ("index.html", "#out", "#in", "no such anchor"),
    "a picture that is not there": ("index.html", "a.svg", "b.svg", "b.svg does not exist"),
    "a script from elsewhere": ("index.html", "<img", '<script src="https://example.org/x.js"></script><img', "loads https"),
    "a font from elsewhere": ("theme/a.css", "url(a", "url(//example.org/a", "loads something from elsewhere"),
    "Doxygen's script from elsewhere": ("api/classvo_1_1RgbdOdometry.html", "<a", '<script src="//x.org/x.js"></script><a',
                                        "loads something from elsewhere"),
    "no equations": ("docs/guide/how_it_works.html", "arithmatex", "arithmetic", "no equations"),
}


def site_failures():
    failures = 0
    for name, (file, old, new, expected) in {"nothing": ("index.html", "", "", ""), **SITE_FAULTS}.items():
        with tempfile.TemporaryDirectory() as folder:
            for path, text in SITE.items():
                target = pathlib.Path(folder) / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(text.replace(old, new, 1) if path == file else text)
            found = list(build_site.faults_of(pathlib.Path(folder), ["track"]))
            if (len(found) != 1 or expected not in found[0]) if expected else found:
                print(f"{name}: {expected!r} expected, found {found}")
                failures += 1
    return failures


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
    sys.exit(1 if main(sys.argv[1]) + site_failures() else 0)
