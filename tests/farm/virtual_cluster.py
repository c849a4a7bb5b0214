"""A Slurm of its own on this machine: munged, slurmctld and two slurmd, each a virtual node, with a key, a configuration and ports made
for it in a folder that the caller gives. Everything listens on the loopback only, and runs as whoever starts it.

    with VirtualCluster(folder) as cluster:
        cluster.run("sbatch", "--wrap", "hostname")
"""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol")
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36


def find(program):
    """Daemons live in sbin, which the path of a user may lack."""
    return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def missing_programs():
    return [program for program in PROGRAMS if find(program) is None]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    try:
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]
    finally:
        for each in sockets:
            each.close()


def end_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def children_of(pids):
    """All living processes that descend from `pids`."""
    parents = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if fields[0] != "Z":
                parents[int(entry.name)] = int(fields[1])
    found, generation = set(), set(pids)
    while generation:
        generation = {pid for pid, parent in parents.items() if parent in generation and pid not in found}
        found |= generation
    return found


def send(pid, number):
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass


def parent_of(pid):
    try:
        return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
    except OSError:
        return pid


CONFIGURATION = """
ClusterName=virtual
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdSpoolDir={folder}/spool-%n
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdTimeout=3
MessageTimeout=2
TCPTimeout=1
ReturnToService=2
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=2,bf_interval=2,batch_sched_delay=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
{nodes}
PartitionName=all Nodes=ALL Default=YES State=UP MaxTime=INFINITE
"""


class VirtualCluster:
    nodes = ("one", "two")

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.configuration = self.folder / "slurm.conf"
        self.environment = {**os.environ, "SLURM_CONF": str(self.configuration)}
        for name in list(self.environment):
            if name.startswith(("SLURM_", "SBATCH_")) and name != "SLURM_CONF":
                del self.environment[name]
        self.daemons = {}

    def __enter__(self):
        # What the daemons leave behind becomes a child of this process, and is ended with it.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        try:
            self._start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def _start(self):
        munge = self.folder / "munge"
        munge.mkdir(mode=0o755)
        key = munge / "key"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(1024))
        self._daemon("munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={key}",
                     f"--pid-file={munge}/pid", f"--seed-file={munge}/seed", f"--log-file={munge}/log", "--num-threads=2")
        self.wait_for("munged", lambda: (munge / "socket").exists())

        import pwd
        controller_port, *node_ports = free_ports(1 + len(self.nodes))
        lines = [f"NodeName={name} NodeHostname={socket.gethostname().split('.')[0]} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN"
                 for name, port in zip(self.nodes, node_ports)]
        self.configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.getuid()).pw_name, folder=self.folder,
            controller_port=controller_port, nodes="\n".join(lines)))
        (self.folder / "state").mkdir()
        self._daemon("slurmctld", "-D", "-i", "-f", str(self.configuration))
        for name in self.nodes:
            (self.folder / f"spool-{name}").mkdir()
            self.start_node(name)
        self.wait_for("both nodes to be idle",
                      lambda: self.run("sinfo", "-h", "-o", "%T %D", check=False).stdout.split() == ["idle", str(len(self.nodes))])

    def start_node(self, name):
        self._daemon("slurmd", "-D", "-N", name, "-f", str(self.configuration), key=name)

    def _daemon(self, program, *arguments, key=None):
        log = open(self.folder / f"{key or program}.out", "ab")
        self.daemons[key or program] = subprocess.Popen(
            [find(program), *arguments], env=self.environment, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
            start_new_session=True, preexec_fn=end_with_parent)
        log.close()

    def kill_node(self, name):
        """As a machine that loses its power: the daemon and all that it started, at once. Returns how many processes that were."""
        daemon = self.daemons.pop(name)
        victims = children_of([daemon.pid]) | {daemon.pid}
        # A running task hangs on slurmstepd, which has left the daemon for the reaper above it: this process.
        for pid in children_of([os.getpid()]) - victims:
            try:
                words = pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
            except OSError:
                continue
            if f"SLURMD_NODENAME={name}".encode() in words:
                victims |= {pid, parent_of(pid)} | children_of([pid])
        victims.discard(os.getpid())
        for number in (signal.SIGSTOP, signal.SIGKILL):  # stopped first, so that nobody is left to tell of another's death
            for pid in victims:
                send(pid, number)
        daemon.wait()
        return len(victims)

    def run(self, program, *arguments, check=True, **options):
        return subprocess.run([find(program), *arguments], env=self.environment, cwd=options.pop("cwd", self.folder), text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=check, **options)

    def wait_for(self, what, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise TimeoutError(f"waited {seconds} s for {what}\n{self.logs()}")
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} ended with {daemon.returncode}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        parts = []
        for path in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")) + [self.folder / "munge/log"]:
            if path.exists() and path.stat().st_size:
                parts.append(f"--- {path.name}\n" + "\n".join(path.read_text(errors="replace").splitlines()[-30:]))
        return "\n".join(parts)

    def stop(self):
        if "slurmctld" in self.daemons:
            self.run("scancel", "--full", "--user", str(os.getuid()), check=False)
        for daemon in self.daemons.values():
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(5)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons.clear()
        end = time.monotonic() + 10
        while (left := children_of([os.getpid()])) and time.monotonic() < end:
            for pid in left:
                send(pid, signal.SIGKILL)
            time.sleep(0.05)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            pass
