"""A sweep as processes, for tests that kill, stop and resume runs of the program.

Environment: SIGMASWEEP, the program; MPIEXEC, mpirun with its options; FAILING_CALLS, the library of failing_calls.c.
"""

import concurrent.futures
import ctypes
import errno
import os
import pathlib
import re
import shlex
import signal
import struct
import subprocess
import tempfile
import time

import h5py

PROGRAM = os.environ["SIGMASWEEP"]
MPIEXEC = shlex.split(os.environ.get("MPIEXEC", "mpirun --oversubscribe"))
LIMIT = 120  # s; a process that takes longer hangs, and fails the test

# 360 rows of fixed steps. With 4000 steps a row takes 1 to about 10 ms and a run one or two seconds, in which it can be
# disturbed; with 20 steps it takes hardly any time. For sigma > 10 the longest columns are chaotic, and error bars
# would take most of the time.
SPEC = """
title = "A sweep to be disturbed"
[sweep]
N            = [2, 5, 10, 20]
epsilon      = [0.9, 0.8]
v0           = [1.0, 0.1, 0.01]
tc           = 1e-5
sigma        = { from = 0.01, to = 5.0, count = 15, scale = "log" }
integrator   = "verlet"
steps_per_tc = STEPS
"""

# A precision study of a second or two.
PRECISION = """
[sweep]
N = 2
epsilon = 0.9
sigma = 0.3
v0 = 1.0
tc = 1e-5
[precision]
integrators  = ["exact", "verlet"]
steps_per_tc = [20]
tolerances   = [1e-3]
tuples  = 2
checks  = 1
repeats = 1
seconds = 1
"""


def spec(steps=4000):
    return SPEC.replace("STEPS", repr(float(steps)))


def failing(call, at=1, number=errno.EIO, path="", on=False, rank=None):
    """The environment for a run in which a call fails; see failing_calls.c."""
    environment = dict(os.environ, LD_PRELOAD=os.environ["FAILING_CALLS"], FAIL_CALL=call, FAIL_AT=str(at),
                       FAIL_ERRNO=str(number), FAIL_PATH=path)
    if on:
        environment["FAIL_ON"] = "1"
    if rank is not None:
        environment["FAIL_RANK"] = str(rank)
    return environment


def xxh3(data, seed=0):
    """The checksum XXH3_64bits of the program's files."""
    library = ctypes.CDLL("libxxhash.so.0")
    library.XXH3_64bits_withSeed.restype = ctypes.c_uint64
    return library.XXH3_64bits_withSeed(data, ctypes.c_size_t(len(data)), ctypes.c_uint64(seed))


def first_record(journal):
    """Where the records of a journal begin."""
    return 72 + struct.unpack_from("<Q", journal, 48)[0]


class Sweep:
    """A spec and its table in a temporary directory."""

    def __init__(self, text=None):
        self.home = tempfile.TemporaryDirectory(prefix="sigmasweep-")
        self.path = pathlib.Path(self.home.name)
        self.spec = self.path / "sweep.toml"
        self.table = self.path / "table.h5"
        self.journal = self.path / "table.h5.journal"
        self.spec.write_text(text or spec())

    def __del__(self):
        self.home.cleanup()

    def command(self, ranks, *options):
        """The command of a run; without mpirun for ranks = 0."""
        launcher = [*MPIEXEC, "-n", str(ranks)] if ranks else []
        return [*launcher, PROGRAM, "run", str(self.spec), "-o", str(self.table), *options]

    def start(self, ranks, *options, **how):
        return subprocess.Popen(self.command(ranks, *options), cwd=self.path, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **how)

    def run(self, ranks, *options, **how):
        return end_of(self.start(ranks, *options, **how))

    def results(self):
        with h5py.File(self.table, "r") as table:
            return table["results"][()].tobytes()

    def timings(self):
        with h5py.File(self.table, "r") as table:
            return table["timings"][()]

    def files(self):
        """The names in the directory; those of the other ranks' journals as that of rank 0's."""
        return sorted({re.sub(r"\.journal\.\d+$", ".journal", entry.name) for entry in self.path.iterdir()})

    def journals(self):
        """The journals of all ranks, that of rank 0 first."""
        others = [path for path in self.journal.parent.glob(self.journal.name + ".*") if path.suffix[1:].isdigit()]
        return [path for path in [self.journal, *sorted(others, key=lambda path: int(path.suffix[1:]))] if path.exists()]

    def journalled(self):
        """run_time by row, from the journals. A journal's header of 72 bytes has the size of a record at byte 12, and at
        byte 48 the size of the sweep's description, which follows the header. A record starts with the row's index and
        ends with run_time, predicted_time, rank, attempt and checksum. The last attempt counts."""
        rows = {}
        for journal in self.journals():
            try:
                data = journal.read_bytes()
            except FileNotFoundError:
                continue
            size = struct.unpack_from("<I", data, 12)[0]
            for start in range(first_record(data), len(data) - size + 1, size):
                row, = struct.unpack_from("<Q", data, start)
                attempt, = struct.unpack_from("<i", data, start + size - 12)
                if row not in rows or attempt >= rows[row][0]:
                    rows[row] = attempt, struct.unpack_from("<d", data, start + size - 32)[0]
        return {row: run_time for row, (_, run_time) in rows.items()}

    def in_flight(self):
        """The run's number, and rank by row that is being computed, from table.h5.running: pages, the first for the run,
        the others for a rank each, which begins with its row + 1, or that of a batch; the batch stands at 152."""
        try:
            data = (self.path / "table.h5.running").read_bytes()
        except FileNotFoundError:
            return None, {}
        run, ranks, page = struct.unpack_from("<3Q", data, 24)
        rows = {}
        for rank in range(ranks):
            row_plus_1, = struct.unpack_from("<Q", data, page * (1 + rank))
            batch, *others = struct.unpack_from("<257Q", data, page * (1 + rank) + 152)
            if row_plus_1:
                rows |= dict.fromkeys(others[:batch] if batch else [row_plus_1 - 1], rank)
        return run, rows

    def finish_keeping_rows(self):
        """Runs again to the end. Rows of the journal must not be computed again; returns them."""
        kept = self.journalled()
        again = self.run(2)
        assert again.code == 0, again
        run_time = self.timings()["run_time"]
        assert {row: run_time[row] for row in kept} == kept, "finished rows were computed again"
        return kept

    def wait_for_rows(self, process, rows=1):
        """Waits until the journal has this number of rows, or the run is over."""
        end = time.monotonic() + LIMIT
        while process.poll() is None and len(self.journalled()) < rows:
            if time.monotonic() > end:
                process.kill()
                raise AssertionError("no row came")
            time.sleep(0.01)


