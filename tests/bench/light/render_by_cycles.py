"""blender -b -P render_by_cycles.py -- SCENE OUT.npy SAMPLES REFLECTIONS VIEW...: render as `renderers` does.

One thread, box filter, no denoiser, no clamping; linear RGB, the camera of a View's six numbers. Prints the CPU time."""

import math
import os
import sys
import time

import numpy

numpy.bool = bool  # Debian 12's importer of glTF uses the name that NumPy 1.24 has removed
sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402  (needs the name)
from lamp_box import View  # noqa: E402

scene_file, out, samples, reflections, *numbers = sys.argv[sys.argv.index("--") + 1 :]
width, height, focal, *eye = map(float, numbers)
view = View(int(width), int(height), focal, eye)

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=scene_file)
# What the importer makes of a diffuse material is Disney's diffuse reflection, not Lambert's.
for material in bpy.data.materials:
    if material.name.startswith("Lambert"):
        nodes = material.node_tree.nodes
        colour = nodes["Principled BSDF"].inputs["Base Color"].default_value[:]
        lambert = nodes.new("ShaderNodeBsdfDiffuse")
        lambert.inputs["Color"].default_value = colour
        output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
        material.node_tree.links.new(lambert.outputs["BSDF"], output.inputs["Surface"])
scene = bpy.context.scene
scene.render.engine = "CYCLES"
cycles = scene.cycles
cycles.device, cycles.samples = "CPU", int(samples)
cycles.use_denoising = cycles.use_adaptive_sampling = False
# Cycles counts the reflections after the first, where light is looked for too.
for name in ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces"):
    setattr(cycles, name, int(reflections) - 1)
cycles.blur_glossy = cycles.sample_clamp_indirect = cycles.sample_clamp_direct = 0
cycles.pixel_filter_type = "BOX"
scene.render.threads_mode, scene.render.threads = "FIXED", 1
data = bpy.data.cameras.new("camera")
data.sensor_fit, data.sensor_width, data.lens = "HORIZONTAL", view.width, view.focal
camera = bpy.data.objects.new("camera", data)
camera.location = (view.eye[0], -view.eye[2], view.eye[1])  # Blender's z is up
camera.rotation_euler = (math.pi / 2, 0, 0)
bpy.context.collection.objects.link(camera)
scene.camera = camera
scene.world = bpy.data.worlds.new("world")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0, 0, 0, 1)
scene.render.resolution_x, scene.render.resolution_y = view.width, view.height
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = out + ".exr"
begun = time.process_time()
bpy.ops.render.render(write_still=True)
print("CPU", time.process_time() - begun)
pixels = numpy.array(bpy.data.images.load(out + ".exr").pixels[:], numpy.float32)
numpy.save(out, pixels.reshape(view.height, view.width, 4)[::-1, :, :3])
os.remove(out + ".exr")
