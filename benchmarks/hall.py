#!/usr/bin/python3
"""Writes a heavy scene for measuring: an open hall of about 1.7 million triangles under sun and sky, with five textures.

  benchmarks/hall.py FOLDER [DETAIL]        FOLDER/hall.toml, .ply and .png files; DETAIL 1 is the full number of triangles

Columns with flutes carry two rows of round arches; a vaulted ceiling covers the aisles, the middle is open to the sky. The floor, the walls and the steps
are uneven, so that no triangle can be left out. Needs numpy (apt-get install python3-numpy).
"""
import pathlib
import struct
import sys
import zlib

import numpy as np

length, aisle, nave, height = 28.0, 3.2, 6.0, 8.0  # metres: along z, each side, the open middle, to the ceiling


class Hall:
    def __init__(self, folder, detail):
        self.folder, self.detail = folder, np.sqrt(0.516 * detail)
        self.parts = {}

    def sheet(self, material, columns, rows, points, uv_scale=(1.0, 1.0)):
        """A grid of points (s, t) -> (x, y, z), s and t from 0 to 1; its front is where s x t points."""
        m, n = (max(3, round(count * self.detail)) for count in (columns, rows))
        s, t = np.meshgrid(np.linspace(0.0, 1.0, m + 1), np.linspace(0.0, 1.0, n + 1), indexing="ij")
        p = np.stack(np.broadcast_arrays(*points(s, t)), axis=-1)
        normal = np.cross(np.gradient(p, axis=0), np.gradient(p, axis=1))
        normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12)
        vertices = np.concatenate([p, normal, (s * uv_scale[0])[..., None], (t * uv_scale[1])[..., None]], axis=-1).reshape(-1, 8)
        corner = (np.arange(m)[:, None] * (n + 1) + np.arange(n)).ravel()
        quads = np.stack([corner, corner + n + 1, corner + n + 2, corner + 1], axis=1)
        faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        self.parts.setdefault(material, []).append((vertices.astype("<f4"), faces))

    def write(self):
        count = 0
        for material, sheets in self.parts.items():
            starts = np.cumsum([0] + [len(v) for v, _ in sheets[:-1]])
            vertices = np.concatenate([v for v, _ in sheets])
            faces = np.concatenate([f + start for (_, f), start in zip(sheets, starts)])
            records = np.empty(len(faces), dtype=[("corners", "u1"), ("corner", "<i4", 3)])
            records["corners"], records["corner"] = 3, faces
            names = "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz", "u", "v"))
            header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n{names}"
                      f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
            (self.folder / f"{material}.ply").write_bytes(header.encode() + vertices.tobytes() + records.tobytes())
            count += len(faces)
        return count


def waves(x, y, seed):
    """A sum of sines in random directions, from -1 to 1."""
    random = np.random.default_rng(seed)
    total = np.zeros(np.broadcast(x, y).shape)
    for octave in range(1, 9):
        angle, phase = random.uniform(0.0, 2.0 * np.pi, 2)
        frequency = 1.6 ** octave
        total += np.sin(frequency * (x * np.cos(angle) + y * np.sin(angle)) + phase) / octave
    return total / 2.72