class Ended:
    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def __str__(self):
        return f"exit {self.code}\n{self.out}\n{self.err}"


def end_of(process):
    try:
        out, err = process.communicate(timeout=LIMIT)
    except subprocess.TimeoutExpired:
        for rank in ranks_of(process):
            os.kill(rank, 9)
        process.kill()
        out, err = process.communicate()
        raise AssertionError(f"it hangs:\n{out}\n{err}") from None
    return Ended(process.returncode, out, err)


def ranks_of(process):
    """The processes that mpirun started."""
    try:
        text = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
    except OSError:
        return []
    return [int(pid) for pid in text.split()]


def wait_until_gone(processes):
    """Waits for the end of ranks after another rank, or mpirun, was killed."""
    def runs(pid):
        try:
            return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
        except OSError:
            return False

    end = time.monotonic() + LIMIT
    while any(runs(pid) for pid in processes):
        if time.monotonic() > end:
            raise AssertionError("a rank outlives the others, or its mpirun")
        time.sleep(0.02)


def wait_until_caught(process, ranks, number):
    """Waits until the process (ranks = 0), or each of its ranks, handles the signal. A child of mpirun that is not yet the
    program has mpirun's handlers."""
    end = time.monotonic() + LIMIT
    while process.poll() is None and time.monotonic() < end:
        pids = ranks_of(process) if ranks else [process.pid]
        if len(pids) == max(ranks, 1) and all(catches(pid, number) for pid in pids):
            return
        time.sleep(0.001)
    raise AssertionError(f"nobody handles signal {number}: {end_of(process)}")


def catches(pid, number):
    try:
        if os.readlink(f"/proc/{pid}/exe") != os.path.realpath(PROGRAM):
            return False
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return False
    caught = next(int(line.split()[1], 16) for line in status.splitlines() if line.startswith("SigCgt"))
    return bool(caught >> (number - 1) & 1)


def wait_until_unlocked(sweep):
    """Waits for the end of ranks whose mpirun was killed."""
    end = time.monotonic() + 20
    while time.monotonic() < end:
        with open("/proc/locks") as locks:
            inodes = {line.split()[5].split(":")[-1] for line in locks if len(line.split()) > 5}
        try:
            if str(os.stat(f"{sweep.table}.lock").st_ino) not in inodes:
                return
        except FileNotFoundError:
            return
        time.sleep(0.05)
    raise AssertionError("a rank outlived its mpirun")


def at_once(call, *arguments):
    """Calls a function that waits most of its time with each of the arguments, all at the same time. Its results, in
    order; the first error where it fails."""
    with concurrent.futures.ThreadPoolExecutor(len(arguments)) as pool:
        return list(pool.map(call, arguments))


def stopped_sweep():
    """A sweep that was stopped with a few rows in its journal."""
    sweep = Sweep()
    process = sweep.start(2)
    sweep.wait_for_rows(process, 5)
    process.send_signal(signal.SIGUSR1)
    ended = end_of(process)
    if ended.code != 75:
        raise AssertionError(f"a run that was told to stop: {ended}")
    return sweep
