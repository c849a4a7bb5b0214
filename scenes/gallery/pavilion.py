#!/usr/bin/env python3
"""Writes pavilion-morning.toml, pavilion-noon.toml and pavilion-dusk.toml: the same place under sun and sky at three times of a day in June.

    scenes/gallery/pavilion.py
"""
import math
import os
import random

HERE = os.path.dirname(os.path.abspath(__file__))

TIMES = {
    "morning": ("2026-06-21T06:50:00+02:00", 1.9, "in the morning, an hour after sunrise"),
    "noon": ("2026-06-21T13:30:00+02:00", 1.1, "at noon"),
    "dusk": ("2026-06-21T20:40:00+02:00", 3.2, "in the evening, a quarter of an hour before sunset"),
}

HEAD = """# A pavilion by the water near Florence, {what}. All light is that of the computed sky and its sun. Made by pavilion.py.

[render]
size = [1200, 675]
spp = 512
exposure = {exposure}
view = "agx"
bounces = 8

[camera]
position = [-9.5, 2.1, 15]
look_at = [0.6, 2.9, 0]
fov = 50

[sky]
latitude = 43.77
longitude = 11.26
time = "{time}"
heading = 300
turbidity = 3
ground = 0.15
"""

PLACE = """
[material.marble]
type = "diffuse"
color = [0.74, 0.71, 0.66]

[material.tile]
type = "diffuse"
color = [0.55, 0.24, 0.14]

[material.grass]
type = "diffuse"
color = [0.1, 0.16, 0.05]

[material.leaves]
type = "diffuse"
color = [0.05, 0.1, 0.035]

[material.hill]
type = "diffuse"
color = [0.1, 0.13, 0.07]

[material.water]
type = "plastic"
color = [0.02, 0.05, 0.055]
refraction = 1.33
roughness = 0.06

[[plane]]
normal = [0, 1, 0]
material = "water"

# Land, by the water.
[[box]]
min = [-400, -2, -400]
max = [400, 0.35, 6.5]
material = "grass"
"""


def number(x):
    return f"{x:.4g}"


def point(*xyz):
    return "[" + ", ".join(number(x) for x in xyz) + "]"


def shape(kind, material, **keys):
    return f"\n[[{kind}]]\n" + "".join(f"{key} = {value}\n" for key, value in keys.items()) + f'material = "{material}"\n'


def place():
    rng = random.Random(5)
    out = [PLACE]
    for i in range(4):
        r = 4.9 - 0.3 * i
        out.append(shape("box", "marble", min=point(-r, 0.3, -r), max=point(r, 0.55 + 0.2 * i, r)))
    floor = 1.15
    for i in range(12):
        a = 2 * math.pi * (i + 0.5) / 12
        x, z = 3.1 * math.cos(a), 3.1 * math.sin(a)
        out.append(shape("cylinder", "marble", **{"from": point(x, floor, z), "to": point(x, floor + 0.16, z), "radius": 0.33}))
        out.append(shape("cone", "marble", **{"from": point(x, floor + 0.16, z), "to": point(x, 4.1, z), "radius": 0.24, "top_radius": 0.19}))
        out.append(shape("box", "marble", min=point(x - 0.3, 4.1, z - 0.3), max=point(x + 0.3, 4.3, z + 0.3)))
    out.append(shape("cylinder", "marble", **{"from": "[0, 4.3, 0]", "to": "[0, 4.75, 0]", "radius": 3.5}))
    out.append(shape("cylinder", "marble", **{"from": "[0, 4.75, 0]", "to": "[0, 4.9, 0]", "radius": 3.75}))
    out.append(shape("cone", "tile", **{"from": "[0, 4.9, 0]", "to": "[0, 6.7, 0]", "radius": 3.6, "top_radius": 0.25}))
    out.append(shape("sphere", "marble", center="[0, 6.9, 0]", radius=0.34))
    out.append(shape("sphere", "marble", center=point(0, floor + 1.6, 0), radius=0.55))
    out.append(shape("cylinder", "marble", **{"from": point(0, floor, 0), "to": point(0, floor + 1.1, 0), "radius": 0.4}))
    for i in range(26):  # cypresses
        side = rng.choice([-1, 1])
        x, z = side * rng.uniform(7, 26), rng.uniform(-30, 3)
        h = rng.uniform(4, 8)
        out.append(shape("cone", "leaves", **{"from": point(x, 0.9, z), "to": point(x, 0.9 + h, z), "radius": number(0.11 * h), "top_radius": 0.02}))
        out.append(shape("sphere", "leaves", center=point(x, 0.9, z), radius=number(0.11 * h)))
    for i in range(14):  # hills far away
        a = math.radians(-95 + 190 * i / 13)
        d = rng.uniform(160, 330)
        r = rng.uniform(70, 160)
        out.append(shape("sphere", "hill", center=point(d * math.sin(a), rng.uniform(0.1, 0.3) * r - r, -d * math.cos(a)), radius=number(r)))
    return "".join(out)


everything = place()
for name, (time, exposure, what) in TIMES.items():
    with open(os.path.join(HERE, f"pavilion-{name}.toml"), "w") as out:
        out.write(HEAD.format(time=time, exposure=exposure, what=what) + everything)
