"""slurm/sweep.sbatch and slurm/array.sbatch on a cluster of this one machine: runs that finish, are cut by their time
limit, cancelled, divided, or lose their node. Always the results are those of an undisturbed run, bit for bit."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from cluster import Cluster, Job, slurm  # noqa: E402
from sweep_process import Sweep, spec  # noqa: E402

# 360 rows of milliseconds each, some 15 s of one core in all; and one that outlasts a job's shortest limit, a minute.
SLOW, LONG = spec(steps=25000), spec(steps=130000)


def setUpModule():
    global cluster, slow_results, long_sweep, long_job
    cluster = Cluster()
    unittest.addModuleCleanup(cluster.stop)
    long_sweep = Sweep(LONG)
    long_job = Job("sweep.sbatch", long_sweep, ["--ntasks=1", "--time=1"])  # beside all the others
    slow_results = undisturbed(SLOW)


def undisturbed(text):
    whole = Sweep(text)
    ended = whole.run(2)
    assert ended.code == 0, ended
    return whole.results()


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

    def test_stops_in_time_and_requeues_itself(self):
        sweep = Sweep(SLOW)
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"], ["--max-time", "5"], launcher="srun --mpi=pmix")
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.assertGreaterEqual(job.restarts(), 1, job)
        self.check_results(sweep, job)

    def test_does_not_requeue_itself_for_nothing(self):
        sweep = Sweep(spec(steps=1e7).replace("[2, 5, 10, 20]", "20"))
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"], ["--max-time", "1"])
        self.assertEqual(job.wait(), {"FAILED"}, job)
        self.assertEqual([facts["ExitCode"] for facts in job.facts()], ["75:0"], job)
        self.assertIn("the time limit is too short", job.output.read_text())
        self.assertIn("would not end in time", job.output.read_text())

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

    def test_time_limit(self):
        """Not told how much time it has, the run asks Slurm. (setUpModule() has started it.)"""
        results = undisturbed(LONG)
        self.assertEqual(long_job.wait(), {"COMPLETED"}, long_job)
        self.assertGreaterEqual(long_job.restarts(), 1, long_job)
        self.assertIn("stopped on purpose", long_job.output.read_text())
        self.assertEqual(long_sweep.results(), results, long_job)

    def test_very_last_node_fails(self):  # this hits every job
        sweep = Sweep(SLOW)
        job = Job("sweep.sbatch", sweep, ["--ntasks=2"])
        job.wait_until("at work", lambda: len(sweep.journalled()) >= 20)
        node = slurm("sinfo", "-h", "-N", "-o", "%n").strip()
        slurm("scontrol", "update", f"nodename={node}", "state=down", "reason=test")
        job.wait_until("off the node", lambda: job.states() <= {"PENDING"})
        kept = sweep.journalled()
        self.assertFalse(sweep.table.exists(), job)
        slurm("scontrol", "update", f"nodename={node}", "state=resume")
        self.assertEqual(job.wait(), {"COMPLETED"}, job)
        self.assertEqual(job.restarts(), 1, job)
        self.check_results(sweep, job)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")


if __name__ == "__main__":
    unittest.main(verbosity=2)
