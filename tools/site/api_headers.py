#!/usr/bin/env python3
"""api_headers.py ROOT: prints the headers that are installed, those that the components name and what they include of ours."""

import pathlib
import re
import sys


def api_headers(root):
    cmake = "".join((root / folder / "CMakeLists.txt").read_text() for folder in ("vo", "synth"))
    waiting = " ".join(re.findall(r"\bHEADERS ([^)]*?)(?:\n *PUBLIC|\))", cmake)).split()
    headers = set()
    while waiting:
        header = waiting.pop()
        if header not in headers and (root / header).exists():
            headers.add(header)
            waiting += re.findall(r'^#include "((?:vo|synth)/[^"]*)"', (root / header).read_text(), flags=re.MULTILINE)
    return sorted(headers)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("\n".join(api_headers(pathlib.Path(sys.argv[1]))))
