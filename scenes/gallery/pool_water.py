#!/usr/bin/env python3
"""Makes pool-water.glb: the water of pool.toml, which moves for four seconds and begins again.

    pool_water.py [FILE]

Waves of deep water, each with a height h, a way k and a speed: h sin(k x - w t + p) = h sin(k x + p) cos(w t) - h cos(k x + p) sin(w t). So all waves of
the same period are two morph targets, whose weights are cos(w t) and -sin(w t). Waves run as fast as gravity lets them, w = sqrt(g k), and the periods
are those that fit into four seconds.
"""
import json
import math
import pathlib
import struct
import sys

SECONDS = 4.0
SIDE, HALF, DEPTH = 116, 2.02, 1.42  # squares along a side; metres, a little into the walls and into the bottom
KEYS = 96
# How many periods in four seconds; heights in millimetres, and ways as angles, of the waves that have it.
WAVES = {4: [(19, 0.3), (10, 2.4)], 5: [(13.5, 1.9), (7.5, 5.6)], 6: [(8.4, 4.1), (6.3, 0.8)], 7: [(4.8, 5.3), (3.6, 3.0)], 8: [(2.4, 0.9), (2, 2.8), (1.7, 4.6)]}
FLOAT, UNSIGNED_SHORT, SHORT, BYTE = 5126, 5123, 5122, 5120

blob = bytearray()
views, accessors = [], []


def accessor(kind, component, rows, target=None, scale=None):
    """`scale`: values from -1 to 1 are stored as whole numbers up to it."""
    global blob
    blob += b"\0" * (-len(blob) % 4)
    code, size = {FLOAT: ("f", 4), UNSIGNED_SHORT: ("H", 2), SHORT: ("h", 2), BYTE: ("b", 1)}[component]
    stored = [[round(value * scale) for value in row] for row in rows] if scale else rows
    width = len(rows[0])
    stride = width * size if kind == "SCALAR" else width * size + -(width * size) % 4
    start = len(blob)
    for row in stored:
        blob += struct.pack(f"<{width}{code}", *row).ljust(stride, b"\0")
    views.append({"buffer": 0, "byteOffset": start, "byteLength": len(blob) - start})
    if target:
        views[-1]["target"] = target
        if target == 34962:
            views[-1]["byteStride"] = stride
    entry = {"bufferView": len(views) - 1, "componentType": component, "count": len(rows), "type": kind}
    if scale:
        entry["normalized"] = True
    if component in (FLOAT, SHORT):
        exact = [struct.unpack(f"<{width}f", struct.pack(f"<{width}f", *row)) for row in rows] if component == FLOAT else stored
        entry["min"], entry["max"] = [list(edge(column) for column in zip(*exact)) for edge in (min, max)]
    accessors.append(entry)
    return len(accessors) - 1


# The top, a skirt, and the bottom: a closed body. Of each vertex its place at rest, its normal there, and whether waves lift it and turn its normal.
places, normals, lifted, turned, triangles = [], [], [], [], []


def vertex(place, normal, lift, turn):
    places.append(place)
    normals.append(normal)
    lifted.append(lift)
    turned.append(turn)
    return len(places) - 1


def along(i):
    return HALF * (2 * i / SIDE - 1)


for i in range(SIDE + 1):
    for j in range(SIDE + 1):
        vertex((along(i), 0.0, along(j)), (0, 1, 0), True, True)
for i in range(SIDE):
    for j in range(SIDE):
        a = i * (SIDE + 1) + j
        triangles += [(a, a + 1, a + SIDE + 1), (a + 1, a + SIDE + 2, a + SIDE + 1)]
corners = []
for normal, edge in (((-1, 0, 0), [(-HALF, along(i)) for i in range(SIDE + 1)]), ((0, 0, 1), [(along(i), HALF) for i in range(SIDE + 1)]),
                     ((1, 0, 0), [(HALF, along(SIDE - i)) for i in range(SIDE + 1)]), ((0, 0, -1), [(along(SIDE - i), -HALF) for i in range(SIDE + 1)])):
    line = [(vertex((x, 0.0, z), normal, True, False), vertex((x, -DEPTH, z), normal, False, False)) for x, z in edge]
    for (a, b), (c, d) in zip(line, line[1:]):
        triangles += [(a, b, d), (a, d, c)]
    corners.append([vertex((x, -DEPTH, z), (0, -1, 0), False, False) for x, z in edge])
