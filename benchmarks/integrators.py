#!/usr/bin/env python3
"""What each integrator makes of the same seconds, and how far from the truth: a table, and pictures.

    benchmarks/integrators.py SCENE... [--seconds 10] [--size 400x300] [--integrators path,bdpt,vcm] [--keep FOLDER] [--pictures FOLDER]

Each integrator gets as many samples a pixel as fit into so many seconds of processor, within a twentieth. Then the picture is held against a reference
with another seed, which takes the seconds of --reference; it is made by vcm where --sds is given, whose photons find what is seen of caustics in
mirrors, and else by bdpt, which blurs nothing. References are kept in the folder, by the scene's name, and used again. The error is relative to the
square of the reference (relMSE), and absolute; the product is the absolute one times the seconds.
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile


def lancer(options, *words):
    run = subprocess.run([options.lancer, *map(str, words)], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip().splitlines()[-1] if run.stderr.strip() else f"status {run.returncode}")
    return run.stdout


def render(options, scene, integrator, spp, out, seed=1):
    """Returns processor seconds of rendering."""
    stats = options.keep / "stats.json"
    lancer(options, "render", scene, "--integrator", integrator, "--spp", spp, "--seed", seed, "--size", options.size, "--float",
           "--checkpoint", "off", "--stats", stats, "--quiet", *[word for path in out for word in ("-o", path)])
    return json.loads(stats.read_text())["processor_seconds"]


def samples_for(options, scene, integrator, seconds, outputs, seed=1, within=0.05):
    """Renders with about so many seconds. Returns samples and seconds."""
    spp, spent = 1, render(options, scene, integrator, 1, outputs, seed)
    while spent < 0.08 * seconds:  # few samples tell little: what is prepared once counts, too
        spp *= 4
        spent = render(options, scene, integrator, spp, outputs, seed)
    for _ in range(4):
        if abs(spent / seconds - 1) < within:
            break
        better = max(1, round(spp * seconds / spent))
        if better == spp:
            break
        spp, spent = better, render(options, scene, integrator, better, outputs, seed)
    return spp, spent


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--lancer", default=os.environ.get("LANCER", str(pathlib.Path(__file__).parent.parent / "build/release/lancer")))
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--reference", type=float, default=200, help="seconds of processor for the reference")
    parser.add_argument("--size", default="400x300")
    parser.add_argument("--integrators", default="path,bdpt,vcm")
    parser.add_argument("--sds", action="store_true", help="the reference is made by vcm")
    parser.add_argument("--references-only", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for references and results")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for PNG files, SCENE-INTEGRATOR.png")
    options = parser.parse_args()
    scratch = tempfile.TemporaryDirectory()
    options.keep = options.keep or pathlib.Path(scratch.name)
    options.keep.mkdir(parents=True, exist_ok=True)
    if not options.references_only:
        print("| scene | integrator | samples | processor seconds | relMSE | MSE | product |\n|---|---|---|---|---|---|---|")
    for scene in options.scenes:
        reference = options.keep / f"{scene.stem}-{options.size}.exr"
        if not reference.exists():
            samples_for(options, scene, "vcm" if options.sds else "bdpt", options.reference, [options.keep / "new.exr"], seed=2, within=0.4)
            (options.keep / "new.exr").rename(reference)
        if options.references_only:
            continue
        for integrator in options.integrators.split(","):
            out = options.keep / f"{scene.stem}-{integrator}.exr"
            png = [options.pictures / f"{scene.stem}-{integrator}.png"] if options.pictures else []
            try:
                spp, seconds = samples_for(options, scene, integrator, options.seconds, [out, *png])
            except RuntimeError as why:
                print(f"| {scene.stem} | {integrator} | {why} | | | | |", flush=True)
                continue
            errors = json.loads(lancer(options, "compare", out, reference, "--json"))["all"]
            print(f"| {scene.stem} | {integrator} | {spp} | {seconds:.1f} | {errors['relmse']:.4g} | {errors['mse']:.3g} | "
                  f"{errors['mse'] * seconds:.3g} |", flush=True)


if __name__ == "__main__":
    main()
