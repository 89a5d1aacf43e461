#!/usr/bin/env python3
"""Holds truth/labels.json and the images of ids to glTF files: labels_test.py EDVO SOURCE_FOLDER WORK_FOLDER.

One file is written here, of squares in a plane that a camera sees from the front: which node, copy and primitive is in
which pixel is known by construction. The labels of the repository's scenes are held to a second reading of their JSON.

Exits with 77 (skipped) where python3-numpy is not installed.
"""

import json
import pathlib
import shutil
import struct
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
try:
    from png_file import read_png
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

COLUMNS, ROWS, CELL = 4, 3, 24  # cells of 1 x 1 m in the plane z = 0, and a cell's pixels
FORWARD = f"--size {COLUMNS * CELL}x{ROWS * CELL} --intrinsics {CELL * 10},{CELL * 10},{COLUMNS * CELL / 2 - 0.5}," \
          f"{ROWS * CELL / 2 - 0.5} --path still --move.eye 0,0,10 --move.target 0,0,0 --rate 2 --duration 0.5 --samples 1"
CLASSES = """[[class]]
name = "leg"
nodes = ["*/l?g"]
[[class]]
name = "chair"
nodes = ["*chair*"]
materials = []
[[class]]
name = "wood"
materials = ["wo*", "steam"]
[[class]]
name = "tree"
nodes = ["forest", "sofa"]
[[class]]
name = "chair"
materials = ["cloth"]
"""
CLASS_IDS = {"": 0, "leg": 1, "chair": 2, "wood": 3, "tree": 4}
UNMATCHED = ['class tree: no node that is shown matches "sofa"', 'class wood: no material that is shown matches "steam"']

# What is in a cell, by column and row from the top left: path, node, copy, mesh, primitive, material, class.
SHOWN = {
    (0, 0): ("2", 2, None, 1, 1, 4, "chair"),
    (1, 0): ("2", 2, None, 1, 2, None, ""),
    (2, 0): ("table", 1, None, 2, 0, 1, "wood"),
    (3, 0): ("room/forest", 6, 0, 3, 0, 3, "tree"),
    (0, 1): ("room/forest", 6, 1, 3, 0, 3, "tree"),
    (1, 1): ("room/forest", 6, 2, 3, 0, 3, "tree"),
    (2, 1): ("room/chair/5", 5, None, 2, 0, 1, "chair"),
    (3, 1): ("room/chair/seat", 3, None, 0, 0, 2, "chair"),
    (0, 2): ("room/chair/seat/l\u00e9g", 8, None, 0, 0, 2, "leg"),
}
# The order of the ids: the scene's nodes level by level, and the file's index of each material at its first use.
INSTANCES = [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (3, 1), (0, 2)]
MATERIALS = [4, 1, 3, 2, None]


def place(column, row):
    """The centre of a cell, m."""
    return [column - (COLUMNS - 1) / 2, (ROWS - 1) / 2 - row, 0.0]


def between(origin, target):
    return [b - a for a, b in zip(origin, target)]


