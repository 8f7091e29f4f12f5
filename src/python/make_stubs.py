#!/usr/bin/python3
"""Writes type stubs for the compiled modules of the package, from the signatures in their docstrings.

    make_stubs.py FOLDER/authalic

One NAME.pyi beside each NAME.so, and _classes.pyi with every class. A method that is inherited is in the stub of
its own class only, VTK's classes are imported from vtkmodules.
"""
import importlib
import keyword
import pathlib
import re
import sys

SIGNATURE = re.compile(r"^(\w+)\((.*?)\)(?:\s*->\s*(.+?))?$", re.S)
PLAIN = {"int", "float", "str", "bool", "bytes", "None", "type", "object"}
UNKNOWN = "Any"


def vtk_modules():
    """{class: module} of everything in vtkmodules that is loaded or asked for by name."""
    where = {}
    for name in ("vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkIOCore"):
        for key in vars(importlib.import_module(f"vtkmodules.{name}")):
            if key.startswith("vtk"):
                where.setdefault(key, f"vtkmodules.{name}")
    return where


def split(text, by):
    """Parts of `text` between the separators that are not inside brackets."""
    parts, depth, start = [], 0, 0
    for at, character in enumerate(text):
        depth += (character in "([{") - (character in ")]}")
        if character == by and depth == 0:
            parts.append(text[start:at])
            start = at + 1
    return [part.strip() for part in [*parts, text[start:]] if part.strip()]


class Module:
    """The stub of one compiled module."""

    def __init__(self, name, package, ours, vtk):
        self.name, self.ours, self.vtk = name, ours, vtk
        self.module = importlib.import_module(f"{package}.{name}")
        self.imports = set()

    def classes(self):
        return [value for key, value in sorted(vars(self.module).items()) if key.startswith("vtk")]

    def type_of(self, text, result=False):
        """A type of VTK's signatures as Python spells it."""
        text = (text or "None").strip()
        if text.startswith(("(", "[")):
            inner = [self.type_of(part, result) for part in split(text[1:-1], ",")]
            return f"tuple[{', '.join(inner)}]" if result and text[0] == "(" else f"Sequence[{inner[0]}]"
        if text in PLAIN:
            return text
        if text in self.ours and self.ours[text] != self.name:
            self.imports.add(f"from .{self.ours[text]} import {text}")
        elif text in self.vtk:
            self.imports.add(f"from {self.vtk[text]} import {text}")
        elif text not in self.ours:
            return text if text in self.nested else UNKNOWN
        return text

    def parameter(self, text, number):
        head, _, default = text.partition("=")
        name, _, kind = head.partition(":")
        name = name.strip()
        name = f"{name}_" if keyword.iskeyword(name) else name or f"_arg{number}"
        return f"{name}: {self.type_of(kind) if kind else UNKNOWN}" + (" = ..." if default else "")

    def overloads(self, method):
        """(parameters, result) of each signature at the head of the docstring, and the words after them."""
        head, _, words = (method.__doc__ or "").partition("\n\n")
        blocks = re.split(r"\n(?=\w+\()", re.sub(r"\nC\+\+:.*?(?=\n\w+\(|\Z)", "", head, flags=re.S))
        for block in blocks:
            match = SIGNATURE.match(re.sub(r"\s+", " ", block.strip()))
            if match:
                parameters = split(match.group(2), ",")
                is_static = not parameters or parameters[0] != "self"
                rest = parameters if is_static else parameters[1:]
                yield (is_static, [self.parameter(p, k) for k, p in enumerate(rest)],
                       self.type_of(match.group(3), True), words.strip())

    def method(self, name, method):
        found = list(self.overloads(method)) or [(False, ["*args: Any"], UNKNOWN, "")]
        lines = []
        for is_static, parameters, result, words in found:
            if len(found) > 1:
                lines.append("    @overload")
            if is_static:
                lines.append("    @staticmethod")
            arguments = ", ".join(([] if is_static else ["self"]) + parameters)
            lines.append(f"    def {name}({arguments}) -> {result}:" + ("" if words else " ..."))
            if words:
                lines += ['        """' + re.sub(r"\s+", " ", words).replace("\\", "\\\\").replace('"', "'") + '"""']
        return lines

    def members(self, cls):
        own = {key: value for key, value in vars(cls).items() if not key.startswith("_")}
        self.nested = {key for key, value in own.items() if isinstance(value, type)}
        lines = []
        for key in sorted(self.nested):
            lines += [f"    class {key}(int): ..."]
        for key, value in own.items():
            if isinstance(value, int):
                lines.append(f"    {key}: {type(value).__name__ if type(value).__name__ in self.nested else 'int'}")
            elif callable(value) and key not in self.nested:
                lines += self.method(key, value)
        return lines or ["    ..."]

    def text(self):
        body = []
        for cls in self.classes():
            bases = [base.__name__ for base in cls.__bases__ if base is not object]
            heading = (cls.__doc__ or "").split("\n\n")[0].replace("\n", " ").replace("\\", "\\\\")
            body += ["", f"class {cls.__name__}({', '.join(map(self.type_of_base, bases))}):", f'    """{heading}"""']
            body += self.members(cls)
        return "\n".join(["from collections.abc import Sequence", "from typing import Any, overload", "",
                          *sorted(self.imports), *body, ""])

    def type_of_base(self, name):
        self.nested = set()
        return self.type_of(name)


def main(folder):
    folder = pathlib.Path(folder).resolve()
    sys.path[0] = str(folder.parent)  # the built package, not the sources beside this file
    names = sorted(path.name.split(".")[0] for path in folder.glob("vtkAuthalic*.so"))
    modules = {name: importlib.import_module(f"{folder.name}.{name}") for name in names}
    ours = {key: name for name, module in modules.items() for key in vars(module) if key.startswith("vtk")}
    vtk = vtk_modules()
    for name in names:
        (folder / f"{name}.pyi").write_text(Module(name, folder.name, ours, vtk).text(), encoding="utf-8")
    lines = [f"from .{name} import {key} as {key}" for key, name in sorted(ours.items())]
    everything = ", ".join(f'"{key}"' for key in sorted(ours))
    (folder / "_classes.pyi").write_text("\n".join([*lines, "", f"__all__ = [{everything}]", ""]), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
