"""Builds one of lancer's scenes in Blender and renders it with Cycles on the processor. compare-paths calls it:

  blender -b --factory-startup -P cycles.py -- SCENE.toml SPP SEED THREADS OUT.exr

What the scene has beyond what is read here ends the program: no comparison is better than a wrong one.
"""
import math
import pathlib
import sys
import time
import tomllib

import bmesh
import bpy
import mathutils
import numpy

scene_file, spp, seed, threads, output = sys.argv[sys.argv.index("--") + 1:]
folder = pathlib.Path(scene_file).parent
with open(scene_file, "rb") as file:
    scene = tomllib.load(file)
bpy.ops.wm.read_factory_settings(use_empty=True)
stage = bpy.context.scene


def expect(condition, what):
    if not condition:
        print(f"cycles.py: {scene_file}: {what}")
        sys.exit(1)


def shader(material, kind, **inputs):
    """A material of one node."""
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    node = tree.nodes.new(kind)
    if hasattr(node, "distribution"):
        node.distribution = "SHARP"
    for name, value in inputs.items():
        node.inputs[name].default_value = value
    surface = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(node.outputs[0], surface.inputs["Surface"])
    return tree, node


def rgba(color):
    return (0, 0, 0, 1) if color == "black" else (*color, 1)


def material_of(written):
    m = scene["material"][written] if isinstance(written, str) else written
    known = {"type", "color", "emission", "emission_sides", "refraction"}
    expect(not set(m) - known, f"a material has {set(m) - known}")
    result = bpy.data.materials.new("material")
    color = m.get("color", [1, 1, 1])
    if "emission" in m:
        expect(color == "black" and m.get("emission_sides") == "both", "lamps are black and shine to both sides")
        shader(result, "ShaderNodeEmission", Color=rgba(m["emission"]), Strength=1)
    elif m["type"] == "diffuse":
        tree, node = shader(result, "ShaderNodeBsdfDiffuse", Color=(1, 1, 1, 1) if isinstance(color, dict) else rgba(color))
        if isinstance(color, dict):
            expect(color["type"] == "image" and not set(color) - {"type", "file"}, "textures are plain images")
            image = tree.nodes.new("ShaderNodeTexImage")
            image.image = bpy.data.images.load(str(folder / color["file"]))
            tree.links.new(image.outputs["Color"], node.inputs["Color"])
    elif m["type"] == "conductor":
        shader(result, "ShaderNodeBsdfGlossy", Color=rgba(color), Roughness=0)
    elif m["type"] == "dielectric":
        shader(result, "ShaderNodeBsdfGlass", Color=(1, 1, 1, 1), Roughness=0, IOR=m["refraction"])
    else:
        expect(False, f"a material is {m['type']}")
    return result


def read_ply(path):
    """Corners, uv and triangles of a binary file whose vertices are floats and whose faces are triangles."""
    with open(path, "rb") as file:
        names, counts = [], {}
        while (line := file.readline().split())[0] != b"end_header":
            if line[0] == b"element":
                element = line[1]
                counts[element] = int(line[2])
            elif line[0] == b"property" and element == b"vertex":
                expect(line[1] == b"float", "corners are floats")
                names.append(line[2].decode())
        vertices = numpy.fromfile(file, "<f4", counts[b"vertex"] * len(names)).reshape(-1, len(names))
        faces = numpy.fromfile(file, numpy.dtype([("count", "u1"), ("corner", "<i4", 3)]), counts[b"face"])["corner"]
    return vertices[:, :3], vertices[:, [names.index("u"), names.index("v")]], faces


def place(mesh, written):
    mesh.materials.append(material_of(written))
    thing = bpy.data.objects.new("object", mesh)
    stage.collection.objects.link(thing)
    return thing


