"""A box with a square lamp under its ceiling, a ball of metal and one of plastic, as glTF."""

import base64
import json
import math
import struct
import typing

ROWS = 48  # of a ball's triangles


class View(typing.NamedTuple):
    """A camera that looks along -z in glTF's axes, its middle in the middle of the image."""

    width: int  # px
    height: int  # px
    focal: float  # px
    eye: tuple  # m


VIEW = View(80, 60, 60, (0, 0, 1.8))


def material(colour, metallic=0.0, roughness=1.0, emission=0.0):
    """Return a material of glTF, Lambert's unless it is metallic or smooth; `emission` is its radiance."""
    result = {
        "pbrMetallicRoughness": {
            "baseColorFactor": [*colour, 1],
            "metallicFactor": metallic,
            "roughnessFactor": roughness,
        }
    }
    if metallic == 0 and roughness == 1:
        result["name"] = "Lambert"
        result["extensions"] = {"KHR_materials_specular": {"specularFactor": 0}}
    if emission > 0:
        result["emissiveFactor"] = [1, 1, 1]
        result["name"] = "lamp"
        result["extensions"]["KHR_materials_emissive_strength"] = {"emissiveStrength": emission}
    return result


def quad(corner, right, down):
    """Return positions and triangles of a parallelogram."""
    points = [
        [c + i * r + k * d for c, r, d in zip(corner, right, down)]
        for i, k in ((0, 0), (1, 0), (1, 1), (0, 1))
    ]
    return points, None, [0, 1, 2, 0, 2, 3]


def ball(centre, radius):
    """Return positions, normals and triangles of a ball."""
    normals = []
    for row in range(ROWS + 1):
        for column in range(2 * ROWS + 1):
            polar, turn = math.pi * row / ROWS, math.pi * column / ROWS
            level = math.sin(polar)
            normals.append([level * math.cos(turn), math.cos(polar), -level * math.sin(turn)])
    points = [[c + radius * n for c, n in zip(centre, normal)] for normal in normals]
    indices = []
    for row in range(ROWS):
        for column in range(2 * ROWS):
            a = row * (2 * ROWS + 1) + column
            b = a + 2 * ROWS + 1
            indices += [a, b, a + 1, a + 1, b, b + 1]
    return points, normals, indices


class Document:
    """A glTF document that shapes are added to."""

    def __init__(self):
        self.buffer = b""
        self.json = {
            "asset": {"version": "2.0"},
            "extensionsUsed": ["KHR_materials_emissive_strength", "KHR_materials_specular"],
            "scenes": [{"nodes": []}],
            "nodes": [],
            "meshes": [],
            "materials": [],
            "accessors": [],
            "bufferViews": [],
        }

    def accessor(self, values, kind, code):
        rows = values if kind == "VEC3" else [[value] for value in values]
        data = b"".join(struct.pack(f"<{len(row)}{code}", *row) for row in rows)
        view = {"buffer": 0, "byteOffset": len(self.buffer), "byteLength": len(data)}
        self.buffer += data
        self.json["bufferViews"].append(view)
        accessor = {
            "bufferView": len(self.json["bufferViews"]) - 1,
            "componentType": 5126 if code == "f" else 5125,
            "count": len(rows),
            "type": kind,
        }
        if kind == "VEC3":
            stored = [struct.unpack("<3f", struct.pack("<3f", *row)) for row in rows]
            accessor["min"] = [min(column) for column in zip(*stored)]
            accessor["max"] = [max(column) for column in zip(*stored)]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def add(self, shape, of_material):
        points, normals, indices = shape
        attributes = {"POSITION": self.accessor(points, "VEC3", "f")}
        if normals:
            attributes["NORMAL"] = self.accessor(normals, "VEC3", "f")
        self.json["materials"].append(of_material)
        self.json["meshes"].append(
            {
                "primitives": [
                    {
                        "attributes": attributes,
                        "indices": self.accessor(indices, "SCALAR", "I"),
                        "material": len(self.json["materials"]) - 1,
                    }
                ]
            }
        )
        self.json["nodes"].append({"mesh": len(self.json["meshes"]) - 1})
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.buffer).decode()
        self.json["buffers"] = [{"byteLength": len(self.buffer), "uri": uri}]
        return json.dumps(self.json)


def box():
    """Return a document of a box, 4 x 3 x 4 m about the origin."""
    document = Document()
    grey, red, green = (material(c) for c in ((0.7, 0.7, 0.7), (0.7, 0.1, 0.1), (0.1, 0.6, 0.1)))
    for y in (-1.5, 1.5):
        document.add(quad((-2, y, -2), (4, 0, 0), (0, 0, 4)), grey)
    for z in (-2, 2):
        document.add(quad((-2, -1.5, z), (4, 0, 0), (0, 3, 0)), grey)
    for x, wall in ((-2, red), (2, green)):
        document.add(quad((x, -1.5, -2), (0, 0, 4), (0, 3, 0)), wall)
    return document


def add_balls(document):
    """Add a ball of metal and one of plastic."""
    document.add(ball((-0.8, -0.9, -0.8), 0.6), material((0.9, 0.8, 0.5), metallic=1, roughness=0.25))
    document.add(ball((0.8, -0.9, -0.3), 0.6), material((0.2, 0.3, 0.8), roughness=0.3))


def lit_box(lamp_size, emission):
    """Return a document of the box and a square lamp under its ceiling."""
    document = box()
    corner = (-lamp_size / 2, 1.49, -0.5 - lamp_size / 2)
    document.add(quad(corner, (lamp_size, 0, 0), (0, 0, lamp_size)), material((0, 0, 0), emission=emission))
    return document


def lamp_box():
    """Return the text of the box with two balls, which VIEW shows."""
    document = lit_box(0.6, 12)
    add_balls(document)
    return document.text()


def point_lit_box():
    """Return the text of the box with two balls and a lamp of point size, of 20 cd, in its middle."""
    document = box()
    add_balls(document)
    document.json["extensionsUsed"].append("KHR_lights_punctual")
    lamp = {"type": "point", "intensity": 20}
    document.json["extensions"] = {"KHR_lights_punctual": {"lights": [lamp]}}
    document.json["nodes"].append({"translation": [0, 0.8, 0.3], "extensions": {"KHR_lights_punctual": {"light": 0}}})
    document.json["scenes"][0]["nodes"].append(len(document.json["nodes"]) - 1)
    return document.text()
