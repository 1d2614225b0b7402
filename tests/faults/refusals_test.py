"""A run does not overwrite foreign files, does not share a table with another run, and prints a message once, not once
per rank."""

import os
import resource
import signal
import unittest

from sweep_process import Sweep, end_of, ranks_of, spec

QUICK = spec(steps=20)


class Refusals(unittest.TestCase):
    def check_refused(self, sweep, ranks, code, words, *options):
        before = {name: (sweep.path / name).read_bytes() for name in sweep.files()}
        ended = sweep.run(ranks, *options)
        self.assertEqual(ended.code, code, ended)
        self.assertEqual(ended.err.count(words), 1, ended)
        self.assertNotIn("MPI_ABORT", ended.err)
        self.assertEqual({name: (sweep.path / name).read_bytes() for name in sweep.files()}, before)

    def test_bad_spec_is_one_message(self):
        sweep = Sweep(QUICK.replace("epsilon ", "epsilom "))
        for ranks in (0, 1, 3):
            self.check_refused(sweep, ranks, 65, "epsilom")

    def test_missing_spec(self):
        sweep = Sweep(QUICK)
        sweep.spec.unlink()
        for ranks in (0, 3):
            self.check_refused(sweep, ranks, 66, "sweep.toml")

    def test_no_such_directory(self):
        sweep = Sweep(QUICK)
        sweep.table = sweep.path / "missing" / "table.h5"
        for ranks in (0, 3):
            self.check_refused(sweep, ranks, 73, "table.h5")

    def test_something_else_is_in_the_way(self):
        sweep = Sweep(QUICK)
        sweep.table.write_text("my thesis\n")
        for ranks in (0, 3):
            for options in ((), ("--fresh",)):
                self.check_refused(sweep, ranks, 73, "not a whole sigmasweep table", *options)
        sweep.table.write_bytes(b"")  # of mktemp
        self.check_refused(sweep, 0, 73, "--fresh")
        self.assertEqual(sweep.run(2, "--fresh").code, 0)
        self.assertGreater(len(sweep.results()), 0)

    def test_table_of_another_spec(self):
        sweep = Sweep(QUICK)
        self.assertEqual(sweep.run(2).code, 0)
        old = sweep.results()
        sweep.spec.write_text(QUICK.replace("0.8", "0.7"))
        for ranks in (0, 3):
            self.check_refused(sweep, ranks, 73, "another spec")
        self.assertEqual(sweep.run(2, "--fresh").code, 0)
        self.assertNotEqual(sweep.results(), old)

    def test_journal_of_another_spec(self):
        sweep = Sweep()
        process = sweep.start(2)
        sweep.wait_for_rows(process)
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(end_of(process).code, 75)
        sweep.spec.write_text(QUICK)
        for ranks in (0, 3):
            self.check_refused(sweep, ranks, 73, "another sweep spec")
        self.assertEqual(sweep.run(2, "--fresh").code, 0)

    def test_complete_table_is_left_alone(self):
        sweep = Sweep(QUICK)
        first = sweep.run(3)
        self.assertEqual(first.code, 0, first)
        before = sweep.table.stat()
        for ranks in (0, 2):
            again = sweep.run(ranks)
            self.assertEqual(again.code, 0, again)
            self.assertIn("nothing to compute", again.err)
            self.assertEqual(sweep.table.stat().st_mtime_ns, before.st_mtime_ns)
            self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_two_runs_on_one_table(self):
        sweep = Sweep()
        first = sweep.start(2)
        sweep.wait_for_rows(first)
        manager = ranks_of(first)[0]
        os.kill(manager, signal.SIGSTOP)  # the first run must not end before the others have started
        try:
            for ranks, options in ((0, []), (2, []), (2, ["--fresh"])):
                second = sweep.run(ranks, *options)
                self.assertEqual(second.code, 73, second)
                self.assertEqual(second.err.count("another run is working on"), 1, second)
        finally:
            os.kill(manager, signal.SIGCONT)
        ended = end_of(first)
        self.assertEqual(ended.code, 0, ended)

    def test_full_disk_keeps_what_is_there(self):
        """A limit on the size of the journal stands for a full disk."""
        sweep = Sweep()
        process = sweep.start(0, preexec_fn=lambda: signal.signal(signal.SIGXFSZ, signal.SIG_IGN))
        sweep.wait_for_rows(process)
        little_more = sweep.journal.stat().st_size + 1000
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (little_more, resource.RLIM_INFINITY))
        ended = end_of(process)
        self.assertEqual(ended.code, 74, ended)
        self.assertIn("table.h5.journal", ended.err)
        kept = sweep.journalled()
        self.assertGreater(len(kept), 0)
        ended = sweep.run(2)
        self.assertEqual(ended.code, 0, ended)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")


if __name__ == "__main__":
    unittest.main(verbosity=2)
