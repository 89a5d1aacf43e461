#!/usr/bin/env python3
"""Holds the parsers to what they must refuse: planted_faults.py."""

import pathlib
import sys
import tempfile

import parsers

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">{}</svg>'
SUITE = '<testsuites><testsuite tests="{}" failures="0" errors="0"><testcase name="a" classname="b" time="0"/></testsuite></testsuites>'
PAGE = '<html><head><title>t</title></head><body>{}<script type="application/json">{}</script></body></html>'

GOOD = {
    "a.json": '{"x": [1, null]}',
    "a.toml": 'a.b = 1\na.c = "x"\n',
    "a.csv": "name,value\nx,1\ny,\n",
    "a.svg": SVG.format("<text>m</text>"),
    "a.xml": SUITE.format(1),
    "a.html": PAGE.format("<p>x</p>", "{}"),
    "a.md": "| a | b |\n|---|---|\n| 1 | 2 |\n",
}
FAULTS = {
    "nan.json": '{"x": NaN}',
    "infinite.json": '{"x": -Infinity}',
    "twice.json": '{"x": 1, "x": 2}',
    "bytes.json": b'{"x": "\xff"}',
    "twice.toml": 'hash.imu = "1"\nhash.imu = "2"\n',
    "fields.csv": "name,value\nx,1,2\n",
    "headless.csv": "1,2\n3,4\n",
    "mixed.csv": "value\n1\nx\n",
    "nan.csv": "value\nnan\nnan\n",
    "names.csv": "value,value\n1,2\n",
    "open.svg": SVG.format("<text>m</text><g>"),
    "boxless.svg": '<svg xmlns="http://www.w3.org/2000/svg"><text>m</text></svg>',
    "nan.svg": SVG.format('<text>m</text><path d="M 0 nan"/>'),
    "mute.svg": SVG.format(""),
    "count.xml": SUITE.format(2),
    "raw.xml": SUITE.format(1).replace('name="a"', 'name="a<b"'),
    "order.html": PAGE.format("<p><b>x</p></b>", "{}"),
    "nan.html": PAGE.format("", '{"x": NaN}'),
    "picture.md": "![x](nowhere.svg)\n",
    "cells.md": "| a | b |\n|---|---|\n| 1 |\n",
    "a.unknown": "",
}


def is_refused(folder, name, content):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    try:
        parsers.parse(path)
    except Exception:  # any parser's own kind
        return True
    return False


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        wrong = [f"{name} was refused" for name, content in GOOD.items() if is_refused(folder, name, content)]
        wrong += [f"{name} was taken" for name, content in FAULTS.items() if not is_refused(folder, name, content)]
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
