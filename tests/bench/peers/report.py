"""The measurements as tables in Markdown and as a picture; the part of README.md that is made of them."""

import math
import pathlib
import statistics
import subprocess
import textwrap

# What README shows of each method, in this order; the full table has all.
SHOWN = (("exact, side by side", "1e-12"), ("exact", "1e-12"), ("odeint dopri5, events", "1e-08"),
         ("odeint dopri5, events", "1e-12"), ("odeint dopri5", "1e-12"), ("odeint rkf78", "1e-08"),
         ("CVODE Adams, events", "1e-12"), ("rk4", "tc/100"), ("rk4", "tc/2000"), ("gear5", "tc/100"),
         ("gear5", "tc/2000"), ("verlet", "tc/100"), ("leapfrog", "tc/100"), ("LAMMPS gran/hooke", "tc/50"),
         ("LAMMPS gran/hooke", "tc/500"), ("LIGGGHTS hooke/stiffness", "tc/50"), ("Yade ViscEl", "tc/50"))
UNIT = ("exact, side by side", "1e-12", "like")
BEGIN, END = "<!-- peers: begin -->", "<!-- peers: end -->"
LEAST_ERROR = 2.0**-54  # half the last digit of a double between 1/2 and 1: smaller errors are drawn here

# Okabe and Ito's colours and gnuplot's point types, as in the program's own plots.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7F6000")
SYMBOLS = (6, 4, 8, 12, 10, 2, 14, 1)


def power(x):
    """4e-8 as 4 · 10⁻⁸."""
    if x is None:
        return "none"
    if x == 0.0:
        return "0"
    mantissa, exponent = f"{x:.0e}".split("e")
    digits = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return digits if mantissa == "1" else f"{mantissa} · {digits}"


def three_digits(x):
    """12345.6 as 12,300; 1234.5 as 1230; 1.2345 as 1.23."""
    if x <= 0.0:
        return "0"
    digits = 2 - math.floor(math.log10(x))
    return f"{round(x, digits):{',' if x >= 1e4 else ''}.{max(0, digits)}f}"


def setting(text):
    """1e-04 as 10⁻⁴, tc/50 as t_c/50."""
    return text.replace("tc/", "t_c/") if text.startswith("tc/") else power(float(text))


def lines_of(found):
    """One line for each method and setting, and order of the tuples: the seven sigmas, and what their cells have in common."""
    lines = {}
    for cell in found["cells"]:
        lines.setdefault((cell["method"], cell["setting"]), []).append(cell)
    out = []
    for (method, its_setting), cells in lines.items():
        by_sigma = sorted((c for c in cells if c.get("sigma") is not None), key=lambda c: c["sigma"])
        side_by_side = len(cells) > len(by_sigma)
        out.append({"method": method, "setting": its_setting, "order": "sigma" if side_by_side else None, "cells": by_sigma,
                    "seconds": statistics.fmean(c["seconds"] for c in by_sigma)})
        for cell in cells:
            if cell.get("order"):
                out.append({**out[-1], "order": cell["order"], "seconds": cell["seconds"]})
    for line in out:
        line["failed"] = sum(c["failed"] for c in line["cells"])
        errors = [(c["error_max"], c["error_median"]) for c in line["cells"] if c["error_max"] is not None]
        line["error_max"] = max((largest for largest, _ in errors), default=None)
        line["error_median"] = statistics.median(median for _, median in errors) if errors else None
    return out


def unit_of(lines):
    """The time that all others are compared with; None if it was not measured."""
    return next((l["seconds"] for l in lines if (l["method"], l["setting"], l["order"]) == UNIT), None)


def name_of(line):
    names = {None: "", "sigma": ", a call for each σ", "like": ", like tuples beside each other",
             "interleaved": ", interleaved"}
    return line["method"] + names[line["order"]]


def columns_of(line, unit):
    largest = power(line["error_max"]) + (f" ({line['failed']} without a result)" if line["failed"] else "")
    ratio = "" if unit is None else three_digits(line["seconds"] / unit)
    return [name_of(line), setting(line["setting"]), power(line["error_median"]), largest,
            three_digits(1e6 * line["seconds"]), ratio]


HEAD = ["method", "setting", "median error", "largest error", "µs a tuple", "times as long"]


def markdown(rows):
    return "".join("| " + " | ".join(row) + " |\n" for row in [rows[0], ["---"] * len(rows[0]), *rows[1:]])


def conditions(found):
    return (f"{found['processor']}, one core, {found['date']}, revision {found['revision']}, {found['compiler']}; "
            f"{found['tuples']} tuples for each sigma ({found['tuples_of_codes']} for other programs), the least time of "
            f"{found['rounds']} rounds.")


def processes(found):
    """What a process of each other program costs, a sentence."""
    each = [f"{p['method'].split()[0]} {three_digits(1e3 * p['cpu'])} ms of CPU time and {three_digits(1e3 * p['wall'])} ms in all"
            for p in found["processes"]]
    return f"The times of other programs are of their loops alone. A process for one tuple takes: {'; '.join(each)}.\n" if each else ""


