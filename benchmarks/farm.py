#!/usr/bin/env python3
"""Measures what docs/scaling.md reckons with: start-up, the bytes of shards, merging, a job of 10 000 frames, and the pace of Slurm.

  benchmarks/farm.py [LANCER]        build/release/lancer if not given; minutes, and 6 GB of memory and disk in the temporary folder
"""
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
LANCER = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/lancer")
BOX = str(ROOT / "scenes/gallery/cornell-box.toml")
FILM = str(ROOT / "scenes/gltf/carousel.gltf")


def run(*words, status=0):
    """Seconds, processor seconds, MB of memory at most."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    process = subprocess.Popen([LANCER, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    out, err = process.communicate()
    seconds, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode != status:
        sys.exit(f"lancer {' '.join(map(str, words))} ended with {process.returncode}: {err}")
    return seconds, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def median(count, *words, status=0):
    return sorted(run(*words, status=status)[0] for _ in range(count))[count // 2]


def peak_of(*words):
    """MB that one run takes at most."""
    text = subprocess.run(["/usr/bin/env", "python3", "-c", "import resource, subprocess, sys\nsubprocess.run(sys.argv[1:], check=True, "
                           "stdout=subprocess.DEVNULL)\nprint(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)", LANCER,
                           *map(str, words)], capture_output=True, text=True, check=True).stdout
    return int(text) / 1024


def megabytes(paths):
    return sum(path.stat().st_size for path in paths) / 1e6


def start_up(folder):
    print("start-up")
    print(f"  lancer --version               {1e3 * median(21, '--version'):8.1f} ms")
    for name, scene in (("cornell-box.toml", BOX), ("carousel.gltf, 69 kB", FILM)):
        words = ("render", scene, "--size", "16x16", "--spp", 1, "--quiet", "--threads", 1, "-o", folder / "a.exr")
        print(f"  {name:<30} {1e3 * median(7, *words):8.1f} ms to a picture of 16x16, 1 sample")


def shards(folder):
    print("shards of a picture, 1 sample a pixel, one thread")
    print("  picture       shards  MB of films  bytes a pixel  MB of EXR  merge: s  s a MB  MB of memory")
    for size, counts in (("1920x1080", (1, 16, 256)), ("3840x2160", (16, 256)), ("7680x4320", (256,))):
        for aov in ((), ("--aov", "albedo,normal,depth")):
            for count in counts if not aov else counts[:1]:
                place = folder / "shards"
                place.mkdir()
                for shard in range(1, count + 1):
                    run("render", BOX, "--size", size, "--spp", 1, *aov, "--shard", f"{shard}/{count}", "--quiet", "-o", place / f"{shard}.film")
                films = sorted(place.iterdir())
                words = ("merge", *films, "-o", folder / "out.exr", "--quiet")
                seconds = min(run(*words)[0] for _ in range(2))
                width, height = map(int, size.split("x"))
                total = megabytes(films)
                print(f"  {size:<10}{'+ 7' if aov else '   '} {count:6} {total:12.1f} {total * 1e6 / width / height:14.1f} "
                      f"{megabytes([folder / 'out.exr']):10.1f} {seconds:9.2f} {seconds / total:7.4f} {peak_of(*words):13.0f}", flush=True)
                shutil.rmtree(place)


def film_of_10000(folder):
    print("a job of 10 000 frames")
    os.chdir(folder)
    words = ("farm", "submit", FILM, "--frames", "1:10000", "--size", "16x16", "--spp", 1, "--tasks", 1000, "-o", "f.#####.exr")
    print(f"  farm submit, without a scheduler {run(*words)[0]:8.2f} s")
    seconds, processor = run("farm", "work", "f.farm", 1, 2, 3)
    print(f"  30 frames by farm work           {seconds / 30 * 1e3:8.1f} ms a frame of 16x16, of which {processor / 30 * 1e3:.1f} ms of processors")
    for frame in range(1, 10001):
        (folder / f"f.farm/done/{frame:04}").touch()
    print(f"  farm status, all done            {median(5, 'farm', 'status', 'f.farm'):8.3f} s")
    for frame in range(1, 10001):
        (folder / f"f.{frame:05}.exr").touch()
    print(f"  farm merge, all done             {median(5, 'farm', 'merge', 'f.farm'):8.3f} s")


def slurm(folder):
    sys.path.insert(0, str(ROOT / "tests/farm"))
    from virtual_cluster import VirtualCluster, missing_programs
    if missing_programs():
        print("Slurm is not here")
        return
    (folder / "cluster").mkdir()
    with VirtualCluster(folder / "cluster") as cluster:
        start = time.monotonic()
        cluster.run("sbatch", "--array=1-1000", "--output=/dev/null", "--wrap", "true")
        print(f"Slurm, two virtual nodes of one processor\n  sbatch of 1000 tasks             {time.monotonic() - start:8.3f} s")
        start = time.monotonic()
        print(f"  squeue -r of them                {(cluster.run('squeue', '-h', '-r', '-o', '%T'), time.monotonic() - start)[1]:8.3f} s")
        time.sleep(20)
        left = len(cluster.run("squeue", "-h", "-r").stdout.splitlines())
        print(f"  empty tasks                      {(1000 - left) / (time.monotonic() - start):8.1f} a second")


with tempfile.TemporaryDirectory() as place:
    for measure in (start_up, shards, film_of_10000, slurm):
        (pathlib.Path(place) / measure.__name__).mkdir()
        measure(pathlib.Path(place) / measure.__name__)
