"""A tuple that takes too long does not delay the end of a run or its stop by a signal, and a run goes on after such a
tuple has killed its process."""

import os
import signal
import subprocess
import time
import unittest

import h5py
from sweep_process import LIMIT, PROGRAM, Sweep, end_of, ranks_of, wait_until_unlocked

# Row 3 takes minutes.
LONG = """
[sweep]
N            = [2, 3, 4, 200]
epsilon      = 0.9
v0           = 1.0
tc           = 1e-5
sigma        = 0.1
zip          = [["N", "steps_per_tc"]]
integrator   = "gear5"
steps_per_tc = [500.0, 500.0, 500.0, 1e6]
"""
LONG_ROW = 3
# Rows 2 and 3 take minutes.
TWO_LONG = LONG.replace("[2, 3, 4, 200]", "[2, 3, 199, 200]").replace("500.0, 1e6]", "1e6, 1e6]")


def statuses(sweep):
    with h5py.File(sweep.table, "r") as table:
        kind = h5py.check_enum_dtype(table["results"].dtype["status"])
        names = {value: name for name, value in kind.items()}
        return [names[value] for value in table["results"]["status"]]


def start_long_rows(sweep, ranks, *options, rows=(LONG_ROW,)):
    """Starts a run and waits until these rows are being computed. Returns the process and the ranks of the rows."""
    before, _ = sweep.in_flight()  # the notes of a run that died
    process = sweep.start(ranks, *options)
    end = time.monotonic() + LIMIT
    while process.poll() is None and time.monotonic() < end:
        run, rank_of = sweep.in_flight()
        if run != before and all(row in rank_of for row in rows):
            return process, [rank_of[row] for row in rows]
        time.sleep(0.01)
    raise AssertionError(f"rows {rows} did not begin: {end_of(process)}")


def kill_rank(process, rank, ranks):
    os.kill(ranks_of(process)[rank] if ranks else process.pid, signal.SIGSEGV)


class LongTuple(unittest.TestCase):
    def test_time_limit(self):
        sweep = Sweep(LONG + "[run]\ntuple_time_limit = 0.3\n")
        for ranks in (0, 2):
            ended = sweep.run(ranks, "--fresh")
            self.assertEqual(ended.code, 3, ended)
            self.assertEqual(statuses(sweep), ["ok", "ok", "ok", "time_limit"])

    def test_stop_does_not_wait(self):
        for ranks, number in ((0, signal.SIGTERM), (0, signal.SIGINT), (3, signal.SIGUSR1)):
            with self.subTest(ranks=ranks, signal=number):
                sweep = Sweep(LONG)
                process, _ = start_long_rows(sweep, ranks)
                start = time.monotonic()
                process.send_signal(number)
                ended = end_of(process)
                self.assertEqual(ended.code, 75, ended)
                self.assertLess(time.monotonic() - start, 2.0)
                self.assertNotIn(LONG_ROW, sweep.journalled())
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5.journal"])

    def test_signal_to_another_rank(self):
        sweep = Sweep(LONG)
        process, [busy] = start_long_rows(sweep, 3)
        start = time.monotonic()
        os.kill(ranks_of(process)[(busy + 1) % 3], signal.SIGTERM)
        self.assertEqual(end_of(process).code, 75)
        self.assertLess(time.monotonic() - start, 2.0)

    def test_quarantine(self):
        for ranks in (0, 3):
            with self.subTest(ranks=ranks):
                sweep = Sweep(LONG)
                for _ in range(2):
                    process, [rank] = start_long_rows(sweep, ranks)
                    kill_rank(process, rank, ranks)
                    self.assertNotEqual(end_of(process).code, 0)
                ended = sweep.run(ranks)
                self.assertEqual(ended.code, 3, ended)
                self.assertEqual(ended.err.count(f"row {LONG_ROW} is left out"), 1, ended)
                self.assertEqual(statuses(sweep), ["ok", "ok", "ok", "quarantined"])
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
                shown = subprocess.run([PROGRAM, "show", str(sweep.table), "--failed"], capture_output=True, text=True)
                self.assertEqual(shown.stdout.count("sigmasweep one "), 1, shown)
                self.assertIn("nothing to compute", sweep.run(ranks).err)

    def test_ranks_that_mpirun_ends_are_not_blamed(self):
        sweep = Sweep(TWO_LONG)
        for _ in range(2):
            process, [_, guilty] = start_long_rows(sweep, 3, rows=(2, 3))
            kill_rank(process, guilty, 3)
            self.assertNotEqual(end_of(process).code, 0)
        process, _ = start_long_rows(sweep, 3, rows=(2,))
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertIn("row 3 is left out", ended.err)
        self.assertNotIn("row 2 is left out", ended.err)

    def test_a_killed_mpirun_is_no_reason(self):
        sweep = Sweep(TWO_LONG)
        for _ in range(2):
            process, _ = start_long_rows(sweep, 3, rows=(2, 3))
            process.kill()
            end_of(process)
            wait_until_unlocked(sweep)
        process, _ = start_long_rows(sweep, 3, rows=(2, 3))
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertNotIn("is left out", ended.err)

    def test_one_death_is_no_reason(self):
        sweep = Sweep(LONG)
        process, [rank] = start_long_rows(sweep, 2)
        os.kill(ranks_of(process)[rank], signal.SIGKILL)
        end_of(process)
        process, _ = start_long_rows(sweep, 2)  # the row is tried again
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(end_of(process).code, 75)


