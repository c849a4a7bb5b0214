#!/usr/bin/env python3
"""Makes carousel.gltf: glass, gold and painted spheres that ride on a turning wheel, each up and down in its own time. Ten seconds, and it begins again.

    carousel.py [FILE]
"""
import base64
import json
import math
import pathlib
import struct
import sys

blob = bytearray()
views, accessors, meshes, nodes, channels, samplers = [], [], [], [], [], []


def accessor(kind, component, rows, bounds=False, target=None):
    global blob
    blob += b"\0" * (-len(blob) % 4)
    flat = [value for row in rows for value in row]
    code = {5126: "f", 5123: "H"}[component]
    data = struct.pack(f"<{len(flat)}{code}", *flat)
    views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data), **({"target": target} if target else {})})
    blob += data
    entry = {"bufferView": len(views) - 1, "componentType": component, "count": len(rows), "type": kind}
    if bounds:
        stored = [struct.unpack(f"<{len(row)}f", struct.pack(f"<{len(row)}f", *row)) for row in rows]
        entry["min"], entry["max"] = [list(edge(column) for column in zip(*stored)) for edge in (min, max)]
    accessors.append(entry)
    return len(accessors) - 1


def shape(points, normals, triangles):
    return {"attributes": {"POSITION": accessor("VEC3", 5126, points, True, 34962), "NORMAL": accessor("VEC3", 5126, normals, False, 34962)},
            "indices": accessor("SCALAR", 5123, [(i,) for t in triangles for i in t], False, 34963)}


def ball(rings=20, sides=40):
    points = []
    for i in range(rings + 1):
        for j in range(sides + 1):
            a, b = math.pi * i / rings, 2 * math.pi * j / sides
            points.append((math.sin(a) * math.cos(b), math.cos(a), -math.sin(a) * math.sin(b)))
    triangles = []
    for i in range(rings):
        for j in range(sides):
            a, b = i * (sides + 1) + j, (i + 1) * (sides + 1) + j
            triangles += [(a, b, b + 1)] * (i < rings - 1) + [(a, b + 1, a + 1)] * (i > 0)
    return shape(points, points, triangles)


def drum(sides=64):
    """Radius 1, from y = 0 to 1."""
    points, normals, triangles = [], [], []
    for j in range(sides + 1):
        c, s = math.cos(2 * math.pi * j / sides), -math.sin(2 * math.pi * j / sides)
        points += [(c, 0, s), (c, 1, s), (c, 0, s), (c, 1, s)]
        normals += [(c, 0, s), (c, 0, s), (0, -1, 0), (0, 1, 0)]
        if j < sides:
            a, b = 4 * j, 4 * j + 4
            triangles += [(a, b, b + 1), (a, b + 1, a + 1)]
    below, above = len(points), len(points) + 1
    points += [(0, 0, 0), (0, 1, 0)]
    normals += [(0, -1, 0), (0, 1, 0)]
    for j in range(sides):
        triangles += [(below, 4 * j + 6, 4 * j + 2), (above, 4 * j + 3, 4 * j + 7)]
    return shape(points, normals, triangles)


def mesh(base, material):
    meshes.append({"primitives": [{**base, "material": material}]})
    return len(meshes) - 1


def node(**entry):
    nodes.append(entry)
    return len(nodes) - 1


def animate(target, path, times, values, kind):
    samplers.append({"input": accessor("SCALAR", 5126, [(t,) for t in times], True), "output": accessor(kind, 5126, values)})
    channels.append({"sampler": len(samplers) - 1, "target": {"node": target, "path": path}})


def paint(name, color, roughness=0.4, metallic=0.0, **more):
    return {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "roughnessFactor": roughness, "metallicFactor": metallic}, **more}


materials = [
    paint("floor", (0.55, 0.5, 0.45), 0.9),
    paint("wheel", (0.1, 0.16, 0.3), 0.25),
    paint("gold", (1.0, 0.77, 0.34), 0.15, 1.0),
    paint("glass", (0.97, 0.99, 1.0), 0.0, extensions={"KHR_materials_transmission": {"transmissionFactor": 1},
                                                       "KHR_materials_volume": {"thicknessFactor": 0.5}, "KHR_materials_ior": {"ior": 1.5}}),
    paint("red", (0.75, 0.06, 0.05), 0.2),
    paint("lamp", (0, 0, 0), 1, emissiveFactor=[1, 0.82, 0.62], extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 14}}),
]
sphere, cylinder = ball(), drum()
floor = node(name="floor", mesh=mesh(shape([(-9, 0, 9), (9, 0, 9), (9, 0, -9), (-9, 0, -9)], [(0, 1, 0)] * 4, [(0, 1, 2), (0, 2, 3)]), 0))
disc = node(name="disc", mesh=mesh(cylinder, 1), translation=[0, 0.12, 0], scale=[2.5, 0.14, 2.5])
pole = node(name="pole", mesh=mesh(cylinder, 2), translation=[0, 0.26, 0], scale=[0.14, 2.1, 0.14])
top = node(name="lamp", mesh=mesh(sphere, 5), translation=[0, 2.62, 0], scale=[0.42, 0.42, 0.42])
riders = []
for i in range(6):
    angle, radius = 2 * math.pi * i / 6, 1.85
    x, z = radius * math.cos(angle), radius * math.sin(angle)
    rod = node(name=f"rod {i + 1}", mesh=mesh(cylinder, 2), translation=[x, 0.26, z], scale=[0.035, 1.75, 0.035])
    rider = node(name=f"rider {i + 1}", mesh=mesh(sphere, (3, 4, 2)[i % 3]), translation=[x, 1.0, z], scale=[0.45, 0.45, 0.45])
    riders += [rod, rider]
    times = [10 * k / 40 for k in range(41)]
    animate(rider, "translation", times, [(x, 1.15 + 0.38 * math.sin(2 * math.pi * (2 * k / 40 + i / 3)), z) for k in range(41)], "VEC3")
wheel = node(name="wheel", children=[disc, pole, top, *riders])
turns = [(0.0, math.sin(math.pi * k / 8), 0.0, math.cos(math.pi * k / 8)) for k in range(9)]
animate(wheel, "rotation", [10 * k / 8 for k in range(9)], turns, "VEC4")
tilt = math.radians(-13) / 2
camera = node(name="camera", camera=0, translation=[0, 2.9, 7.6], rotation=[math.sin(tilt), 0, 0, math.cos(tilt)])
half = math.radians(-50) / 2
sun = node(name="sun", extensions={"KHR_lights_punctual": {"light": 0}}, rotation=[math.sin(half), 0, 0, math.cos(half)])

scene = {
    "asset": {"version": "2.0", "generator": "lancer's carousel.py"},
    "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_transmission",
                       "KHR_materials_volume"],
    "scene": 0, "scenes": [{"nodes": [floor, wheel, camera, sun]}], "nodes": nodes, "meshes": meshes, "materials": materials,
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.62, "znear": 0.1, "aspectRatio": 1.7777778}}],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "color": [0.75, 0.85, 1], "intensity": 2.5}]}},
    "animations": [{"name": "ten seconds", "samplers": samplers, "channels": channels}],
    "accessors": accessors, "bufferViews": views,
    "buffers": [{"byteLength": len(blob), "uri": "data:application/octet-stream;base64," + base64.b64encode(blob).decode()}],
}
path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("carousel.gltf")
path.write_text(json.dumps(scene, indent=1) + "\n")
