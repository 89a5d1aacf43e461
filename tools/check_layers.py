#!/usr/bin/env python3
"""Holds every folder to the folders that it may include, and prints what they are.

A folder's CMakeLists.txt calls edvo_module(USES ...) with the folders whose headers it includes. It is
an error if a file includes another folder's header that is not named there, if a folder is named whose
headers nothing includes, if the folders include each other in a cycle, or if a header of a library is
included outside the files that hide it. CONVENTIONS.md has the table of folders that --write makes.
"""

import argparse
import collections
import pathlib
import re
import sys

TOPS = ("vo", "synth", "tools")
MOST_FILES = 27  # a folder with more holds more than one idea
TABLE_BEGIN, TABLE_END = "<!-- folders -->\n", "\n<!-- end of folders -->"

ONLY_IN = {  # header of a library: the files that may name it
    "embree3/": ["synth/ray_tracing/embree_"],
    "GL/": ["synth/rasterization/gl_"],
    "EGL/": ["synth/rasterization/gl_context.cpp"],
    "tiny_gltf.h": ["synth/gltf_model/", "synth/gltf_materials/", "synth/gltf/"],
    "draco/": ["synth/gltf_model/draco.cpp"],
    "meshoptimizer.h": ["synth/gltf_model/meshopt.cpp"],
    "openexr.h": ["synth/environment/exr.cpp"],
    "toml++/": ["vo/text_files/toml_file.cpp"],
    "png.h": ["vo/image_files/png.cpp"],
    "turbojpeg.h": ["vo/image_files/jpeg_codec.cpp"],
    "xxhash.h": ["vo/hashing/content_hash.cpp"],
    "zlib.h": ["vo/archives/gzip.cpp", "vo/archives/crc32.cpp"],
    "lz4": ["vo/recording_files/compression.cpp"],
    "zstd.h": ["vo/recording_files/compression.cpp"],
    "bzlib.h": ["vo/recording_files/compression.cpp"],
    "webp/": ["tools/pictures/webp.cpp"],
    "httplib.h": ["tools/live/http/"],
    "CLI/": ["tools/cli/", "tools/commands/", "tools/edvo.cpp"],
    "opencv2/videoio": ["vo/videos/opencv/"],
    "opencv2/rgbd": ["tools/bench/peers/opencv_peer.cpp"],
    "boost/": ["tools/statistics/significance.cpp"],
    "ceres/": [],
}


def declared_uses(folder):
    """The folders that edvo_module(USES ...) names, or None for a folder that is no module."""
    lists = folder / "CMakeLists.txt"
    text = lists.read_text() if lists.exists() else ""
    call = re.search(r"^edvo_module\(([^)]*)\)", text, re.M)
    if not call:
        return None
    words = call[1].split()
    uses = []
    if "USES" in words:
        for word in words[words.index("USES") + 1:]:
            if word in ("PUBLIC", "PRIVATE"):
                break
            uses.append(word)
    return uses


def description(folder):
    text = (folder / "CMakeLists.txt").read_text()
    lines = re.match(r"((?:#.*\n)+)", text)
    return " ".join(line.lstrip("# ") for line in lines[1].splitlines()) if lines else ""


def sources_of(root, folder):
    return sorted(p for p in (root / folder).iterdir() if p.suffix in (".h", ".cpp"))


def folders_below(root):
    found = []
    for top in TOPS:
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                name = path.parent.relative_to(root).as_posix()
                if name not in found:
                    found.append(name)
    return found


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'#include ["<](.+)[">]', line)
        if match:
            yield number, match[1]


def module_of(folder, modules):
    """A subfolder without a CMakeLists.txt of its own belongs to the module around it."""
    while folder and folder not in modules:
        folder = folder.rpartition("/")[0]
    return folder


