#!/usr/bin/env python3
"""lancer farm on a real Slurm: two virtual nodes on this machine, one of which loses its power in the middle of a picture; a task that is killed;
a job that is cancelled and goes on. What comes out has the bytes of a single machine. Ends with 77 where Slurm is not here.

    slurm_test.py LANCER
"""
import hashlib
import json
import os
import pathlib
import signal
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from virtual_cluster import VirtualCluster, children_of, missing_programs, send  # noqa: E402

LANCER = os.path.abspath(sys.argv[1])
SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
PICTURE = [str(SCENES / "gltf/carousel.gltf"), "--size", "192x108", "--spp", "96", "--seed", "5", "--frame", "1.5"]
FILM = [str(SCENES / "gltf/carousel.gltf"), "--size", "96x54", "--spp", "32", "--frames", "10:40:10", "--fps", "12"]


def hash_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def expect(condition, what):
    if not condition:
        raise AssertionError(what)


class Farm:
    def __init__(self, cluster, folder):
        self.cluster, self.folder = cluster, folder

    def lancer(self, *words, status=0):
        done = self.cluster.run(LANCER, *words, cwd=self.folder, check=False)
        expect(done.returncode == status, f"lancer {' '.join(words)} ended with {done.returncode}, not {status}:\n{done.stdout}")
        return done.stdout

    def status(self, job):
        done = self.cluster.run(LANCER, "farm", "status", job, "--json", cwd=self.folder, check=False)
        expect(done.returncode in (0, 1), done.stdout)
        return json.loads(done.stdout)

    def wait(self, job, what, condition, seconds=90):
        self.cluster.wait_for(f"{job}: {what}", lambda: condition(self.status(job)), seconds)

    def logs(self, job):
        return "\n".join(f"--- {path.name}\n{path.read_text()}" for path in sorted((self.folder / job / "log").glob("*.log")))

    def workers(self):
        """Processes of lancer that Slurm has started, by the node that they run on."""
        found = {}
        for pid in children_of([os.getpid()]):
            try:
                program = os.readlink(f"/proc/{pid}/exe")
                words = pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
            except OSError:
                continue
            nodes = [word.partition(b"=")[2].decode() for word in words if word.startswith(b"SLURMD_NODENAME=")]
            if program == LANCER and nodes:
                found.setdefault(nodes[0], []).append(pid)
        return found


    def freeze(self, node):
        """Stops a task that is at work on the node; whether there was one."""
        for pid in self.workers().get(node, []):
            send(pid, signal.SIGSTOP)
            try:
                if pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] in "Tt":
                    return True
            except OSError:
                pass
        return False


def a_node_is_lost(farm):
    farm.lancer("render", *PICTURE, "--quiet", "-o", "single.exr", "-o", "single.png")
    said = farm.lancer("farm", "submit", *PICTURE, "-o", "many.exr", "-o", "many.png", "--shards", "10", "--slurm")
    expect("10 shards in 10 tasks, given to Slurm" in said, said)
    farm.wait("many.farm", "two of ten shards", lambda s: s["units_done"] >= 2)
    farm.cluster.wait_for("the first node to be at work", lambda: farm.freeze("one"))  # so that it is not done before it dies
    killed = farm.cluster.kill_node("one")
    expect(killed >= 3, f"a daemon, a step and a task at least, not {killed} processes")
    expect(not farm.status("many.farm")["done"], "the node was lost too late to tell anything")
    farm.wait("many.farm", "all of it", lambda s: s["done"])
    for name in ("exr", "png"):
        expect(hash_of(farm.folder / f"single.{name}") == hash_of(farm.folder / f"many.{name}"),
               f"many.{name} is not single.{name}\n{farm.logs('many.farm')}")
    expect("SLURM_RESTART" not in farm.logs("many.farm"), "a log that is none")
    expect(not list((farm.folder / "many.farm/shards").iterdir()), "shards are left")
    expect("100 %  10 of 10 shards, all written" in farm.lancer("farm", "status", "many.farm"), "a full bar")
    farm.cluster.start_node("one")
    print(f"one of two nodes lost: 10 shards, sha256 {hash_of(farm.folder / 'many.exr')}, as on a single machine")


def tasks_are_killed(farm):
    farm.lancer("render", *FILM, "--quiet", "-o", "single.##.exr")
    farm.lancer("farm", "submit", *FILM, "-o", "many.##.exr", "--shards", "2", "--tasks", "4", "--slurm")
    farm.cluster.wait_for("a task to be killed", lambda: farm.workers())
    for pids in farm.workers().values():
        for pid in pids:
            send(pid, signal.SIGKILL)
    farm.wait("many.farm", "all frames", lambda s: s["done"])
    manifest = json.loads((farm.folder / "many.farm/manifest.json").read_text())
    expect(len(manifest["rounds"]) > 1, f"what was killed was not submitted again\n{farm.logs('many.farm')}")
    for frame in (10, 20, 30, 40):
        expect(hash_of(farm.folder / f"single.{frame}.exr") == hash_of(farm.folder / f"many.{frame}.exr"),
               f"frame {frame} differs\n{farm.logs('many.farm')}")
    expect(len({hash_of(farm.folder / f"many.{frame}.exr") for frame in (10, 20, 30, 40)}) == 4, "nothing moves")
    print("tasks killed: 4 frames of 2 shards, each as on a single machine")


def a_job_is_cancelled(farm):
    words = ["farm", "submit", *PICTURE, "-o", "later.exr", "--shards", "10", "--slurm"]
    farm.lancer(*words)
    farm.wait("later.farm", "one shard", lambda s: s["units_done"] >= 1)
    farm.lancer("farm", "cancel", "later.farm")
    farm.cluster.wait_for("an empty queue", lambda: not farm.cluster.run("squeue", "-h").stdout.strip())
    status = farm.status("later.farm")
    expect(status["cancelled"] and not status["done"] and 1 <= status["units_done"] < 10, str(status))
    expect("goes on" in farm.lancer("farm", "cancel", "later.farm"), "cancelled twice")
    farm.lancer(*words)
    farm.wait("later.farm", "all of it", lambda s: s["done"])
    expect(hash_of(farm.folder / "later.exr") == hash_of(farm.folder / "single.exr"), "what was cancelled and went on differs")
    expect("done already" in farm.lancer(*words), "submitted a third time")
    print("cancelled and submitted again: as on a single machine")


def main():
    if missing := missing_programs():
        print(f"Slurm is not here ({', '.join(missing)} missing): the farm is not tested against it. ./test --all installs it.")
        return 77
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("told to stop"))
    with tempfile.TemporaryDirectory(prefix="lancer-slurm-") as folder:
        folder = pathlib.Path(folder)
        (folder / "cluster").mkdir()
        with VirtualCluster(folder / "cluster") as cluster:
            for test in (a_node_is_lost, tasks_are_killed, a_job_is_cancelled):
                (folder / "work").mkdir(exist_ok=True)
                start = time.monotonic()
                if test is tasks_are_killed:
                    (folder / "film").mkdir()
                    test(Farm(cluster, folder / "film"))
                else:
                    test(Farm(cluster, folder / "work"))
                print(f"  {test.__name__}: {time.monotonic() - start:.1f} s", flush=True)
    expect(not children_of([os.getpid()]), "processes are left")
    return 0


if __name__ == "__main__":
    sys.exit(main())
