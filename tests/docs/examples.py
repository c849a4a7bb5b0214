#!/usr/bin/env python3
"""Every whole scene that the documentation shows, which is one with a camera and a shape, renders without a warning.

    examples.py LANCER
"""
import glob
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def main():
    program = sys.argv[1]
    scenes = []
    for page in [os.path.join(ROOT, "README.md")] + sorted(glob.glob(os.path.join(ROOT, "docs", "*.md"))):
        with open(page, encoding="utf-8") as file:
            for number, block in enumerate(re.findall(r"```toml\n(.*?)```", file.read(), flags=re.S), 1):
                if "[camera]" in block and "[[sphere]]" in block:
                    scenes.append((f"{os.path.relpath(page, ROOT)}, example {number}", block))
    if len(scenes) < 3:
        sys.exit(f"only {len(scenes)} whole scenes were found")
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        path, picture = os.path.join(folder, "scene.toml"), os.path.join(folder, "scene.png")
        for where, text in scenes:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            done = subprocess.run([program, "render", path, "-o", picture, "--size", "32x18", "--progress", "plain", "--quiet"],
                                  capture_output=True, text=True)
            said = done.stderr.strip()
            if done.returncode != 0 or said or not os.path.exists(picture):
                print(f"{where}: exit status {done.returncode}\n{done.stderr}")
                wrong += 1
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
