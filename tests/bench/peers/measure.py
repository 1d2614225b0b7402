"""Measures every method alternately, in rounds, on one core, and keeps the least time of each.

    measure.py PROGRAM [options]        what tests/bench/peers/run calls; --help lists the options

Leaves peers.json, peers.md and peers.svg.
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import lammps
import liggghts
import report
import yade

ROOT = pathlib.Path(__file__).resolve().parents[3]
CODES = (lammps, liggghts, yade)
ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}


def pin():
    """This process and those that it starts run on one core: the last one it may use."""
    core = max(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {core})
    return core


def library_methods(program, tuples, rounds, methods):
    """The tuples and the cells that the program `peers` measures in its own process."""
    arguments = [program, "--tuples", str(tuples), "--rounds", str(rounds), "--methods", methods]
    return json.loads(subprocess.run(arguments, check=True, stdout=subprocess.PIPE).stdout)


def run(code, script):
    """Output, CPU and wall time of a process of the code."""
    with tempfile.TemporaryDirectory() as folder, open(pathlib.Path(folder) / "output", "w+", encoding="utf-8") as output:
        path = pathlib.Path(folder) / "input.py"
        path.write_text(script, encoding="utf-8")
        start = time.perf_counter()
        process = subprocess.Popen(code.command(str(path)), stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT, cwd=folder, env=ENVIRONMENT)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        raise RuntimeError(f"{code.NAME} ended with {process.returncode}:\n{text[-2000:]}")
    return text, usage.ru_utime + usage.ru_stime, wall


def cells_of(code, groups):
    """A cell for each step and group; `loops`: the seconds that the code's own loop took, tuple by tuple."""
    cells = []
    for steps in code.STEPS:
        tuples = [t for group in groups.values() for t in group]
        found = dict(zip(map(id, tuples), code.results(run(code, code.script(tuples, steps))[0]), strict=True))
        for sigma, group in groups.items():
            errors = [abs(found[id(t)][0] - t["eps_eff"]) for t in group]
            cells.append({"method": code.NAME, "setting": f"tc/{steps}", "sigma": sigma, "failed": 0,
                          "error_max": max(errors), "error_median": statistics.median_high(errors),
                          "loops": [found[id(t)][1] for t in group]})
    return cells


def process_of(code, groups):
    """What it costs to compute one tuple in a process of its own: the set's mean at tc/50."""
    costs = [run(code, code.script([group[0]], 50))[1:] for group in groups.values()]
    return {"method": code.NAME, "cpu": statistics.fmean(c for c, _ in costs),
            "wall": statistics.fmean(w for _, w in costs)}


def keep_least(kept, new):
    """Adds the measurements of a round to those before. A cell's time is the least, or the mean of its loops' least ones."""
    for cell in new:
        key = tuple(cell.get(name) for name in ("method", "setting", "sigma", "order"))
        before = kept.get(key, cell)
        for name in ("seconds", "cpu", "wall"):
            if name in before and "loops" not in cell:
                cell[name] = min(cell[name], before[name])
        if "loops" in cell:
            cell["loops"] = list(map(min, cell["loops"], before["loops"]))
            cell["seconds"] = statistics.fmean(cell["loops"])
        kept[key] = cell


def first_line(command):
    return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False).stdout.split("\n")[0].strip()


def processor():
    names = re.findall(r"^model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return names[0] if names else platform.machine()


def measure(options):
    core = pin()
    cells, processes = {}, {}
    codes = [code for code in CODES if shutil.which(code.PROGRAM) and re.search(options.methods, code.NAME)]
    for number in range(options.rounds):
        print(f"round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
        own = library_methods(options.program, options.tuples, 1, options.methods)
        keep_least(cells, own["cells"])
        groups = {}
        for each in own["tuples"]:
            group = groups.setdefault(each["sigma"], [])
            if len(group) < options.tuples_of_codes:
                group.append(each)
        for code in codes:
            keep_least(cells, cells_of(code, groups))
            keep_least(processes, [process_of(code, groups)])
    if not cells:
        raise SystemExit(f"no method's name matches '{options.methods}'")
    return {"date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d"),
            "revision": first_line(["git", "describe", "--always", "--dirty"]), "processor": processor(), "core": core,
            "compiler": first_line(["c++", "--version"]), "load": os.getloadavg()[0], "rounds": options.rounds,
            "tuples": options.tuples, "tuples_of_codes": options.tuples_of_codes, "cells": list(cells.values()),
            "processes": list(processes.values())}


def arguments():
    parser = argparse.ArgumentParser(description="Measures every method on the reference set.")
    parser.add_argument("program", help="the program `peers`")
    parser.add_argument("--quick", action="store_true", help="a minute: fewer tuples and rounds")
    parser.add_argument("--tuples", type=int, help="tuples for each sigma (32)")
    parser.add_argument("--rounds", type=int, help="how often all is measured (10)")
    parser.add_argument("--methods", default=".", help="regular expression of the methods' names")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."), metavar="DIRECTORY",
                        help="where peers.json, peers.md and peers.svg go")
    parser.add_argument("--readme", nargs="?", type=pathlib.Path, const=ROOT, metavar="DIRECTORY",
                        help="also replaces the table in README.md and docs/peers.svg (of this checkout, or below DIRECTORY)")
    options = parser.parse_args()
    try:
        re.compile(options.methods)
    except re.error as error:
        parser.error(f"--methods {options.methods}: {error}")
    options.tuples = options.tuples or (8 if options.quick else 32)
    options.rounds = options.rounds or (2 if options.quick else 10)
    options.tuples_of_codes = min(options.tuples, 1 if options.quick else 4)
    return options


def main():
    options = arguments()
    options.output.mkdir(parents=True, exist_ok=True)
    if options.readme:
        report.check_readme(options.readme)
    found = measure(options)
    (options.output / "peers.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    table = report.full_table(found)
    (options.output / "peers.md").write_text(table, encoding="utf-8")
    report.draw(found, options.output / "peers.svg")
    print(table)
    if options.readme:
        report.put_into_readme(found, options.readme)


if __name__ == "__main__":
    main()
