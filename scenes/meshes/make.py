#!/usr/bin/env python3
"""Makes the meshes of the example scenes again, beside this file. Needs nothing but Python 3.

    torus-knot.ply   a tube along a (2, 3) torus knot; binary, with normals
    blob.ply         an icosahedron, subdivided and dented; ascii, with normals
    gem.obj          a round brilliant: 57 facets and a faceted girdle
    vase.obj         a turned vase, with normals and texture coordinates
    goblet.ply, wine.ply  a wine glass of height 2.2, and what is in it: wine that reaches a little into the glass; binary, with normals
    still-life.obj   a table with a bowl, fruit, a mirror and a vase, with the materials of still-life.mtl
    ring.ply         a finger ring: outer radius 1, height 0.36; binary, with normals
    pawn.ply, queen.ply, bishop.ply, king.ply, rook.ply   turned chessmen; binary, with normals
"""
import math
import os
import struct

HERE = os.path.dirname(os.path.abspath(__file__))


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def mul(a, s): return [x * s for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def unit(a): return mul(a, 1 / math.sqrt(dot(a, a)))


def write_ply(name, positions, normals, triangles, binary):
    header = ["ply", f"format {'binary_little_endian' if binary else 'ascii'} 1.0", "comment made by make.py",
              f"element vertex {len(positions)}"]
    header += [f"property float {p}" for p in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    with open(os.path.join(HERE, name), "wb") as file:
        file.write(("\n".join(header) + "\n").encode())
        for p, n in zip(positions, normals):
            file.write(struct.pack("<6f", *p, *n) if binary else (" ".join(f"{x:.5f}" for x in p + n) + "\n").encode())
        for t in triangles:
            file.write(struct.pack("<B3i", 3, *t) if binary else f"3 {t[0]} {t[1]} {t[2]}\n".encode())


def torus_knot(around=320, ring=20, tube=0.33):
    def center(t):
        r = 2 + math.cos(3 * t)
        return [r * math.cos(2 * t) / 2, math.sin(3 * t) / 2, r * math.sin(2 * t) / 2]

    positions, normals, triangles = [], [], []
    for i in range(around):
        t = 2 * math.pi * i / around
        c = center(t)
        along = unit(sub(center(t + 1e-4), center(t - 1e-4)))
        side = unit(cross(along, unit(c)))
        up = cross(side, along)
        for j in range(ring):
            a = 2 * math.pi * j / ring
            n = add(mul(side, math.cos(a)), mul(up, math.sin(a)))
            positions.append(add(c, mul(n, tube)))
            normals.append(n)
            k, l = (i + 1) % around, (j + 1) % ring
            triangles += [(i * ring + j, i * ring + l, k * ring + j), (k * ring + j, i * ring + l, k * ring + l)]
    write_ply("torus-knot.ply", positions, normals, orient(positions, normals, triangles), True)


def orient(positions, normals, triangles):
    """Counter-clockwise seen from where the normals point."""
    result = []
    for a, b, c in triangles:
        n = cross(sub(positions[b], positions[a]), sub(positions[c], positions[a]))
        if dot(n, n) > 1e-20:
            result.append((a, b, c) if dot(n, normals[a]) + dot(n, normals[b]) + dot(n, normals[c]) > 0 else (a, c, b))
    return result


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    points = [unit(p) for p in ([-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g], [0, -1, -g], [0, 1, -g],
                                [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1])]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle = {}

        def half(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(unit(add(points[a], points[b])))
            return middle[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = half(a, b), half(b, c), half(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return points, faces


def blob():
    points, faces = icosphere(4)

    def radius(p):
        return 1 + 0.13 * math.sin(4 * p[0] + 1) * math.sin(4 * p[1]) * math.cos(4 * p[2]) + 0.05 * math.sin(9 * p[1] + 3 * p[0])

    positions = [mul(p, radius(p)) for p in points]
    normals = [[0.0, 0.0, 0.0] for _ in positions]
    for a, b, c in faces:
        n = cross(sub(positions[b], positions[a]), sub(positions[c], positions[a]))
        for i in (a, b, c):
            normals[i] = add(normals[i], n)
    write_ply("blob.ply", positions, [unit(n) for n in normals], faces, False)


def brilliant():
    """Facets as planes n . p <= d, the angles usual for diamonds; the corners are where three planes meet inside all others."""
    planes = [([0, 1, 0], None)]
    crown, pavilion, star, upper, lower = 34.5, 40.75, 22.0, 41.5, 41.9
    girdle, table = 0.02, 0.56  # half height of the girdle, radius of the table's corners; the girdle's radius is 1
    table_height = girdle + (1 - table) * math.tan(math.radians(crown))
    planes[0] = ([0, 1, 0], table_height)

    def facet(azimuth, angle, through, downwards=False):
        a, b = math.radians(azimuth), math.radians(angle)
        n = [math.sin(b) * math.cos(a), -math.cos(b) if downwards else math.cos(b), math.sin(b) * math.sin(a)]
        planes.append((n, dot(n, through)))

    def at(radius, azimuth, height):
        return [radius * math.cos(math.radians(azimuth)), height, radius * math.sin(math.radians(azimuth))]

    for k in range(8):
        facet(45 * k, crown, at(1, 45 * k, girdle))
        facet(45 * k + 22.5, star, at(table, 45 * k, table_height))
        facet(45 * k, pavilion, at(1, 45 * k, -girdle), True)
    for k in range(16):
        facet(22.5 * k + 11.25, upper, at(1, 22.5 * k + 11.25, girdle))
        facet(22.5 * k + 11.25, lower, at(1, 22.5 * k + 11.25, -girdle), True)
    for k in range(32):
        facet(11.25 * k, 90, at(1, 11.25 * k, 0))

    corners = []
    for i in range(len(planes)):
        for j in range(i + 1, len(planes)):
            for k in range(j + 1, len(planes)):
                (n1, d1), (n2, d2), (n3, d3) = planes[i], planes[j], planes[k]
                det = dot(n1, cross(n2, n3))
                if abs(det) < 1e-9:
                    continue
                p = mul(add(add(mul(cross(n2, n3), d1), mul(cross(n3, n1), d2)), mul(cross(n1, n2), d3)), 1 / det)
                if all(dot(n, p) <= d + 1e-9 for n, d in planes) and all(dot(sub(p, q), sub(p, q)) > 1e-10 for q in corners):
                    corners.append(p)
    lines = ["# A round brilliant, made by make.py: y is up, the girdle's radius is 1."]
    lines += [f"v {p[0]:.6f} {p[1]:.6f} {p[2]:.6f}" for p in corners]
    for n, d in planes:
        on = [i for i, p in enumerate(corners) if abs(dot(n, p) - d) < 1e-7]
        if len(on) < 3:
            continue
        middle = mul([sum(corners[i][k] for i in on) for k in range(3)], 1 / len(on))
        u = unit(sub(corners[on[0]], middle))
        v = cross(n, u)
        on.sort(key=lambda i: math.atan2(dot(sub(corners[i], middle), v), dot(sub(corners[i], middle), u)))
        lines.append("f " + " ".join(str(i + 1) for i in on))
    with open(os.path.join(HERE, "gem.obj"), "w") as file:
        file.write("\n".join(lines) + "\n")


def spline(points, steps):
    """A smooth line through [radius, height] points; a point given twice is a sharp edge."""
    pieces, piece = [], [points[0]]
    for p in points[1:]:
        if p == piece[-1]:
            pieces.append(piece)
            piece = []
        piece.append(p)
    pieces.append(piece)
    result = []
    for q in pieces:
        line = []
        for i in range(len(q) - 1):
            p0, p1, p2, p3 = q[max(i - 1, 0)], q[i], q[i + 1], q[min(i + 2, len(q) - 1)]
            n = steps if len(q) > 2 else 1
            for s in range(n):
                t = s / n
                line.append([0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t ** 3)
                             for a, b, c, d in zip(p0, p1, p2, p3)])
        line.append(q[-1])
        result.append([[r if r > 1e-9 else 0.0, h] for r, h in line])
    return result


def lathe(points, around, steps):
    """Turns a line about the y axis: positions, normals, uvs, triangles."""
    positions, normals, uvs, triangles = [], [], [], []
    top = max(p[1] for p in points)
    bottom = min(p[1] for p in points)
    for line in spline(points, steps):
        first = len(positions)
        for i, (r, h) in enumerate(line):
            before, after = line[max(i - 1, 0)], line[min(i + 1, len(line) - 1)]
            nr, nh = after[1] - before[1], before[0] - after[0]
            size = math.hypot(nr, nh) or 1.0
            for j in range(around + 1):
                a = 2 * math.pi * (j % around) / around  # the seam closes to the last bit
                positions.append([r * math.cos(a), h, -r * math.sin(a)])
                normals.append([nr / size * math.cos(a), nh / size, -nr / size * math.sin(a)])
                uvs.append([j / around, (h - bottom) / (top - bottom)])
        for i in range(len(line) - 1):
            for j in range(around):
                a = first + i * (around + 1) + j
                b = a + around + 1
                triangles += [(a, a + 1, b), (a + 1, b + 1, b)]
    return positions, normals, uvs, orient(positions, normals, triangles)


def vase():
    outside = [[0, 0], [0.42, 0], [0.42, 0], [0.46, 0.04], [0.62, 0.35], [0.72, 0.75], [0.6, 1.15], [0.34, 1.5], [0.27, 1.75], [0.36, 1.95],
               [0.44, 2.02], [0.44, 2.02], [0.40, 2.02], [0.40, 2.02], [0.32, 1.93], [0.235, 1.75], [0.3, 1.5], [0.56, 1.15], [0.68, 0.75],
               [0.58, 0.35], [0.4, 0.06], [0, 0.05]]
    positions, normals, uvs, triangles = lathe(outside, 36, 3)
    lines = ["# A turned vase, made by make.py."]
    lines += [f"v {p[0]:.4f} {p[1]:.4f} {p[2]:.4f}" for p in positions]
    lines += [f"vt {t[0]:.4f} {t[1]:.4f}" for t in uvs]
    lines += [f"vn {n[0]:.3f} {n[1]:.3f} {n[2]:.3f}" for n in normals]
    lines += ["f " + " ".join(f"{i + 1}/{i + 1}/{i + 1}" for i in t) for t in triangles]
    with open(os.path.join(HERE, "vase.obj"), "w") as file:
        file.write("\n".join(lines) + "\n")


def goblet():
    glass = [[0, 0], [0.7, 0], [0.7, 0], [0.7, 0.025], [0.7, 0.025], [0.4, 0.06], [0.12, 0.13], [0.07, 0.3], [0.06, 0.6], [0.08, 0.9], [0.2, 1.03],
             [0.45, 1.2], [0.62, 1.5], [0.62, 1.85], [0.54, 2.2], [0.54, 2.2], [0.52, 2.2], [0.52, 2.2], [0.595, 1.85], [0.595, 1.5], [0.43, 1.23],
             [0.19, 1.07], [0, 1.03]]
    wine = [[0, 1.02], [0.195, 1.06], [0.437, 1.222], [0.604, 1.5], [0.607, 1.6], [0.607, 1.6], [0, 1.6]]
    for name, line in (("goblet", glass), ("wine", wine)):
        positions, normals, _, triangles = lathe(line, 72, 6)
        write_ply(name + ".ply", positions, normals, triangles, True)


def ring():
    # Comfortably rounded within, nearly flat without.
    outline = []
    for i in range(65):
        a = 2 * math.pi * i / 64
        x, y = math.cos(a), math.sin(a)
        outline.append([0.9 + 0.1 * math.copysign(abs(x) ** 0.7, x) * (1.0 if x > 0 else 0.8), 0.18 + 0.18 * math.copysign(abs(y) ** 0.5, y)])
    outline[-1] = list(outline[0])
    positions, normals, _, triangles = lathe(outline, 192, 1)
    # The line is closed: its ends have one normal.
    n = 193
    for j in range(n):
        meeting = unit(add(normals[j], normals[-n + j]))
        normals[j] = normals[-n + j] = meeting
    write_ply("ring.ply", positions, normals, triangles, True)


FOOT = [[0, 0], [0.40, 0], [0.40, 0], [0.42, 0.05], [0.41, 0.12], [0.36, 0.17], [0.36, 0.17], [0.37, 0.21], [0.33, 0.27]]


def chessmen():
    def ball(center, radius, start=-60, end=90, steps=10):
        return [[radius * math.cos(math.radians(a)), center + radius * math.sin(math.radians(a))]
                for a in (start + (end - start) * i / steps for i in range(steps + 1))]

    men = {
        "pawn": FOOT + [[0.2, 0.45], [0.14, 0.68], [0.13, 0.78], [0.13, 0.78], [0.24, 0.80], [0.24, 0.84], [0.14, 0.87], [0.14, 0.87]]
        + ball(1.03, 0.21, -48),
        "rook": FOOT + [[0.25, 0.45], [0.21, 0.75], [0.22, 0.92], [0.22, 0.92], [0.3, 0.97], [0.3, 0.97], [0.3, 1.25], [0.3, 1.25], [0.21, 1.25],
                        [0.21, 1.25], [0.21, 1.15], [0.21, 1.15], [0, 1.15]],
        "bishop": FOOT + [[0.22, 0.5], [0.14, 0.85], [0.125, 1.02], [0.125, 1.02], [0.24, 1.05], [0.24, 1.09], [0.14, 1.13], [0.14, 1.13],
                          [0.205, 1.26], [0.2, 1.38], [0.12, 1.53], [0.05, 1.59], [0.05, 1.59]] + ball(1.63, 0.06, -40),
        "queen": FOOT + [[0.25, 0.5], [0.16, 0.95], [0.14, 1.2], [0.14, 1.2], [0.28, 1.24], [0.28, 1.28], [0.17, 1.32], [0.17, 1.32],
                         [0.19, 1.5], [0.29, 1.72], [0.29, 1.72], [0.25, 1.71], [0.18, 1.74], [0.08, 1.8], [0.08, 1.8]] + ball(1.86, 0.085, -40),
        "king": FOOT + [[0.26, 0.5], [0.17, 1.0], [0.15, 1.28], [0.15, 1.28], [0.29, 1.32], [0.29, 1.36], [0.18, 1.4], [0.18, 1.4],
                        [0.21, 1.6], [0.28, 1.82], [0.28, 1.82], [0.2, 1.9], [0, 1.94]],
    }
    for name, line in men.items():
        positions, normals, _, triangles = lathe(line, 40, 3)
        write_ply(name + ".ply", positions, normals, triangles, True)


def still_life():
    """Groups with materials; polygons of four corners; numbers that count backwards."""
    lines = ["# A still life, made by make.py; its materials are in still-life.mtl.", "mtllib still-life.mtl"]

    def part(name, material, positions, normals, uvs, faces):
        lines.extend([f"o {name}", f"usemtl {material}"])
        lines.extend(f"v {p[0]:.3f} {p[1]:.3f} {p[2]:.3f}" for p in positions)
        lines.extend(f"vt {t[0]:.3f} {t[1]:.3f}" for t in uvs)
        lines.extend(f"vn {n[0]:.2f} {n[1]:.2f} {n[2]:.2f}" for n in normals)
        count = len(positions)
        lines.extend("f " + " ".join(f"{i - count}/{i - count}/{i - count}" for i in face) for face in faces)

    def sheet(name, material, corner, along, up, times=1):
        positions = [corner, add(corner, along), add(add(corner, along), up), add(corner, up)]
        part(name, material, positions, [unit(cross(along, up))] * 4, [[0, 0], [times, 0], [times, times], [0, times]], [(0, 1, 2, 3)])

    def turned(name, material, line, at, around=30, steps=2):
        positions, normals, uvs, triangles = lathe(line, around, steps)
        part(name, material, [add(p, at) for p in positions], normals, uvs, triangles)

    def round_line(radius):
        return [[radius * math.sin(math.pi * i / 8), radius - radius * math.cos(math.pi * i / 8)] for i in range(9)]

    sheet("table", "wood", [-2.4, 0, 1.6], [4.8, 0, 0], [0, 0, -3.2], 2)
    sheet("wall", "plaster", [-2.4, 0, -1.6], [4.8, 0, 0], [0, 2.6, 0])
    sheet("mirror", "mirror", [-2.1, 0.05, -1.2], [1.9, 0, -0.2], [0, 1.9, -0.1])
    bowl = [[0, 0], [0.3, 0], [0.3, 0], [0.32, 0.03], [0.55, 0.12], [0.8, 0.36], [0.86, 0.5], [0.86, 0.5], [0.82, 0.5], [0.82, 0.5], [0.74, 0.36],
            [0.5, 0.17], [0, 0.12]]
    turned("bowl", "glaze", bowl, [0.15, 0, 0.1])
    turned("orange", "orange", round_line(0.3), [-0.1, 0.22, 0.2])
    turned("lemon", "lemon", round_line(0.25), [0.42, 0.27, 0.05])
    turned("golden apple", "gold", round_line(0.27), [1.35, 0, 0.75])
    glass = [[0, 0], [0.3, 0], [0.3, 0], [0.33, 0.05], [0.28, 0.5], [0.36, 1.1], [0.42, 1.3], [0.42, 1.3], [0.39, 1.3], [0.39, 1.3], [0.33, 1.1], [0.25, 0.5],
             [0.28, 0.12], [0, 0.1]]
    turned("vase", "glass", glass, [1.45, 0, -0.45])
    sheet("leaf", "leaf", [-1.5, 0.02, 1.3], [1.0, 0, 0.25], [0.1, 0.28, -0.85])
    with open(os.path.join(HERE, "still-life.obj"), "w") as file:
        file.write("\n".join(lines) + "\n")
    with open(os.path.join(HERE, "still-life.mtl"), "w") as file:
        file.write(MATERIALS)


MATERIALS = """# Made by make.py: one material of each kind.
newmtl wood
Kd 1 1 1
map_Kd -s 1 0.5 ../textures/wood.png
Ks 0.5 0.5 0.5
Ns 120

newmtl plaster
Kd 0.62 0.6 0.56
illum 1

newmtl mirror
Kd 0 0 0
Ks 0.92 0.92 0.92
illum 3

newmtl glaze
Kd 0.05 0.16 0.4
Pr 0.6
Pc 1
Pcr 0.05

newmtl orange
Kd 0.8 0.3 0.03
Ks 0.5 0.5 0.5
Ns 30

newmtl lemon
Kd 0.85 0.68 0.05
Ks 0.5 0.5 0.5
Ns 60

newmtl gold
Kd 1 0.72 0.3
Pm 1
Pr 0.25

newmtl glass
Ni 1.5
Tf 0.9 1 0.93
illum 7

newmtl leaf
Kd 1 1 1
map_Kd ../textures/leaf.png
map_d ../textures/leaf.png
illum 1
"""


if __name__ == "__main__":
    torus_knot()
    blob()
    brilliant()
    vase()
    goblet()
    ring()
    chessmen()
    still_life()
