"""Two hosts on one machine: network namespaces with names, networks and shared memory of their own, that mpirun reaches
as it reaches others by ssh. Skipped where namespaces are not allowed (77)."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import MPIEXEC, PROGRAM, Sweep, end_of, spec  # noqa: E402

QUICK = spec(steps=20)
NAMES = [f"sigmasweep{os.getpid()}{letter}" for letter in "ab"]
ADDRESSES = ["10.213.77.1", "10.213.77.2"]  # in networks of their own: no others are met there


def ip(*arguments):
    subprocess.run(["ip", *arguments], check=True, capture_output=True, text=True)


def make_hosts():
    for name in NAMES:
        ip("netns", "add", name)
    ip("link", "add", "left", "netns", NAMES[0], "type", "veth", "peer", "name", "right", "netns", NAMES[1])
    for name, address, link in zip(NAMES, ADDRESSES, ("left", "right")):
        ip("-n", name, "addr", "add", f"{address}/24", "dev", link)
        ip("-n", name, "link", "set", link, "up")
        ip("-n", name, "link", "set", "lo", "up")
    subprocess.run(on_host(0, "true"), check=True, capture_output=True)


def on_host(host, command):
    setup = f"hostname host{host}; mount -t tmpfs none /dev/shm"
    return ["ip", "netns", "exec", NAMES[host], "unshare", "-u", "-m", "sh", "-ec", f"{setup}; {command}"]


def remove_hosts():
    for name in NAMES:
        subprocess.run(["ip", "netns", "del", name], capture_output=True)


class OnTwoHosts(Sweep):
    """Rank 0 on the first host, all others on the second, which may see another `directory` than the first."""

    def __init__(self, text, directory=None):
        super().__init__(text)
        self.table = self.path / "here" / "table.h5"
        self.journal = self.path / "here" / "table.h5.journal"
        self.table.parent.mkdir()
        other = f"mount -t tmpfs none {directory}; " if directory else ""
        agent = self.path / "agent"
        second = " ".join(f"'{word}'" for word in on_host(1, "")[:-1])
        # Called with the host's name and a command for its shell.
        agent.write_text(f"#!/bin/sh\nshift\nexec {second} \"{on_host(1, other)[-1]}$*\"\n")
        agent.chmod(0o755)

    def command(self, ranks, *options):
        hosts = f"{ADDRESSES[0]}:1,{ADDRESSES[1]}:{ranks - 1}"
        program = [PROGRAM, "run", str(self.spec), "-o", str(self.table), *options]
        agent = ["--mca", "plm_rsh_agent", str(self.path / "agent")]
        launch = [*MPIEXEC, "-n", str(ranks), "--host", hosts, *agent, *program]
        return on_host(0, "exec " + " ".join(f"'{word}'" for word in launch))


class Hosts(unittest.TestCase):
    def test_same_results(self):
        one = Sweep(QUICK)
        self.assertEqual(one.run(0).code, 0)
        for ranks in (2, 4):
            two = OnTwoHosts(QUICK)
            ended = two.run(ranks)
            self.assertEqual(ended.code, 0, ended)
            self.assertEqual(two.results(), one.results())
            self.assertEqual(len(set(two.timings()["rank"])), ranks)

    def test_a_host_that_is_lost(self):
        sweep = OnTwoHosts(spec())
        process = sweep.start(3)
        sweep.wait_for_rows(process, 20)
        lost = subprocess.run(["ip", "netns", "pids", NAMES[1]], capture_output=True, text=True, check=True).stdout
        for pid in lost.split():
            os.kill(int(pid), signal.SIGKILL)
        self.assertNotEqual(end_of(process).code, 0)
        time.sleep(2)  # the other host's ranks are ended after mpirun
        kept = sweep.journalled()
        self.assertGreaterEqual(len(kept), 20)
        ended = sweep.run(3)
        self.assertEqual(ended.code, 0, ended)
        self.assertIn(f"going on with {len(kept)} of 360 rows", ended.err)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")

    def test_stop_reaches_the_other_host(self):
        sweep = OnTwoHosts(spec(steps=8000))
        process = sweep.start(3)
        sweep.wait_for_rows(process)
        ranks = subprocess.run(["ip", "netns", "pids", NAMES[1]], capture_output=True, text=True, check=True).stdout
        for pid in ranks.split():
            if pathlib.Path(f"/proc/{pid}/comm").read_text().strip() == pathlib.Path(PROGRAM).name[:15]:
                os.kill(int(pid), signal.SIGTERM)
                break
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertGreater(len(sweep.journalled()), 0)

    def test_another_directory_on_the_other_host(self):
        sweep = OnTwoHosts(QUICK)
        other = OnTwoHosts(QUICK, directory=sweep.table.parent)
        shutil.copy(other.path / "agent", sweep.path / "agent")
        ended = sweep.run(3)
        self.assertEqual(ended.code, 73, ended)
        self.assertEqual(ended.err.count("does not find"), 1, ended)
        self.assertEqual(sweep.journalled(), {})
        self.assertFalse(sweep.table.exists())


if __name__ == "__main__":
    try:
        make_hosts()
    except (OSError, subprocess.CalledProcessError) as error:
        remove_hosts()
        print("namespaces are not allowed here:", error, getattr(error, "stderr", ""))
        sys.exit(77)
    try:
        unittest.main(verbosity=2)
    finally:
        remove_hosts()
