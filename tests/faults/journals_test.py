"""The ranks of a run keep their rows in a journal each. A journal that is missing, or damaged at its beginning, costs
its own rows and no others, whichever it is; and any number of ranks goes on with the journals of any other."""

import json
import signal
import subprocess
import unittest

from sweep_process import PROGRAM, Sweep, end_of, first_record, ranks_of, spec, wait_until_gone

TEXT = spec(steps=8000)


class Journals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        reference = Sweep(TEXT)
        assert reference.run(1).code == 0
        cls.results = reference.results()

    def killed(self, ranks=4, rows=60, sweep=None):
        """A sweep all whose processes are killed after so many rows."""
        sweep = sweep or Sweep(TEXT)
        process = sweep.start(ranks)
        sweep.wait_for_rows(process, rows)
        processes = ranks_of(process)
        process.kill()
        for rank in processes:
            subprocess.run(["kill", "-9", str(rank)], stderr=subprocess.DEVNULL, check=False)
        wait_until_gone(processes)
        process.communicate()
        return sweep

    def finishes(self, sweep, ranks, kept):
        ended = sweep.run(ranks)
        self.assertEqual(ended.code, 0, ended)
        self.assertIn(f"going on with {len(kept)} of 360 rows", ended.err)
        self.assertEqual(sweep.results(), self.results)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
        return ended

    def test_more_and_fewer_ranks_go_on(self):
        sweep, rows = Sweep(TEXT), 0
        for ranks in (4, 2, 1, 3):
            self.killed(ranks, rows + 25, sweep)
            kept = sweep.journalled()
            self.assertGreaterEqual(len(kept), rows)
            rows = len(kept)
        self.assertEqual(len(sweep.journals()), 4)
        self.finishes(sweep, 2, kept)

    def test_a_missing_journal_costs_its_rows(self):
        for which in (0, 2):
            sweep = self.killed()
            all_rows, journal = sweep.journalled(), sweep.journals()[which]
            journal.unlink()
            kept = sweep.journalled()
            self.assertLess(len(kept), len(all_rows))
            seen = json.loads(subprocess.run([PROGRAM, "status", "--json", sweep.table], check=True,
                                             capture_output=True, text=True).stdout)
            self.assertEqual((seen["state"], seen["done"]), ("stopped", len(kept)))
            self.finishes(sweep, 3, kept)

    def test_a_journal_with_a_damaged_beginning_costs_its_rows(self):
        for which in (0, 1):
            sweep = self.killed()
            journal = sweep.journals()[which]
            data = bytearray(journal.read_bytes())
            journal.unlink()
            kept = sweep.journalled()
            data[20] ^= 4
            journal.write_bytes(data)
            ended = self.finishes(sweep, 4, kept)
            self.assertIn(f"{journal.name} is a journal with a damaged header; it is passed over", ended.err)

    def test_a_damaged_description_costs_nothing(self):
        sweep = self.killed()
        kept = sweep.journalled()
        for journal in sweep.journals():
            data = bytearray(journal.read_bytes())
            data[first_record(data) - 5] ^= 4
            journal.write_bytes(data)
        self.finishes(sweep, 4, kept)

    def test_a_fresh_start_leaves_no_journal_of_a_larger_run(self):
        sweep = self.killed()
        ended = sweep.run(2, "--fresh", "--max-time", "0")
        self.assertEqual(ended.code, 75, ended)
        self.assertEqual(sweep.journalled(), {})
        self.assertEqual([path.name for path in sweep.journals()], ["table.h5.journal"])

    def test_journals_without_the_first_say_nothing_beside_the_table(self):
        sweep = Sweep(TEXT)
        process = sweep.start(3)
        sweep.wait_for_rows(process, 100)
        journals = {path: path.read_bytes() for path in sweep.journals()[1:]}
        self.assertEqual(end_of(process).code, 0)
        for path, data in journals.items():
            path.write_bytes(data)  # killed while it removed them
        seen = json.loads(subprocess.run([PROGRAM, "status", "--json", sweep.table], check=True, capture_output=True,
                                         text=True).stdout)
        self.assertEqual(seen["state"], "complete")
        ended = sweep.run(2)
        self.assertEqual(ended.code, 0, ended)
        self.assertIn("is complete, nothing to compute", ended.err)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_a_stopped_run_is_extended_with_the_rows_of_all_ranks(self):
        sweep = Sweep(TEXT)
        process = sweep.start(3)
        sweep.wait_for_rows(process, 60)
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(end_of(process).code, 75)
        kept = sweep.journalled()
        sweep.spec.write_text(TEXT.replace("[0.9, 0.8]", "[0.9, 0.8, 0.7]"))
        ended = sweep.run(2, "--extend", "--max-time", "0")
        self.assertEqual(ended.code, 75, ended)
        self.assertIn(f"going on with {len(kept)} of 540 rows, {len(kept)} of them taken over", ended.err)
        self.assertEqual(sorted(sweep.journalled().values()), sorted(kept.values()))


if __name__ == "__main__":
    unittest.main()
