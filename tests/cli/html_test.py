"""plot -o x.html, x.gp and x.csv: the page is alone and holds the rows, its commands repeat them, and where Chromium is
installed it is used with real clicks and keys."""

import csv
import html
import importlib.util
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import unittest

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM, Sweep  # noqa: E402

SPEC = """
title = "Soft & hard <beads>"
[defaults]
N       = [3, 5]
v0      = 0.3
sigma   = [0.01, 0.1, 0.5, 1, 3, 10]
[[sweep]]
tc      = 1e-5
epsilon = 0.9
method  = ["md", "ed"]
[[sweep]]
K_over_m = 1e14
D_n     = 1e5
law     = "hertz"
wall    = "matched"
"""
HAS_BROWSER = (shutil.which("chromium") and shutil.which("chromedriver") and importlib.util.find_spec("selenium"))


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Sweep(SPEC)
        assert cls.sweep.run(0).code == 0
        for ending in ("html", "gp", "csv"):
            cls.plot(f"table.{ending}")
        cls.page = (cls.sweep.path / "table.html").read_text()
        cls.data = json.loads(re.search(r"^const data = (.*);$", cls.page, re.M)[1])
        with h5py.File(cls.sweep.path / "table.h5") as table:
            cls.eps_eff = table["results"]["eps_eff"][:]

    @classmethod
    def plot(cls, *arguments):
        ended = subprocess.run([PROGRAM, "plot", "table.h5", "-o", *arguments], cwd=cls.sweep.path, capture_output=True,
                               text=True, timeout=60)
        assert (ended.returncode, ended.stderr) == (0, ""), ended

    def test_it_needs_nothing_else(self):
        self.assertNotRegex(self.page.replace("http://www.w3.org/2000/svg", ""), r"https?:|src=|@import|url\((?!#inside)")
        self.assertIn("<title>Soft &amp; hard &lt;beads&gt;</title>", self.page)
        self.assertLess(len(self.page), 100_000)

    def test_commands_repeat_the_rows_to_the_bit(self):
        self.assertEqual(sorted(row["index"] for row in self.data["rows"]), list(range(len(self.eps_eff))))
        for row in self.data["rows"][::3]:
            command = shlex.split(row["command"])
            self.assertEqual(command[0], "sigmasweep")
            ended = subprocess.run([PROGRAM, *command[1:], "--json"], capture_output=True, text=True, timeout=60)
            self.assertEqual(ended.returncode, 0, (row, ended))
            self.assertEqual(json.loads(ended.stdout)["eps_eff"], self.eps_eff[row["index"]], row)

    def test_csv(self):
        points = list(csv.DictReader((self.sweep.path / "table.csv").open()))
        self.assertEqual(len(points), len(self.eps_eff))
        for point in points:
            self.assertEqual(float(point["eps_eff"]), self.eps_eff[int(point["row"])])

    def test_gnuplot_draws_the_commands(self):
        drawn = subprocess.run(["gnuplot", "table.gp"], cwd=self.sweep.path, capture_output=True, text=True, timeout=60)
        self.assertEqual(drawn.returncode, 0, drawn)
        self.assertIn("</svg>", drawn.stdout)

    def test_plots_of_an_edited_spec(self):
        (self.sweep.path / "edited.toml").write_text(SPEC + '[[plot]]\nx = "N"\ny = "1 - eps_eff"\nx_label = "beads"\n')
        self.plot("edited.csv", "--spec", "edited.toml")
        points = list(csv.DictReader((self.sweep.path / "edited.csv").open()))
        self.assertEqual({float(point["N"]) for point in points}, {3.0, 5.0})
        self.plot("edited.svg", "--spec", "edited.toml")
        self.assertIn("beads", (self.sweep.path / "edited.svg").read_text())

    def test_report(self):
        ended = subprocess.run([PROGRAM, "report", "table.h5"], cwd=self.sweep.path, capture_output=True, text=True,
                               timeout=60)
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (0, "table-report.html\n", ""), ended)
        page = (self.sweep.path / "table-report.html").read_text()
        self.assertNotRegex(page.replace("http://www.w3.org", ""), r"https?:|<script|@import")
        self.assertIn("<title>Soft &amp; hard &lt;beads&gt;</title>", page)
        self.assertEqual(page.count("<img alt="), 1)
        self.assertIn(f"<th>ok</th><td>{len(self.eps_eff)}</td>", page)
        for line in SPEC.splitlines():
            self.assertIn(html.escape(line), page)

    def test_report_tells_rows_without_a_result(self):
        failing = Sweep("[sweep]\nmethod = 'ed'\nN = [3, 30]\nepsilon = 0.1\nv0 = 1\ntc = 1e-5\nsigma = 1\n"
                        "[trajectory]\nsamples = 11\n[plot]\nkind = 'trajectories'\n")
        failing.run(0)
        shutil.rmtree(failing.path / "table.trajectories", ignore_errors=True)
        ended = subprocess.run([PROGRAM, "report", "table.h5", "-o", "x.html"], cwd=failing.path, capture_output=True,
                               text=True, timeout=60)
        self.assertEqual(ended.returncode, 0, ended)
        page = (failing.path / "x.html").read_text()
        self.assertIn("could not be drawn", page)
        self.assertIn("collapsed", page)

    @unittest.skipUnless(HAS_BROWSER, "chromium, chromium-driver or python3-selenium is not installed")
    def test_in_a_browser(self):
        from selenium import webdriver
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.by import By
        from selenium.webdriver.common.keys import Keys
        options = webdriver.ChromeOptions()
        for option in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1300,900"):
            options.add_argument(option)
        browser = webdriver.Chrome(options=options, service=webdriver.chrome.service.Service(shutil.which("chromedriver")))
        self.addCleanup(browser.quit)
        browser.get((self.sweep.path / "table.html").as_uri())
        self.assertEqual(browser.get_log("browser"), [])
        plot, panel = browser.find_element(By.ID, "plot"), browser.find_element(By.ID, "panel")

        def click(x, y):
            ActionChains(browser).move_by_offset(0, 0).perform()
            middle = [plot.rect["x"] + plot.rect["width"] / 2, plot.rect["y"] + plot.rect["height"] / 2]
            ActionChains(browser).move_to_element_with_offset(plot, x - middle[0], y - middle[1]).click().perform()

        where = ("const m = plot.getScreenCTM(); return drawn.map(e => "
                 "[e.at[0]*m.a + m.e, e.at[1]*m.d + m.f, data.rows[e.point[3]].index, e.point[1]])")
        points = browser.execute_script(where)
        self.assertEqual(len(points), len(self.eps_eff))
        x, y, row, value = points[2]
        click(x, y)
        self.assertRegex(panel.text, rf"Row \d+")
        self.assertIn("sigmasweep one", panel.text)
        self.assertIn("eps_eff_error", panel.text)
        # Keys: to another point, and a closer look, which leaves points outside.
        before = panel.text
        plot.send_keys(Keys.ARROW_RIGHT)
        self.assertNotEqual(panel.text, before)
        for _ in range(4):
            plot.send_keys("+")
        self.assertLess(len(browser.execute_script(where)), len(points))
        plot.send_keys("0")
        self.assertEqual(len(browser.execute_script(where)), len(points))
        # The key hides a curve.
        browser.find_elements(By.CSS_SELECTOR, "#key button")[0].click()
        self.assertLess(len(browser.execute_script(where)), len(points))


if __name__ == "__main__":
    unittest.main()
