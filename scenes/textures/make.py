#!/usr/bin/env python3
"""Makes the textures of the example scenes again, beside this file. Needs nothing but Python 3.

    grid.png    8 x 4 fields, lettered A to H from left to right and numbered 1 to 4 from the bottom up: shows at once how a texture lies
    tiles.png   a glazed tile that repeats without a seam
    planet.png  continents of noise, for a sphere
    wood.png    rings of a tree, cut along; repeats from top to bottom
    sky.hdr     an afternoon: a low sun and soft clouds over a plain, as radiance all around
    leaf.png    a leaf; what is not leaf has alpha 0
    studs.png   normals of round studs in a plate: red to the right, green upwards, blue outwards; numbers, no colours
    slit.png    a white strip: what a projector throws through a slit
    scratches.png   streaks along u, white where a surface is worn; numbers, no colours
"""
import colorsys
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
FONT = {"A": "01110 10001 10001 11111 10001 10001 10001", "B": "11110 10001 10001 11110 10001 10001 11110",
        "C": "01111 10000 10000 10000 10000 10000 01111", "D": "11110 10001 10001 10001 10001 10001 11110",
        "E": "11111 10000 10000 11110 10000 10000 11111", "F": "11111 10000 10000 11110 10000 10000 10000",
        "G": "01111 10000 10000 10011 10001 10001 01111", "H": "10001 10001 10001 11111 10001 10001 10001",
        "1": "00100 01100 00100 00100 00100 00100 01110", "2": "01110 10001 00001 00110 01000 10000 11111",
        "3": "11110 00001 00001 01110 00001 00001 11110", "4": "00010 00110 01010 10010 11111 00010 00010"}


