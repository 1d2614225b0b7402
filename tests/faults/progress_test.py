"""The progress of a run: a bar where standard error is a terminal, the program's own or that of mpirun; log lines
elsewhere."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios
import time
import unittest

from sweep_process import LIMIT, MPIEXEC, Sweep, spec

TEXT = spec(steps=8000)  # some seconds


def on_terminal(command, columns=100, **how):
    """What the command writes to a terminal that is its standard error."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("4H", 24, columns, 0, 0))
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs, **how)
    os.close(theirs)
    written, end = b"", time.monotonic() + LIMIT
    while time.monotonic() < end:
        if not select.select([ours], [], [], 1.0)[0]:
            continue
        try:
            piece = os.read(ours, 65536)
        except OSError:  # nobody has the terminal open any more
            break
        if not piece:
            break
        written += piece
    os.close(ours)
    code = process.wait(timeout=LIMIT)
    return code, written.decode().replace("\r\n", "\n")


def redrawn(text):
    return re.findall(r"\r([^\r\n]*)\x1b\[K", text)


class Progress(unittest.TestCase):
    def check_bar(self, ranks, columns):
        sweep = Sweep(TEXT)
        code, text = on_terminal(sweep.command(ranks), columns, cwd=sweep.path)
        self.assertEqual(code, 0, text)
        bars = redrawn(text)
        self.assertGreater(len(bars), 3, text)
        self.assertIn("/360 rows", bars[0])
        self.assertRegex(bars[-1], r"100.0 %  360/360 rows")
        self.assertLess(max(map(len, bars)), columns)
        self.assertTrue(text.startswith(f"sigmasweep: 360 rows to compute on {max(ranks, 1)} rank"), text)
        return bars

    def test_a_bar_on_the_terminal_of_mpirun(self):
        self.assertRegex(self.check_bar(3, 100)[-1], r"^\[#{28}\] 100.0 %")

    def test_a_bar_on_the_own_terminal_as_wide_as_it_is(self):
        self.check_bar(0, 60)

    def test_log_lines_where_mpirun_labels_them(self):
        sweep = Sweep(spec(steps=2000))
        command = [*MPIEXEC, "--tag-output", *sweep.command(2)[len(MPIEXEC):]]
        code, text = on_terminal(command, cwd=sweep.path)
        self.assertEqual(code, 0, text)
        self.assertEqual(redrawn(text), [])
        self.assertIn("360/360 rows", text)

    def test_log_lines_in_a_file_of_a_run_that_was_started_on_a_terminal(self):
        sweep = Sweep(spec(steps=2000))
        log = sweep.path / "log"
        code, text = on_terminal(["sh", "-c", '"$@" 2> log', "sh", *sweep.command(2)], cwd=sweep.path)
        self.assertEqual((code, text), (0, ""))
        self.assertNotIn("\r", log.read_text())
        self.assertIn("360/360 rows", log.read_text())

    def test_log_lines_from_the_first_second_on(self):
        sweep = Sweep(TEXT)
        began, times = time.monotonic(), []
        process = sweep.start(2)
        for line in process.stderr:
            times.append((time.monotonic() - began, line))
        self.assertEqual(process.wait(timeout=LIMIT), 0)
        process.stdout.close()
        process.stderr.close()
        lines = [line for _, line in times if "/360 rows" in line]
        self.assertRegex(times[0][1], "360 rows to compute on 2 ranks")
        self.assertRegex(times[1][1], "predicted: .* of core time")
        self.assertGreaterEqual(len(lines), 2, times)
        seconds = [float(found[1]) * (1e-3 if found[2] == "ms" else 1.0)
                   for found in re.finditer(r"rows/s, ([\d.]+) (ms|s), left", lines[0])]
        self.assertTrue(seconds and seconds[0] < 5.0, lines)  # 0.7 s on a machine with nothing else to do


if __name__ == "__main__":
    unittest.main(verbosity=2)
