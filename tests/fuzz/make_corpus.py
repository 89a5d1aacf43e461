#!/usr/bin/env python3
"""make_corpus.py OUT FOLDER...: glTF files of the folders, each with its buffers inside, as seeds."""

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


def main(out, folders):
    out.mkdir(parents=True, exist_ok=True)
    for folder in folders:
        for path in sorted(folder.rglob("*.gl*")):
            if path.suffix in (".gltf", ".glb"):
                seed = embedded(path)
                if len(seed) <= MOST_BYTES:
                    (out / hashlib.sha256(seed).hexdigest()[:16]).write_bytes(seed)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), [pathlib.Path(folder) for folder in sys.argv[2:]])