def write_png(name, width, height, color):
    """color(x, y) gives (r, g, b) or (r, g, b, alpha) from 0 to 1 as stored, y from the top."""
    kind_of_png = 6 if len(color(0, 0)) == 4 else 2
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            rows += bytes(min(255, max(0, round(255 * c))) for c in color(x, y))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(os.path.join(HERE, name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind_of_png, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def grid():
    cell, columns, lines, dot = 64, 8, 4, 5

    def color(x, y):
        column, line = x // cell, lines - 1 - y // cell
        light = 0.93 if (column + line) % 2 else 0.72
        paper = colorsys.hsv_to_rgb(column / columns, 0.18 + 0.16 * line, light)
        i, j = x % cell, y % cell
        if i < 2 or j < 2:
            return (1, 1, 1)
        for sign, left in (("ABCDEFGH"[column], 5), ("1234"[line], 34)):
            a, b = (i - left) // dot, (j - 15) // dot
            if 0 <= a < 5 and 0 <= b < 7 and FONT[sign].split()[b][a] == "1":
                return (0.1, 0.1, 0.14)
        return paper

    write_png("grid.png", cell * columns, cell * lines, color)


def hashed(*key):
    return zlib.crc32(repr(key).encode()) / 0xFFFFFFFF


def smooth(t): return t * t * (3 - 2 * t)


def noise(x, y, z):
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = smooth(x - i), smooth(y - j), smooth(z - k)
    total = 0.0
    for a in (0, 1):
        for b in (0, 1):
            for c in (0, 1):
                total += hashed(i + a, j + b, k + c) * (u if a else 1 - u) * (v if b else 1 - v) * (w if c else 1 - w)
    return total


def clouds(x, y, z, octaves=6):
    return sum(noise(x * 2 ** o + 7.3 * o, y * 2 ** o, z * 2 ** o) / 2 ** (o + 1) for o in range(octaves))


def mix(a, b, t):
    t = min(1.0, max(0.0, t))
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def planet():
    width, height = 512, 256

    def color(x, y):
        around, up = 2 * math.pi * (x + 0.5) / width, math.pi * (0.5 - (y + 0.5) / height)
        p = [math.cos(up) * math.cos(around), math.sin(up), math.cos(up) * math.sin(around)]
        land = clouds(*(1.7 * c + 3 for c in p))
        ice = abs(p[1]) + 0.35 * (land - 0.5)
        sea = mix((0.03, 0.10, 0.28), (0.10, 0.34, 0.50), (land - 0.30) / 0.20)
        ground = mix((0.27, 0.40, 0.16), (0.62, 0.52, 0.33), (land - 0.52) / 0.14)
        ground = mix(ground, (0.86, 0.84, 0.80), (land - 0.66) / 0.06)
        return mix(ground if land > 0.505 else sea, (0.95, 0.97, 0.99), (ice - 0.86) / 0.05)

    write_png("planet.png", width, height, color)


def tiles():
    size = 128

    def color(x, y):
        u, v = (x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1
        a, r = math.atan2(v, u), math.hypot(u, v)
        corner = math.hypot(1 - abs(u), 1 - abs(v))
        white, blue, pale, ochre = (0.93, 0.92, 0.87), (0.10, 0.24, 0.52), (0.42, 0.60, 0.78), (0.85, 0.60, 0.22)
        c = white
        if r < 0.50 + 0.22 * abs(math.cos(2 * a)) ** 0.6:
            c = blue
        if r < 0.42 + 0.19 * abs(math.cos(2 * a)) ** 0.6:
            c = pale
        if r < 0.34 * (0.55 + 0.45 * abs(math.cos(4 * a))):
            c = white
        if r < 0.12:
            c = ochre
        if corner < 0.42:
            c = blue
        if corner < 0.34:
            c = ochre
        if corner < 0.20:
            c = white
        if max(abs(u), abs(v)) > 0.965:
            c = (0.55, 0.54, 0.50)
        return c

    write_png("tiles.png", size, size, color)


def wood():
    width, height = 512, 256

    def color(x, y):
        u, v = x / width, y / height
        a = 2 * math.pi * v
        bend = clouds(u * 1.5, 1.2 * math.cos(a) + 5, 1.2 * math.sin(a) + 5, 3)
        ring = (8 * v + 3.2 * bend) % 1.0
        fibre = noise(u * 30, 40 * math.cos(a), 40 * math.sin(a))
        c = mix((0.66, 0.42, 0.22), (0.42, 0.23, 0.10), smooth(ring) * 0.85)
        return mix(c, (0.30, 0.16, 0.07), 0.25 * fibre)

    write_png("wood.png", width, height, color)


def write_hdr(name, width, height, color):
    """color(x, y) gives linear (r, g, b). Radiance's format: a shared exponent, and runs of equal bytes in each row."""

    def shared(rgb):
        largest = max(rgb)
        if largest < 1e-32:
            return (0, 0, 0, 0)
        mantissa, exponent = math.frexp(largest)
        return tuple(int(c * mantissa * 256 / largest) for c in rgb) + (exponent + 128,)

    def packed(row):
        out, i = bytearray(), 0
        while i < len(row):
            run = 1
            while i + run < len(row) and run < 127 and row[i + run] == row[i]:
                run += 1
            if run > 2:
                out += bytes((128 + run, row[i]))
                i += run
                continue
            j = i + 1
            while j < len(row) and j - i < 128 and not (j + 2 < len(row) and row[j] == row[j + 1] == row[j + 2]):
                j += 1
            out += bytes((j - i,)) + bytes(row[i:j])
            i = j
        return out

    data = bytearray(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode())
    for y in range(height):
        row = [shared(color(x, y)) for x in range(width)]
        data += bytes((2, 2, width >> 8, width & 255))
        for channel in range(4):
            data += packed([texel[channel] for texel in row])
    with open(os.path.join(HERE, name), "wb") as file:
        file.write(data)


def sky():
    width, height = 384, 192
    azimuth, elevation = math.radians(55), math.radians(24)  # of the sun, from the picture's middle to the right
    sun = (math.sin(azimuth) * math.cos(elevation), math.sin(elevation), -math.cos(azimuth) * math.cos(elevation))

    def color(x, y):
        theta, phi = math.pi * (y + 0.5) / height, 2 * math.pi * ((x + 0.5) / width - 0.5)
        d = (math.sin(phi) * math.sin(theta), math.cos(theta), -math.cos(phi) * math.sin(theta))
        near = sum(i * j for i, j in zip(d, sun))
        if d[1] < 0:
            return mix((0.30, 0.26, 0.21), (0.13, 0.11, 0.08), -d[1] * 3)
        light = mix((0.95, 0.93, 0.90), (0.16, 0.34, 0.82), d[1] ** 0.45)
        glow = max(0, near)
        light = tuple(c + g * (0.55 * glow ** 8 + 2.5 * glow ** 90) for c, g in zip(light, (1.0, 0.78, 0.5)))
        far = 1 / (d[1] + 0.12)
        cover = (clouds(9 + 0.9 * d[0] * far, 3, 9 + 0.9 * d[2] * far, 5) - 0.47) * 6
        lit = mix((0.55, 0.58, 0.66), (1.7, 1.55, 1.35), 0.35 + 0.65 * glow ** 2)
        light = mix(light, lit, min(1, max(0, cover)) * min(1, d[1] * 5))
        disk = 1 / (1 + math.exp((math.acos(min(1, near)) - math.radians(1.3)) / math.radians(0.25)))
        return tuple(c + s * disk for c, s in zip(light, (1250, 1080, 830)))

    write_hdr("sky.hdr", width, height, color)


def leaf():
    size = 256

    def color(x, y):
        u, v = (x + 0.5) / size * 2 - 1, 1 - (y + 0.5) / size * 2  # v upwards
        along = (v + 0.9) / 1.75
        half = 0.62 * math.sin(math.pi * min(1.0, max(0.0, along)) ** 0.75) ** 0.9 + 0.03 * math.cos(40 * along)
        stem = abs(u) < 0.025 and -0.98 < v < 0.8
        inside = 0 < along < 1 and abs(u) < half
        ribs = abs(math.sin(9 * (v - 0.55 * abs(u)) * math.pi / 2))
        green = mix((0.20, 0.42, 0.10), (0.42, 0.58, 0.18), smooth(ribs))
        if stem or (inside and ribs < 0.12):
            green = (0.55, 0.66, 0.30)
        return green + ((1.0,) if inside or stem else (0.0,))

    write_png("leaf.png", size, size, color)


def studs():
    size = 128

    def color(x, y):
        u, v = (x + 0.5) / size * 2 - 1, 1 - (y + 0.5) / size * 2
        r = math.hypot(u, v)
        nx, ny, nz = 0.0, 0.0, 1.0
        if r < 0.6:
            nx, ny = 1.3 * u, 1.3 * v
            nz = math.sqrt(max(0.0, 1 - nx * nx - ny * ny))
        edge = max(abs(u), abs(v))
        if edge > 0.94:
            nx = math.copysign(0.5, -u) if abs(u) > 0.94 else 0.0
            ny = math.copysign(0.5, -v) if abs(v) > 0.94 else 0.0
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        return (0.5 + 0.5 * nx / length, 0.5 + 0.5 * ny / length, 0.5 + 0.5 * nz / length)

    write_png("studs.png", size, size, color)


def scratches():
    width, height = 256, 256

    def color(x, y):
        worn = clouds(x / 32, y / 32, 2.5, 4)
        streak = noise(x / 24, y / 1.5, 0.5)
        t = smooth(min(1.0, max(0.0, (worn - 0.42) * 5))) * 0.75 + 0.25 * streak
        return (t, t, t)

    write_png("scratches.png", width, height, color)


def slit():
    """White; a projector's picture, narrow and high."""
    write_png("slit.png", 1, 24, lambda x, y: (1.0, 1.0, 1.0))


if __name__ == "__main__":
    grid()
    tiles()
    planet()
    wood()
    sky()
    leaf()
    studs()
    scratches()
    slit()
