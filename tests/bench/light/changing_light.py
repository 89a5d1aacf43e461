#!/usr/bin/env python3
"""changing_light.py EDVO OUT: what light that changes costs a tracker.

Gives the repository's room animations of its lamps' intensity (KHR_animation_pointer) and walks the path of the scenario
`hand_held` through it with the presets default, paper and authors, two seeds each (`edvo sweep`): steady light; the
pendant lamp going out; both lamps dimmed to a quarter and back; the sun behind a cloud for a moment. OUT/LIGHT holds a
room and its sweep."""

import argparse
import base64
import json
import pathlib
import shutil
import struct
import subprocess

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
LAMPS = {"pendant": 0, "floor": 1, "sun": 2}
# Lights with their strengths, of that at rest, at these times, s.
LIGHTS = {
    "steady": ([], [], []),
    "lamp_out": (["pendant"], [0, 0.7, 0.75], [1, 1, 0]),
    "dimmed": (["pendant", "floor"], [0, 0.75, 1.5], [1, 0.25, 1]),
    "cloud": (["sun"], [0, 0.5, 0.7, 0.9, 1.1], [1, 1, 0.1, 0.1, 1]),
}


def add_values(document, values):
    """Append numbers as a buffer, a view and an accessor of their own; return the accessor's index."""
    content = struct.pack(f"<{len(values)}f", *values)
    uri = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    document["buffers"].append({"byteLength": len(content), "uri": uri})
    document["bufferViews"].append({"buffer": len(document["buffers"]) - 1, "byteLength": len(content)})
    document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126,
                                  "count": len(values), "type": "SCALAR", "min": [min(values)], "max": [max(values)]})
    return len(document["accessors"]) - 1


def animate(document, lamps, times, strengths):
    lights = document["extensions"]["KHR_lights_punctual"]["lights"]
    document["extensionsUsed"].append("KHR_animation_pointer")
    animation = {"samplers": [], "channels": []}
    for lamp in map(LAMPS.get, lamps):
        values = [strength * lights[lamp]["intensity"] for strength in strengths]
        animation["samplers"].append({"input": add_values(document, times), "output": add_values(document, values)})
        pointer = f"/extensions/KHR_lights_punctual/lights/{lamp}/intensity"
        animation["channels"].append({
            "sampler": len(animation["samplers"]) - 1,
            "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": pointer}}}})
    document["animations"] = [animation]


def write_room(folder, light):
    """Write the room under a light, and its scenario; return the latter."""
    shutil.copytree(REPOSITORY / "assets/room", folder / "room", dirs_exist_ok=True)
    path = folder / "room/room.gltf"
    document = json.loads(path.read_text())
    if light[0]:
        animate(document, *light)
    path.write_text(json.dumps(document))
    scenario = folder / "scenario.toml"
    text = (REPOSITORY / "scenarios/hand_held.toml").read_text()
    scenario.write_text(text.replace("room/room.gltf", str(path)))
    return scenario


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("edvo")
    parser.add_argument("out", type=pathlib.Path)
    arguments = parser.parse_args()
    for name, light in LIGHTS.items():
        folder = arguments.out / name
        scenario = write_room(folder.resolve(), light)
        print(name, flush=True)
        subprocess.run([arguments.edvo, "sweep", scenario, "--set", "odometry.preset=default,paper,authors",
                        "--seeds", "2", "--out", folder / "sweep", "--force"], check=True)


if __name__ == "__main__":
    main()
