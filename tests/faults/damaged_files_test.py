"""Damaged, truncated and foreign tables and journals are detected and reported once; they are neither used nor
overwritten."""

import os
import random
import struct
import subprocess
import unittest

import h5py
from sweep_process import PROGRAM, Sweep, first_record, spec, stopped_sweep, xxh3

QUICK = spec(steps=20)
SEAL = 16  # bytes behind the end of the HDF5 file


def flipped(data, byte, bit):
    return data[:byte] + bytes([data[byte] ^ 1 << bit]) + data[byte + 1:]


def layout(dtype):
    """The layout as text for the checksum: "name offset type" and the names of an enumeration."""
    text = ""
    for name in dtype.names:
        member, offset = dtype.fields[name][:2]
        names = h5py.check_enum_dtype(member) or {}
        values = "".join(f" {name}={value}" for name, value in sorted(names.items(), key=lambda item: item[1]))
        text += f"{name} {offset} {member.str}{values}\n"
    return text.encode()


class DamagedTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Sweep(QUICK)
        assert cls.sweep.run(2).code == 0
        cls.whole = cls.sweep.table.read_bytes()
        with h5py.File(cls.sweep.table) as table:
            cls.data = {name: (table[name].id.get_offset(), table[name].nbytes) for name in ("results", "timings")}
        seed = int(os.environ.get("DAMAGE_SEED", random.SystemRandom().randrange(10**9)))
        print(f"DAMAGE_SEED={seed}")
        cls.random = random.Random(seed)

    def check(self, damaged, run=False):
        self.sweep.table.write_bytes(damaged)
        shown = subprocess.run([PROGRAM, "show", self.sweep.table], capture_output=True, text=True, timeout=60)
        self.assertEqual((shown.returncode, shown.stdout, shown.stderr.count("\n")), (74, "", 1), shown)
        self.assertIn("table.h5 is not a whole table", shown.stderr)
        for ranks in (0, 2) if run else ():
            ended = self.sweep.run(ranks)
            self.assertEqual(ended.code, 73, ended)
            self.assertEqual(ended.err.count("not a whole sigmasweep table"), 1, ended)
            self.assertEqual(self.sweep.table.read_bytes(), damaged)
            self.assertEqual(self.sweep.files(), ["sweep.toml", "table.h5"])

    def test_checksums_are_what_is_said(self):
        self.sweep.table.write_bytes(self.whole)
        self.assertEqual(self.whole[-SEAL:], b"SSWSEAL\n" + struct.pack("<Q", xxh3(self.whole[:-SEAL])))
        with h5py.File(self.sweep.table) as table:
            for name, dataset in table.items():
                rows = dataset[()]
                sums = [xxh3(layout(rows.dtype)), *(xxh3(row.tobytes(), k) for k, row in enumerate(rows))]
                self.assertEqual(dataset.attrs["checksum"], f"{sum(sums) % 2**64:016x}", name)

    def test_any_flipped_bit(self):
        for i in range(40):
            byte, bit = self.random.randrange(len(self.whole) - SEAL), self.random.randrange(8)
            if byte in range(20, 24):
                continue  # HDF5's note that the file is open for writing is not sealed
            with self.subTest(byte=byte, bit=bit):
                self.check(flipped(self.whole, byte, bit), run=i == 0)

    def test_flipped_bit_of_the_rows_without_seal(self):
        for name, (offset, size) in self.data.items():
            for i in range(10):
                byte, bit = offset + self.random.randrange(size), self.random.randrange(8)
                with self.subTest(dataset=name, byte=byte, bit=bit):
                    self.check(flipped(self.whole[:-SEAL], byte, bit), run=i == 0)

    def test_cut(self):
        self.check(self.whole[:-SEAL - 1], run=True)
        for _ in range(20):
            size = self.random.randrange(len(self.whole) - SEAL)
            with self.subTest(size=size):
                self.check(self.whole[:size])

    def test_of_an_older_format(self):
        self.sweep.table.write_bytes(self.whole)
        with h5py.File(self.sweep.table, "r+") as table:
            table.attrs.modify("format_version", table.attrs["format_version"] - 1)
        self.check(self.sweep.table.read_bytes())


class DamagedJournals(unittest.TestCase):
    def test_damaged_records_are_told_and_computed_again(self):
        sweep = stopped_sweep()
        kept = len(sweep.journalled())
        journal = max(sweep.journals(), key=lambda path: path.stat().st_size)
        data = journal.read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        journal.write_bytes(flipped(data, first_record(data) + size // 2, 3)[:-1])
        ended = sweep.run(2)
        self.assertEqual(ended.code, 0, ended)
        self.assertIn("2 damaged or torn records of the journal are passed over", ended.err)
        self.assertIn(f"going on with {kept - 2} of 360 rows", ended.err)

    def test_of_another_build(self):
        sweep = stopped_sweep()
        data = bytearray(sweep.journal.read_bytes())
        data[44] ^= 1
        data[64:72] = struct.pack("<Q", xxh3(bytes(data[:64])))  # the header's checksum is right
        sweep.journal.write_bytes(data)
        for ranks in (0, 2):
            ended = sweep.run(ranks)
            self.assertEqual(ended.code, 73, ended)
            self.assertEqual(ended.err.count("another build of the program"), 1, ended)
            self.assertEqual(sweep.journal.read_bytes(), data)
        self.assertEqual(sweep.run(2, "--fresh").code, 0)

    def test_of_another_version(self):
        sweep = stopped_sweep()
        for byte, bit, words in ((8, 8, "format"), (16, 1, "other fields"), (40, 1, "physics version")):
            data = bytearray(sweep.journal.read_bytes())
            data[byte] ^= bit
            data[64:72] = struct.pack("<Q", xxh3(bytes(data[:64])))
            changed = Sweep()
            changed.journal.write_bytes(data)
            ended = changed.run(0)
            self.assertEqual((ended.code, ended.err.count(words)), (73, 1), ended)
            self.assertEqual(changed.journal.read_bytes(), data)


class FreshStart(unittest.TestCase):
    def test_stopped_before_its_first_row_is_still_a_fresh_start(self):
        sweep = Sweep(QUICK)
        self.assertEqual(sweep.run(2).code, 0)
        before = sweep.table.read_bytes()
        ended = sweep.run(2, "--fresh", "--max-seconds", "0")
        self.assertEqual(ended.code, 75, ended)
        self.assertEqual(sweep.journalled(), {})
        self.assertEqual(sweep.table.read_bytes(), before)
        ended = sweep.run(2)
        self.assertEqual(ended.code, 0, ended)
        self.assertIn("older than the fresh start", ended.err)
        self.assertIn("computed 360 rows", ended.err)
        self.assertNotEqual(sweep.table.read_bytes(), before)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
