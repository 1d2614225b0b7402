"""Where outputs go: a link is written through to its target, devices and pipes are streams and never replaced, and
nothing that is not of this program, and no input, is written over."""

import os
import pathlib
import stat
import subprocess
import unittest

import h5py
from sweep_process import PRECISION, PROGRAM, Sweep

SPEC = """
title = "Few rows"
[sweep]
N = [2, 3]
v0 = 1.0
tc = 2e-5
epsilon = 0.9
sigma = [0.1, 0.2]
"""


class Places(unittest.TestCase):
    def setUp(self):
        self.sweep = Sweep(SPEC)
        self.path = self.sweep.path
        self.assertEqual(self.sweep.run(0, "-q").code, 0)
        self.csv = self.ok("export", "table.h5").stdout

    def call(self, *arguments, **how):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, timeout=60, cwd=self.path,
                              stdin=subprocess.DEVNULL, **how)

    def ok(self, *arguments, **how):
        ended = self.call(*arguments, **how)
        self.assertEqual((ended.returncode, ended.stderr), (0, b""), ended)
        return ended

    def refused(self, *arguments, words=b"", code=73):
        before = self.content()
        ended = self.call(*arguments)
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count(b"\n")), (code, b"", 1), ended)
        self.assertIn(words, ended.stderr)
        self.assertEqual(self.content(), before)

    def content(self):
        return {entry.name: entry.read_bytes() for entry in self.path.iterdir() if entry.is_file()}

    def text(self, name):
        return (self.path / name).read_bytes()

    def test_a_link_is_written_through(self):
        (self.path / "far").mkdir()
        (self.path / "far" / "real.csv").write_text("old")
        (self.path / "link.csv").symlink_to("far/real.csv")
        (self.path / "new.csv").symlink_to(self.path / "far" / "new.csv")  # its target is not there yet
        for link, target in (("link.csv", "far/real.csv"), ("new.csv", "far/new.csv")):
            self.ok("export", "table.h5", "-o", link)
            self.assertTrue((self.path / link).is_symlink())
            self.assertEqual(self.text(target), self.csv)
        (self.path / "picture.svg").symlink_to("far/picture.svg")
        self.assertEqual(self.call("plot", "table.h5", "-o", "picture.svg").returncode, 0)
        self.assertTrue((self.path / "picture.svg").is_symlink())
        self.assertIn(b"</svg>", self.text("far/picture.svg"))

    def test_a_table_behind_a_link(self):
        (self.path / "far").mkdir()
        (self.path / "link.h5").symlink_to("far/t.h5")
        self.ok("run", "-q", "sweep.toml", "-o", "link.h5")
        self.assertTrue((self.path / "link.h5").is_symlink())
        self.assertEqual(sorted(os.listdir(self.path / "far")), ["t.h5"])
        with h5py.File(self.path / "far" / "t.h5") as table:
            self.assertEqual(table["results"][()].tobytes(), self.sweep.results())
        self.ok("run", "-q", "sweep.toml", "-o", "link.h5")  # it is known to be complete

    def test_streams_get_text_and_stay_what_they_are(self):
        self.assertEqual(self.ok("export", "table.h5", "-o", "-").stdout, self.csv)
        self.assertEqual(self.ok("export", "table.h5", "-o", "/dev/stdout").stdout, self.csv)
        self.assertFalse((self.path / "-").exists())
        os.mkfifo(self.path / "pipe")
        (self.path / "linked").symlink_to("pipe")
        for name in ("pipe", "linked"):
            reader = subprocess.Popen(["cat", "pipe"], stdout=subprocess.PIPE, cwd=self.path)
            self.ok("export", "table.h5", "-o", name)
            self.assertEqual(reader.communicate(timeout=60)[0], self.csv)
        self.assertTrue(stat.S_ISFIFO(os.stat(self.path / "pipe").st_mode))
        shell = subprocess.run(["bash", "-c", f"'{PROGRAM}' export table.h5 --format jsonl -o >(wc -l); wait $!"],
                               capture_output=True, text=True, timeout=60, cwd=self.path)
        self.assertEqual((shell.returncode, shell.stdout.strip()), (0, "4"), shell)
        os.mkfifo(self.path / "picture.svg")
        reader = subprocess.Popen(["cat", "picture.svg"], stdout=subprocess.PIPE, cwd=self.path)
        self.assertEqual(self.call("plot", "table.h5", "-o", "picture.svg").returncode, 0)
        self.assertIn(b"</svg>", reader.communicate(timeout=60)[0])

    def test_a_device_is_not_replaced(self):
        device = self.path / "null"
        try:
            os.mknod(device, stat.S_IFCHR | 0o600, os.makedev(1, 3))
            device.write_bytes(b"x")
        except OSError:
            device = pathlib.Path("/dev/null")
            if os.geteuid() == 0:
                self.skipTest("no device can be made here, and root must not try the real one")
        self.ok("export", "table.h5", "-o", device)
        self.assertTrue(stat.S_ISCHR(os.stat(device).st_mode))
        for command in (("run", "-q", "sweep.toml"), ("run", "-q", "--fresh", "sweep.toml")):
            self.refused(*command, "-o", device, words=b"it is a device, and a table needs a file")
        self.refused("run", "-q", "sweep.toml", "-o", "-", words=b"a table needs a file")
        self.assertTrue(stat.S_ISCHR(os.stat(device).st_mode))

    def test_a_pipe_that_nobody_reads(self):
        os.mkfifo(self.path / "pipe")
        self.refused("export", "table.h5", "-o", "pipe", words=b"no program reads")

    def test_inputs_are_not_written_over(self):
        self.refused("export", "table.h5", "-o", "table.h5", words=b"input")
        os.link(self.path / "table.h5", self.path / "same.svg")
        self.refused("plot", "table.h5", "-o", "same.svg", words=b"the same file as table.h5")
        for options in ((), ("--fresh",)):
            self.refused("run", "-q", *options, "sweep.toml", "-o", "sweep.toml", words=b"input")
        self.refused("merge", "table.h5", "table.h5", "--fresh", words=b"input")
        (self.path / "p.toml").write_text(PRECISION)
        self.refused("precision", "-q", "p.toml", "-o", "p.toml", words=b"input")

    def test_tables_replace_tables_only(self):
        (self.path / "p.toml").write_text(PRECISION)
        (self.path / "p.h5").write_text("user data\n")
        self.refused("precision", "-q", "p.toml", "--no-plots", words=b"is there already")
        self.refused("precision", "-q", "p.toml", "--no-plots", "-o", "table.h5", words=b"is there already")
        for options in ((), ("--fresh",)):
            self.refused("run", "-q", *options, "sweep.toml", "-o", "p.h5", words=b"not a whole sigmasweep table")
        with h5py.File(self.path / "foreign.h5", "w") as file:
            file["measured"] = [1.0, 2.0]
        self.refused("run", "-q", "--fresh", "sweep.toml", "-o", "foreign.h5", words=b"is there already")
        (self.path / "p.h5").write_bytes(b"")  # of mktemp
        for _ in range(2):  # a study replaces its own table
            self.assertEqual(self.call("precision", "-q", "p.toml", "--no-plots").returncode, 0)

    def test_unfinished_files_of_others_are_left_alone(self):
        victim = self.path / "victim"
        victim.write_text("keep\n")
        for suffix, command in ((".part", ("run", "-q", "sweep.toml", "-o")), (".journal", ("run", "-q", "sweep.toml", "-o")),
                                (".running", ("run", "-q", "sweep.toml", "-o")), (".lock", ("run", "-q", "sweep.toml", "-o")),
                                (".part", ("export", "table.h5", "-o"))):
            with self.subTest(suffix=suffix, command=command[0]):
                link = self.path / f"t.h5{suffix}"
                link.symlink_to("victim")
                ended = self.call(*command, "t.h5")
                self.assertEqual((ended.returncode, ended.stderr.count(b"\n")), (73, 1), ended)
                self.assertIn(b"t.h5" + suffix.encode(), ended.stderr)
                self.assertEqual(victim.read_text(), "keep\n")
                self.assertTrue(link.is_symlink())
                link.unlink()
                for name in list(self.path.glob("t.h5*")):
                    name.unlink()
        (self.path / "t.csv.part").write_text("left by a killed run")
        self.ok("export", "table.h5", "-o", "t.csv")
        self.assertEqual(self.text("t.csv"), self.csv)
        self.assertFalse((self.path / "t.csv.part").exists())