class Retry(unittest.TestCase):
    """Rows that were given up can be computed again, without the others."""

    def test_time_limit(self):
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                sweep = Sweep(LONG + "[run]\ntuple_time_limit = 0.3\n")
                self.assertEqual(sweep.run(ranks).code, 3)
                before, results = sweep.timings(), sweep.results()
                ended = sweep.run(ranks, "--retry")
                self.assertEqual(ended.code, 3, ended)
                self.assertIn("going on with 3 of 4 rows", ended.err)
                self.assertEqual(sweep.results(), results)
                after = sweep.timings()
                self.assertEqual(before[:LONG_ROW].tolist(), after[:LONG_ROW].tolist(), "others were computed again")
                self.assertEqual(after["attempt"].tolist(), [1, 1, 1, 2])
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_killed_retry_keeps_the_other_rows(self):
        sweep = Sweep(LONG + "[run]\ntuple_time_limit = 5.0\n")
        self.assertEqual(sweep.run(2).code, 3)
        table, before = sweep.table.read_bytes(), sweep.timings()
        process, _ = start_long_rows(sweep, 0, "--retry")
        process.kill()
        end_of(process)
        self.assertEqual(sweep.table.read_bytes(), table)
        ended = sweep.run(2)
        self.assertEqual(ended.code, 3, ended)
        self.assertIn("going on with 3 of 4 rows", ended.err)
        self.assertEqual(before[:LONG_ROW].tolist(), sweep.timings()[:LONG_ROW].tolist())

    def test_quarantined(self):
        sweep = Sweep(LONG)
        for _ in range(2):
            process, _ = start_long_rows(sweep, 0)
            kill_rank(process, 0, 0)
            end_of(process)
        self.assertEqual(sweep.run(0).code, 3)
        self.assertEqual(statuses(sweep)[LONG_ROW], "quarantined")
        process, _ = start_long_rows(sweep, 2, "--retry")
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertEqual(set(sweep.journalled()), {0, 1, 2})

    def test_nothing_to_retry(self):
        sweep = Sweep(LONG.replace("1e6", "2.0").replace("0.9", "0.1"))  # unstable on any machine
        self.assertEqual(sweep.run(0).code, 3)
        before = sweep.table.stat().st_mtime_ns
        ended = sweep.run(0, "--retry")
        self.assertIn("nothing to compute", ended.err)
        self.assertEqual(sweep.table.stat().st_mtime_ns, before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
