#!/usr/bin/python3
"""The rules of the house that a machine can hold.

    check_house.py CHECK ROOT

CHECK is one of function-length, file-length, line-length, dependencies, private-headers, leftovers, layout, citations,
fixtures. Exits 1 with one line per violation.
"""
import hashlib
import pathlib
import re
import sys

MAX_FUNCTION_LINES = 80
MAX_FILE_LINES = 600
MAX_COLUMNS = 120

TOP_LEVEL = {"CMakeLists.txt", "CMakePresets.json", "src", "modules", "pipelines", "testing", "data", "docs", "LICENSE",
             "build", "out"}


def sources(root, folders=("modules", "src", "testing", "pipelines"), endings=(".h", ".cxx")):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in endings and path.is_file() and "__pycache__" not in path.parts:
                yield path


def blank_out(text):
    """The text with comments, strings and characters replaced by blanks, line breaks kept."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def cxx_functions(text):
    """(line, length) of every outermost brace block that follows a parameter list."""
    text = blank_out(text)
    depth, start, found = [], None, []
    for at, character in enumerate(text):
        if character == "{":
            before = text[max(0, at - 400):at]
            heading = re.split(r"[;{}]", before)[-1]
            is_function = bool(re.search(r"\)[\s\w:&>,()*\[\]=-]*$", heading)) and not re.search(
                r"\b(namespace|enum)\b", heading)
            depth.append(is_function and not any(depth))
            if depth[-1]:
                start = at
        elif character == "}" and depth:
            if depth.pop():
                found.append((text.count("\n", 0, start) + 1, text.count("\n", start, at) + 1))
    return found


def check_function_length(root):
    for path in sources(root, endings=(".h", ".cxx")):
        for line, length in cxx_functions(path.read_text()):
            if length > MAX_FUNCTION_LINES:
                yield f"{path.relative_to(root)}:{line}: function of {length} lines"
    for path in sources(root, endings=(".py",)):
        lines = path.read_text().splitlines()
        for number, line in enumerate(lines):
            match = re.match(r"( *)def ", line)
            if not match:
                continue
            end = number + 1
            while end < len(lines) and (not lines[end].strip() or lines[end].startswith(match.group(1) + " ")
                                        or re.match(match.group(1) + r"\)", lines[end])):
                end += 1
            if end - number > MAX_FUNCTION_LINES:
                yield f"{path.relative_to(root)}:{number + 1}: function of {end - number} lines"


def check_file_length(root):
    for path in sources(root, endings=(".h", ".cxx", ".py")):
        length = len(path.read_text().splitlines())
        if length > MAX_FILE_LINES:
            yield f"{path.relative_to(root)}: {length} lines"


def check_line_length(root):
    for path in sources(root, endings=(".h", ".cxx", ".py")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            is_table_row = re.match(r"\s*(\*|//[/!])\s*\|", line)  # Markdown has no way to break one
            if len(line) > MAX_COLUMNS and not is_table_row:
                yield f"{path.relative_to(root)}:{number}: {len(line)} columns"


def architecture(root):
    """The tables of docs/architecture.md: {module: modules it may use} and the order of Core's folders."""
    text = (root / "docs/architecture.md").read_text()
    tables = [re.findall(r"^\| (\w+) \| (.*) \|$", part, flags=re.M) for part in text.split("\n## ")]
    modules, folders = [table for table in tables if table]
    return ({name: set(re.findall(r"\w+", uses)) for name, uses in modules if name != "module"},
            [name for name, _ in folders if name != "folder"])


def private_headers(root):
    """{header as others would include it: the folder that it belongs to}, from "Private to FOLDER/." near its top."""
    found = {}
    for path in sources(root, folders=("modules",), endings=(".h",)):
        if re.search(r"Private to \w+/", path.read_text()[:600]):
            inside = path.relative_to(root / "modules")
            found[str(inside if inside.parts[0] in ("Core", "Formats", "Reports") else inside.name)] = path.parent
    return found


