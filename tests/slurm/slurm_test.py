"""slurm/sweep.sbatch and slurm/array.sbatch on a cluster of this one machine: runs that finish, are cut by their time
limit, cancelled, divided, or lose their node. Always the results are those of an undisturbed run, bit for bit."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
import sweep_process  # noqa: E402
from cluster import Cluster, Job, slurm  # noqa: E402
from sweep_process import Sweep, spec  # noqa: E402

SLOW = spec(steps=25000)  # 360 rows of milliseconds each, some 12 s of one core in all
sweep_process.LIMIT = 500  # s


def setUpModule():
    global slow_results, limited
    cluster = Cluster()
    unittest.addModuleCleanup(cluster.stop)
    limited = Limited()
    unittest.addModuleCleanup(limited.thread.join)
    whole = Sweep(SLOW)
    ended = whole.run(2)
    assert ended.code == 0, ended
    slow_results = whole.results()


class Limited:
    """A job that is too long for the shortest limit that Slurm has, a minute, without computing for a minute: the
    program sleeps most of it. Goes on beside the other tests."""

    def __init__(self):
        self.sweep = Sweep(SLOW)
        # No USR1 before the end: the program has its own clock, and asks Slurm for the time that it has.
        self.job = Job("sweep.sbatch", self.sweep, ["--ntasks=1", "--time=1", "--signal=B:CONT@1"])
        self.thread = threading.Thread(target=self.hold_up)
        self.thread.start()

    def hold_up(self):
        self.job.wait_until("started", lambda: "PENDING" not in self.job.states())
        start = time.monotonic()
        self.job.wait_until("at work", lambda: len(self.sweep.journalled()) >= 20)
        ranks = self.ranks()
        for rank in ranks:
            os.kill(rank, signal.SIGSTOP)
        time.sleep(max(0.0, start + 52 - time.monotonic()))
        for rank in ranks:
            os.kill(rank, signal.SIGCONT)

    def ranks(self):
        found = []
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                name, place = (process / "comm").read_text().strip(), os.readlink(process / "cwd")
            except OSError:
                continue  # not ours, or gone
            if (name, place) == ("sigmasweep", str(self.sweep.path)):
                found.append(int(process.name))
        return found


class Slurm(unittest.TestCase):
    def check_results(self, sweep, job):
        self.assertTrue(sweep.table.exists(), job)
        self.assertEqual(sweep.results(), slow_results, job)
        self.assertFalse(sweep.journal.exists(), job)

    def test_finishes(self):
        jobs = []
        for launcher in ("mpirun", "srun --mpi=pmix"):
            sweep = Sweep(SLOW)
            jobs.append((sweep, Job("sweep.sbatch", sweep, ["--ntasks=2"], launcher=launcher)))
        for sweep, job in jobs:
            self.assertEqual(job.wait(), {"COMPLETED"}, job)
            self.assertEqual(job.restarts(), 0, job)
            self.check_results(sweep, job)

    def test_told_to_stop_it_requeues_itself(self):
        for launcher in ("mpirun", "srun --mpi=pmix"):
            sweep = Sweep(SLOW)
            job = Job("sweep.sbatch", sweep, ["--ntasks=2"], launcher=launcher)
            job.wait_until("at work", lambda: len(sweep.journalled()) >= 20)
            slurm("scancel", "--batch", "--signal=USR1", job.id)  # as --signal=B:USR1 does
            self.assertEqual(job.wait(), {"COMPLETED"}, job)
            self.assertEqual(job.restarts(), 1, job)
            self.assertIn("stopped on purpose", job.output.read_text())
            self.check_results(sweep, job)

    def test_terminated_it_requeues_itself(self):
        """A TERM to all processes of the job, as before a job of higher rank: mpirun ends with 1 then."""
        for launcher in ("mpirun", "srun --mpi=pmix"):
            sweep = Sweep(SLOW)
            job = Job("sweep.sbatch", sweep, ["--ntasks=2"], launcher=launcher)
            job.wait_until("at work", lambda: len(sweep.journalled()) >= 20)
            slurm("scancel", "--full", "--signal=TERM", job.id)
            self.assertEqual(job.wait(), {"COMPLETED"}, job)
            self.assertEqual(job.restarts(), 1, job)
            self.check_results(sweep, job)

    def test_does_not_requeue_itself_for_nothing(self):
        sweep = Sweep(spec(steps=1e6).replace("[2, 5, 10, 20]", "20"))
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"], ["--max-time", "1"])
        self.assertEqual(job.wait(), {"FAILED"}, job)
        self.assertEqual([facts["ExitCode"] for facts in job.facts()], ["75:0"], job)
        self.assertIn("the time limit is too short", job.output.read_text())
        self.assertIn("it needs a longer time limit", job.output.read_text())

    def test_cancelled(self):
        sweep = Sweep(SLOW)
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"])
        job.wait_until("at work", lambda: len(sweep.journalled()) >= 20)
        slurm("scancel", job.id)
        self.assertEqual(job.wait(), {"CANCELLED"}, job)
        self.assertFalse(sweep.table.exists(), job)
        kept = sweep.journalled()
        self.assertGreaterEqual(len(kept), 20)
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"])
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.check_results(sweep, job)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")

    def test_array(self):
        sweep = Sweep(SLOW)
        job = Job("array.sbatch", sweep, ["--array=0-3", "--ntasks=1"])
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.check_results(sweep, job)
        parts = [f"table.slice-{i}-of-4.h5" for i in range(4)]
        self.assertEqual(sweep.files(), ["job.out", "sweep.toml", "table.h5", *parts])

    def test_array_from_1_with_trajectories(self):
        sweep = Sweep(spec(steps=20) + "[trajectory]\nsamples = 11\nwhere = \"N == 2\"\n")
        job = Job("array.sbatch", sweep, ["--array=1-3", "--ntasks=2"])
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.assertTrue(sweep.table.exists(), job)
        self.assertEqual(len(list((sweep.path / "table.trajectories").glob("row-*.h5"))), 90, job)

    def test_time_limit(self):
        self.assertEqual(limited.job.wait(), {"COMPLETED"}, limited.job)
        self.assertGreaterEqual(limited.job.restarts(), 1, limited.job)
        self.assertIn("stopped on purpose", limited.job.output.read_text())
        self.check_results(limited.sweep, limited.job)

    def test_very_last_node_fails(self):  # this hits every job
        sweep = Sweep(SLOW)
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"])
        job.wait_until("at work", lambda: len(sweep.journalled()) >= 20)
        node = slurm("sinfo", "-h", "-N", "-o", "%n").strip()
        slurm("scontrol", "update", f"nodename={node}", "state=down", "reason=test")
        job.wait_until("off the node", lambda: job.restarts() == 1)
        kept = sweep.journalled()
        try:
            slurm("scontrol", "update", f"nodename={node}", "state=resume")
        except subprocess.CalledProcessError:
            pass  # it has come back by itself
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.assertEqual(job.restarts(), 1, job)
        self.check_results(sweep, job)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")


if __name__ == "__main__":
    unittest.main(verbosity=2)
