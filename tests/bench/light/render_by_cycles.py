"""blender -b -P render_by_cycles.py -- SCENE OUT.npy SAMPLES REFLECTIONS VIEW...: render as `renderers` does.

One thread, box filter, no denoiser, no clamping; linear RGB, the camera of a View's six numbers. Without REFLECTIONS, 0,
surfaces show their base colour unlit. Prints the CPU time."""

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
for lamp in bpy.data.lights:
    lamp.energy *= 683  # lumens that the importer takes for a watt
    lamp.shadow_soft_size = 0


def node(tree, kind, **inputs):
    """Add a node whose inputs are values or sockets; return its first output."""
    added = tree.nodes.new(kind)
    for name, value in inputs.items():
        socket = next(socket for socket in added.inputs if socket.identifier == name)
        if isinstance(value, bpy.types.NodeSocket):
            tree.links.new(value, socket)
        else:
            socket.default_value = value
    return added.outputs[0]


def diffuse_weight(n_v):
    """Return the mean of 1 - F over a cosine's lobe of lights, F Schlick's of 0.04 and the half vector."""
    level, turn = numpy.meshgrid((numpy.arange(256) + 0.5) / 256, (numpy.arange(256) + 0.5) * math.pi / 256)
    n_l = numpy.sqrt(level)  # of equal shares of the cosine's lobe
    l_v = n_l * n_v + numpy.sqrt((1 - n_l**2) * (1 - n_v**2)) * numpy.cos(turn)
    grazing = (1 - numpy.sqrt((1 + l_v) / 2)) ** 5
    return 1 - (0.04 + 0.96 * grazing).mean()


def diffuse_weight_node(tree):
    """Add nodes whose output is `diffuse_weight` where the surface is."""
    geometry = tree.nodes.new("ShaderNodeNewGeometry").outputs
    product = tree.nodes.new("ShaderNodeVectorMath")
    product.operation = "DOT_PRODUCT"
    for socket, name in zip(product.inputs, ("Normal", "Incoming")):
        tree.links.new(geometry[name], socket)
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    stops = ramp.color_ramp.elements
    places = numpy.linspace(0, 1, 32) ** 2  # closer where the weight is steep
    for place in places[1:-1]:
        stops.new(place)
    for stop, place in zip(stops, places):
        stop.color = (*[diffuse_weight(place)] * 3, 1)
    tree.links.new(product.outputs["Value"], ramp.inputs[0])
    return ramp.outputs[0]


def as_gltf_says(material):
    """Make a material's surface that of glTF 2.0's appendix B as far as Cycles has nodes for it.

    What the importer makes is Disney's: a dielectric's diffuse reflection grows with roughness and is not weakened by
    what the surface reflects. Here its weight is right for light from everywhere, by the angle of the view alone."""
    tree = material.node_tree
    principled = tree.nodes["Principled BSDF"].inputs
    colour, metallic = principled["Base Color"].default_value[:], principled["Metallic"].default_value
    surface = node(tree, "ShaderNodeBsdfDiffuse", Color=colour)
    if not material.name.startswith("Lambert"):
        roughness = principled["Roughness"].default_value

        def principled_as(colour, metallic):
            made = {"Base Color": colour, "Metallic": metallic, "Roughness": roughness, "IOR": 1.5}
            socket = node(tree, "ShaderNodeBsdfPrincipled", **made)
            tree.nodes[-1].distribution = "GGX"
            return socket

        black = (0, 0, 0, 1)
        nothing = node(tree, "ShaderNodeBsdfDiffuse", Color=black)
        matt = node(tree, "ShaderNodeMixShader", Fac=diffuse_weight_node(tree), Shader=nothing, Shader_001=surface)
        dielectric = node(tree, "ShaderNodeAddShader", Shader=matt, Shader_001=principled_as(black, 0))
        metal = principled_as(colour, 1)
        surface = node(tree, "ShaderNodeMixShader", Fac=metallic, Shader=dielectric, Shader_001=metal)
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(surface, output.inputs["Surface"])


def as_unlit(material):
    """Make a material's surface shine in its base colour."""
    tree = material.node_tree
    colour = tree.nodes["Principled BSDF"].inputs["Base Color"].default_value[:]
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(node(tree, "ShaderNodeEmission", Color=colour), output.inputs["Surface"])


for material in bpy.data.materials:
    if int(reflections) == 0:
        as_unlit(material)
    elif material.name != "lamp":
        as_gltf_says(material)
scene = bpy.context.scene
scene.render.engine = "CYCLES"
cycles = scene.cycles
cycles.device, cycles.samples = "CPU", int(samples)
cycles.use_denoising = cycles.use_adaptive_sampling = False
# Cycles counts the reflections after the first, where light is looked for too.
for name in ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces"):
    setattr(cycles, name, max(0, int(reflections) - 1))
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
