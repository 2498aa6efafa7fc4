"""Blender's side of cycles.sh: the same mesh, light and camera, by Cycles on one thread.

    blender -b --factory-startup -P cycles.py -- MESH.ply OUT.pfm SIDE BOUNCES CERTAIN SEED SAMPLES...

Renders with each number of samples, prints a line "cycles SAMPLES SECONDS" of processor time for each, and writes the
last picture. Russian roulette begins after CERTAIN bounces. The numbers of the room are those that cycles.sh gives
Raywalk.
"""
import array
import math
import os
import struct
import sys
import time

import bpy
from mathutils import Vector

mesh_path, picture_path, side, bounces, certain, seed, *all_samples = sys.argv[sys.argv.index("--") + 1:]


def read_ply(path):
    """Positions and triangles of a binary PLY that has floats x, y, z and lists of three ints, and nothing else."""
    with open(path, "rb") as file:
        counts = {}
        while (line := file.readline().split()) != [b"end_header"]:
            if line[:1] == [b"element"]:
                counts[line[1]] = int(line[2])
        positions = array.array("f", file.read(12 * counts[b"vertex"]))
        corners = array.array("i")
        for count, *triangle in struct.iter_unpack("<B3i", file.read(13 * counts[b"face"])):
            assert count == 3
            corners.extend(triangle)
    return positions, corners


def add_mesh(name, positions, corners, sides, material):
    mesh = bpy.data.meshes.new(name)
    faces = len(corners) // sides
    mesh.vertices.add(len(positions) // 3)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(faces)
    mesh.polygons.foreach_set("loop_start", range(0, len(corners), sides))
    mesh.polygons.foreach_set("loop_total", [sides] * faces)
    mesh.update(calc_edges=True)
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def make_material(name, kind, **inputs):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    shader = nodes.new(kind)
    for key, value in inputs.items():
        shader.inputs[key].default_value = value
    material.node_tree.links.new(shader.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
add_mesh("Room", *read_ply(mesh_path), 3,
         make_material("Grey", "ShaderNodeBsdfDiffuse", Color=(0.7, 0.7, 0.7, 1), Roughness=0))
add_mesh("Light", [-3.7216, 15.8633, -2.73871, 1.5584, 15.8633, -2.73871,
                   1.5584, 15.8633, 2.54129, -3.7216, 15.8633, 2.54129], [0, 1, 2, 3], 4,
         make_material("Emitter", "ShaderNodeEmission", Color=(1, 1, 1, 1), Strength=20))

camera = bpy.data.cameras.new("Camera")
camera.sensor_fit = "VERTICAL"
camera.angle = math.radians(50)
camera.clip_start, camera.clip_end = 1e-3, 1e4
scene.camera = bpy.data.objects.new("Camera", camera)
eye, look_at = Vector((2.4184, 6.36349, 10.4013)), Vector((-1.0816, 3.86349, -0.0987129))
ahead = (look_at - eye).normalized()
right = ahead.cross(Vector((0, 1, 0))).normalized()
above = right.cross(ahead)
for row in range(3):
    for column, axis in enumerate((right, above, -ahead, eye)):
        scene.camera.matrix_world[row][column] = axis[row]
scene.collection.objects.link(scene.camera)

scene.world = bpy.data.worlds.new("Black")
scene.world.color = (0, 0, 0)
render, cycles = scene.render, scene.cycles
render.engine = "CYCLES"
render.resolution_x = render.resolution_y = int(side)
render.resolution_percentage = 100
render.threads_mode, render.threads = "FIXED", 1
render.use_compositing = render.use_sequencer = False
render.filepath = picture_path + ".exr"
render.image_settings.file_format = "OPEN_EXR"
render.image_settings.color_depth = "32"
render.image_settings.color_mode = "RGB"
cycles.device = "CPU"
cycles.seed = int(seed)
cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
cycles.max_bounces = cycles.diffuse_bounces = int(bounces)
cycles.min_light_bounces = int(certain)
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = cycles.blur_glossy = 0
for samples in all_samples:
    cycles.samples = int(samples)
    begin = time.process_time()
    bpy.ops.render.render(write_still=True)
    print("cycles", samples, time.process_time() - begin, flush=True)

# From EXR to PFM, which Python reads without a library; both begin with the lowest row.
picture = bpy.data.images.load(render.filepath)
pixels = array.array("f", picture.pixels[:])
del pixels[3::4]
with open(picture_path, "wb") as file:
    file.write(f"PF\n{side} {side}\n-1.0\n".encode())
    pixels.tofile(file)
os.remove(render.filepath)
