"""A Slurm cluster of this one machine, and the project's batch scripts as jobs on it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

SCRIPTS = pathlib.Path(__file__).parents[2] / "slurm"
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
LIMIT = 500  # s; what hangs fails
OVER = {"COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY", "BOOT_FAIL", "DEADLINE"}


class Cluster:
    def __init__(self):
        self.home = tempfile.TemporaryDirectory(prefix="sigmasweep-slurm-")
        started = self.local_cluster("start")
        if started.returncode in (69, 77):  # packages are missing; not root
            print(f"skipped: {started.stderr.strip()}")
            sys.exit(SKIPPED)
        if started.returncode != 0:
            self.local_cluster("stop")
            raise AssertionError(started.stderr)
        # The daemons are nobody's children: should this process be killed, somebody must stop them.
        self.watch = subprocess.Popen(
            ["sh", "-c", 'while kill -0 "$1" 2> /dev/null; do sleep 1; done; "$2" stop "$3"; rm -rf "$3"', "watch",
             str(os.getpid()), SCRIPTS / "local-cluster", self.home.name],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        os.environ["SLURM_CONF"] = f"{self.home.name}/slurm.conf"

    def local_cluster(self, what):
        return subprocess.run([SCRIPTS / "local-cluster", what, self.home.name], text=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def stop(self):
        self.watch.kill()
        self.watch.wait()
        self.local_cluster("stop")
        self.home.cleanup()


def slurm(*words):
    return subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True, timeout=60).stdout


class Job:
    """A script of slurm/ on the sweep's spec and table. `how` are options of sbatch, `options` those of the run."""

    def __init__(self, script, sweep, how=(), options=(), launcher="mpirun"):
        self.output = sweep.path / "job.out"
        environment = dict(os.environ, SIGMASWEEP_LAUNCHER=launcher)
        command = ["sbatch", "--parsable", *how, "-o", self.output, SCRIPTS / script, sweep.spec.name, sweep.table.name]
        submitted = subprocess.run([*map(str, command), *options], cwd=sweep.path, env=environment, check=True,
                                   capture_output=True, text=True, timeout=60)
        self.id = submitted.stdout.strip()

    def facts(self):
        """Of each job of an array, or of the one: JobState, Restarts, ExitCode, ..."""
        lines = slurm("scontrol", "show", "job", "-o", self.id).splitlines()
        return [dict(re.findall(r"(\w+)=(\S*)", line)) for line in lines if line]

    def states(self):
        return {facts["JobState"] for facts in self.facts()}

    def restarts(self):
        return sum(int(facts["Restarts"]) for facts in self.facts())

    def wait_until(self, what, holds):
        end = time.monotonic() + LIMIT
        while not holds():
            if time.monotonic() > end or (what != "over" and self.states() <= OVER and not holds()):
                raise AssertionError(f"job {self.id} is {self.states()}, not {what}:\n{self}")
            time.sleep(0.2)

    def wait(self):
        """Until it is over for good. Its states."""
        self.wait_until("over", lambda: self.states() <= OVER)
        return self.states()

    def __str__(self):
        return f"{self.facts()}\n{self.output.read_text() if self.output.exists() else 'no output'}"