def check_includes(root, modules):
    problems = []
    used = collections.defaultdict(set)
    for folder in folders_below(root):
        own = module_of(folder, modules)
        for path in sources_of(root, folder):
            source = path.relative_to(root).as_posix()
            for number, included in includes(path):
                other = module_of(included.rpartition("/")[0], modules)
                if other and other != own:
                    used[own].add(other)
                    if own and other not in modules[own]:
                        problems.append(f"{source}:{number}: {own} may not include {included}")
                for header, places in ONLY_IN.items():
                    if included.startswith(header) and not source.startswith(tuple(places)):
                        problems.append(f"{source}:{number}: {included} may only be included in "
                                        f"{', '.join(places) or 'tests'}")
    for name, uses in modules.items():
        for other in uses:
            if other not in modules:
                problems.append(f"{name}/CMakeLists.txt: uses {other}, which is no module")
            elif other not in used[name]:
                problems.append(f"{name}/CMakeLists.txt: uses {other} but includes none of its headers")
    return problems


def check_order(modules):
    """Each module in an order in which it uses only those before it; what is left is a cycle."""
    placed, left = set(), dict(modules)
    while True:
        ready = [name for name, uses in left.items() if all(u in placed or u not in modules for u in uses)]
        if not ready:
            break
        placed.update(ready)
        for name in ready:
            del left[name]
    if not left:
        return []
    start = next(iter(left))
    cycle = [start]
    while True:
        following = next(u for u in left[cycle[-1]] if u in left)
        if following in cycle:
            cycle = cycle[cycle.index(following):] + [following]
            return [f"folders use each other in a cycle: {' -> '.join(cycle)}"]
        cycle.append(following)


def check_sizes(root, modules):
    return [f"{name}: holds {len(files)} files, expected at most {MOST_FILES}"
            for name in modules if len(files := sources_of(root, name)) > MOST_FILES]


def in_order(modules):
    """The modules, each after those that it uses; by name where nothing else decides."""
    ordered = []
    while len(ordered) < len(modules):
        ready = [name for name in modules
                 if name not in ordered and all(u in ordered for u in modules[name])]
        top = min(TOPS.index(name.partition("/")[0]) for name in ready)
        ordered += [name for name in ready if TOPS.index(name.partition("/")[0]) == top]
    return ordered


def table(root, modules):
    lines = ["| folder | what | files | lines | target | may include |", "|---|---|---:|---:|---|---|"]
    for name in in_order(modules):
        files = sources_of(root, name)
        count = sum(len(f.read_text().splitlines()) for f in files)
        lines.append(f"| `{name}` | {description(root / name)} | {len(files)} | {count} | "
                     f"`{name.replace('/', '_')}` | {', '.join(modules[name])} |")
    return lines


def document_parts(document):
    """The text before, of, and after the table between the two marks of a document."""
    text = document.read_text()
    begin, end = text.index(TABLE_BEGIN) + len(TABLE_BEGIN), text.index(TABLE_END)
    return text[:begin], text[begin:end].strip().splitlines(), text[end:]


def without_counts(line):
    return [cell for i, cell in enumerate(line.split("|")) if i not in (3, 4)]


def check_table(document, root, modules):
    """Lines and files may grow between two writings of the table; the rest must be as it is."""
    written = [without_counts(line) for line in document_parts(document)[1]]
    if written == [without_counts(line) for line in table(root, modules)]:
        return []
    return [f"{document.name}: its table of folders is not as they are; write it anew with "
            f"tools/check_layers.py --write {document.name}"]


def write_table(document, root, modules):
    before, _, after = document_parts(document)
    document.write_text("\n".join([before, *table(root, modules), after]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", nargs="?", default=".", type=pathlib.Path)
    parser.add_argument("--write", metavar="FILE", type=pathlib.Path,
                        help="write the table of folders into a document")
    arguments = parser.parse_args()
    root = arguments.root
    modules = {}
    for folder in folders_below(root):
        uses = declared_uses(root / folder)
        if uses is not None:
            modules[folder] = uses
    problems = check_includes(root, modules) + check_order(modules) + check_sizes(root, modules)
    if not problems and arguments.write:
        write_table(arguments.write, root, modules)
    if not problems:
        problems = check_table(root / "CONVENTIONS.md", root, modules)
    print("\n".join(problems) or f"layers ok: {len(modules)} folders")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
