"""The reference of specs: help, schema, docs/spec.md, a blank spec and completion know the same keys as the reader."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import jsonschema

PROGRAM = os.environ["SIGMASWEEP"]
ROOT = pathlib.Path(__file__).parents[2]
GEOMETRIES = ("column", "vibrated-column", "lattice", "vibrated-lattice")


def sigmasweep(*arguments, **options):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60, **options)


def output_of(*arguments):
    ended = sigmasweep(*arguments)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


def keys_of(schema):
    """The keys of a table's schema and of the tables in it."""
    keys = set()
    for form in (schema, schema.get("items", {}), *schema.get("anyOf", [])):
        for key, value in form.get("properties", {}).items():
            keys |= {key} | keys_of(value)
    return keys


class Reference(unittest.TestCase):
    maxDiff = None

    def test_the_document_and_the_schema_are_those_of_the_program(self):
        self.assertEqual((ROOT / "docs/spec.md").read_text(), output_of("help", "spec"))
        self.assertEqual((ROOT / "sweeps/sigmasweep.schema.json").read_text(), output_of("schema"))

    def test_parts_of_the_reference(self):
        whole = output_of("help", "spec")
        for topic, key in (("plot", "`guides`"), ("fields", "`eps_eff`")):
            part = output_of("help", topic)
            self.assertIn(part, whole)
            self.assertIn(key, part)

    def test_every_key_is_in_the_reference_and_in_a_blank_spec(self):
        schema = json.loads(output_of("schema"))
        reference = output_of("help", "spec")
        blank = "".join(output_of("new", geometry) for geometry in GEOMETRIES)
        for table, value in schema["properties"].items():
            for key in keys_of(value):
                self.assertIn(f"`{key}`", reference)
            for key in value.get("properties", {}) if table in ("sweep", "run", "trajectory") else ():
                self.assertRegex(blank, rf"(?m)^(# )?{key} = ")

    def test_a_key_that_the_schema_does_not_know_is_refused_by_the_reader(self):
        schema = json.loads(output_of("schema"))
        with tempfile.TemporaryDirectory() as folder:
            for table in schema["properties"]:
                if table == "title":
                    continue
                spec = pathlib.Path(folder) / "spec.toml"
                spec.write_text(("[sweep]\nN = 1\nv0 = 1.0\ntc = 1e-5\ns0 = 0.0\nepsilon = 0.9\n" if table != "sweep" else "")
                                + f"[{table}]\nnonsense = 1\n")
                ended = sigmasweep("plan", str(spec))
                self.assertEqual(ended.returncode, 65)
                # The message names all keys of the table.
                for key in schema["properties"][table].get("properties", {}):
                    self.assertIn(key, ended.stderr)

    def test_the_specs_of_the_project_satisfy_the_schema(self):
        schema = json.loads(output_of("schema"))
        validator = jsonschema.Draft7Validator(schema)
        jsonschema.Draft7Validator.check_schema(schema)
        for path in sorted((ROOT / "sweeps").glob("*.toml")):
            with self.subTest(path.name):
                text = path.read_text()
                self.assertEqual(text.split("\n")[0], "#:schema sigmasweep.schema.json")
                self.assertEqual([error.message for error in validator.iter_errors(tomllib.loads(text))], [])

    def test_the_schema_finds_mistakes(self):
        validator = jsonschema.Draft7Validator(json.loads(output_of("schema")))
        good = {"sweep": {"N": [1, 2], "sigma": {"from": 0.1, "to": 1, "count": 3, "scale": "log"}}}
        self.assertTrue(validator.is_valid(good))
        for bad in ({}, {"sweep": {"n": 1}}, {"sweep": {"N": 1.5}}, {"sweep": {"N": []}},
                    {"sweep": {"sigma": {"from": 1, "count": 2}}}, {"sweep": {"law": "hook"}},
                    {"sweep": {}, "plot": {"x_scale": "logarithmic"}}, {"sweep": {}, "plot": {"series": "nonsense"}},
                    {"sweep": {}, "plot": {"guides": {"y": 1}}}, {"sweep": {}, "run": {"manager": True}}):
            self.assertFalse(validator.is_valid(bad), bad)

    def test_a_blank_spec_can_be_planned(self):
        with tempfile.TemporaryDirectory() as folder:
            for geometry in GEOMETRIES:
                path = pathlib.Path(folder) / f"{geometry}.toml"
                self.assertEqual(sigmasweep("new", geometry, "-o", str(path)).returncode, 0)
                plan = sigmasweep("plan", str(path))
                self.assertEqual(plan.returncode, 0, plan.stderr)
                # Each parameter in a comment is one that the geometry has.
                text = path.read_text()
                for line in re.findall(r"(?m)^# (\w+ = [^.].*)$", text.partition("# [plot]")[0]):
                    ended = sigmasweep("plan", "-", input=text.replace("# " + line, line, 1))
                    self.assertNotIn("unknown key", ended.stderr)
                    self.assertIn(ended.returncode, (0, 65), ended.stderr)
                before = path.read_bytes()
                again = sigmasweep("new", geometry, "-o", str(path))
                self.assertEqual((again.returncode, path.read_bytes()), (73, before))


class Completion(unittest.TestCase):
    def completed(self, *words):
        script = output_of("completion", "bash")
        line = " ".join(f"'{word}'" for word in words)
        ended = subprocess.run(
            ["bash", "-c", f"{script}\nCOMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _sigmasweep; "
             "printf '%s\\n' \"${COMPREPLY[@]}\""], capture_output=True, text=True, timeout=60)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        return ended.stdout.split()

    def test_bash(self):
        self.assertIn("precision", self.completed("sigmasweep", ""))
        self.assertEqual(self.completed("sigmasweep", "pl"), ["plan", "plot"])
        self.assertEqual(self.completed("sigmasweep", "one", "--eps"), ["--epsilon"])
        self.assertEqual(self.completed("sigmasweep", "one", "--law", "hert"), ["hertz", "hertz-kuwabara-kono"])
        self.assertIn("eps_eff_error", self.completed("sigmasweep", "show", "x.h5", "--where", "eps"))
        self.assertIn("lattice", self.completed("sigmasweep", "new", ""))

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh(self):
        subprocess.run(["zsh", "-n", "/dev/stdin"], input=output_of("completion", "zsh"), text=True, check=True)

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish(self):
        subprocess.run(["fish", "--no-execute"], input=output_of("completion", "fish"), text=True, check=True)


if __name__ == "__main__":
    unittest.main()
