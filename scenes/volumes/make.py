#!/usr/bin/env python3
"""Makes the grids of the example scenes again, beside this file. Needs nothing but Python 3.

    cloud.vol       a heap of cloud: densities from 0 to 1
    flame.vol       a flame: how much soot there is, from 0 to 1
    flame-heat.vol  and its temperatures in kelvin

A .vol file is "VOL", version 3, five 32-bit integers (1: floats; cells along x, y and z; channels), six floats (the box) and the values, x fastest.
"""
import math
import os
import struct

HERE = os.path.dirname(os.path.abspath(__file__))


def write_vol(name, size, low, high, value):
    """value(x, y, z) for the middles of the cells, each from 0 to 1."""
    columns, rows, layers = size
    values = [value((i + 0.5) / columns, (j + 0.5) / rows, (k + 0.5) / layers)
              for k in range(layers) for j in range(rows) for i in range(columns)]
    with open(os.path.join(HERE, name), "wb") as file:
        file.write(b"VOL\x03" + struct.pack("<5i6f", 1, columns, rows, layers, 1, *low, *high))
        file.write(struct.pack(f"<{len(values)}f", *values))


def lattice(x, y, z, seed):
    """A number from 0 to 1 for each whole point, without a pattern."""
    n = (x * 0x8DA6B343 + y * 0xD8163841 + z * 0xCB1AB31F + seed * 0x9E3779B1) & 0xFFFFFFFF
    n = ((n ^ (n >> 15)) * 0x2C1B3C6D) & 0xFFFFFFFF
    n = ((n ^ (n >> 12)) * 0x297A2D39) & 0xFFFFFFFF
    return (n ^ (n >> 15)) / 0xFFFFFFFF


def noise(x, y, z, seed):
    """Smooth between the points of the lattice."""
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = (t * t * (3 - 2 * t) for t in (x - i, y - j, z - k))
    def along(b, c):
        a0, a1 = lattice(i, b, c, seed), lattice(i + 1, b, c, seed)
        return a0 + (a1 - a0) * u
    def across(c):
        b0, b1 = along(j, c), along(j + 1, c)
        return b0 + (b1 - b0) * v
    c0, c1 = across(k), across(k + 1)
    return c0 + (c1 - c0) * w


def turbulence(x, y, z, octaves, seed):
    return sum(noise(x * 2 ** o, y * 2 ** o, z * 2 ** o, seed + o) / 2 ** o for o in range(octaves)) / (2 - 2 ** (1 - octaves))


def smooth_step(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


# Heaps of a cloud: middle and radius, in a box of 4 x 2 x 4 m.
HEAPS = [(2.0, 0.75, 2.0, 0.62), (1.35, 0.62, 2.2, 0.45), (2.7, 0.65, 1.8, 0.5), (2.2, 1.15, 1.9, 0.5), (1.75, 0.6, 1.45, 0.42),
         (2.5, 0.6, 2.6, 0.4), (3.15, 0.5, 2.15, 0.33), (0.95, 0.48, 1.9, 0.3), (1.9, 0.95, 2.45, 0.42)]


def cloud(x, y, z):
    p = (4 * x, 2 * y, 4 * z)
    inside = max(1 - math.dist(p, heap[:3]) / heap[3] for heap in HEAPS)
    rough = turbulence(3 * p[0], 3 * p[1], 3 * p[2], 4, 1) - 0.5
    floor = smooth_step(0.16, 0.34, p[1] + 0.15 * (noise(3 * p[0], 0, 3 * p[2], 9) - 0.5))
    return smooth_step(0.0, 0.3, inside + 1.15 * rough) * floor


def flame_shape(x, y, z):
    """How far inside the flame: 1 along its axis, 0 at its border."""
    sway = 0.10 * y * math.sin(5 * y + 1)
    radius = 0.36 * math.sqrt(min(y / 0.25, 1.0)) * (1 - y) ** 0.6 + 0.02
    wobble = 0.35 * (turbulence(4 * x, 3 * y, 4 * z, 3, 20) - 0.5)
    return max(1 - math.hypot(x - 0.5 - sway, z - 0.5) / radius + wobble * y * 2, 0.0)


def flame(x, y, z):
    return smooth_step(0.0, 0.45, flame_shape(x, y, z)) * smooth_step(0.0, 0.1, y) * smooth_step(0.0, 0.12, 1 - y)


def heat(x, y, z):
    return 1250 + 950 * smooth_step(0.0, 0.8, flame_shape(x, y, z)) * (1 - 0.35 * y)


if __name__ == "__main__":
    write_vol("cloud.vol", (64, 32, 64), (-2, 0, -2), (2, 2, 2), cloud)
    write_vol("flame.vol", (24, 48, 24), (-0.25, 0, -0.25), (0.25, 1, 0.25), flame)
    write_vol("flame-heat.vol", (24, 48, 24), (-0.25, 0, -0.25), (0.25, 1, 0.25), heat)
