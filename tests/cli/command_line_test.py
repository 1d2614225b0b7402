"""What is typed and what comes back: exit codes, messages, JSON. No table is needed here."""

import json
import math
import os
import pathlib
import resource
import shlex
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["SIGMASWEEP"]
MPIEXEC = shlex.split(os.environ["MPIEXEC"])
COLUMN = "--v0 1 --tc 2e-5 --N 10 --epsilon 0.9".split()
SPEC = """
title = "Two by three"
[sweep]
method = ["md", "ed"]
N = 3
epsilon = 0.9
v0 = 1.0
tc = 1e-5
sigma = [0.1, 1, 10]
"""

AXIS = "{ from = 0.1, to = 1, count = 1048576 }"


def sigmasweep(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, **options)


class Files(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="sigma sweep ")
        self.addCleanup(directory.cleanup)
        self.path = pathlib.Path(directory.name)

    def write(self, text):
        (self.path / "spec.toml").write_text(text)
        return self.path / "spec.toml"


class WrongCommands(Files):
    def check(self, code, words, *arguments):
        ended = sigmasweep(*arguments)
        self.assertEqual(ended.returncode, code, ended)
        self.assertEqual(ended.stdout, "", ended)
        self.assertEqual(ended.stderr.count("\n"), 1, ended)
        self.assertTrue(ended.stderr.startswith("sigmasweep: "), ended)
        for word in words:
            self.assertIn(word, ended.stderr)

    def test_slips_of_a_new_user(self):
        self.check(64, ["a command is needed", "sigmasweep --help"])
        self.check(64, ["'plto'", "'plot'", "sigmasweep --help"], "plto", "fig2a.h5")
        self.check(64, ["--rank", "--ranks", "sigmasweep plan --help"], "plan", "--rank", 4, self.write(SPEC))
        self.check(64, ["'extra'"], "plan", self.write(SPEC), "extra")
        self.check(64, ["spec"], "run")
        self.check(64, ["--N", "whole number"], "one", *COLUMN[:4], "--N", "ten", "--epsilon", 0.9, "--s0", 0)
        self.check(64, ["--v0", "'1 m/s'"], "one", "--v0", "1 m/s")
        self.check(64, ["--method", "md", "ed"], "one", *COLUMN, "--s0", 0, "--method", "soft")

    def test_tuples_that_are_none(self):
        self.check(64, ["epsilon", "2"], "one", "--v0", 1, "--tc", 1, "--N", 2, "--epsilon", 2, "--s0", 0)
        self.check(64, ["v0", "-1"], "one", "--v0", -1, "--tc", 1, "--N", 2, "--epsilon", 1, "--s0", 0)
        self.check(64, ["'tc', 'epsilon', 'N' are missing"], "one", "--v0", 1)
        self.check(64, ["s0", "sigma"], "one", *COLUMN, "--s0", 0, "--sigma", 0)
        self.check(64, ["'tc'", "'material'", "conflict"], "one", *COLUMN, "--s0", 0, "--material", "steel")
        self.check(64, ["seed", "random"], "one", *COLUMN, "--s0", 0, "--seed", 3)
        self.check(64, ["steps_per_tc"], "one", *COLUMN, "--s0", 0, "--steps-per-tc", 50)
        self.check(64, ["steps_per_tc", "tolerance", "conflict"], "one", *COLUMN, "--s0", 0, "--integrator", "rk4",
                   "--steps-per-tc", 50, "--tolerance", 1e-4)
        self.check(64, ["tc"], "one", "--v0", 1, "--tc", "inf", "--N", 2, "--epsilon", 1, "--s0", 0)

    def test_files(self):
        for command in ("run", "plan"):
            self.check(66, ["no.toml"], command, self.path / "no.toml")
        for command in ("plot", "show", "export"):
            self.check(66, ["no.h5"], command, self.path / "no.h5")
        self.check(65, ["spec.toml:6", "epsilom", "epsilon"], "plan", self.write(SPEC.replace("epsilon", "epsilom")))
        self.check(65, ["spec.toml"], "run", self.write("[sweep"), "-o", self.path / "t.h5")
        self.assertEqual([p.name for p in self.path.iterdir()], ["spec.toml"])
        self.check(73, ["missing/t.h5"], "run", self.write(SPEC), "-o", self.path / "missing" / "t.h5")

    def test_a_sweep_too_large_for_memory_or_for_a_run(self):
        for count, words in ((30, "2013265920 rows take"), (32, "2147483648 rows are more than one run may have")):
            axes = f"{{ from = 0.1, to = 10, count = {1 << 25} }}\ns0 = 1e-6\nd = {{ from = 1e-3, to = 2e-3, count = {count} }}"
            spec = SPEC.replace("v0 = 1.0\n", "").replace("sigma = [0.1, 1, 10]", "v0 = " + axes)
            self.check(65, [words, "split"], "run", self.write(spec), "-o", self.path / "t.h5")
        self.assertEqual([f.name for f in self.path.iterdir() if f.name.endswith(".journal")], [])


