#!/usr/bin/env python3
"""Fails when a source file includes a layer that its own layer may not know."""

import pathlib
import re
import sys

MAY_INCLUDE = {  # layer: what it may include beside itself
    "vo/core": [],
    "vo/io": ["vo/core"],
    "vo/image": ["vo/core"],
    "vo/tracking": ["vo/core", "vo/image"],
    "vo/mapping": ["vo/core", "vo/image"],
    "vo/evaluation": ["vo/core"],
    "vo": ["vo/core", "vo/image", "vo/mapping", "vo/tracking"],
    "synth": ["vo/core", "vo/io"],
    "tools": ["vo", "vo/core", "vo/io", "vo/image", "vo/mapping", "vo/tracking",
              "vo/evaluation", "synth"],
}

ONLY_IN = {  # third-party header: the files that may name it
    "embree3/": ["synth/embree_scene"],
    "GL/": ["synth/gl_"],
    "EGL/": ["synth/gl_context.cpp"],
    "tiny_gltf.h": ["synth/gltf"],
    "draco/": ["synth/gltf_draco.cpp"],
    "meshoptimizer.h": ["synth/gltf_meshopt.cpp"],
    "toml++/": ["vo/io/toml_file.cpp"],
    "png.h": ["vo/io/png.cpp"],
    "turbojpeg.h": ["synth/jpeg_codec.cpp"],
    "zlib.h": ["vo/io/gzip.cpp"],
    "webp/": ["tools/report/webp.cpp"],
    "CLI/": ["tools/"],
    "opencv2/rgbd": ["tools/bench/opencv_peer.cpp"],
    "ceres/": [],
}


def layer_of(path):
    return max((layer for layer in MAY_INCLUDE if path.startswith(layer + "/")), key=len, default=None)


def violation(source, included):
    own, other = layer_of(source), layer_of(included)
    if other and other != own and other not in MAY_INCLUDE[own]:
        return f"{own} may not include {included}"
    for header, places in ONLY_IN.items():
        if included.startswith(header) and not source.startswith(tuple(places)):
            return f"{included} may only be included in {', '.join(places) or 'tests'}"
    return None


def main(root):
    violations = []
    for top in ("vo", "synth", "tools"):
        for path in sorted((root / top).rglob("*.[hc]*")):
            source = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text().splitlines(), 1):
                include = re.match(r'#include ["<](.+)[">]', line)
                problem = include and violation(source, include[1])
                if problem:
                    violations.append(f"{source}:{number}: {problem}")
    print("\n".join(violations) or "layers ok")
    return bool(violations)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
