#!/usr/bin/env python3
"""slanted_texture.py OUT [--samples 1,4,16,64] [--reference 4096]: what anisotropic filtering is worth.

Renders a checkered floor that recedes to 3 degrees, and the repository's corridor from its end, without light by `edvo`
(its Python module, e.g. PYTHONPATH=build/release/python) with isotropic and with anisotropic textures, and prints for
each number of samples a pixel the root-mean-square difference from the picture of --reference isotropic samples, over
that picture's mean, and the CPU time of one thread. The renderers are those that the option `render.kind` names. Writes
OUT/SCENE.png, to be looked at: the ray tracer's pictures of 4 samples, isotropic and anisotropic, and the reference."""

import argparse
import base64
import json
import pathlib
import struct
import time
import zlib

import numpy as np

import edvo

ASSETS = pathlib.Path(__file__).resolve().parents[3] / "assets"
WIDTH, HEIGHT = 160, 120  # px


def png(pixels):
    """Return the bytes of a grey or colour PNG of 8 bits."""
    height, width = pixels.shape[:2]
    colour = 0 if pixels.ndim == 2 else 2
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(name, content):
        checked = name + content
        return struct.pack(">I", len(content)) + checked + struct.pack(">I", zlib.crc32(checked))

    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def data_uri(kind, content):
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def checkered_floor():
    """Return a glTF document: 20 x 20 m of dark and bright squares, 1 m below the origin, ahead along -z."""
    texels = np.where((np.indices((256, 256)) // 4).sum(axis=0) % 2 == 0, 255, 0).astype(np.uint8)
    corners = [(-10, -1, 0), (10, -1, 0), (10, -1, -20), (-10, -1, -20)]
    values = struct.pack("<12f8f6H", *np.ravel(corners), 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 2, 0, 2, 3)
    views = [(0, 48), (48, 32), (80, 12)]
    return json.dumps({
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                       "extensions": {"KHR_materials_unlit": {}}}],
        "textures": [{"source": 0}],
        "images": [{"uri": data_uri("image/png", png(texels))}],
        "buffers": [{"byteLength": len(values), "uri": data_uri("application/octet-stream", values)}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [-10, -1, -20], "max": [10, -1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    })


def picture_of(scene, eye, kind, samples, anisotropy):
    """Return the radiance seen along -z, and the CPU time, s."""
    options = edvo.RenderOptions()
    options.kind, options.mode, options.samples, options.anisotropy = kind, "unlit", samples, anisotropy
    camera = edvo.Camera(width=WIDTH, height=HEIGHT, fx=WIDTH, fy=WIDTH, cx=(WIDTH - 1) / 2, cy=(HEIGHT - 1) / 2)
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = eye
    renderer = edvo.Renderer(scene, options, exposure=1)
    begun = time.process_time()
    picture = np.array(renderer.render(camera, pose, ["image"])["radiance"])
    return picture, time.process_time() - begun


def save(pictures, path):
    """Write pictures side by side, each pixel as 2 x 2."""
    shown = np.clip(np.concatenate(pictures, axis=1), 0, 1) ** (1 / 2.2)
    shown = shown.repeat(2, axis=0).repeat(2, axis=1)
    path.write_bytes(png(np.ascontiguousarray((255 * shown + 0.5).astype(np.uint8))))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--samples", default="1,4,16,64")
    parser.add_argument("--reference", type=int, default=4096)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    floor = arguments.out / "floor.gltf"
    floor.write_text(checkered_floor())
    scenes = {"floor": (edvo.Scene(str(floor)), (0, 0, 0)),
              "corridor": (edvo.Scene(str(ASSETS / "corridor/corridor.gltf")), (0, 1.2, 1.5))}
    print("scene     renderer    samples  isotropic  CPU s  anisotropic  CPU s")
    for name, (scene, eye) in scenes.items():
        shown = []
        truth, _ = picture_of(scene, eye, "ray_tracer", arguments.reference, 1)
        for kind in ("ray_tracer", "rasterizer"):
            for samples in map(int, arguments.samples.split(",")):
                cells = []
                for anisotropy in (1, 16):
                    picture, seconds = picture_of(scene, eye, kind, samples, anisotropy)
                    error = np.sqrt(((picture - truth) ** 2).mean()) / truth.mean()
                    cells.append(f"{error:9.4f} {seconds:6.3f}")
                    if samples == 4 and kind == "ray_tracer":
                        shown.append(picture)
                print(f"{name:9} {kind:11} {samples:7}  " + "  ".join(cells))
        save([*shown, truth], arguments.out / f"{name}.png")


if __name__ == "__main__":
    main()