for m in scene.get("mesh", []):
    mesh = bpy.data.meshes.new("mesh")
    if "file" in m:
        corners, uvs, triangles = read_ply(folder / m["file"])
        mesh.vertices.add(len(corners))
        mesh.vertices.foreach_set("co", corners.ravel())
        mesh.loops.add(triangles.size)
        mesh.loops.foreach_set("vertex_index", triangles.ravel())
        mesh.polygons.add(len(triangles))
        mesh.polygons.foreach_set("loop_start", numpy.arange(0, triangles.size, 3))
        mesh.polygons.foreach_set("loop_total", numpy.full(len(triangles), 3))
        mesh.polygons.foreach_set("use_smooth", numpy.ones(len(triangles), bool))
        mesh.uv_layers.new().data.foreach_set("uv", uvs[triangles.ravel()].ravel())
        mesh.update(calc_edges=True)
    else:
        mesh.from_pydata(m["positions"], [], m["triangles"])
    place(mesh, m["material"])

for s in scene.get("sphere", []):
    mesh = bpy.data.meshes.new("sphere")
    ball = bmesh.new()
    bmesh.ops.create_icosphere(ball, subdivisions=6, radius=s["radius"])
    ball.to_mesh(mesh)
    mesh.polygons.foreach_set("use_smooth", numpy.ones(len(mesh.polygons), bool))
    place(mesh, s["material"]).location = s["center"]

for l in scene.get("light", []):
    expect(l["type"] == "directional", "lights are directional")
    sun = bpy.data.lights.new("sun", "SUN")
    sun.angle = 0
    sun.energy = 1
    sun.color = l["power"]
    thing = bpy.data.objects.new("sun", sun)
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = (-mathutils.Vector(l["direction"])).to_track_quat("Z", "Y")
    stage.collection.objects.link(thing)

stage.world = bpy.data.worlds.new("world")
stage.world.use_nodes = True
tree = stage.world.node_tree
tree.nodes.clear()
sky = tree.nodes.new("ShaderNodeBackground")
sky.inputs["Color"].default_value = rgba(scene.get("background", {}).get("color", [0, 0, 0]))
tree.links.new(sky.outputs[0], tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"])

eye = scene["camera"]
camera = bpy.data.cameras.new("camera")
expect(eye["fov_axis"] == "height", "the field of view is over the height")
camera.sensor_fit = "VERTICAL"
camera.angle = math.radians(eye["fov"])
camera.clip_start = 0.001
camera.clip_end = 1e4
stage.camera = bpy.data.objects.new("camera", camera)
stage.collection.objects.link(stage.camera)
position, target = mathutils.Vector(eye["position"]), mathutils.Vector(eye["look_at"])
ahead = (target - position).normalized()
right = ahead.cross(mathutils.Vector((0, 1, 0))).normalized()
up = right.cross(ahead)
stage.camera.matrix_world = mathutils.Matrix(((right.x, up.x, -ahead.x, position.x), (right.y, up.y, -ahead.y, position.y),
                                              (right.z, up.z, -ahead.z, position.z), (0, 0, 0, 1)))

settings = scene["render"]
expect(settings["filter"] == "box", "the filter is a box")
render = stage.render
render.engine = "CYCLES"
render.resolution_x, render.resolution_y = settings["size"]
render.resolution_percentage = 100
render.threads_mode = "FIXED"
render.threads = int(threads)
render.image_settings.file_format = "OPEN_EXR"
render.image_settings.color_mode = "RGB"
render.image_settings.color_depth = "32"
render.filepath = output
stage.view_settings.view_transform = "Raw"
cycles = stage.cycles
cycles.device = "CPU"
cycles.samples = int(spp)
cycles.seed = int(seed)
cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
for key in ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces"):
    setattr(cycles, key, settings["bounces"])
cycles.caustics_reflective = cycles.caustics_refractive = True
cycles.blur_glossy = cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0
cycles.pixel_filter_type = "BOX"
cycles.filter_width = 1.0

# Once small, so that the trees of the scene stand and only the samples are timed.
render.use_persistent_data = True
render.resolution_percentage = 2
cycles.samples = 1
bpy.ops.render.render()
render.resolution_percentage = 100
cycles.samples = int(spp)
begin, before = time.perf_counter(), time.process_time()
bpy.ops.render.render(write_still=True)
print(f"rendered in {time.perf_counter() - begin:.3f} s, processor {time.process_time() - before:.3f} s")