def build(hall):
    half = nave / 2
    wall = half + aisle
    hall.sheet("floor", 340, 700, lambda s, t: ((2 * s - 1) * wall, 0.02 * waves(12 * s, 30 * t, 1), (1 - 2 * t) * length / 2), (6, 14))
    for side in (-1, 1):
        hall.sheet("plaster", 600, 220, lambda s, t: (side * (wall + 0.03 * waves(25 * s, 8 * t, 2)), height * t, side * (2 * s - 1) * length / 2), (9, 3))
        hall.sheet("plaster", 300, 220,
                   lambda s, t: (side * (1 - 2 * s) * wall, height * t, side * (length / 2 + 0.03 * waves(11 * s, 8 * t, 3))), (4, 3))
        hall.sheet("plaster", 200, 500, lambda s, t: (side * (half + aisle * s), height - 1.0 + 1.0 * np.sin(np.pi * s) ** 0.8, side * (1 - 2 * t) * length / 2), (2, 9))
    bays = np.linspace(-length / 2 + 2, length / 2 - 2, 9)
    for x in (-half, half):
        for z in bays:
            def column(s, t, x=x, z=z):
                angle = 2 * np.pi * s
                radius = 0.32 - 0.05 * t + 0.14 * np.exp(-30 * t) + 0.14 * np.exp(-30 * (1 - t))
                radius = radius * (1 - 0.05 * np.abs(np.sin(9 * angle)))
                return x + radius * np.cos(angle), 4.6 * t, z - radius * np.sin(angle)
            hall.sheet("stone", 150, 130, lambda s, t: column(s, t), (2, 5))
        for low, high in zip(bays[:-1], bays[1:]):
            def arch(s, t, x=x, low=low, high=high):
                along, around = np.pi * s, 2 * np.pi * t
                radius = (high - low) / 2 + 0.2 * np.cos(around)
                return x + 0.2 * np.sin(around), 4.6 + 0.85 * radius * np.sin(along), (low + high) / 2 - radius * np.cos(along)
            hall.sheet("stone", 110, 44, lambda s, t: arch(s, t), (5, 1))
            def banner(s, t, x=x, low=low, high=high):
                return (x + 0.06 * np.sin(21 * s) * (0.3 + t), 4.4 - 2.2 * t, (low + high) / 2 + np.sign(-x) * (0.5 - s) * 1.6)
            hall.sheet("cloth", 110, 80, lambda s, t: banner(s, t), (1, 2))
    random = np.random.default_rng(5)
    for _ in range(150):
        x, z, size = random.uniform(-half + 0.6, half - 0.6), random.uniform(-12, 12), random.uniform(0.08, 0.3)
        def pot(s, t, x=x, z=z, size=size):
            angle = 2 * np.pi * s
            radius = size * (0.35 + 0.65 * np.sin(np.pi * (0.1 + 0.8 * t))) * (1 + 0.04 * np.sin(11 * angle + 9 * t))
            return x + radius * np.cos(angle), 2.4 * size * t, z - radius * np.sin(angle)
        hall.sheet("glaze", 44, 40, lambda s, t: pot(s, t), (3, 2))


def write_png(path, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows, columns, _ = pixels.shape
    raw = np.concatenate([np.zeros((rows, 1), np.uint8), pixels.reshape(rows, -1)], axis=1).tobytes()
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(raw, 6)) + chunk(b"IEND", b""))


def paint(folder):
    y, x = np.mgrid[0:1024, 0:1024] / 1024.0
    grain = waves(60 * x, 60 * y, 11)[..., None]
    tiles = ((np.floor(6 * x) + np.floor(6 * y)) % 2)[..., None]
    stripes = (np.floor(10 * x) % 3 == 0)[..., None]
    pictures = {"floor": np.where(tiles > 0.5, [0.78, 0.74, 0.66], [0.36, 0.24, 0.20]) + 0.05 * grain,
                "plaster": np.array([0.82, 0.72, 0.58]) + 0.07 * grain,
                "stone": np.array([0.72, 0.70, 0.66]) + 0.09 * grain,
                "cloth": np.where(stripes, [0.75, 0.66, 0.25], [0.55, 0.10, 0.12]) + 0.03 * grain,
                "glaze": np.array([0.20, 0.42, 0.58]) + 0.12 * np.sign(grain)}
    for name, color in pictures.items():
        write_png(folder / f"{name}.png", (np.clip(color, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8))
    return list(pictures)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    hall = Hall(folder, float(sys.argv[2]) if len(sys.argv) > 2 else 1.0)
    build(hall)
    text = """# A hall under sun and sky, made by benchmarks/hall.py.

[render]
size = [1280, 720]
spp = 8
bounces = 6
filter = "box"

[camera]
position = [-1.6, 1.9, 12.4]
look_at = [0.9, 3.1, 0]
fov = 62
fov_axis = "height"

[background]
color = [0.7, 0.85, 1.1]

[[light]]
type = "directional"
direction = [-0.42, -0.9, -0.3]
power = [12, 11, 9.5]
"""
    for name in paint(folder):
        text += f"""
[material.{name}]
type = "diffuse"
color = {{ type = "image", file = "{name}.png" }}

[[mesh]]
file = "{name}.ply"
material = "{name}"
"""
    (folder / "hall.toml").write_text(text)
    print(f"{hall.write()} triangles")


if __name__ == "__main__":
    main()
