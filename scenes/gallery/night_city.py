#!/usr/bin/env python3
"""Writes night-city.toml and its meshes: a city by night, lit by thousands of windows and street lamps and nothing else.

    scenes/gallery/night_city.py

Streets every 12 m, blocks of towers; each lit window is two triangles of an emissive mesh, each street lamp a light with a photometric file.
"""
import os
import random
import struct

HERE = os.path.dirname(os.path.abspath(__file__))
MESHES = os.path.join(HERE, "..", "meshes")
rng = random.Random(2018)


def write_ply(name, quads):
    """Quads of four corners, counter-clockwise from outside."""
    with open(os.path.join(MESHES, name), "wb") as out:
        out.write(("ply\nformat binary_little_endian 1.0\n"
                   f"element vertex {4 * len(quads)}\nproperty float x\nproperty float y\nproperty float z\n"
                   f"element face {len(quads)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        for quad in quads:
            for corner in quad:
                out.write(struct.pack("<3f", *corner))
        for i in range(len(quads)):
            out.write(struct.pack("<B4i", 4, 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3))


walls, roofs = [], []
windows = {"warm": [], "white": [], "blue": []}
lamps = []


def tower(x0, x1, z0, z1, height):
    corners = [(x0, z1), (x1, z1), (x1, z0), (x0, z0)]
    for i in range(4):
        (ax, az), (bx, bz) = corners[i], corners[(i + 1) % 4]
        walls.append([(ax, 0, az), (bx, 0, bz), (bx, height, bz), (ax, height, az)])
        length = abs(bx - ax) + abs(bz - az)
        dx, dz = (bx - ax) / length, (bz - az) / length
        nx, nz = -dz, dx  # outwards
        columns = max(int(length / 0.8), 1)
        for row in range(1, int(height / 0.9)):
            lit = 0.13 if rng.random() < 0.9 else 0.6
            for column in range(columns):
                if rng.random() > lit:
                    continue
                kind = rng.choices(["warm", "white", "blue"], [0.72, 0.22, 0.06])[0]
                s = (column + 0.5) * length / columns
                y = row * 0.9
                px, pz = ax + dx * s + nx * 0.01, az + dz * s + nz * 0.01
                w, h = 0.22, 0.25
                windows[kind].append([(px - dx * w, y - h, pz - dz * w), (px + dx * w, y - h, pz + dz * w),
                                      (px + dx * w, y + h, pz + dz * w), (px - dx * w, y + h, pz - dz * w)])
    roofs.append([(x0, height, z1), (x1, height, z1), (x1, height, z0), (x0, height, z0)])


BLOCK = 12.0
for bx in range(-5, 6):
    for bz in range(-8, 3):
        cx, cz = bx * BLOCK, bz * BLOCK
        middle = max(0.0, 1.0 - ((bx - 1) ** 2 + (bz + 3) ** 2) / 40.0)
        for qx in (-1, 1):
            for qz in (-1, 1):
                if bx == 0 and bz == 1:
                    continue  # an empty square
                height = 3.0 + 5.0 * rng.random() + 16.0 * middle * rng.random() ** 2
                x, z = cx + qx * 2.15, cz + qz * 2.15
                half = 1.5 + 0.45 * rng.random()
                tower(x - half, x + half, z - half, z + half, height)
        # Lamps along the streets to the left and in front of the block.
        for i in range(4):
            along = (i + 0.5) * BLOCK / 4 - BLOCK / 2
            lamps.append((cx - BLOCK / 2 + 1.0, cz + along, 1.0, 0.0))
            lamps.append((cx + along, cz - BLOCK / 2 + 1.0, 0.0, 1.0))

write_ply("night-walls.ply", walls)
write_ply("night-roofs.ply", roofs)
for kind, quads in windows.items():
    write_ply(f"night-windows-{kind}.ply", quads)
count = sum(len(quads) for quads in windows.values())
with open(os.path.join(HERE, "night-city.toml"), "w") as out:
    out.write(f"""# A city by night: {count} lit windows, two triangles each, and {len(lamps)} street lamps with a photometric file. Made by night_city.py.

[render]
size = [1280, 720]
spp = 512
exposure = 3.4
view = "agx"
bounces = 6

[camera]
position = [7, 13.5, 34]
look_at = [2, 5.5, -12]
fov = 52

[sky]
elevation = -9
azimuth = 300
turbidity = 4

[material.wall]
type = "diffuse"
color = [0.32, 0.3, 0.28]

[material.roof]
type = "diffuse"
color = [0.16, 0.16, 0.17]

[material.asphalt]
type = "plastic"
color = [0.06, 0.06, 0.065]
roughness = 0.35

[material.warm]
type = "diffuse"
color = [0.05, 0.05, 0.05]
emission = {{ blackbody = 2800, scale = 1.1 }}

[material.white]
type = "diffuse"
color = [0.05, 0.05, 0.05]
emission = {{ blackbody = 4300, scale = 1.3 }}

[material.blue]
type = "diffuse"
color = [0.05, 0.05, 0.05]
emission = {{ rgb = [0.25, 0.55, 1], scale = 1 }}

[[plane]]
normal = [0, 1, 0]
material = "asphalt"
""")
    for name, material in [("walls", "wall"), ("roofs", "roof")] + [(f"windows-{kind}", kind) for kind in windows]:
        out.write(f'\n[[mesh]]\nfile = "../meshes/night-{name}.ply"\nmaterial = "{material}"\n')
    for x, z, fx, fz in lamps:
        out.write(f'\n[[light]]\ntype = "ies"\nfile = "../lamps/street.ies"\nposition = [{x:g}, 2.2, {z:g}]\nforward = [{fz:g}, 0, {fx:g}]\n'
                  'power = { blackbody = 2100, scale = 0.012 }\n')
print(count, "windows,", len(lamps), "lamps,", len(walls), "walls")
