#!/usr/bin/env python3
"""make_corpus.py OUT FOLDER...: files of the repository as seeds, OUT/FUZZER/NAME.

glTF files of the folders, each with its buffers inside; scenarios; the first results of the baseline.
"""

import base64
import hashlib
import json
import pathlib
import sys
import urllib.parse

MOST_BYTES = 65536


def embedded(path):
    """The file with its external buffers and images as data URIs; as it is if that makes no sense."""
    content = path.read_bytes()
    if path.suffix != ".gltf":
        return content
    try:
        document = json.loads(content)
        for key, kind in (("buffers", "application/octet-stream"), ("images", "image/png")):
            for element in document.get(key, []):
                file = path.parent / urllib.parse.unquote(element["uri"])
                data = base64.b64encode(file.read_bytes()[:MOST_BYTES]).decode()
                element["uri"] = f"data:{kind};base64,{data}"
    except (AttributeError, KeyError, OSError, TypeError, ValueError):
        return content
    return json.dumps(document).encode()


def add(out, fuzzer, content):
    """Writes a seed under the hash of what it holds."""
    (out / fuzzer).mkdir(parents=True, exist_ok=True)
    (out / fuzzer / hashlib.sha256(content).hexdigest()[:16]).write_bytes(content)


def add_results(out, baseline):
    """One scenario of a baseline, with one trial and with all."""
    document = json.loads(baseline.read_text())
    document["scenarios"] = document["scenarios"][:1]
    add(out, "results", json.dumps(document).encode())
    for scenario in document["scenarios"]:
        scenario["trials"] = scenario["trials"][:1]
    add(out, "results", json.dumps(document).encode())


def main(out, folders):
    for path in sorted(pathlib.Path("scenarios").glob("*.toml")):
        add(out, "scenario", path.read_bytes())
        add(out, "toml", path.read_bytes())
    add_results(out, pathlib.Path("scenarios/baseline.json"))
    for folder in folders:
        for path in sorted(folder.rglob("*.gl*")):
            if path.suffix in (".gltf", ".glb"):
                seed = embedded(path)
                if len(seed) <= MOST_BYTES:
                    add(out, "gltf", seed)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), [pathlib.Path(folder) for folder in sys.argv[2:]])