def full_table(found):
    lines = lines_of(found)
    unit = unit_of(lines)
    sigmas = sorted({c["sigma"] for line in lines for c in line["cells"]})
    rows = [HEAD + [f"σ = {sigma:g}" for sigma in sigmas]]
    for line in lines:
        by_sigma = {c["sigma"]: c for c in line["cells"]} if line["order"] in (None, "sigma") else {}
        rows.append(columns_of(line, unit) + [
            f"{power(by_sigma[s]['error_max'])}, {three_digits(1e6 * by_sigma[s]['seconds'])}" if s in by_sigma else ""
            for s in sigmas])
    return (f"{conditions(found)} The columns of each σ have the largest error and µs a tuple.\n\n{markdown(rows)}\n"
            f"{processes(found)}")


def short_table(found):
    """The lines that README shows."""
    lines = lines_of(found)
    unit = unit_of(lines)
    rows = [HEAD]
    for shown in SHOWN:
        of_method = [l for l in lines if (l["method"], l["setting"]) == shown]
        rows += [columns_of(l, unit) for l in of_method if l["order"] != "sigma"]
    below = textwrap.fill(f"{conditions(found)} {processes(found)}", 120)
    return f"{markdown(rows)}\n{below}\n"


def colour_of(number):
    return COLOURS[number % len(COLOURS)]


def style_of(number):
    """The look of a method: when the colours begin again, lines are dashed."""
    dashes = "1" if number < len(COLOURS) else "(6,4)"
    return (f"pointtype {SYMBOLS[number % len(SYMBOLS)]} pointsize 0.7 linewidth 1.3 dashtype {dashes} "
            f"linecolor '{colour_of(number)}'")


def blocks_of(line, panel, number):
    """A method's points in a panel, as gnuplot's data and plot elements."""
    name = f"$p{panel}_{number}"
    style = style_of(number)
    points = "".join(f"{max(c['error_median'], LEAST_ERROR):.6g} {max(c['error_max'], LEAST_ERROR):.6g} {c['seconds']:.6g}\n"
                     for c in line if c["error_max"] is not None) or "NaN NaN NaN\n"
    return (f"{name} << end_of_data\n{points}end_of_data\n",
            f"{name} using 1:3:1:2 with xerrorbars pointtype 0 linewidth 0.8 linecolor '{colour_of(number)}' notitle, "
            f"{name} using 1:3 with linespoints {style} notitle")


def key_panel(methods):
    elements = [f"NaN with linespoints {style_of(number)} title '{method}'" for number, method in enumerate(methods)]
    return ("unset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid\nset title ' '\n"
            "set key left top reverse Left samplen 2\nplot " + ", ".join(elements) + "\n")


def gnuplot_script(found):
    """A panel for each sigma, and one for the key."""
    cells = [c for c in found["cells"] if c.get("sigma") is not None]
    methods = list(dict.fromkeys(c["method"] for c in cells))
    times = [c["seconds"] for c in cells]
    errors = [c["error_max"] for c in cells if c["error_max"] is not None]
    low, high = 10.0**math.floor(math.log10(min(times))), 10.0**math.ceil(math.log10(max(times)))
    script = ("set encoding utf8\nset terminal svg size 1460,690 enhanced background '#ffffff' font 'DejaVu Sans,12'\n"
              "set multiplot layout 2,4 rowsfirst title 'Error against time: N = 10, ε = 0.9' noenhanced\n"
              "set border 3 linecolor '#404040'\nset tics nomirror out\nset nokey\n"
              "set grid linetype 1 linecolor '#E4E4E4' linewidth 0.6\nset logscale xy\nset format x '10^{%L}'\n"
              f"set format y '10^{{%L}}'\nset xrange [1e-17:{max(1e-2, 10.0 * max(errors)):g}]\nset yrange [{low:g}:{high:g}]\n"
              "set xtics 1e3\nset xlabel 'error of ε_{eff}: median, to largest'\nset ylabel 'time a tuple (s)'\n")
    for panel, sigma in enumerate(sorted({c["sigma"] for c in cells})):
        blocks = [blocks_of([c for c in cells if c["method"] == method and c["sigma"] == sigma], panel, number)
                  for number, method in enumerate(methods)]
        script += "".join(data for data, _ in blocks) + f"set title 'σ = {sigma:g}'\nplot " + ", ".join(p for _, p in blocks) + "\n"
    return script + key_panel(methods) + "unset multiplot\n"


def draw(found, path):
    picture = subprocess.run(["gnuplot"], input=gnuplot_script(found), stdout=subprocess.PIPE, text=True, check=True)
    pathlib.Path(path).write_text(picture.stdout, encoding="utf-8")


def check_readme(root):
    """The text before the table and after it. SystemExit if README.md has no place for it."""
    text = (root / "README.md").read_text(encoding="utf-8")
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise SystemExit(f"{root / 'README.md'}: needs one line {BEGIN} and after it one line {END}")
    return text[:text.index(BEGIN)], text[text.index(END) + len(END):]


def put_into_readme(found, root):
    """Replaces what stands between the marks of README.md, and docs/peers.svg."""
    before, after = check_readme(root)
    table = f"{BEGIN}\n![Error against time of this program and its peers](docs/peers.svg)\n\n{short_table(found)}{END}"
    draw(found, root / "docs" / "peers.svg")
    (root / "README.md").write_text(before + table + after, encoding="utf-8")
