"""slurm/sweep.sbatch and slurm/array.sbatch as programs, with an environment and commands in place of Slurm's: whether they
queue themselves again, and which arrays they take."""

import os
import pathlib
import stat
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import LIMIT, PROGRAM, Sweep, spec  # noqa: E402

SCRIPTS = pathlib.Path(__file__).parents[2] / "slurm"
QUICK = spec(steps=20)


class Script:
    """A batch script on a sweep of its own. `program` is a shell script that is called in place of the program, with the
    program's path in $PROGRAM."""

    def __init__(self, script, text=QUICK, program='exec "$PROGRAM" "$@"', state="RUNNING"):
        self.sweep, self.script = Sweep(text), script
        for name, lines in (("squeue", f"echo {state}"), ("scontrol", f"echo \"$@\" > {self.sweep.path}/requeued"),
                            ("program", program)):
            path = self.sweep.path / "bin" / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(f"#!/bin/sh\n{lines}\n")
            path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def run(self, *options, **variables):
        bin = self.sweep.path / "bin"
        environment = dict(os.environ, PATH=f"{bin}:{os.environ['PATH']}", SLURM_JOB_ID="7", PROGRAM=PROGRAM,
                           SIGMASWEEP=str(bin / "program"), SIGMASWEEP_LAUNCHER="env", **variables)
        # The program asks squeue as well; here it is told.
        environment["SLURM_JOB_END_TIME"] = "9999999999"
        return subprocess.run([SCRIPTS / self.script, self.sweep.spec.name, self.sweep.table.name, *options],
                              cwd=self.sweep.path, env=environment, text=True, capture_output=True, timeout=LIMIT)

    def requeued(self):
        return (self.sweep.path / "requeued").exists()


def array(task, first, last, count=None, **variables):
    return dict(SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_MIN=str(first), SLURM_ARRAY_TASK_MAX=str(last),
                SLURM_ARRAY_TASK_COUNT=str(count or last - first + 1), **variables)


# Some rows, then an end with the code that is wanted.
SOME_ROWS = """[ "$1" = run ] || exec "$PROGRAM" "$@"
"$PROGRAM" "$@" &
until [ "$(stat -c %s table*.journal 2> /dev/null || echo 0)" -gt 20000 ]; do sleep 0.01; done
kill -USR1 $!; wait $!
exit CODE"""
NO_ROWS = """[ "$1" = run ] || exec "$PROGRAM" "$@"
"$PROGRAM" "$@" --max-time 0
exit CODE"""


class Requeue(unittest.TestCase):
    def scripts(self):
        yield "sweep.sbatch", {}
        yield "array.sbatch", array(0, 0, 0)

    def test_after_progress(self):
        slow = spec(steps=20000)
        for script, variables in self.scripts():
            for code in (75, 1, 143):  # mpirun that had a TERM ends with 1, srun with 143
                with self.subTest(script=script, code=code):
                    job = Script(script, slow, SOME_ROWS.replace("CODE", str(code)))
                    ended = job.run(**variables)
                    self.assertTrue(job.requeued(), ended)

    def test_not_when_cancelled(self):
        for script, variables in self.scripts():
            job = Script(script, spec(steps=20000), SOME_ROWS.replace("CODE", "1"), state="COMPLETING")
            ended = job.run(**variables)
            self.assertEqual(ended.returncode, 1, ended)
            self.assertFalse(job.requeued(), ended)

    def test_a_journal_without_rows_is_no_progress(self):
        for script, variables in self.scripts():
            for code in (75, 1):
                job = Script(script, program=NO_ROWS.replace("CODE", str(code)))
                ended = job.run(**variables)
                self.assertEqual(ended.returncode, code, ended)
                self.assertFalse(job.requeued(), ended)
                self.assertEqual("the time limit is too short" in ended.stderr, code == 75, ended)
                self.assertTrue(list(job.sweep.path.glob("*.journal")))

    def test_not_after_an_error(self):
        for script, variables in self.scripts():
            job = Script(script, text="[sweep]\nnonsense = 1\n")
            self.assertEqual(job.run(**variables).returncode, 65)
            self.assertFalse(job.requeued())


class Arrays(unittest.TestCase):
    def test_from_0_and_from_1(self):
        whole = Sweep(QUICK)
        self.assertEqual(whole.run(0).code, 0)
        for first in (0, 1):
            job = Script("array.sbatch")
            for task in (first + 2, first, first + 1):
                ended = job.run(**array(task, first, first + 2))
                self.assertEqual(ended.returncode, 0, ended)
            self.assertEqual(job.sweep.results(), whole.results())

    def test_some_of_its_tasks(self):
        job = Script("array.sbatch")
        self.assertEqual(job.run(**array(1, 1, 3)).returncode, 0)
        for task in (2, 3):
            ended = job.run(**array(task, 2, 3, SIGMASWEEP_ARRAY="1-3"))
            self.assertEqual(ended.returncode, 0, ended)
        self.assertTrue(job.sweep.table.exists())

    def test_refused_before_anything_is_computed(self):
        for variables, words in ((array(3, 3, 5), "SIGMASWEEP_ARRAY"), (array(0, 0, 6, 4), "gaps"), ({}, "no job array"),
                                 (array(4, 4, 4, SIGMASWEEP_ARRAY="0-3"), "not one of"),
                                 (array(4, 4, 4, SIGMASWEEP_ARRAY="3"), "must begin with 0 or 1")):
            job = Script("array.sbatch")
            ended = job.run(**variables)
            self.assertEqual((ended.returncode, ended.stderr.count("\n")), (64, 1), ended)
            self.assertIn(words, ended.stderr)
            self.assertEqual(job.sweep.files(), ["bin", "sweep.toml"])

    def test_rows_without_a_result(self):
        """They are no reason not to join the slices."""
        job = Script("array.sbatch", spec(steps=2).replace("0.8]", "0.01]"))  # unstable
        codes = {job.run(**array(task, 0, 1)).returncode for task in (0, 1)}
        self.assertEqual(codes, {3})
        self.assertTrue(job.sweep.table.exists())

    def test_trajectories(self):
        job = Script("array.sbatch", QUICK + '[trajectory]\nsamples = 11\nwhere = "N == 2"\n')
        for task in (0, 1):
            ended = job.run(**array(task, 0, 1))
            self.assertEqual(ended.returncode, 0, ended)
        self.assertEqual(len(list((job.sweep.path / "table.trajectories").glob("row-*.h5"))), 90, ended)


if __name__ == "__main__":
    unittest.main(verbosity=2)
