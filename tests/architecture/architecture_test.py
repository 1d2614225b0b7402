"""The rooms of src/ and include/ keep their order and their size."""

import collections
import re
import unittest

import source_tree as tree

MAX_FILES_OF_A_FOLDER = 24
MAX_LINES_OF_A_FILE = 400
MAX_LINES_OF_A_FUNCTION = 60  # a screen
MAX_FILES_THAT_ASK_FOR_THE_GEOMETRY = 12
ASKS_FOR_THE_GEOMETRY = re.compile(r"is_vibrated\(|is_lattice\(|Geometry::|geometry_of")


class Rooms(unittest.TestCase):
    maxDiff = None

    def test_each_folder_is_a_room(self):
        self.assertEqual({tree.room_of(path) for path in tree.files(".cpp", ".hpp")}, set(tree.ROOMS))

    def test_no_include_runs_upward(self):
        upward = [f"{path}:{line}: {included}" for path in tree.files(".cpp", ".hpp")
                  for line, included in tree.includes(path)
                  if (file := tree.file_of(included, path)) and
                  tree.ROOMS.index(tree.room_of(file)) > tree.ROOMS.index(tree.room_of(path))]
        self.assertEqual(upward, [])

    def test_includes_are_written_from_src_or_include(self):
        generated = {"git_revision.hpp"}
        lost = [f"{path}:{line}: {included}" for path in tree.files(".cpp", ".hpp")
                for line, included in tree.includes(path)
                if tree.file_of(included, path) not in (f"src/{included}", f"include/{included}")
                and included not in generated]
        self.assertEqual(lost, [])

    def test_a_room_links_only_to_rooms_below_it(self):
        upward = [f"{room} links to {other}" for room in tree.ROOMS for other in tree.links(room)
                  if tree.ROOMS.index(other) >= tree.ROOMS.index(room)]
        self.assertEqual(upward, [])

    def test_a_room_links_to_what_it_includes(self):
        reached = {}
        for room in tree.ROOMS:
            reached[room] = {room}.union(*(reached.get(other, set()) for other in tree.links(room)))
        missing = {f"{tree.room_of(path)} includes {tree.room_of(file)}" for path in tree.files(".cpp", ".hpp")
                   for _, included in tree.includes(path) if (file := tree.file_of(included, path))
                   and tree.room_of(file) not in reached[tree.room_of(path)]}
        self.assertEqual(sorted(missing), [])


class Headers(unittest.TestCase):
    maxDiff = None

    def test_installed_headers_include_installed_headers_only(self):
        internal = [f"{path}:{line}: {included}" for path in tree.files(".hpp") if path.startswith(tree.INSTALLED)
                    for line, included in tree.includes(path)
                    if not (tree.file_of(included, path) or "").startswith(tree.INSTALLED)]
        self.assertEqual(internal, [])

    def test_a_source_includes_its_own_header_first(self):
        for path in tree.files(".cpp"):
            own = [name for name in (path[len("src/"):-len(".cpp")] + ".hpp",
                                     "sigmasweep/" + path[len("src/"):-len(".cpp")] + ".hpp") if tree.file_of(name, path)]
            if own:
                with self.subTest(path):
                    self.assertEqual(tree.includes(path)[0][1], own[0])

    def test_functions_are_defined_in_the_source_of_their_headers_name(self):
        elsewhere = []
        sources = {path.removesuffix(".in"): tree.plain(tree.read(path)).replace("= {}", "") for path in tree.files(".cpp", ".hpp", ".in")}
        for header in tree.files(".hpp"):
            stem = re.sub(r"^(include/sigmasweep|src)/|\.hpp$", "", header)
            # Code that is compiled once a number type stands in several files: stem.hpp, stem_impl.hpp, stem_double.cpp.
            own = "".join(text for path, text in sources.items() if re.match(rf"(include/sigmasweep|src)/{stem}(_\w+)?\.", path))
            for owner, name in sorted(tree.declared_functions(header)):
                qualified = rf"\b{re.escape(owner.split('::')[-1])}(?:<[^;{{}}]*>)?::{re.escape(name)}\s*\("
                pattern = qualified if owner else rf"(?<![.>\w]){re.escape(name)}(?:<[^;{{}}]*>)?\s*\([^;]*?\{{"
                if not re.search(pattern, own, re.S):
                    elsewhere.append(f"{header}: {owner + '::' if owner else ''}{name}")
        self.assertEqual(sorted(elsewhere), [])

    def test_names_do_not_clash(self):
        places = collections.defaultdict(set)
        for header in tree.files(".hpp"):
            for namespace, name in tree.defined_types(header):
                places[name].add(namespace)
        twice = {name: sorted(spaces) for name, spaces in places.items() if len(spaces) > 1}
        self.assertEqual(twice, {}, "types of the same name in several namespaces")
        functions = {name for header in tree.files(".hpp") for owner, name in tree.declared_functions(header) if not owner}
        self.assertEqual(functions & tree.namespaces(), set(), "functions that are called as a namespace is")


class Documents(unittest.TestCase):
    maxDiff = None

    def test_links_lead_to_files(self):
        dead = [f"{path}: {target}" for path in tree.documents() for target in tree.linked_files(path)
                if not (tree.ROOT / path).parent.joinpath(target).exists()]
        self.assertEqual(dead, [])

    def test_sources_that_comments_and_documents_name_exist(self):
        lost = [f"{path}: {named}" for path in (*tree.files(".cpp", ".hpp"), *tree.documents())
                for named in tree.named_sources(path) if not (tree.ROOT / named).exists()]
        self.assertEqual(lost, [])


class Sizes(unittest.TestCase):
    maxDiff = None

    def test_folders(self):
        count = collections.Counter(path.rpartition("/")[0] for path in tree.files())
        self.assertEqual({folder: n for folder, n in count.items() if n > MAX_FILES_OF_A_FOLDER}, {})

    def test_files(self):
        lines = {path: len(tree.read(path).splitlines()) for path in tree.files()}
        self.assertEqual({path: n for path, n in lines.items() if n > MAX_LINES_OF_A_FILE}, {})

    def test_functions(self):
        long = [f"{path}:{line}: {length} lines: {head}" for path in tree.files(".cpp", ".hpp")
                for line, length, head in tree.functions(path) if length > MAX_LINES_OF_A_FUNCTION]
        self.assertEqual(long, [])

    def test_few_files_ask_for_the_geometry(self):
        asking = [path for path in tree.files(".cpp", ".hpp") if ASKS_FOR_THE_GEOMETRY.search(tree.plain(tree.read(path)))]
        self.assertLessEqual(len(asking), MAX_FILES_THAT_ASK_FOR_THE_GEOMETRY, asking)


if __name__ == "__main__":
    unittest.main(verbosity=2)
