#!/usr/bin/env python3
"""Writes OUT/scene.gltf: COUNT nodes that share a mesh of 5120 triangles, a floor and a lamp.

usage: make_copies.py OUT COUNT"""
import json
import math
import pathlib
import struct
import sys

ROWS, COLUMNS = 32, 80
SPACING = 2.5  # m
FLOAT, UNSIGNED_INT = 5126, 5125


class Buffer:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, values, kind, component=FLOAT):
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[kind]
        data = struct.pack(f"<{len(values)}{'f' if component == FLOAT else 'I'}", *values)
        self.views.append(
            {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        accessor = {"bufferView": len(self.views) - 1, "componentType": component,
                    "count": len(values) // width, "type": kind}
        if kind == "VEC3":
            stored = struct.unpack(f"<{len(values)}f", data)
            accessor["min"] = [min(stored[axis::3]) for axis in range(3)]
            accessor["max"] = [max(stored[axis::3]) for axis in range(3)]
        self.bytes += data
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def add_ball(buffer):
    """A bumpy ball."""
    positions, normals, triangles = [], [], []
    for row in range(ROWS + 1):
        theta = math.pi * row / ROWS
        for column in range(COLUMNS + 1):
            phi = 2 * math.pi * column / COLUMNS
            normal = (math.sin(theta) * math.cos(phi), math.cos(theta),
                      math.sin(theta) * math.sin(phi))
            radius = 1 + 0.1 * math.sin(5 * theta) * math.sin(7 * phi)
            positions += [radius * x for x in normal]
            normals += normal
    for row in range(ROWS):
        for column in range(COLUMNS):
            a = row * (COLUMNS + 1) + column
            b = a + COLUMNS + 1
            triangles += [a, a + 1, b, a + 1, b + 1, b]
    return {"attributes": {"POSITION": buffer.add(positions, "VEC3"),
                           "NORMAL": buffer.add(normals, "VEC3")},
            "indices": buffer.add(triangles, "SCALAR", UNSIGNED_INT), "material": 0}


def add_floor(buffer, half):
    corners = [-half, -2, -half, half, -2, -half, half, -2, half, -half, -2, half]
    return {"attributes": {"POSITION": buffer.add(corners, "VEC3")},
            "indices": buffer.add([0, 2, 1, 0, 3, 2], "SCALAR", UNSIGNED_INT), "material": 1}


def node_of(copy, side):
    """Turned about the vertical and stretched, on a grid of `side` a row."""
    scale = 0.7 + 0.3 * math.sin(1.3 * copy)
    half_turn = 0.185 * copy
    return {"mesh": 0,
            "translation": [SPACING * (copy % side - side / 2 + 0.5), 0.5 * math.sin(copy),
                            SPACING * (copy // side - side / 2 + 0.5)],
            "rotation": [0, math.sin(half_turn), 0, math.cos(half_turn)],
            "scale": [scale, scale * (1 + 0.3 * math.cos(copy)), scale]}


def color(rgb):
    return {"pbrMetallicRoughness": {"baseColorFactor": [*rgb, 1], "metallicFactor": 0}}


def main(out, count):
    side = math.ceil(math.sqrt(count))
    buffer = Buffer()
    meshes = [{"primitives": [add_ball(buffer)]},
              {"primitives": [add_floor(buffer, SPACING * side / 2)]}]
    lamp = {"translation": [0, 30, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}
    nodes = [node_of(copy, side) for copy in range(count)] + [{"mesh": 1}, lamp]
    lights = {"lights": [{"type": "point", "intensity": 2000}]}
    document = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
                "extensions": {"KHR_lights_punctual": lights},
                "buffers": [{"uri": "scene.bin", "byteLength": len(buffer.bytes)}],
                "bufferViews": buffer.views, "accessors": buffer.accessors,
                "materials": [color((0.8, 0.4, 0.3)), color((0.5, 0.5, 0.5))],
                "meshes": meshes, "nodes": nodes,
                "scenes": [{"nodes": list(range(len(nodes)))}], "scene": 0}
    out.mkdir(parents=True, exist_ok=True)
    (out / "scene.bin").write_bytes(buffer.bytes)
    (out / "scene.gltf").write_text(json.dumps(document))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