def check_private_headers(root):
    private = private_headers(root)
    for path in sources(root, folders=("modules", "src")):
        text = path.read_text()
        for header, folder in private.items():
            if f'#include "{header}"' not in text:
                continue
            if path.parent != folder:
                yield f"{path.relative_to(root)}: {header} is private to {folder.relative_to(root)}"
            elif path.suffix == ".h" and "Private to " not in text[:600]:
                yield f"{path.relative_to(root)}: is installed, but {header} is not"


def check_dependencies(root):
    may_use, core_order = architecture(root)
    for path in sources(root, folders=("modules",)):
        module = path.relative_to(root / "modules").parts[0]
        folder = path.relative_to(root / "modules").parts[1]
        for number, line in enumerate(path.read_text().splitlines(), 1):
            include = re.match(r'\s*#include [<"]([^>"]+)[>"]', line)
            if not include:
                continue
            target = include.group(1)
            where = f"{path.relative_to(root)}:{number}: {target}"
            parts = target.split("/")
            if module in ("Core", "Formats", "Reports") and parts[0].startswith("vtk"):
                yield f"{where} (no VTK below the filters)"
            if path.suffix == ".h" and parts[0] in ("CGAL", "cholmod.h", "nifti2_io.h", "expat.h", "zlib.h"):
                yield f"{where} (private libraries stay out of headers)"
            if parts[0] in may_use and parts[0] != module and parts[0] not in may_use[module]:
                yield f"{where} ({module} may not use {parts[0]})"
            if module == "Core" and parts[0] == "Core":
                if core_order.index(parts[1]) > core_order.index(folder):
                    yield f"{where} ({folder} comes before {parts[1]})"


def check_leftovers(root):
    # Spelled in pieces, so that this file does not find itself.
    marks = "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK"])
    pattern = re.compile(rf"\b({marks})\b|/tmp/" + "wt|/wor" + "k/|/ro" + "ot/")
    for path in sources(root, folders=("modules", "src", "testing", "pipelines", "docs"),
                        endings=(".h", ".cxx", ".py", ".sh", ".md", ".txt", ".cmake")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if pattern.search(line):
                yield f"{path.relative_to(root)}:{number}: {line.strip()[:100]}"
    for path in sources(root, folders=("modules/Core",)):
        for number, line in enumerate(blank_out(path.read_text()).splitlines(), 1):
            if re.search(r"\b(printf|cout|cerr|puts)\b", line):
                yield f"{path.relative_to(root)}:{number}: Core prints"


def check_layout(root):
    for path in sorted(root.iterdir()):
        agreed = path.name in TOP_LEVEL or path.suffix == ".md" or path.name == "CITATION.cff"
        if not (agreed or path.name.startswith(".")):
            yield f"{path.name}: outside the agreed layout"


def check_citations(root):
    keys = set(re.findall(r"^@\w+\{(\w+),", (root / "docs/references.bib").read_text(), flags=re.M))
    for path in sources(root, folders=("modules",)):
        for key in re.findall(r"@cite\s+(\w+)", path.read_text()):
            if key not in keys:
                yield f"{path.relative_to(root)}: @cite {key} is not in docs/references.bib"


def check_fixtures(root):
    rows = (root / "data/MANIFEST.tsv").read_text().splitlines()[1:]
    listed = {row.split("\t")[0]: row.split("\t")[1] for row in rows}
    present = {p.name for p in (root / "data").iterdir()} - {"MANIFEST.tsv", "make_fixtures.py", "__pycache__"}
    for name in sorted(present ^ set(listed)):
        yield f"data/{name}: listed in the manifest or present, but not both"
    for name in sorted(present & set(listed)):
        if hashlib.sha256((root / "data" / name).read_bytes()).hexdigest() != listed[name]:
            yield f"data/{name}: sha256 differs from the manifest"


def main():
    check, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    violations = list(globals()["check_" + check.replace("-", "_")](root))
    print("\n".join(violations))
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
