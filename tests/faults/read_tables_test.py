"""Tables that other programs had in their hands: open, left open, repacked, packed, with links to elsewhere, in odd
places. Numbers are read where they are those that were written; a changed number is found."""

import os
import shutil
import subprocess
import sys
import unittest

import h5py
import numpy
from sweep_process import PRECISION, PROGRAM, Sweep, xxh3

SPEC = """
[sweep]
N = [2, 3]
v0 = 1.0
tc = 2e-5
epsilon = 0.9
sigma = [0.1, 0.2, 0.5]
"""
HOLD = 'import h5py, time; f = h5py.File("t.h5", "r+"); EDIT; print(flush=True); time.sleep(600)'


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Sweep(SPEC)
        cls.path = cls.sweep.path
        assert cls.sweep.run(0, "-q").code == 0
        cls.whole = cls.sweep.table.read_bytes()
        cls.csv = cls.call("export", "table.h5").stdout

    @classmethod
    def call(cls, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, timeout=60, cwd=cls.path,
                              stdin=subprocess.DEVNULL)

    def setUp(self):
        (self.path / "t.h5").write_bytes(self.whole)

    def reads(self, name="t.h5"):
        exported = self.call("export", name)
        self.assertEqual((exported.returncode, exported.stdout, exported.stderr), (0, self.csv, b""), exported)
        for command in (("show", name), ("plot", name, "-o", "t.svg"), ("run", "-q", "sweep.toml", "-o", name)):
            ended = self.call(*command)
            self.assertEqual(ended.returncode, 0, ended)

    def refuses(self, words, name="t.h5", commands=("show", "export", "plot")):
        for command in commands:
            ended = self.call(command, name)
            self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count(b"\n")), (74, b"", 1), ended)
            self.assertIn(words, ended.stderr)

    def held(self, edit="pass"):
        """A program that has the table open for writing; the caller kills it."""
        holder = subprocess.Popen([sys.executable, "-c", HOLD.replace("EDIT", edit)], stdout=subprocess.PIPE, cwd=self.path)
        holder.stdout.readline()
        return holder

    def kill(self, holder):
        holder.kill()
        holder.wait()
        holder.stdout.close()

    def test_open_for_writing_elsewhere_and_after_that_was_killed(self):
        holder = self.held()
        self.reads()
        self.kill(holder)
        self.assertNotEqual((self.path / "t.h5").read_bytes(), self.whole)  # HDF5's note is left
        self.reads()

    def test_opened_for_writing_and_closed(self):
        with h5py.File(self.path / "t.h5", "r+") as table:
            table.attrs["my note"] = "of another program"
        self.assertNotEqual((self.path / "t.h5").read_bytes()[-16:-8], b"SSWSEAL\n")
        self.reads()

    def test_format_of_later_versions_left_open(self):
        """HDF5 itself does not open such a file without h5clear."""
        with h5py.File(self.path / "table.h5") as table, h5py.File(self.path / "t.h5", "w", libver="latest") as copy:
            for name in table:
                table.copy(name, copy)
            for name, value in table.attrs.items():
                copy.attrs[name] = value
        self.reads()
        holder = self.held()
        self.kill(holder)
        with self.assertRaises(OSError):
            h5py.File(self.path / "t.h5")
        self.reads()

    def test_a_changed_number_is_found(self):
        holder = self.held("d = f['results']; r = d[()]; r['eps_eff'][1] += 1e-12; d[()] = r; f.flush()")
        self.kill(holder)
        self.refuses(b"damaged")
        with h5py.File(self.path / "table.h5") as table:
            at = table["results"].id.get_offset() + 8
        for note in (0, 1):  # HDF5's own note, set or not, excuses no other change
            data = bytearray(self.whole)
            data[20] = note
            data[at] ^= 1
            (self.path / "t.h5").write_bytes(data)
            self.refuses(b"damaged or changed after it was written")

    def test_repacked(self):
        if not shutil.which("h5repack"):
            self.skipTest("no h5repack (Debian: hdf5-tools)")
        for options in ([], ["-f", "GZIP=6"], ["-l", "results:CHUNK=2", "-f", "SHUF", "-f", "GZIP=9"], ["-L"]):
            with self.subTest(options=options):
                subprocess.run(["h5repack", *options, "table.h5", "t.h5"], cwd=self.path, check=True)
                self.reads()

    def test_packed_and_extensible(self):
        with h5py.File(self.path / "t.h5", "r+") as table:
            rows, attributes = table["results"][()], dict(table["results"].attrs)
            kind = table["results"].id.get_type()
            del table["results"]
            properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            properties.set_chunk((2,))
            properties.set_deflate(9)
            space = h5py.h5s.create_simple((len(rows),), (h5py.h5s.UNLIMITED,))
            results = h5py.Dataset(h5py.h5d.create(table.id, b"results", kind, space, properties))
            results[()] = rows
            for name, value in attributes.items():
                results.attrs[name] = value
        self.reads()
        with h5py.File(self.path / "t.h5", "r+") as table:
            table["results"].resize((len(rows) + 1,))
        self.refuses(b"has not the 6 rows")

    def test_extents_that_nothing_is_stored_for(self):
        huge = 1 << 40
        with h5py.File(self.path / "t.h5", "r+") as table:
            for name in ("results", "timings"):
                kind, attributes = table[name].id.get_type(), dict(table[name].attrs)
                del table[name]
                properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
                properties.set_chunk((1024,))
                dataset = h5py.Dataset(h5py.h5d.create(table.id, name.encode(), kind, h5py.h5s.create_simple((huge,)), properties))
                for key, value in attributes.items():
                    dataset.attrs[key] = value
            table.attrs["rows"] = numpy.uint64(huge)
        self.refuses(b"has not the size")

    def test_data_elsewhere_are_not_followed(self):
        os.replace(self.path / "t.h5", self.path / "other.h5")
        for how in ("link", "soft", "virtual", "external"):
            with self.subTest(how=how):
                (self.path / "t.h5").write_bytes(self.whole)
                with h5py.File(self.path / "t.h5", "r+") as table:
                    old, attributes = table["results"], dict(table["results"].attrs)
                    dtype, rows = old.dtype, len(old)
                    del table["results"]
                    if how == "link":
                        table["results"] = h5py.ExternalLink("other.h5", "/results")
                    elif how == "soft":
                        table["results"] = h5py.SoftLink("/timings")
                    elif how == "virtual":
                        layout = h5py.VirtualLayout(shape=(rows,), dtype=dtype)
                        layout[:] = h5py.VirtualSource("other.h5", "results", shape=(rows,))
                        table.create_virtual_dataset("results", layout)
                    else:
                        table.create_dataset("results", (rows,), dtype, external=[("/etc/hostname", 0, rows * dtype.itemsize)])
                    if how in ("virtual", "external"):
                        for name, value in attributes.items():
                            table["results"].attrs[name] = value
                self.refuses(b"elsewhere" if how in ("link", "soft") else b"in other files")

    def test_no_regular_file(self):
        os.mkfifo(self.path / "pipe.h5")
        (self.path / "directory.h5").mkdir()
        (self.path / "linked.h5").symlink_to("pipe.h5")
        for name in ("pipe.h5", "directory.h5", "linked.h5"):
            self.refuses(b"not a regular file", name)
            self.assertEqual(self.call("merge", "merged.h5", name).returncode, 74)
            reused = self.call("run", "-q", "sweep.toml", "-o", "reused.h5", "--reuse", name)
            self.assertEqual(reused.returncode, 74, reused)

    def test_no_rows(self):
        with h5py.File(self.path / "t.h5", "r+") as table:
            for name in ("results", "timings"):
                kind, attributes = table[name].id.get_type(), dict(table[name].attrs)
                layout = "".join(line + "\n" for line in self.layout_of(table[name].dtype))
                del table[name]
                dataset = h5py.Dataset(h5py.h5d.create(table.id, name.encode(), kind, h5py.h5s.create_simple((0,))))
                for key, value in attributes.items():
                    dataset.attrs[key] = value
                dataset.attrs["checksum"] = f"{xxh3(layout.encode()):016x}"
            table.attrs["rows"] = numpy.uint64(0)
            table.attrs["spec"] = "this is of a later version"
            table.attrs["spec_hash"] = f"{xxh3(b'this is of a later version'):016x}"
        for command in (("show",), ("export",), ("plot",), ("plot", "--kind", "precision"), ("plot", "--kind", "stability")):
            ended = self.call(command[0], "t.h5", *command[1:])
            self.assertEqual((ended.returncode, ended.stderr.count(b"\n")), (74, 1), ended)
            self.assertIn(b"it has no rows", ended.stderr)

    @staticmethod
    def layout_of(dtype):
        for name in dtype.names:
            member, offset = dtype.fields[name][:2]
            names = h5py.check_enum_dtype(member) or {}
            values = "".join(f" {key}={value}" for key, value in sorted(names.items(), key=lambda item: item[1]))
            yield f"{name} {offset} {member.str}{values}"


