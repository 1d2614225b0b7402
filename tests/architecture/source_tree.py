"""The tree of sources, as far as its rules need to be known: rooms, includes, links, functions and names.

Not a parser of C++: it relies on the layout that clang-format gives (a function ends with a brace at its own indentation).
"""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

# From the lowest room to the highest. A room uses itself and the rooms before it.
ROOMS = ["base", "model", "numerics", "contact", "assembly", "solve", "sweep", "trajectory", "plot", "mpi", "store",
         "engine", "studies", "cli", "python"]

INSTALLED = "include/sigmasweep"
KEYWORDS = {"if", "for", "while", "switch", "return", "sizeof", "decltype", "alignas", "alignof", "noexcept", "requires",
            "static_assert", "catch", "operator", "defined", "throw", "co_return", "explicit", "assert"}


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def files(*endings):
    """Paths of the sources below src/ and include/, from the root of the project."""
    found = [path for folder in ("src", "include") for path in (ROOT / folder).rglob("*") if path.is_file()]
    return sorted(path.relative_to(ROOT).as_posix() for path in found if not endings or path.suffix in endings)


def documents():
    """Paths of README.md and the like, and of docs/, from the root of the project."""
    return sorted(path.relative_to(ROOT).as_posix() for path in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")))


def linked_files(path):
    """The targets of a document's links and pictures that are files of the project."""
    links = re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", read(path))
    return [link for link in links if not re.match(r"https?:|mailto:", link)]


def named_sources(path):
    """The sources src/... and include/... that a text names in full, but for examples such as NAME.cpp and what diffs add."""
    text = re.sub(r"```diff.*?```", "", read(path), flags=re.S)
    return [name for name in re.findall(r"\b(?:src|include)/[\w/]+\.(?:cpp|hpp)\b", text) if "NAME" not in name]


def room_of(path):
    """The room of a source: src/solve/exact/a.cpp and include/sigmasweep/solve/b.hpp are of "solve"."""
    parts = path.split("/")
    return parts[2] if path.startswith(INSTALLED) else parts[1]


def includes(path):
    """(line number, included path) of each #include "..." of a source."""
    return [(number, match[1]) for number, line in enumerate(read(path).splitlines(), 1)
            if (match := re.match(r'\s*#\s*include\s*"([^"]+)"', line))]


def file_of(included, path):
    """The file that an include of `path` names, from the root of the project; None if there is none."""
    beside = (pathlib.PurePosixPath(path).parent / included).as_posix()
    for candidate in (f"include/{included}", f"src/{included}", beside):
        if (ROOT / candidate).is_file():
            return candidate
    return None


def links(room):
    """The rooms that the target of a room links to."""
    text = re.sub(r"#.*", "", read(f"src/{room}/CMakeLists.txt"))
    calls = re.findall(r"target_link_libraries\(sigmasweep(?:_%s)?\s([^)]*)\)" % room, text)
    return sorted({name for call in calls for name in re.findall(r"\bsigmasweep(?:_|::)(\w+)", call)} & set(ROOMS))


def plain(text):
    """The text without comments, strings and preprocessor lines; as many lines as before."""
    def blank(match):
        return "\n" * match[0].count("\n") or (" " if match[0].startswith("/") else '""')
    text = re.sub(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', blank, text, flags=re.S)
    return re.sub(r"^\s*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m[0].count("\n"), text, flags=re.M)


def functions(path):
    """(first line, number of lines, beginning) of the functions of a source that are longer than one line."""
    found, lines = [], plain(read(path)).split("\n")
    begin = indent = None
    for number, line in enumerate(lines):
        match = re.match(r"^( {0,4})(?!(?:if|for|while|switch|else|do|struct|class|enum|union|namespace|return)\b)\S.*\{$", line)
        if begin is None and match and not line.lstrip().startswith(":") and ("(" in line or (number and "(" in lines[number - 1])) and not re.search(r"= \{|to_array<", line):
            begin, indent = number, match[1]
        elif begin is not None and line.startswith(indent + "}"):
            found.append((begin + 1, number - begin + 1, lines[begin].strip()))
            begin = None
    return found


def scopes(path):
    """(scope, text) of what stands directly in each namespace and class of a source, up to ; or {. Scopes are tuples of
    (kind, name), with kind "namespace", "class" or "other"."""
    found, stack, pending = [], [], ""
    depth = 0  # of parentheses
    for token in re.findall(r"[{};()]|[^{};()]+", plain(read(path))):
        depth += (token == "(") - (token == ")")
        if token == "{" and depth == 0:
            head = pending.strip()
            found.append((tuple(stack), head + " {"))
            while (shorter := re.sub(r"<[^<>]*>", " ", head)) != head:  # "class" of template parameters names no class
                head = shorter
            namespace = re.match(r"(?:inline )?namespace\s*([\w:]*)", head)
            kind = re.search(r"(?:^|\s|>)(struct|class|enum class|enum|union)\s+(?:alignas\([^)]*\)\s*)?((?:\w+::)*\w+)[^()=]*$", head)
            stack.append(("namespace", namespace[1]) if namespace else
                         ("class", kind[2]) if kind and not kind[1].startswith("enum") else ("other", ""))
            pending = ""
        elif token == "}" and depth == 0:
            pending = ""
            if stack:
                stack.pop()
        elif token == ";" and depth == 0:
            found.append((tuple(stack), pending.strip() + ";"))
            pending = ""
        else:
            pending += token
            if depth == 0:
                pending = re.sub(r"\b(public|private|protected)\s*:(?!:)", "", pending)
    return found


def declared_functions(header):
    """(class or "", name) of the functions that a header declares without defining them."""
    found = set()
    for scope, text in scopes(header):
        if any(kind == "other" for kind, _ in scope) or not text.endswith(";"):
            continue
        text = re.sub(r"\[\[.*?\]\]|__attribute__\s*\(\(.*?\)\)|noexcept\s*\([^)]*\)|alignas\s*\([^)]*\)", "", text)
        if re.match(r"\s*(?:using|typedef|friend|extern template|template\s*<>|static_assert|inline|constexpr|concept|return)\b",
                    text) or re.search(r"=\s*(?:0|default|delete)\s*;$|\boperator\b|\binline\b", text):
            continue
        text = re.sub(r"^\s*template\s*<.*?>\s*(?=\w)", "", text, flags=re.S) if "(" in text.partition(">")[0] else text
        while (shorter := re.sub(r"<[^<>]*>", "", text)) != text:  # template arguments may be functions' types
            text = shorter
        match = re.search(r"(~?\b[A-Za-z_]\w*)\s*\(", text)
        if not match or match[1] in KEYWORDS or re.match(r"\s*[*&]", text[match.end():]) or "=" in text[:match.start()]:
            continue
        classes = "::".join(name for kind, name in scope if kind == "class")
        found.add((classes, match[1]))
    return found


def defined_types(header):
    """(namespace, name) of the types that a header defines at namespace scope."""
    found = set()
    for scope, text in scopes(header):
        if any(kind != "namespace" for kind, _ in scope):
            continue
        match = re.search(r"(?:^|\s|>)(?:struct|class|enum class|enum|union)\s+(\w+)[^()=;]*\{$", text) or \
            re.match(r"(?:template\s*<.*>\s*)?(?:using)\s+(\w+)\s*=", text)
        if match and not re.search(r"\b%s\s*<" % match[1], text):  # a specialisation defines no new name
            found.add(("::".join(name for _, name in scope if name), match[1]))
    return found


def namespaces():
    return {name for path in files(".hpp", ".cpp") for declared in re.findall(r"^namespace ([\w:]+)", plain(read(path)), re.M)
            for name in declared.split("::")}
