#!/usr/bin/env python3
"""Holds the parsers to what they must refuse: planted_faults.py."""

import io
import json
import pathlib
import sys
import tempfile
import zipfile

try:
    import numpy
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

import parsers

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">{}</svg>'
SUITE = '<testsuites><testsuite tests="{}" failures="0" errors="0"><testcase name="a" classname="b" time="0"/></testsuite></testsuites>'
PAGE = '<html><head><title>t</title></head><body>{}<script type="application/json">{}</script></body></html>'



def evo_archive(rmse=5.0, stamps=(1.0, 2.0)):
    """An archive of the errors 1 m and 7 m."""
    stats = {"rmse": rmse, "mean": 4.0, "median": 4.0, "std": 3.0, "min": 1.0, "max": 7.0, "sse": 50.0}
    info = {"title": "t", "label": "l", "ref_name": "a", "est_name": "b"}
    bytes_of = io.BytesIO()
    with zipfile.ZipFile(bytes_of, "w") as archive:
        archive.writestr("info.json", json.dumps(info))
        archive.writestr("stats.json", json.dumps(stats))
        for name, values in (("error_array", (1.0, 7.0)), ("timestamps", stamps)):
            array = io.BytesIO()
            numpy.save(array, numpy.array(values))
            archive.writestr(name + ".npy", array.getvalue())
    return bytes_of.getvalue()


GOOD = {
    "a.json": '{"x": [1, null]}',
    "a.jsonl": '{"schema": "s", "schema_version": 1, "hash": "h"}\n{"key": {}}\n',
    "a.toml": 'a.b = 1\na.c = "x"\n',
    "a.csv": "name,value\nx,1\ny,\n",
    "a.svg": SVG.format("<text>m</text>"),
    "a.xml": SUITE.format(1),
    "a.html": PAGE.format("<p>x</p>", "{}"),
    "a.md": "| a | b |\n|---|---|\n| 1 | 2 |\n",
    "a.zip": evo_archive(),
}
FAULTS = {
    "nan.json": '{"x": NaN}',
    "infinite.json": '{"x": -Infinity}',
    "twice.json": '{"x": 1, "x": 2}',
    "bytes.json": b'{"x": "\xff"}',
    "headless.jsonl": '{"key": {}}\n{"key": {}}\n',
    "cut.jsonl": '{"schema": "s", "schema_version": 1, "hash": "h"}\n',
    "open.jsonl": '{"schema": "s", "schema_version": 1, "hash": "h"}\n{"key": {}}',
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
    "cut.zip": evo_archive()[:-9],
    "damaged.zip": evo_archive().replace(b"NUMPY", b"NUMPI", 1),
    "rmse.zip": evo_archive(rmse=4.0),
    "stamps.zip": evo_archive(stamps=(2.0, 1.0)),
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
