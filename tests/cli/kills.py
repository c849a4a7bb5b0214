#!/usr/bin/env python3
"""Kills a render with SIGKILL at random moments, resumes it until it is done, and holds the picture against one that nobody disturbed.

    kills.py LANCER COUNT [--seed N]
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

SCENE = """
[render]
size = [96, 72]
[camera]
position = [0, 1, 4]
look_at = [0, 0.5, 0]
[[sphere]]
center = [1, 3, 1]
radius = 0.4
material = { type = "diffuse", emission = [1, 1, 1], emission_strength = 20 }
[[sphere]]
center = [0, 0.5, 0]
radius = 0.5
material = { type = "diffuse", color = "#c08040" }
[[box]]
min = [-3, -0.1, -3]
max = [3, 0, 3]
material = { type = "diffuse", color = "#808080" }
"""


def main():
    lancer, count = os.path.abspath(sys.argv[1]), int(sys.argv[2])
    seed = int(sys.argv[4]) if "--seed" in sys.argv else random.randrange(1 << 30)
    print("seed", seed)
    chance = random.Random(seed)
    kills = resumed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.toml").write_text(SCENE)
        common = ["--quiet", "--threads", "2", "--checkpoint", "10ms"]
        render = [lancer, "render", "scene.toml", "--integrator", "path", "--spp", "160"]
        start = time.monotonic()
        subprocess.run(render + ["-o", "whole.exr", "--quiet", "--threads", "2", "--checkpoint", "off"], cwd=folder, check=True)
        took = time.monotonic() - start
        whole = (folder / "whole.exr").read_bytes()
        while kills < count:
            for old in ("out.exr", "out.exr.checkpoint", "out.exr.checkpoint-before"):
                (folder / old).unlink(missing_ok=True)
            command = render + ["-o", "out.exr"] + common
            while True:
                process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE)
                try:
                    process.wait(timeout=chance.uniform(0.0, took) if kills < count else None)
                except subprocess.TimeoutExpired:
                    process.send_signal(signal.SIGKILL)
                    process.wait()
                    kills += 1
                errors = process.stderr.read().decode()
                process.stderr.close()
                if process.returncode == 0:
                    break
                if process.returncode != -signal.SIGKILL:
                    sys.exit(f"kill {kills}: exit status {process.returncode}: {errors}")
                has_film = any((folder / f"out.exr.{end}").exists() for end in ("checkpoint", "checkpoint-before"))
                resumed += has_film
                command = [lancer, "resume", "out.exr"] + common if has_film else render + ["-o", "out.exr"] + common
            if (folder / "out.exr").read_bytes() != whole:
                sys.exit(f"after {kills} kills: the picture is another one")
    print(f"{kills} kills, {resumed} times resumed from a checkpoint, every picture the same as the undisturbed one")


main()
