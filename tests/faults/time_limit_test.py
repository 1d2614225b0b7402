"""A run ends in time for --max-time or the end of a Slurm job: it computes the rows that fit and returns exit code
75."""

import os
import stat
import time
import unittest
import unittest.mock

from sweep_process import PROGRAM, Sweep, spec

# 24 rows of milliseconds, and 24 that are predicted to take more than a minute each.
TWO_KINDS = """
[sweep]
N            = [2, 100]
epsilon      = 0.9
v0           = [1.0, 0.1]
tc           = 1e-5
sigma        = { from = 0.01, to = 1.0, count = 12, scale = "log" }
zip          = [["N", "steps_per_tc"]]
integrator   = "gear5"
steps_per_tc = [500.0, 1e6]
"""
SLOW_ROW = """
[sweep]
N            = 100
epsilon      = 0.9
v0           = 1.0
tc           = 1e-5
sigma        = 0.1
integrator   = "verlet"
steps_per_tc = 1e6
"""
QUICK, SLOW = spec(steps=20), spec(steps=40000)


class TimeLimit(unittest.TestCase):
    def test_long_rows_are_not_begun(self):
        for ranks in (0, 2, 3):
            with self.subTest(ranks=ranks):
                sweep = Sweep(TWO_KINDS)
                start = time.monotonic()
                ended = sweep.run(ranks, "--max-time", "0:15")
                self.assertEqual(ended.code, 75, ended)
                self.assertLess(time.monotonic() - start, 10, "it waited for the end, or began a long row")
                self.assertIn("24 of 48 rows done, the others would not end in time", ended.err)
                self.assertEqual(set(sweep.journalled()), set(range(24)))
                self.assertFalse(sweep.table.exists())

    def test_goes_on_and_finishes(self):
        text = TWO_KINDS.replace("1e6", "1e5").replace("100]", "10]")
        whole, cut = Sweep(text), Sweep(text)
        self.assertEqual(whole.run(2).code, 0)
        self.assertEqual(cut.run(2, "--max-time", "0.05").code, 75)
        kept = cut.journalled()
        self.assertLess(len(kept), 48)
        ended = cut.run(2, "--max-time", "1-00:00:00")
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(cut.results(), whole.results())
        run_time = cut.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")

    def test_stops_in_time(self):
        for option in ("--max-time", "--max-seconds"):
            sweep = Sweep(SLOW)
            start = time.monotonic()
            ended = sweep.run(2, option, "3")
            self.assertEqual(ended.code, 75, ended)
            self.assertLess(time.monotonic() - start, 10)  # 3 s, and start and end of MPI on a busy machine
            self.assertGreater(len(sweep.journalled()), 0)

    def test_a_row_that_takes_longer(self):
        """It is tried in each run, and the run says that the limit is too short."""
        sweep = Sweep(SLOW_ROW)
        for _ in range(2):
            ended = sweep.run(2, "--max-time", "3")
            self.assertEqual(ended.code, 75, ended)
            self.assertIn("0 of 1 rows done, none of which within the", ended.err)
            self.assertIn("it needs a longer time limit", ended.err)

    def test_refusals(self):
        sweep = Sweep(QUICK)
        for wrong in ("soon", "1:2:3:4", "-1", "1:", ":1", "nan", "inf", "1e400", "1-", ""):
            ended = sweep.run(0, f"--max-time={wrong}")
            self.assertEqual(ended.code, 64, (wrong, ended))
            self.assertEqual(sweep.files(), ["sweep.toml"])


class InSlurmJob(unittest.TestCase):
    """A job without Slurm: the environment of a job, and a script squeue in the PATH."""

    def script(self, path, text):
        path.parent.mkdir(exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return str(path)

    def run_in_job(self, sweep, ranks, squeue="exit 1", **variables):
        environment = dict(os.environ, SLURM_JOB_ID="7", **variables)
        self.script(sweep.path / "bin" / "squeue", f"echo \"$@\" >> {sweep.path}/asked\n{squeue}")
        # mpirun puts its own directory first in the PATH, and a real squeue may be there.
        program = self.script(sweep.path / "bin" / "program", f"PATH={sweep.path}/bin:$PATH exec {PROGRAM} \"$@\"")
        # Open MPI must not start the ranks by Slurm.
        environment |= {f"OMPI_MCA_{part}": "^slurm" for part in ("ras", "plm", "ess")}
        with unittest.mock.patch("sweep_process.PROGRAM", program):
            return sweep.run(ranks, env=environment)

    def test_end_from_the_environment(self):
        sweep = Sweep(SLOW)
        ended = self.run_in_job(sweep, 2, SLURM_JOB_END_TIME=str(int(time.time()) + 4))
        self.assertEqual(ended.code, 75, ended)
        self.assertIn("job 7 ends in", ended.err)

    def test_end_from_squeue_asked_once(self):
        for ranks in (0, 3):
            sweep = Sweep(SLOW)
            ended = self.run_in_job(sweep, ranks, "echo 0:04")
            self.assertEqual(ended.code, 75, ended)
            self.assertRegex(ended.err, r"job 7 ends in 4(\.0)? s")
            self.assertEqual((sweep.path / "asked").read_text(), "-h -j 7 -o %L\n")

    def test_an_end_long_past_is_of_another_job(self):
        """A shell that outlived its job still has its variables."""
        for ranks in (0, 2):
            sweep = Sweep(QUICK)
            ended = self.run_in_job(sweep, ranks, SLURM_JOB_END_TIME=str(int(time.time()) - 3600))
            self.assertEqual(ended.code, 0, ended)
            self.assertEqual(ended.err.count("SLURM_JOB_END_TIME was 1 h 00 min ago"), 1, ended)

    def test_an_end_just_past_is_the_end(self):
        sweep = Sweep(QUICK)
        ended = self.run_in_job(sweep, 0, SLURM_JOB_END_TIME=str(int(time.time()) - 5))
        self.assertEqual(ended.code, 75, ended)

    def test_no_limit(self):
        for answer in ("UNLIMITED", "NOT_SET", "2-00:00:00"):
            sweep = Sweep(QUICK)
            ended = self.run_in_job(sweep, 0, f"echo {answer}")
            self.assertEqual(ended.code, 0, ended)
            self.assertNotIn("squeue", ended.err)

    def test_squeue_fails_or_hangs(self):
        for broken in ("exit 1", "exec sleep 100", "echo", "kill -9 $$", "exec sleep 100 > /dev/null"):
            with self.subTest(squeue=broken):
                sweep = Sweep(QUICK)
                start = time.monotonic()
                ended = self.run_in_job(sweep, 0, broken)
                self.assertEqual(ended.code, 0, ended)
                self.assertEqual(ended.err.count("squeue does not say when this job ends"), 1, ended)
                self.assertLess(time.monotonic() - start, 30)


if __name__ == "__main__":
    unittest.main(verbosity=2)