class FreshStart(unittest.TestCase):
    FILMS = SPEC + "[trajectory]\nsamples = 11\nwhere = 'N == 2'\n"

    def test_removes_its_own_trajectories_only(self):
        sweep = Sweep(self.FILMS)
        self.assertEqual(sweep.run(0, "-q").code, 0)
        films = sweep.path / "table.trajectories"
        self.assertEqual(sorted(os.listdir(films)), ["row-000000.h5", "row-000001.h5"])
        (films / "row-my-precious.h5").write_text("keep")
        (films / "row-000007.h5").write_text("keep")
        (films / "row-000005.h5.part").write_text("left by a killed run")
        sweep.spec.write_text(self.FILMS.replace("samples = 11", "samples = 12"))
        ended = sweep.run(0, "-q", "--fresh")
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sorted(os.listdir(films)),
                         ["row-000000.h5", "row-000001.h5", "row-000007.h5", "row-my-precious.h5"])

    def test_leaves_what_is_behind_a_link(self):
        sweep = Sweep(self.FILMS)
        other = sweep.path / "other"
        other.mkdir()
        (other / "row-000001.h5").write_text("keep")
        (sweep.path / "table.trajectories").symlink_to("other")
        ended = sweep.run(0, "-q", "--fresh")
        self.assertEqual((ended.code, sweep.files()), (73, ["other", "sweep.toml", "table.trajectories"]), ended)
        self.assertEqual((other / "row-000001.h5").read_text(), "keep")


if __name__ == "__main__":
    unittest.main(verbosity=2)
