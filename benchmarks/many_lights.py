#!/usr/bin/env python3
"""Time to equal error with 10 lights and with 10 000 of the same total: a night scene of boxes on a plain.

    benchmarks/many_lights.py [--lancer build/release/lancer] [--kinds point,sphere,mesh] [--pairs 3] [--size 160x90]

For each kind of light both scenes are rendered in turns, and against a reference of their own with far more samples: processor seconds times the mean
square error. What is printed last is the ratio of that for 10 000 lights to that for 10; and the same of errors relative to the square of the picture's
mean, for lamps that stand elsewhere do not light quite as much of what is seen.
"""
import argparse
import json
import math
import os
import random
import resource
import subprocess
import tempfile


def scene(kind, count, size, total=600.0):
    rng = random.Random(7)
    # Spheres would shine into the camera, and the noise of their edges drown all else: they wear hats, and are looked at from above.
    position = "[0, 30, 0.1]" if kind == "sphere" else "[0, 9, 24]"
    out = [f"[camera]\nposition = {position}\nlook_at = [0, 0, 0]\nfov = 55\n\n[render]\nsize = [{size[0]}, {size[1]}]\nbounces = 4\n",
           '[material.ground]\ntype = "diffuse"\ncolor = [0.5, 0.5, 0.5]\n',
           '[material.wall]\ntype = "diffuse"\ncolor = [0.6, 0.5, 0.4]\n',
           '[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = "ground"\n']
    for x in range(-4, 5):
        for z in range(-4, 5):
            height = 0.6 + 2.2 * rng.random()
            out.append(f'[[box]]\nmin = [{4 * x - 0.9}, 0, {4 * z - 0.9}]\nmax = [{4 * x + 0.9}, {height:.3f}, {4 * z + 0.9}]\nmaterial = "wall"\n')
    side = math.ceil(math.sqrt(count))
    power = total / count
    radius = 0.02
    positions, triangles = [], []
    if kind == "sphere":
        out.append(f'[material.lamp]\ntype = "diffuse"\ncolor = [0, 0, 0]\nemission = {{ rgb = [1, 1, 1], scale = {power / (math.pi * radius ** 2):.6g} }}\n')
    for i in range(count):
        # On streets between the boxes, jittered, at lamp height.
        x = -18 + 36 * ((i % side) + rng.random()) / side
        z = -18 + 36 * ((i // side) + rng.random()) / side
        if abs(x / 4 - round(x / 4)) < 0.25 and abs(z / 4 - round(z / 4)) < 0.25:
            x += 2.0
        y = 0.4 + 1.2 * rng.random()
        if kind == "point":
            out.append(f'[[light]]\ntype = "point"\nposition = [{x:.4f}, {y:.4f}, {z:.4f}]\npower = [{power:.6g}, {power:.6g}, {power:.6g}]\n')
        elif kind == "sphere":
            out.append(f'[[sphere]]\ncenter = [{x:.4f}, {y:.4f}, {z:.4f}]\nradius = {radius}\nmaterial = "lamp"\n')
            a = len(positions)
            positions += [[x + 0.06 * i, y + 0.025, z + 0.06 * j] for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            triangles += [[a, a + 1, a + 2], [a, a + 2, a + 3]]
        else:
            a = len(positions)
            positions += [[x - 0.03, y, z - 0.03], [x + 0.03, y, z - 0.03], [x, y, z + 0.04]]
            triangles.append([a, a + 1, a + 2])
    if kind == "mesh":
        area = 0.5 * 0.06 * 0.07
        out.append(f'[material.lamp]\ntype = "diffuse"\ncolor = [0, 0, 0]\nemission = {{ rgb = [1, 1, 1], scale = {power / area:.6g} }}\n')
        out.append(f'[[mesh]]\npositions = {positions}\ntriangles = {triangles}\nmaterial = "lamp"\n')
    if kind == "sphere":
        out.append('[material.hat]\ntype = "diffuse"\ncolor = [0, 0, 0]\n')
        out.append(f'[[mesh]]\npositions = {positions}\ntriangles = {triangles}\nmaterial = "hat"\n')
    return "\n".join(out)


def render(lancer, file, out, spp, seed):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([lancer, "render", file, "-o", out, "--spp", str(spp), "--seed", str(seed), "--threads", "2", "--quiet", "--float", "--checkpoint", "off"], check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def error(lancer, out, reference):
    run = subprocess.run([lancer, "compare", out, reference, "--json"], capture_output=True, text=True)
    return json.loads(run.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lancer", default=os.path.join(os.path.dirname(__file__), "..", "build", "release", "lancer"))
    parser.add_argument("--kinds", default="point,sphere,mesh")
    parser.add_argument("--pairs", type=int, default=3)
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--reference", type=int, default=1024)
    parser.add_argument("--keep", help="folder for the scenes and pictures")
    options = parser.parse_args()
    size = [int(n) for n in options.size.split("x")]
    folder = options.keep or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    for kind in options.kinds.split(","):
        cost = {10: [], 10000: []}
        files = {}
        for count in cost:
            name = os.path.join(folder, f"{kind}-{count}")
            files[count] = name
            with open(name + ".toml", "w") as out:
                out.write(scene(kind, count, size))
            if not os.path.exists(name + "-reference.exr"):
                render(options.lancer, name + ".toml", name + "-reference.exr", options.reference, 1000)
        for pair in range(options.pairs):
            for count, name in files.items():
                # The time of starting and compiling is taken off: two renders, of spp and of one sample.
                once = render(options.lancer, name + ".toml", name + "-1.exr", 1, pair)
                seconds = render(options.lancer, name + ".toml", name + ".exr", options.spp, pair) - once
                measured = error(options.lancer, name + ".exr", name + "-reference.exr")
                cost[count].append((seconds, measured["all"]["mse"], measured["all"]["mean"]))
                print(f"{kind} {count}: {seconds:.2f} s, mse {measured['all']['mse']:.4g}, mean {measured['all']['mean']:.4g}", flush=True)
        mean = {count: sum(s * e for s, e, _ in pairs) / len(pairs) for count, pairs in cost.items()}
        relative = {count: sum(s * e / m ** 2 for s, e, m in pairs) / len(pairs) for count, pairs in cost.items()}
        print(f"{kind}: {mean[10000] / mean[10]:.2f} times the seconds x mse of 10 lights, {relative[10000] / relative[10]:.2f} times relative to the mean", flush=True)


main()