middle = vertex((0.0, -DEPTH, 0.0), (0, -1, 0), False, False)
for line in corners:
    triangles += [(middle, d, c) for c, d in zip(line, line[1:])]

targets, weights = [], []
for periods, waves in WAVES.items():
    w = 2 * math.pi * periods / SECONDS
    k = w * w / 9.81
    steepest = sum(0.001 * h * k for h, _ in waves)
    for cosine in (False, True):
        lifts, turns = [], []
        for place, lift, turn in zip(places, lifted, turned):
            phases = [(k * (math.cos(way) * place[0] + math.sin(way) * place[2]) + 2.39996 * periods * (n + 1), 0.001 * h, way)
                      for n, (h, way) in enumerate(waves)]
            up = sum(h * (math.cos(p) if cosine else math.sin(p)) for p, h, _ in phases) if lift else 0.0
            slopes = [(h * k * (-math.sin(p) if cosine else math.cos(p)), way) for p, h, way in phases] if turn else []
            # Targets are as steep as their numbers reach, and their weights small: so 8 bits are enough for a normal.
            lifts.append((0.0, up / steepest, 0.0))
            turns.append((-sum(s * math.cos(way) for s, way in slopes) / steepest, 0.0, -sum(s * math.sin(way) for s, way in slopes) / steepest))
        targets.append({"POSITION": accessor("VEC3", SHORT, lifts, 34962, 32767), "NORMAL": accessor("VEC3", BYTE, turns, 34962, 127)})
    weights += [(steepest, w, False), (-steepest, w, True)]


def weight(strength, w, sine, t):
    """With its slope."""
    return (strength * math.sin(w * t), strength * w * math.cos(w * t)) if sine else (strength * math.cos(w * t), -strength * w * math.sin(w * t))


times = [SECONDS * i / KEYS for i in range(KEYS + 1)]
values = []  # the slope that comes, the value, the slope that goes
for t in times:
    at = [weight(*each, t % SECONDS) for each in weights]  # the end is the beginning, to the last bit
    values += [slope for _, slope in at] + [value for value, _ in at] + [slope for _, slope in at]
primitive = {"attributes": {"POSITION": accessor("VEC3", FLOAT, places, 34962), "NORMAL": accessor("VEC3", BYTE, normals, 34962, 127)},
             "indices": accessor("SCALAR", UNSIGNED_SHORT, [(i,) for t in triangles for i in t], 34963), "targets": targets, "material": 0}
sampler = {"input": accessor("SCALAR", FLOAT, [(t,) for t in times]), "output": accessor("SCALAR", FLOAT, [(v,) for v in values]),
           "interpolation": "CUBICSPLINE"}
scene = {
    "asset": {"version": "2.0", "generator": "lancer's pool_water.py"},
    "extensionsUsed": ["KHR_mesh_quantization", "KHR_materials_transmission", "KHR_materials_volume", "KHR_materials_ior"],
    "extensionsRequired": ["KHR_mesh_quantization"],
    "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "water", "mesh": 0}],
    "meshes": [{"name": "water", "primitives": [primitive], "weights": [weight(*each, 0.0)[0] for each in weights]}],
    "materials": [{"name": "water", "pbrMetallicRoughness": {"roughnessFactor": 0, "metallicFactor": 0}, "extensions": {
        "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.335},
        "KHR_materials_volume": {"thicknessFactor": 1.4, "attenuationDistance": 1, "attenuationColor": [0.73, 0.94, 0.966]}}}],
    "animations": [{"name": "waves", "samplers": [sampler], "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]}],
    "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(blob)}],
}
text = json.dumps(scene, separators=(",", ":")).encode()
text += b" " * (-len(text) % 4)
blob += b"\0" * (-len(blob) % 4)
chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob
path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("pool-water.glb")
path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