class Answers(Files):
    def test_help_and_version(self):
        for arguments in ([], ["run"], ["plan"], ["one"], ["plot"], ["show"], ["export"]):
            ended = sigmasweep(*arguments, "--help")
            self.assertEqual((ended.returncode, ended.stderr), (0, ""))
            self.assertIn("Usage: sigmasweep", ended.stdout)
        ended = sigmasweep("--version")
        self.assertEqual(ended.returncode, 0)
        for word in ("sigmasweep ", "revision", "compiler", "MPI", "HDF5"):
            self.assertIn(word, ended.stdout)

    def one(self, *arguments):
        ended = sigmasweep("one", *COLUMN, *arguments, "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        return json.loads(ended.stdout)

    def test_one(self):
        # From an independent integration at high precision, to the digits given; the solver asks for 1e-10.
        for sigma, expected in ((0, 0.966686739758), (0.1, 0.931129144499), (1, 0.424689077436), (10, 0.341547467017)):
            result = self.one("--sigma", sigma)
            self.assertLess(abs(result["eps_eff"] - expected), 1e-10)
            self.assertEqual((result["status"], result["method"], result["N"]), ("ok", "md", 10))
            self.assertTrue(0 <= result["eps_eff_error"] < 1e-10)
        self.assertEqual(self.one("--s0", "1e-6", "--method", "ed")["contacts"], 100)
        self.assertEqual(self.one("--s0", "1e-6", "--wall", "matched")["wall"], "matched")

    def test_one_with_a_step_chosen_by_the_tolerance(self):
        for integrator in ("gear5", "verlet", "rk4", "leapfrog"):
            result = self.one("--sigma", 0.1, "--integrator", integrator, "--tolerance", "1e-4")
            self.assertLess(abs(result["eps_eff"] - 0.931129144499), 1e-4)  # of an independent integration
            self.assertTrue(0 < result["eps_eff_error"] <= 1e-4)

    def test_plan_says_what_is_unstable(self):
        spec = self.write(SPEC.replace('method = ["md", "ed"]', 'integrator = "gear5"\nsteps_per_tc = 50').replace(
            "epsilon = 0.9", "epsilon = [0.02, 0.05, 0.5]").replace("N = 3", "N = 10"))
        ended = sigmasweep("plan", spec, "--json")
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (0, 1))
        for words in ("6 of 9 tuples", "unstable", "gear5 at tc/50", "from 0.02 to 0.05"):
            self.assertIn(words, ended.stderr)
        self.assertEqual(json.loads(ended.stdout)["tuples"], 9)

    def test_one_of_a_material(self):
        for material, law in (("steel", "hooke"), ("steel", "hertz"), ("aluminium", "hertz-kuwabara-kono")):
            arguments = f"one --material {material} --law {law} --v0 1 --s0 0 --N 1".split()
            result = json.loads(sigmasweep(*arguments, "--json").stdout)
            self.assertLess(abs(result["tc"] - 4.6e-6), 0.11e-6)  # the paper's, in Sec. III: about 4.6e-6 s
            self.assertLess(abs(result["epsilon"] - {"steel": 0.9, "aluminium": 0.6}[material]), 1e-12)
            self.assertEqual((result["status"], result["material"], result["law"]), ("ok", material, law))
            for word in ("tc ", "epsilon ", "K_over_m ", "D_n "):
                self.assertIn(word, sigmasweep(*arguments).stdout)
        arguments = "one --v0 0.05 --s0 1e-6 --N 3 --law hertz --K-over-m 2e12 --D-n 1e3 --random-separation true"
        result = json.loads(sigmasweep(*arguments.split(), "--seed", 7, "--json").stdout)
        self.assertLess(abs(result["epsilon"] - 0.924199892990), 1e-10)  # of an independent integration
        self.assertEqual((result["random_separation"], result["seed"]), (True, 7))

    def test_numbers_are_kept_to_the_bit(self):
        v0 = math.pi * 1e-3
        result = self.one("--s0", "1e-7")
        again = sigmasweep("one", "--v0", repr(v0), *COLUMN[2:], "--s0", repr(1 / 3e7), "--json")
        self.assertEqual(json.loads(again.stdout)["v0"], v0)
        self.assertEqual(json.loads(again.stdout)["s0"], 1 / 3e7)
        self.assertEqual(result, self.one("--s0", "1e-7"))

    def test_one_for_people(self):
        ended = sigmasweep("one", *COLUMN, "--s0", "1e-6")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        for words in ("1 m/s", "0.95208601", "+-", "ok"):
            self.assertIn(words, ended.stdout)

    def test_plan(self):
        ended = sigmasweep("plan", self.write(SPEC), "--ranks", 3, "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        plan = json.loads(ended.stdout)
        self.assertEqual((plan["tuples"], plan["ranks"], plan["title"]), (6, 3, "Two by three"))
        self.assertEqual([(a["name"], a["size"]) for a in plan["axes"]], [("method", 2), ("sigma", 3)])
        self.assertGreaterEqual(plan["makespan_seconds"], plan["lower_bound_seconds"])
        self.assertGreaterEqual(plan["core_seconds"], plan["longest_seconds"])
        self.assertFalse(plan["estimated_from_sample"])
        self.assertIn("tuples         6", sigmasweep("plan", self.path / "spec.toml").stdout)
        self.assertEqual([p.name for p in self.path.iterdir()], ["spec.toml"])

    def test_plan_measures(self):
        spec = self.write(SPEC)
        self.assertIsNone(json.loads(sigmasweep("plan", spec, "--json").stdout)["measured"])
        ended = sigmasweep("plan", spec, "--measure", 4, "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        plan = json.loads(ended.stdout)
        measured = plan["measured"]
        self.assertEqual((measured["rows"], measured["given_up"]), (4, 0))
        self.assertLessEqual(measured["least"], measured["mean"])
        self.assertLessEqual(measured["mean"], measured["most"])
        self.assertGreaterEqual(plan["makespan_seconds"], plan["lower_bound_seconds"])
        self.assertRegex(sigmasweep("plan", spec, "--measure", 4).stdout, r"measured       4 rows need \S+ times the predicted")
        self.assertEqual([p.name for p in self.path.iterdir()], ["spec.toml"])

    def test_plan_says_what_run_refuses(self):
        """Not all rows of a large sweep fit in one run."""
        values = "{ from = 0.1, to = 0.9, count = 1000000 }"
        spec = self.write(f"[sweep]\nmethod = 'ed'\nN = 2\nv0 = 1.0\ntc = 1e-5\nsigma = {values}\nepsilon = {values}\n")
        planned, ran = sigmasweep("plan", spec, "--json"), sigmasweep("run", spec, cwd=self.path)
        refusal = json.loads(planned.stdout)["refused"]
        self.assertIn("1000000000000 rows are more than", refusal)
        self.assertIn(refusal, planned.stderr)
        self.assertEqual(ran.returncode, 65, ran)
        self.assertIn(refusal, ran.stderr)

    def test_plan_with_keys_that_are_set(self):
        spec = self.write(SPEC)
        ended = sigmasweep("plan", "--set", "N=[2, 5]", spec, "--set", "method=ed", "--set", "where=sigma > 0.5", "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        plan = json.loads(ended.stdout)
        self.assertEqual([(a["name"], a["size"]) for a in plan["axes"]], [("N", 2), ("sigma", 3)])
        self.assertEqual(plan["tuples"], 4)
        self.assertEqual(spec.read_text(), SPEC)

    def test_wrong_keys_and_values_that_are_set(self):
        spec = self.write(SPEC)
        for typed, code, words in (
                ("n=3", 65, "unknown key sweep.n (did you mean 'N'?)"),
                ("N=-1", 65, "sweep.N = -1 is not allowed"),
                ("s0=1e-6", 65, "give s0 or sigma, not both"),
                ("method=edd", 65, "did you mean 'ed'?"),
                ("N", 64, "--set N: give KEY=VALUE"),
                ("tc=2*10^-5", 64, "'2*10^-5' is not a value in TOML (write 2e-5)")):
            for command in ("plan", "run", "precision", "stability"):
                ended = sigmasweep(command, spec, "--set", typed, cwd=self.path)
                self.assertEqual((ended.returncode, ended.stdout), (code, ""), ended)
                self.assertEqual(ended.stderr.count("\n"), 1, ended)
                self.assertIn(words, ended.stderr)
                self.assertIn("--set " + typed, ended.stderr)
        self.assertEqual([p.name for p in self.path.iterdir()], ["spec.toml"])

    def test_plan_of_a_huge_sweep_is_a_sample(self):
        axis = "{ from = 0.1, to = 100, count = 1000 }"
        spec = SPEC.replace("[0.1, 1, 10]", axis)
        spec = spec.replace("v0 = 1.0", "v0 = " + axis).replace("tc = 1e-5", "tc = " + axis)
        plan = json.loads(sigmasweep("plan", self.write(spec), "--json").stdout)
        self.assertEqual((plan["tuples"], plan["estimated_from_sample"]), (2 * 10**9, True))
        self.assertGreater(plan["core_seconds"], 2 * 10**9 * 1e-8)

    def test_plan_of_as_many_tuples_as_there_may_be(self):
        """2^40 of them: little time and memory, and a tuple more is refused."""
        spec = SPEC.replace('method = ["md", "ed"]\n', "").replace("[0.1, 1, 10]", AXIS)
        spec = spec.replace("v0 = 1.0", f"v0 = {AXIS}")

        def small():
            resource.setrlimit(resource.RLIMIT_CPU, (1, 1))  # s; measured: 0.06
            resource.setrlimit(resource.RLIMIT_DATA, (2**28, 2**28))  # a byte each would be 4096 times that

        ended = sigmasweep("plan", self.write(spec), "--json", preexec_fn=small)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertEqual(json.loads(ended.stdout)["tuples"], 2**40)
        ended = sigmasweep("plan", self.write(spec.replace("1048576", "1048577", 1)), preexec_fn=small)
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count("\n")), (65, "", 1), ended)


class UnderALauncher(Files):
    def test_commands_for_one_process_work_in_each(self):
        """As tasks of srun, ranks of mpirun, workers of mpi4py."""
        for variables in ({"OMPI_COMM_WORLD_RANK": "1"}, {"SLURM_PROCID": "3"}, {"PMI_RANK": "2", "PMI_SIZE": "4"}):
            environment = dict(os.environ, **variables)
            ended = sigmasweep("one", *COLUMN, "--s0", 0, "--json", env=environment)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""))
            self.assertEqual(json.loads(ended.stdout)["N"], 10)
            for arguments in (["one", "--bogus"], ["plto"], ["show", "missing.h5"]):
                ended = sigmasweep(*arguments, env=environment)
                self.assertIn(ended.returncode, (64, 66))
                self.assertEqual((ended.stdout, ended.stderr.count("\n")), ("", 1), ended)
            self.assertIn("Examples", sigmasweep("--help", env=environment).stdout)

    def test_mpirun(self):
        command = [*MPIEXEC, "-n", "3", PROGRAM, "one", *COLUMN, "--s0", "0"]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=60)
        self.assertEqual((ended.returncode, ended.stdout.count("eps_eff ")), (0, 3), ended)

    def test_ranks_of_a_parallel_command_speak_once(self):
        environment = dict(os.environ, OMPI_COMM_WORLD_RANK="1")
        for arguments, code in ((["run", "--help"], 0), (["run", "--bogus"], 64)):
            ended = sigmasweep(*arguments, env=environment)
            self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (code, "", ""))

    def test_launcher_of_another_mpi(self):
        """Each process would be rank 0 of 1."""
        spec = str(self.write(SPEC))
        for command in (["run", spec], ["precision", spec], ["stability", spec], ["merge", "all.h5", "part.h5"]):
            for variables in ({"PMI_SIZE": "4", "PMI_RANK": "0"}, {"MV2_COMM_WORLD_SIZE": "2"},
                              {"SLURM_STEP_NUM_TASKS": "3"}):
                ended = sigmasweep(*command, env=dict(os.environ, **variables), cwd=self.path)
                self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count("\n")), (64, "", 1), ended)
                name, number = next(iter(variables.items()))
                self.assertIn(f"{name} = {number}", ended.stderr)
                self.assertIn("of another MPI", ended.stderr)
                self.assertEqual(os.listdir(self.path), ["spec.toml"])
        ended = sigmasweep("run", spec, env=dict(os.environ, PMI_SIZE="4", PMI_RANK="2"), cwd=self.path)
        self.assertEqual((ended.returncode, ended.stderr), (64, ""), "not only rank 0 spoke")

    def test_one_process_within_many_tasks(self):
        """mpirun -n 1 in each task of srun."""
        spec = str(self.write(SPEC))
        command = [*MPIEXEC, "-n", "1", PROGRAM, "run", spec]
        environment = dict(os.environ, SLURM_STEP_NUM_TASKS="4")
        ended = subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=self.path, env=environment)
        self.assertEqual(ended.returncode, 0, ended)

    def test_alone_there_is_no_daemon(self):
        """Open MPI's singletons would start one, and wait for it at the end."""
        spec = str(self.write(SPEC.replace("[0.1, 1, 10]", AXIS)))
        with subprocess.Popen([PROGRAM, "run", spec], cwd=self.path, stderr=subprocess.PIPE, text=True) as run:
            run.stderr.readline()  # MPI is there
            children = pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text()
            run.terminate()
            run.stderr.read()
        self.assertEqual((children, run.returncode), ("", 75))


if __name__ == "__main__":
    unittest.main(verbosity=2)
