#!/usr/bin/env python3
"""Makes still-life.glb, beside this file, again: a table with a checked cloth, a lacquered ball, a glass egg, a golden ring and a paper lamp. Needs nothing
but Python 3."""
import json
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))


def png(width, height, pixel):
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def surface(place, rows, columns):
    """Vertices and triangles of place(u, v), u and v from 0 to 1, with normals from differences."""
    positions, normals, uvs, triangles = [], [], [], []
    step = 1e-4
    for i in range(rows + 1):
        for j in range(columns + 1):
            u, v = j / columns, i / rows
            p = place(u, v)
            w = min(max(v, 0.01), 0.99)  # at the poles of a ball, from a little beside them
            a = [x - y for x, y in zip(place(u + step, w), place(u - step, w))]
            b = [x - y for x, y in zip(place(u, w + step), place(u, w - step))]
            n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            length = math.sqrt(sum(x * x for x in n))
            positions.append(p)
            normals.append([x / length for x in n])
            uvs.append([u, v])
    for i in range(rows):
        for j in range(columns):
            a = i * (columns + 1) + j
            b, c, d = a + 1, a + columns + 1, a + columns + 2
            triangles += [t for t in ([a, b, d], [a, d, c]) if len({tuple(round(x, 9) for x in positions[k]) for k in t}) == 3]
    return positions, normals, uvs, triangles


def sphere(u, v):
    return [math.sin(2 * math.pi * u) * math.sin(math.pi * v), -math.cos(math.pi * v), math.cos(2 * math.pi * u) * math.sin(math.pi * v)]


def egg(u, v):
    x, y, z = sphere(u, v)
    narrow = 1.0 - 0.15 * y
    return [x * narrow, 1.3 * y, z * narrow]


def ring(u, v):
    a, b = 2 * math.pi * u, 2 * math.pi * v
    r = 1 + 0.28 * math.cos(b)
    return [r * math.sin(a), 0.28 * math.sin(b), r * math.cos(a)]


def cloth(u, v):
    x, z = 6 * u - 3, 3 - 6 * v
    return [x, 0.02 * math.sin(3 * x) * math.cos(4 * z), z]


data = bytearray()
views, accessors, meshes, nodes = [], [], [], []


def view(raw):
    while len(data) % 4:
        data.append(0)
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)})
    data.extend(raw)
    return len(views) - 1


def accessor(kind, component, letter, values):
    flat = [x for value in values for x in value]
    entry = {"bufferView": view(struct.pack(f"<{len(flat)}{letter}", *flat)), "componentType": component, "count": len(values), "type": kind}
    if kind == "VEC3":
        flat32 = [struct.unpack("<f", struct.pack("<f", x))[0] for x in flat]
        entry["min"] = [min(flat32[k::3]) for k in range(3)]
        entry["max"] = [max(flat32[k::3]) for k in range(3)]
    accessors.append(entry)
    return len(accessors) - 1


def add(name, shape, material, **place):
    positions, normals, uvs, triangles = shape
    primitive = {"attributes": {"POSITION": accessor("VEC3", 5126, "f", positions), "NORMAL": accessor("VEC3", 5126, "f", normals),
                                "TEXCOORD_0": accessor("VEC2", 5126, "f", uvs)},
                 "indices": accessor("SCALAR", 5123, "H", [[x] for t in triangles for x in t]), "material": material}
    meshes.append({"name": name, "primitives": [primitive]})
    nodes.append({"name": name, "mesh": len(meshes) - 1, **place})


materials = [
    {"name": "cloth", "doubleSided": True, "pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [9, 9], "rotation": 0.4}}},
        "metallicFactor": 0, "roughnessFactor": 0.9},
     "extensions": {"KHR_materials_sheen": {"sheenColorFactor": [0.3, 0.3, 0.3], "sheenRoughnessFactor": 0.5}}},
    {"name": "lacquer", "pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.02, 0.03, 1], "metallicFactor": 0.1, "roughnessFactor": 0.5},
     "normalTexture": {"index": 1, "scale": 0.4},
     "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.03}}},
    {"name": "glass", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
     "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.52},
                    "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.7, "attenuationColor": [0.35, 0.8, 0.6]}}},
    {"name": "gold", "pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.71, 0.29, 1], "metallicFactor": 1, "roughnessFactor": 0.18}},
    {"name": "paper", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.9, 0.9, 1], "metallicFactor": 0}, "emissiveFactor": [1, 0.72, 0.4],
     "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 6}}},
]


def check(x, y):
    return ((52, 84, 122) if (x // 32 + y // 32) % 2 else (226, 221, 208))


def bumps(x, y):
    a, b = 2 * math.pi * 8 * x / 128, 2 * math.pi * 8 * y / 128
    return (int(128 + 60 * math.cos(a) * math.sin(b)), int(128 - 60 * math.sin(a) * math.cos(b)), 240)


add("cloth", surface(cloth, 60, 60), 0)
add("ball", surface(sphere, 48, 96), 1, translation=[-0.95, 0.62, 0.1], scale=[0.6, 0.6, 0.6])
add("egg", surface(egg, 48, 96), 2, translation=[0.35, 0.74, 0.55], scale=[0.55, 0.55, 0.55])
add("ring", surface(ring, 32, 96), 3, translation=[0.95, 0.62, -0.75], scale=[0.5, 0.5, 0.5], rotation=[0.62, 0, 0.2, 0.759])
add("lamp", surface(sphere, 24, 48), 4, translation=[-1.6, 1.9, -1.3], scale=[0.4, 0.4, 0.4])
nodes.append({"name": "view", "camera": 0, "translation": [0.35, 1.9, 4.6], "rotation": [-0.1305, 0.03, 0.004, 0.991]})

images = [{"bufferView": view(png(64, 64, check)), "mimeType": "image/png"}, {"bufferView": view(png(128, 128, bumps)), "mimeType": "image/png"}]
used = sorted({name for m in materials for name in m.get("extensions", {})} | {"KHR_texture_transform"})
gltf = {
    "asset": {"version": "2.0", "generator": "make.py"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
    "meshes": meshes, "materials": materials, "textures": [{"source": 0}, {"source": 1}], "images": images,
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "aspectRatio": 1.5}}], "extensionsUsed": used,
    "accessors": accessors, "bufferViews": views,
}
while len(data) % 4:
    data.append(0)
gltf["buffers"] = [{"byteLength": len(data)}]
text = json.dumps(gltf, separators=(",", ":")).encode()
text += b" " * (-len(text) % 4)
with open(os.path.join(HERE, "still-life.glb"), "wb") as file:
    file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
    file.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + bytes(data))
