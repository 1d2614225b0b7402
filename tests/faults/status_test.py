"""Looking at a sweep at any time: status, show, export and plot while it runs, after a stop, after kill -9 and at its end;
without a lock and without a change to a file. STATUS_TRIALS says how many random kills there are (3)."""

import contextlib
import csv
import io
import json
import os
import random
import signal
import subprocess
import time
import unittest

from sweep_process import LIMIT, PROGRAM, Sweep, end_of, ranks_of, spec, wait_until_gone, wait_until_unlocked

TRIALS = int(os.environ.get("STATUS_TRIALS", "3"))
LONG = spec(steps=40000)  # half a minute of computing
BOOT = 40  # byte of a rank's page where the name of its machine stands


def look(sweep, command, *options, code=0):
    ended = subprocess.run([PROGRAM, command, str(sweep.table), *options], cwd=sweep.path, capture_output=True,
                           text=True, timeout=LIMIT)
    assert ended.returncode == code, ended
    return ended


def status(sweep):
    document = json.loads(look(sweep, "status", "--json").stdout)
    assert list(document) == ["table", "state", "rows", "done", "by_status", "rows_per_second", "seconds_left",
                              "ranks"], document
    assert sum(document["by_status"].values()) == document["done"], document
    for rank in document["ranks"]:
        assert list(rank) == ["rank", "host", "row", "seconds"], rank
    return document


def kill_all(process):
    """mpirun and its ranks, so that none of them writes any more."""
    process.send_signal(signal.SIGSTOP)  # it must not start another rank now
    ranks = ranks_of(process)
    for pid in [*ranks, process.pid]:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    process.communicate(timeout=LIMIT)
    wait_until_gone(ranks)