class LongSpecs(unittest.TestCase):
    """HDF5 limits attributes to 64 kB: a longer spec is a dataset."""

    def check(self, text):
        sweep = Sweep(text)
        for ranks in (0, 3):
            ended = sweep.run(ranks, "-q", "--fresh")
            self.assertEqual(ended.code, 0, ended)
            with h5py.File(sweep.table) as table:
                found = table.attrs["spec"] if "spec" in table.attrs else table["spec"].asstr()[()]
                self.assertEqual(found, text)
            shown = subprocess.run([PROGRAM, "show", sweep.table], capture_output=True, text=True, timeout=60)
            self.assertEqual((shown.returncode, shown.stderr), (0, ""), shown)
            self.assertEqual(sweep.run(ranks, "-q").code, 0)  # it is known to be complete

    def test_many_sizes(self):
        for size in (59_000, 61_000, 70_000, 1_600_000, (4 << 20) - 100):
            with self.subTest(size=size):
                comment = "# µ comment\n"
                self.check(SPEC + comment * ((size - len(SPEC.encode())) // len(comment.encode())))

    def test_many_values(self):
        values = ", ".join(f"{1e-9 * (i + 1):.9g}" for i in range(10_000))
        self.check(f"[sweep]\nmethod = 'ed'\nN = 2\nv0 = 1.0\nepsilon = 0.9\ns0 = [{values}]\n")

    def test_a_long_title(self):
        self.check(f"title = '{'long ' * 20_000}'\n{SPEC}")


class PrecisionTables(unittest.TestCase):
    def test_damage_is_found(self):
        sweep = Sweep(PRECISION)
        call = lambda *arguments: subprocess.run([PROGRAM, *arguments], capture_output=True, timeout=60, cwd=sweep.path)
        self.assertEqual(call("precision", "-q", "sweep.toml", "-o", "p.h5", "--no-plots").returncode, 0)
        table = sweep.path / "p.h5"
        self.assertEqual(call("plot", "p.h5").returncode, 0)
        whole = table.read_bytes()
        with h5py.File(table) as file:
            at = file["precision"].id.get_offset() + file["precision"].dtype.fields["error_max"][1]
        data = bytearray(whole)
        data[at + 7] ^= 4
        for damaged in (data, data[:-16]):  # by the seal, or without one by the dataset's checksum
            table.write_bytes(damaged)
            ended = call("plot", "p.h5")
            self.assertEqual((ended.returncode, ended.stderr.count(b"\n")), (74, 1), ended)
            self.assertIn(b"damaged", ended.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
