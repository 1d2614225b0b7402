"""--slice, merge, --extend and --reuse use rows that were computed elsewhere or earlier, and make the same table, bit
for bit."""

import os
import random
import shutil
import signal
import subprocess
import unittest

import h5py
from sweep_process import MPIEXEC, PROGRAM, Sweep, end_of, ranks_of, spec, wait_until_gone, xxh3

QUICK = spec(steps=20).replace("[2, 5, 10, 20]", "[2, 3, 5, 8]")  # milliseconds for all rows
EXTENDED = QUICK.replace("[0.9, 0.8]", "[0.9, 0.85, 0.8]").replace("count = 15", "count = 29")


def merge(sweep, *parts, options=()):
    return subprocess.run([PROGRAM, "merge", str(sweep.table), *map(str, parts), *options], text=True, timeout=60,
                          capture_output=True)


class Slices(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(QUICK)
        assert cls.whole.run(2).code == 0
        cls.results = cls.whole.results()

    def slices(self, count, indices=None, text=QUICK):
        parts = []
        for index in indices if indices is not None else range(count):
            part = Sweep(text)
            ended = part.run(index % 3, "--slice", f"{index}/{count}")
            self.assertEqual(ended.code, 0, ended)
            parts.append(part)
        return parts

    def test_merged_slices_are_the_whole(self):
        for count in (1, 3, 7):
            parts = self.slices(count)
            sizes = [len(part.timings()) for part in parts]
            self.assertEqual(sum(sizes), 360)
            self.assertLessEqual(max(sizes) - min(sizes), 1)
            random.shuffle(parts)
            merged = Sweep(QUICK)
            ended = merge(merged, *(part.table for part in parts))
            self.assertEqual(ended.returncode, 0, ended)
            self.assertEqual(merged.results(), self.results)
            self.assertEqual(merged.files(), ["sweep.toml", "table.h5"])
            self.assertIn("nothing to compute", merged.run(0).err)
            self.assertIn("nothing to merge", merge(merged, parts[0].table).stderr)

    def test_merge_under_mpirun(self):
        [whole], [half] = self.slices(1), self.slices(2, [1])
        merged = Sweep(QUICK)
        for code, table in ((65, half.table), (66, "missing.h5"), (0, whole.table)):
            ended = subprocess.run([*MPIEXEC, "-n", "2", PROGRAM, "merge", str(merged.table), str(table)], text=True,
                                   timeout=60, capture_output=True)
            self.assertEqual(ended.returncode, code, ended)
            self.assertEqual(ended.stderr.count("sigmasweep: "), int(code != 0), ended)
        self.assertEqual(merged.results(), self.results)

    def test_marked_and_readable(self):
        part = self.slices(3, [1])[0]
        with h5py.File(part.table) as table:
            self.assertEqual((table.attrs["slice_index"], table.attrs["slice_count"]), (1, 3))
        with h5py.File(self.whole.table) as table:
            self.assertNotIn("slice_count", table.attrs)
        shown = subprocess.run([PROGRAM, "show", part.table, "--json"], capture_output=True, check=True, text=True)
        self.assertIn('"slice"', shown.stdout)
        self.assertIn("nothing to compute", part.run(0, "--slice", "1/3").err)
        for options in ([], ["--slice", "0/3"], ["--slice", "1/4"]):
            ended = part.run(0, *options)
            self.assertEqual((ended.code, ended.err.count("another slice")), (73, 1), ended)

    def test_slices_are_balanced(self):
        """Slices have equal cost even if their number is the length of an axis: each has some of the long rows."""
        whole = Sweep(spec(steps=20).replace("[2, 5, 10, 20]", "10").replace("[1.0, 0.1, 0.01]", "1.0"))
        parts = self.slices(15, text=whole.spec.read_text())
        predicted = [part.timings()["predicted_time"].sum() for part in parts]
        self.assertEqual([len(part.timings()) for part in parts], [2] * 15)
        parts = self.slices(5)
        predicted = [part.timings()["predicted_time"].sum() for part in parts]
        self.assertLess(max(predicted), 1.5 * min(predicted))

    def test_merge_refusals(self):
        parts = self.slices(4, [0, 1, 3])
        other = self.slices(4, [2], QUICK.replace("0.8", "0.7"))[0]
        changed = Sweep(QUICK)
        shutil.copy(parts[1].table, changed.table)
        with h5py.File(changed.table, "r+") as table:
            rows = table["results"][()]
            before = xxh3(rows[5].tobytes(), 5)
            rows["eps_eff"][5] += 1e-16 + 1e-15
            table["results"][()] = rows
            checksum = int(table["results"].attrs["checksum"], 16) - before + xxh3(rows[5].tobytes(), 5)
            table["results"].attrs["checksum"] = f"{checksum % 2**64:016x}"
        for given, code, words in (
            (parts, 65, "90 of 360 rows are missing, those of slice 2/4"),
            ([*parts, other], 65, "is of another spec"),
            ([*parts, changed], 65, "1 rows with other results"),
        ):
            merged = Sweep(QUICK)
            ended = merge(merged, *(part.table for part in given))
            self.assertEqual((ended.returncode, ended.stderr.count(words)), (code, 1), ended)
            self.assertEqual(merged.files(), ["sweep.toml"])
        merged = Sweep(QUICK)
        self.assertEqual(merge(merged, merged.path / "missing.h5").returncode, 66)
        merged.table.write_text("my thesis\n")
        for options in ([], ["--fresh"]):
            self.assertEqual(merge(merged, self.whole.table, options=options).returncode, 73)
            self.assertEqual(merged.table.read_text(), "my thesis\n")
        merged.table.write_bytes(b"")
        self.assertEqual(merge(merged, self.whole.table, options=["--fresh"]).returncode, 0)
        self.assertEqual(merged.results(), self.results)

    def test_a_slice_goes_on_where_it_was(self):
        part = Sweep()
        process = part.start(2, "--slice", "1/2")
        part.wait_for_rows(process, 5)
        ranks = ranks_of(process)
        os.kill(ranks[0], signal.SIGKILL)
        end_of(process)
        wait_until_gone(ranks)  # until then the others may keep rows
        kept = part.journalled()
        self.assertEqual(part.run(0).code, 73)
        ended = part.run(2, "--slice", "1/2")
        self.assertEqual(ended.code, 0, ended)
        self.assertIn(f"going on with {len(kept)} of 180 rows", ended.err)


class Extend(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(EXTENDED)
        assert cls.whole.run(2).code == 0
        cls.results = cls.whole.results()

    def test_table(self):
        for ranks in (0, 2):
            sweep = Sweep(QUICK)
            self.assertEqual(sweep.run(2).code, 0)
            old = sorted(sweep.timings()["run_time"])
            sweep.spec.write_text(EXTENDED)
            self.assertEqual(sweep.run(ranks).code, 73)
            ended = sweep.run(ranks, "--extend")
            self.assertEqual(ended.code, 0, ended)
            self.assertIn("going on with 360 of 1044 rows, 360 of them taken over", ended.err)
            self.assertIn("computed 684 rows", ended.err)
            self.assertEqual(sweep.results(), self.results)
            self.assertLessEqual(set(old), set(sweep.timings()["run_time"]))
            self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
            self.assertIn("nothing to compute", sweep.run(ranks, "--extend").err)

    def test_killed_in_between_loses_nothing(self):
        """Neither old nor new rows are lost, and --extend is needed only once."""
        slow, extended = spec(), spec().replace("[0.9, 0.8]", "[0.9, 0.8, 0.7]")
        whole = Sweep(extended)
        self.assertEqual(whole.run(2).code, 0)
        for finished in (True, False):
            with self.subTest(finished=finished):
                sweep = Sweep(slow)
                process = sweep.start(2)
                if not finished:
                    sweep.wait_for_rows(process, 50)
                    process.send_signal(signal.SIGUSR1)
                self.assertEqual(end_of(process).code, 0 if finished else 75)
                old = set(sweep.timings()["run_time"]) if finished else set(sweep.journalled().values())
                sweep.spec.write_text(extended)
                self.assertEqual(sweep.run(2).code, 73)
                process = sweep.start(2, "--extend")
                sweep.wait_for_rows(process, len(old) + 5)
                ranks = ranks_of(process)
                os.kill(ranks[0], signal.SIGKILL)
                end_of(process)
                wait_until_gone(ranks)  # until then the others may keep rows
                kept = sweep.journalled()
                self.assertLessEqual(old, set(kept.values()))
                self.assertEqual(sweep.table.exists(), finished)
                ended = sweep.run(2)
                self.assertEqual(ended.code, 0, ended)
                self.assertIn(f"going on with {len(kept)} of 540 rows\n", ended.err)
                self.assertEqual(sweep.results(), whole.results())

    def test_reuse_several(self):
        one, two = Sweep(QUICK), Sweep(QUICK.replace("[0.9, 0.8]", "0.85"))
        for sweep in (one, two):
            self.assertEqual(sweep.run(2).code, 0)
        before = [sweep.table.read_bytes() for sweep in (one, two)]
        sweep = Sweep(EXTENDED)
        ended = sweep.run(2, "--reuse", str(one.table), "--reuse", str(two.table))
        self.assertEqual(ended.code, 0, ended)
        self.assertIn("going on with 540 of 1044 rows, 540 of them taken over", ended.err)
        self.assertEqual(sweep.results(), self.results)
        self.assertEqual([sweep.table.read_bytes() for sweep in (one, two)], before)
        self.assertEqual(Sweep(EXTENDED).run(0, "--reuse", "missing.h5").code, 66)

    def test_other_physics_or_build_is_not_reused(self):
        for attribute in ("physics_version", "compiler_flags"):
            sweep = Sweep(QUICK)
            self.assertEqual(sweep.run(2).code, 0)
            with h5py.File(sweep.table, "r+") as table:
                old = table.attrs[attribute]
                table.attrs[attribute] = old + " -ffast-math" if isinstance(old, str) else type(old)(int(old) + 1)
            sweep.spec.write_text(EXTENDED)
            before = sweep.table.read_bytes()
            self.assertEqual(sweep.run(2, "--extend").code, 73)
            self.assertEqual((sweep.files(), sweep.table.read_bytes()), (["sweep.toml", "table.h5"], before))
            other = Sweep(EXTENDED)
            ended = other.run(2, "--reuse", str(sweep.table))
            self.assertEqual(ended.code, 0, ended)
            self.assertIn("nothing taken over", ended.err)
            self.assertIn("computed 1044 rows", ended.err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