class Looking(unittest.TestCase):
    def started(self, ranks=3, rows=3, text=LONG):
        sweep = Sweep(text)
        process = sweep.start(ranks)
        self.addCleanup(lambda: process.poll() is None and kill_all(process))
        sweep.wait_for_rows(process, rows)
        return sweep, process

    def agrees_with_the_journal(self, sweep, complete=False):
        """Of a sweep that nobody works on."""
        journal, there = sweep.journalled(), sweep.files()
        seen = status(sweep)
        self.assertEqual((seen["state"], seen["rows"], seen["done"]), ("stopped", 360, len(journal)))
        self.assertEqual(seen["by_status"], {"ok": len(journal)} if journal else {})
        shown = look(sweep, "show", "--json")
        document = json.loads(shown.stdout)
        self.assertEqual((document["complete"], document["rows"], document["done"]), (False, 360, len(journal)))
        self.assertEqual({row["row"]: row["run_time"] for row in document["results"]}, journal)
        self.assertIn(f"table.h5 is not complete: {len(journal)} of 360 rows so far\n", shown.stderr)
        self.assertEqual(shown.stderr.count("\n"), 1)
        self.assertEqual(sweep.files(), there)
        return seen

    def test_random_kills(self):
        seed = int(os.environ.get("STATUS_SEED", random.SystemRandom().randrange(10**9)))
        print(f"STATUS_SEED={seed}", flush=True)
        for trial in range(TRIALS):
            with self.subTest(trial=trial, seed=seed):
                self.kill_at_random(random.Random(seed + trial))

    def kill_at_random(self, chance):
        sweep, process = self.started(rows=chance.randint(1, 60))
        before = len(sweep.journalled())
        seen = status(sweep)
        after = len(sweep.journalled())
        self.assertEqual(seen["state"], "running")
        self.assertTrue(before <= seen["done"] <= after, (before, seen["done"], after))
        time.sleep(chance.uniform(0.0, 0.5))
        kill_all(process)
        seen = self.agrees_with_the_journal(sweep)
        self.assertIsNone(seen["rows_per_second"])
        self.assertIsNone(seen["seconds_left"])
        self.assertEqual({rank["row"]: rank["rank"] for rank in seen["ranks"] if rank["row"] is not None},
                         sweep.in_flight()[1])

    def test_a_running_sweep(self):
        sweep, process = self.started()
        time.sleep(1.0)
        seen = status(sweep)
        self.assertEqual([rank["rank"] for rank in seen["ranks"]], [0, 1, 2])
        self.assertEqual({rank["host"] for rank in seen["ranks"]}, {os.uname().nodename})
        self.assertGreater(seen["rows_per_second"], 0.0)
        self.assertGreater(seen["seconds_left"], 0.0)
        for rank in seen["ranks"]:
            if rank["row"] is not None:
                self.assertTrue(0.0 <= rank["seconds"] < LIMIT, rank)
        text = look(sweep, "status").stdout
        self.assertRegex(text, r"table.h5: running \(process \d+ of this machine exists\)")
        self.assertRegex(text, r"\d+ of 360 rows \(ok \d+\)")
        self.assertIn("rows/s", text)
        self.assertIn(" left\n", text)
        shown = look(sweep, "show", "--limit", "2")
        self.assertRegex(shown.stdout, r"table.h5: \d+ of 360 rows \(ok \d+\)")
        exported = look(sweep, "export")
        self.assertIn("is not complete", exported.stderr)
        rows = list(csv.DictReader(io.StringIO(exported.stdout)))
        self.assertTrue(0 < len(rows) < 360 and all(row["status"] == "ok" for row in rows))
        look(sweep, "plot", "--x", "sigma", "--y", "eps_eff", "-o", "some.svg")
        self.assertIn("rows so far", (sweep.path / "some.svg").read_text())
        self.assertIsNone(process.poll(), "it was over before the looks were")

    def test_a_sweep_that_was_stopped_and_then_finished(self):
        sweep, process = self.started(text=spec(steps=8000))
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(end_of(process).code, 75)
        self.assertEqual(self.agrees_with_the_journal(sweep)["ranks"], [])
        journal = sweep.journal.read_bytes()
        sweep.journal.write_bytes(journal + journal[-100:])  # the torn record of one who writes
        self.assertEqual(json.loads(look(sweep, "show", "--json").stdout)["done"], status(sweep)["done"])
        self.assertEqual(sweep.run(2).code, 0)
        seen = status(sweep)
        self.assertEqual(seen, {"table": str(sweep.table), "state": "complete", "rows": 360, "done": 360,
                                "by_status": {"ok": 360}, "rows_per_second": None, "seconds_left": 0.0, "ranks": []})
        shown = look(sweep, "show", "--json")
        self.assertEqual((json.loads(shown.stdout)["complete"], shown.stderr), (True, ""))
        self.assertIn("table.h5: complete\n360 of 360 rows (ok 360)\n", look(sweep, "status").stdout)
        sweep.journal.write_bytes(journal)  # a journal is younger than the table beside it
        self.assertFalse(json.loads(look(sweep, "show", "--json").stdout)["complete"])

    def test_a_journal_that_outlived_the_table_it_is_of(self):
        sweep, process = self.started(rows=100, text=spec(steps=8000))
        journals = sweep.journals()
        self.assertEqual(len(journals), 3)
        for journal in journals:
            os.link(journal, f"{journal}-kept")
        self.assertEqual(end_of(process).code, 0)
        for journal in journals:
            os.rename(f"{journal}-kept", journal)
        self.assertEqual(len(sweep.journalled()), 360)
        self.assertEqual(status(sweep)["state"], "complete")
        table = sweep.table.read_bytes()
        sweep.table.unlink()  # killed before it was written
        self.assertEqual((status(sweep)["state"], status(sweep)["done"]), ("stopped", 360))
        sweep.table.write_bytes(table[:len(table) // 2])
        self.assertEqual(status(sweep)["state"], "stopped")

    def test_what_is_not_there(self):
        sweep = Sweep()
        for command in ("status", "show", "export", "plot"):
            self.assertIn("there is no table", look(sweep, command, code=66).stderr)
        sweep.journal.write_text("hello")
        for command in ("status", "show", "export", "plot"):
            self.assertIn("not a journal", look(sweep, command, code=74).stderr)

    def test_before_the_first_row(self):
        sweep = Sweep()
        self.assertEqual(sweep.run(2, "--max-time", "0").code, 75)
        self.assertEqual(status(sweep)["done"], 0)
        self.assertIn("0 of 360 rows, ", look(sweep, "show").stdout)
        self.assertEqual(len(look(sweep, "export").stdout.splitlines()), 1)
        for options in ([], ["--kind", "precision"], ["--kind", "stability"]):
            self.assertIn("has no row yet", look(sweep, "plot", *options, code=66).stderr)

    def test_slices(self):
        sweep = Sweep(spec(steps=8000))
        process = sweep.start(2, "--slice", "1/4")
        sweep.wait_for_rows(process, 2)
        seen = status(sweep)
        self.assertEqual((seen["state"], seen["rows"]), ("running", 90))
        kill_all(process)
        document = json.loads(look(sweep, "show", "--json").stdout)
        self.assertEqual((document["rows"], document["slice"]), (90, {"index": 1, "count": 4}))
        self.assertEqual({row["row"] for row in document["results"]}, set(sweep.journalled()))
        ended = subprocess.run([PROGRAM, "merge", "whole.h5", str(sweep.table)], cwd=sweep.path, capture_output=True,
                               text=True, timeout=LIMIT)
        self.assertEqual((ended.returncode, ended.stderr.count("of 90 rows so far")), (65, 1), ended)


class OfAnotherMachine(unittest.TestCase):
    """Processes that cannot be asked for: their notes say that they belong to another machine."""

    def test_heartbeats_tell(self):
        sweep = Sweep(LONG)
        process = sweep.start(3)
        self.addCleanup(lambda: process.poll() is None and kill_all(process))
        sweep.wait_for_rows(process, 3)
        notes = sweep.path / "table.h5.running"
        with open(notes, "r+b") as file:
            for rank in range(3):
                file.seek(4096 * (1 + rank) + BOOT)
                file.write(b"another machine\0")
        self.assertEqual(status(sweep)["state"], "running")
        self.assertRegex(look(sweep, "status").stdout, r"running \(rank \d on \S+ sent a heartbeat\)")
        ranks = ranks_of(process)
        for pid in ranks:
            os.kill(pid, signal.SIGSTOP)
        self.assertIn("stopped (no rank sent a heartbeat for 5 s)", look(sweep, "status").stdout)
        for pid in ranks:
            os.kill(pid, signal.SIGCONT)
        self.assertEqual(status(sweep)["state"], "running")
        kill_all(process)
        wait_until_unlocked(sweep)
        self.assertEqual((status(sweep)["state"], status(sweep)["done"]), ("stopped", len(sweep.journalled())))

    def test_a_rank_that_is_silent_is_shown(self):
        sweep = Sweep(LONG)
        process = sweep.start(2)
        self.addCleanup(lambda: process.poll() is None and kill_all(process))
        sweep.wait_for_rows(process, 3)
        os.kill(ranks_of(process)[1], signal.SIGSTOP)
        end = time.monotonic() + LIMIT
        while "no heartbeat for" not in look(sweep, "status").stdout:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.5)
        self.assertEqual(status(sweep)["state"], "running")


class Summary(unittest.TestCase):
    def test_is_one_document_also_of_a_stopped_run(self):
        sweep = Sweep(spec(steps=8000))
        process = sweep.start(2, "--json")
        sweep.wait_for_rows(process, 3)
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        first = json.loads(ended.out)
        done = len(sweep.journalled())
        self.assertEqual((first["state"], first["exit_code"], first["rows"], first["done"]), ("stopped", 75, 360, done))
        ended = sweep.run(2, "--json")
        last = json.loads(ended.out)
        self.assertEqual((ended.code, last["state"], last["exit_code"]), (0, "complete", 0))
        self.assertEqual((last["rows"], last["done"], last["by_status"]), (360, 360, {"ok": 360}))
        self.assertEqual((last["computed"]["rows"], last["computed"]["ranks"]), (360 - done, 2))
        self.assertNotIn("median", ended.err)
        times = sweep.timings()["run_time"]
        self.assertEqual(last["quantiles"]["run_time"]["max"], max(times))
        self.assertEqual(last["quantiles"]["run_time"]["median"], sorted(times)[len(times) // 2 - 1])
        again = json.loads(sweep.run(0, "--json", "-q").out)
        self.assertEqual((again["computed"]["rows"], again["done"]), (0, 360))
        sweep.spec.write_text("nonsense")
        self.assertEqual(sweep.run(2, "--json").out, "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
