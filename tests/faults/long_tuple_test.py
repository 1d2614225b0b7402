"""A tuple that takes too long does not hold up a run: not its end, not a signal, and not when it takes the process down."""

import os
import signal
import struct
import subprocess
import time
import unittest

import h5py
from sweep_process import LIMIT, PROGRAM, Sweep, end_of, ranks_of

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


def statuses(sweep):
    with h5py.File(sweep.table, "r") as table:
        kind = h5py.check_enum_dtype(table["results"].dtype["status"])
        names = {value: name for name, value in kind.items()}
        return [names[value] for value in table["results"]["status"]]


def rows_in_flight(sweep):
    """Row by rank, from the file beside the table: numbers of 8 bytes, a line of 8 for each rank after the first."""
    try:
        data = (sweep.path / "table.h5.running").read_bytes()
    except FileNotFoundError:
        return {}
    ranks = struct.unpack_from("<Q", data, 32)[0] if len(data) >= 64 else 0
    slots = [struct.unpack_from("<Q", data, 64 * (1 + rank))[0] for rank in range(ranks)]
    return {rank: slot - 1 for rank, slot in enumerate(slots) if slot}


def wait_for_long_row(sweep, process):
    end = time.monotonic() + LIMIT
    while process.poll() is None and time.monotonic() < end:
        for rank, row in rows_in_flight(sweep).items():
            if row == LONG_ROW:
                return rank
        time.sleep(0.01)
    raise AssertionError(f"row {LONG_ROW} did not begin: {end_of(process)}")


class LongTuple(unittest.TestCase):
    def test_time_limit(self):
        sweep = Sweep(LONG + "[run]\ntuple_time_limit = 0.3\n")
        for ranks in (0, 2):
            ended = sweep.run(ranks, "--fresh")
            self.assertEqual(ended.code, 1, ended)
            self.assertEqual(statuses(sweep), ["ok", "ok", "ok", "time_limit"])

    def test_stop_does_not_wait(self):
        for ranks, number in ((0, signal.SIGTERM), (0, signal.SIGINT), (3, signal.SIGUSR1)):
            with self.subTest(ranks=ranks, signal=number):
                sweep = Sweep(LONG)
                process = sweep.start(ranks)
                wait_for_long_row(sweep, process)
                start = time.monotonic()
                process.send_signal(number)
                ended = end_of(process)
                self.assertEqual(ended.code, 75, ended)
                self.assertLess(time.monotonic() - start, 2.0)
                self.assertNotIn(LONG_ROW, sweep.journalled())
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5.journal"])

    def test_signal_to_another_rank(self):
        sweep = Sweep(LONG)
        process = sweep.start(3)
        busy = wait_for_long_row(sweep, process)
        start = time.monotonic()
        os.kill(ranks_of(process)[(busy + 1) % 3], signal.SIGTERM)
        self.assertEqual(end_of(process).code, 75)
        self.assertLess(time.monotonic() - start, 2.0)

    def test_quarantine(self):
        for ranks in (0, 3):
            with self.subTest(ranks=ranks):
                sweep = Sweep(LONG)
                for _ in range(2):
                    process = sweep.start(ranks)
                    rank = wait_for_long_row(sweep, process)
                    os.kill(ranks_of(process)[rank] if ranks else process.pid, signal.SIGSEGV)
                    self.assertNotEqual(end_of(process).code, 0)
                ended = sweep.run(ranks)
                self.assertEqual(ended.code, 1, ended)
                self.assertEqual(ended.err.count(f"row {LONG_ROW} is left out"), 1, ended)
                self.assertEqual(statuses(sweep), ["ok", "ok", "ok", "quarantined"])
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
                shown = subprocess.run([PROGRAM, "show", str(sweep.table), "--failed"], capture_output=True, text=True)
                self.assertEqual(shown.stdout.count("sigmasweep one "), 1, shown)

    def test_one_death_is_no_reason(self):
        sweep = Sweep(LONG)
        process = sweep.start(2)
        rank = wait_for_long_row(sweep, process)
        os.kill(ranks_of(process)[rank], signal.SIGKILL)
        end_of(process)
        process = sweep.start(2)
        wait_for_long_row(sweep, process)  # it is tried again
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(end_of(process).code, 75)


if __name__ == "__main__":
    unittest.main(verbosity=2)