def squares(folder):
    """A file in which nothing is in the order in which the scene shows it; scene 0 is not the default one."""
    corners = [-0.4, -0.4, 0, 0.4, -0.4, 0, 0.4, 0.4, 0, -0.4, 0.4, 0]
    beside = [value + (1 if i % 3 == 0 else 0) for i, value in enumerate(corners)]
    copies = [value for cell in ((3, 0), (0, 1), (1, 1)) for value in place(*cell)]
    binary = b"".join((struct.pack("<12f", *corners), struct.pack("<12f", *beside), struct.pack("<9f", *copies),
                       struct.pack("<6H", 0, 1, 2, 0, 2, 3)))
    (folder / "squares.bin").write_bytes(binary)
    views = [(0, 48), (48, 48), (96, 36), (132, 12)]
    reach = lambda values: {"min": [min(values[k::3]) for k in range(3)], "max": [max(values[k::3]) for k in range(3)]}
    accessors = [{"type": "VEC3", "componentType": 5126, "count": 4, **reach(corners)},
                 {"type": "VEC3", "componentType": 5126, "count": 4, **reach(beside)},
                 {"type": "VEC3", "componentType": 5126, "count": 3},
                 {"type": "SCALAR", "componentType": 5123, "count": 6}]
    square = lambda position=0, **more: {"attributes": {"POSITION": position}, "indices": 3, **more}
    points = {"attributes": {"POSITION": 0}, "mode": 0}  # which show no triangle and so get no id
    document = {
        "asset": {"version": "2.0"}, "extensionsUsed": ["EXT_mesh_gpu_instancing"], "scene": 1,
        "scenes": [{"name": "other", "nodes": [4]}, {"nodes": [2, 7, 1]}],
        "materials": [{"name": "not used"}, {"name": "wood"}, {"name": "steel"}, {}, {"name": "cloth"}],
        "meshes": [{"name": "steel square", "primitives": [square(material=2)]},
                   {"name": "two", "primitives": [points, square(material=4), square(1)]},
                   {"primitives": [square(material=1)]},
                   {"name": "plain", "primitives": [square(material=3)]},
                   {"name": "not shown", "primitives": [square(material=0)]}],
        "nodes": [{"name": "chair", "children": [5, 3]},
                  {"name": "table", "mesh": 2, "translation": place(2, 0)},
                  {"mesh": 1, "translation": place(0, 0)},
                  {"name": "seat", "mesh": 0, "children": [8], "translation": place(3, 1)},
                  {"name": "elsewhere", "mesh": 3},
                  {"mesh": 2, "translation": place(2, 1)},
                  {"name": "forest", "mesh": 3,
                   "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}},
                  {"name": "room", "children": [0, 6]},
                  {"name": "l\u00e9g", "mesh": 0, "translation": between(place(3, 1), place(0, 2))}],
        "buffers": [{"uri": "squares.bin", "byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteOffset": begin, "byteLength": length} for begin, length in views],
        "accessors": [{"bufferView": i, **accessor} for i, accessor in enumerate(accessors)]}
    path = folder / "squares.gltf"
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


def second_reading(path, scene=None):
    """The labels of a file by its JSON alone, as (path, node, copy, mesh, primitive, material) of each instance, for
    files whose instancing has a TRANSLATION."""
    file = json.loads(path.read_text(encoding="utf-8"))
    nodes = file["nodes"]
    level = [(node, "") for node in file["scenes"][file.get("scene", 0) if scene is None else scene]["nodes"]]
    shown = []
    while level:
        below = []
        for index, above in level:
            node = nodes[index]
            path_of_node = above + (node.get("name") or str(index))
            below += [(child, path_of_node + "/") for child in node.get("children", [])]
            if "mesh" not in node:
                continue
            instancing = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
            count = file["accessors"][instancing["attributes"]["TRANSLATION"]]["count"] if instancing else 1
            shown += [(path_of_node, index, copy if instancing else None, node["mesh"], i, primitive.get("material"))
                      for copy in range(count)
                      for i, primitive in enumerate(file["meshes"][node["mesh"]]["primitives"])
                      if primitive.get("mode", 4) >= 4]
        level = below
    return shown


def names_of(elements):
    return [element.get("name", "") for element in elements]


def check_labels(labels, gltf, scene=None):
    """Holds labels to a second reading of their file."""
    file = json.loads(gltf.read_text(encoding="utf-8"))
    expected = second_reading(gltf, scene)
    materials = list(dict.fromkeys(one[5] for one in expected if one[5] is not None)) + [None]
    assert labels["files"] == [gltf.name]
    assert all(one["file"] == 0 for one in labels["instances"] + labels["materials"][:-1])
    assert [one["material"] for one in labels["materials"]] == materials
    assert [one["id"] for one in labels["materials"]] == list(range(1, len(materials) + 1))
    names = names_of(file.get("materials", []))
    assert [one["name"] for one in labels["materials"]] == ["" if m is None else names[m] for m in materials]
    assert [one["id"] for one in labels["instances"]] == list(range(1, len(expected) + 1))
    found = [(one["path"], one["node"], one["copy"], one["mesh"], one["primitive"], materials[one["material_id"] - 1])
             for one in labels["instances"]]
    assert found == expected, f"{found} is not {expected}"
    mesh_names = names_of(file["meshes"])
    assert [one["mesh_name"] for one in labels["instances"]] == [mesh_names[one[3]] for one in expected]


class Program:
    def __init__(self, program, work):
        self.program, self.work = program, work

    def run(self, words, exit_code=0):
        done = subprocess.run([self.program, *words.split()], cwd=self.work, capture_output=True, text=True, check=False)
        assert done.returncode == exit_code, f"edvo {words}: exit code {done.returncode}: {done.stderr}"
        return done.stderr

    def labels(self, folder):
        return json.loads((self.work / folder / "truth/labels.json").read_text(encoding="utf-8"))


def check_squares(edvo):
    gltf = squares(edvo.work)
    (edvo.work / "classes.toml").write_text(CLASSES, encoding="utf-8")
    err = edvo.run(f"render squares.gltf {FORWARD} --channels instance,material,class --classes classes.toml --out squares")
    notes = [line.split("note: ")[1] for line in err.splitlines() if "note: class" in line]
    assert sorted(notes) == UNMATCHED, err
    labels = edvo.labels("squares")
    check_labels(labels, gltf)
    assert labels["classes"] == [{"id": i, "name": name} for name, i in CLASS_IDS.items() if i]
    assert [one["class_id"] for one in labels["materials"]] == [CLASS_IDS["chair"], CLASS_IDS["wood"], 0, 0, 0]
    image = {channel: read_png(edvo.work / f"squares/truth/{channel}/000000.png")
             for channel in ("instance", "material", "class")}
    for row in range(ROWS):
        for column in range(COLUMNS):
            pixel = (row * CELL + CELL // 2, column * CELL + CELL // 2)
            ids = tuple(int(image[channel][pixel]) for channel in ("instance", "material", "class"))
            if (column, row) not in SHOWN:
                assert ids == (0, 0, 0), (column, row, ids)
                continue
            *what, class_name = SHOWN[column, row]
            assert ids == (INSTANCES.index((column, row)) + 1, MATERIALS.index(what[5]) + 1,
                           CLASS_IDS[class_name]), (column, row, ids)
            label = labels["instances"][ids[0] - 1]
            assert [label[key] for key in ("path", "node", "copy", "mesh", "primitive")] == what[:5], label
            assert label["material_id"] == ids[1] and label["class_id"] == ids[2], label
    assert all(int(one[0, 0]) == 0 for one in image.values()), "between the squares"


def check_other_scene(edvo):
    edvo.run(f"render squares.gltf {FORWARD} --scene other --channels instance --out other")
    check_labels(edvo.labels("other"), edvo.work / "squares.gltf", scene=0)
    assert (edvo.work / "other/truth/instance/000000.png").exists()
    assert not (edvo.work / "other/truth/class").exists()


def check_bytes(edvo):
    """Labels and classes are the same on any number of threads; `all` is what it was, without classes."""
    words = f"render squares.gltf {FORWARD} --channels all,class --classes classes.toml"
    edvo.run(f"{words} --out one --threads 1")
    edvo.run(f"{words} --out two --threads 2")
    files = sorted(path.relative_to(edvo.work / "one") for path in (edvo.work / "one").rglob("*") if path.is_file())
    assert pathlib.Path("truth/class/000000.png") in files and pathlib.Path("truth/labels.json") in files
    for path in files:
        assert (edvo.work / "one" / path).read_bytes() == (edvo.work / "two" / path).read_bytes(), path
    edvo.run(f"render squares.gltf {FORWARD} --channels all --out all")
    assert "truth.class" not in (edvo.work / "all/sequence.toml").read_text(encoding="utf-8")
    assert not (edvo.work / "all/truth/class").exists()
    edvo.run(f"render squares.gltf {FORWARD} --channels depth --out depth")
    assert not (edvo.work / "depth/truth/labels.json").exists()


def check_conversion(edvo):
    edvo.run("convert squares tum --format tum")
    for name in ("labels.json", "class/000000.png"):
        assert (edvo.work / "tum/truth" / name).read_bytes() == (edvo.work / "squares/truth" / name).read_bytes()


def check_bad_input(edvo):
    def refusal(text, exit_code=3, channels="class"):
        (edvo.work / "bad.toml").write_text(text, encoding="utf-8")
        err = edvo.run(f"render squares.gltf {FORWARD} --channels {channels} --classes bad.toml --out bad", exit_code)
        assert not (edvo.work / "bad").exists()
        return err

    assert "bad.toml:2: unknown key 'class.0.node.0'" in refusal('[[class]]\nnode = ["a"]\n')
    assert "bad.toml:3: class.0.nodes: expected an array of texts" in refusal('[[class]]\nname = "a"\nnodes = "b"\n')
    assert "bad.toml:2: class.0.name: expected a text in quotes" in refusal('[[class]]\nname = 3\nnodes = ["b"]\n')
    assert "bad.toml:2: class a: expected patterns of nodes or materials" in refusal('[[class]]\nname = "a"\n')
    assert "bad.toml:2: class: expected a name" in refusal('[[class]]\nnodes = ["b"]\n')
    assert "bad.toml:2: class.name: expected tables [[class]]" in refusal('[class]\nname = "a"\n')
    assert "class: is an empty table" in refusal("[[class]]\n")
    assert "bad.toml:1: unknown key 'size'" in refusal('size = 3\n[[class]]\nname = "a"\nnodes = ["b"]\n')
    assert "bad.toml: expected a table [[class]]" in refusal("\n")
    assert "--classes: expected --channels with class" in refusal(CLASSES, 2, "depth")
    err = edvo.run(f"render squares.gltf {FORWARD} --channels class --out bad", 2)
    assert "channels: class: there are no classes" in err, err


def check_repository(edvo, source):
    """The labels of every scene of the repository."""
    scenes = sorted(source.glob("assets/*/*.gltf"))
    assert scenes
    for gltf in scenes:
        edvo.run(f"render {gltf} --size 8x6 --path still --move.eye 0,1,0 --move.target 0,1,-1 --rate 1 --duration 1 "
                 f"--samples 1 --channels instance,material --out {gltf.stem}")
        check_labels(edvo.labels(gltf.stem), gltf)


def main():
    program, source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    edvo = Program(program, work)
    check_squares(edvo)
    check_other_scene(edvo)
    check_bytes(edvo)
    check_conversion(edvo)
    check_bad_input(edvo)
    check_repository(edvo, source)
    return 0


if __name__ == "__main__":
    sys.exit(main())
