#!/usr/bin/python3
"""Holds the proxies of the plugin to the classes they stand for. Needs the package `authalic`, but no ParaView.

    check_proxies.py CHECK FOLDER

CHECK is one of classes, properties, defaults, ranges, ports, help. FOLDER holds the XML files.
Exits 1 with one line per violation.
"""
import re
import sys

import authalic
import proxies
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


def concrete_classes():
    """Filters, readers and writers of the package that can be made."""
    for name in authalic.__all__:
        cls = getattr(authalic, name)
        if isinstance(cls, type) and issubclass(cls, vtkAlgorithm):
            try:
                cls()
            except TypeError:
                continue  # abstract
            yield cls


def own_methods(cls):
    """Names of methods that the class or its bases in the package define, not VTK's."""
    ours = [base for base in cls.__mro__ if base.__module__.startswith("authalic")]
    return {name for base in ours for name in vars(base)}


def pairs(folder):
    """(class, proxy with that class) for every concrete class; the proxy is None when there is none."""
    by_class = {}
    for proxy in proxies.load(folder).values():
        instantiable = not proxy.is_internal or proxy.element.tag == "WriterProxy"
        if instantiable and proxy.vtk_class:
            by_class[proxy.vtk_class] = proxy
    for cls in concrete_classes():
        yield cls, by_class.get(cls.__name__)


def present(folder):
    return [(cls, proxy) for cls, proxy in pairs(folder) if proxy is not None]


def check_classes(folder):
    for cls, proxy in pairs(folder):
        if proxy is None:
            yield f"{cls.__name__}: no proxy"
    for (group, name), proxy in proxies.load(folder).items():
        hints = [hint.tag for hint in proxy.element.findall("Hints/*")]  # the menus do not look at bases
        wanted = {"filters": "ShowInMenu", "sources": "ReaderFactory", "writers": "WriterFactory"}.get(group)
        if wanted and wanted not in hints:
            yield f"{name}: no {wanted} of its own"


def setters(cls):
    """Commands that a panel must have: SetX, and AddX that a ClearXs takes back."""
    methods = own_methods(cls)
    for name in sorted(methods):
        if name.startswith("Set") and "Get" + name[3:] in methods:
            yield name
        if name.startswith("Add") and "Clear" + name[3:] + "s" in methods:
            yield name


def results(cls):
    """Commands that say what an execution gave: GetX that no SetX is for."""
    methods = own_methods(cls)
    for name in sorted(methods):
        ours = name.startswith("Get") and not re.search(r"MinValue$|MaxValue$|^GetNumberOf", name)
        if ours and "Set" + name[3:] not in methods:
            yield name


def check_properties(folder):
    for cls, proxy in present(folder):
        commands = {p.command for p in proxy.properties.values()}
        if cls.__name__.endswith("Writer"):
            commands.add("SetFileName")  # the parallel writer around it has the file name
        for command in [*setters(cls), *([] if proxy.is_internal else results(cls))]:
            if command not in commands:
                yield f"{proxy.name}: no property calls {command}"
        for item in proxy.properties.values():
            for command in filter(None, (item.command, item.clean_command)):
                if not hasattr(cls, command):
                    yield f"{proxy.name}.{item.name}: {cls.__name__} has no {command}"
            if item.label.replace(" ", "") != item.name:
                yield f"{proxy.name}.{item.name}: another name in Python, from the label '{item.label}'"


def check_defaults(folder):
    for cls, proxy in present(folder):
        made = cls()
        for item in proxy.properties.values():
            if item.is_information or item.default is None:
                continue
            actual = getattr(made, "G" + item.command[1:])()
            if (actual if actual is not None else "") != item.default:
                yield f"{proxy.name}.{item.name}: {item.default!r} in the XML, {actual!r} in C++"


def check_ranges(folder):
    for cls, proxy in present(folder):
        made = cls()
        for item in proxy.properties.values():
            yield from enumeration_errors(made, proxy, item)
            if item.entries:
                continue
            for end, written in zip(("Min", "Max"), item.range()):
                limit = getattr(made, f"Get{item.name}{end}Value", None)
                unlimited = limit and abs(limit()) >= 2**31 - 1
                if limit and written != limit() and not (unlimited and written is None):
                    yield f"{proxy.name}.{item.name}: {end} {written} in the XML, {limit()} in C++"
        yield from decorator_errors(proxy)


def enumeration_errors(made, proxy, item):
    if not item.entries:
        return
    lowest, highest = getattr(made, f"Get{item.name}MinValue"), getattr(made, f"Get{item.name}MaxValue")
    if sorted(item.entries) != list(range(lowest(), highest() + 1)):
        yield f"{proxy.name}.{item.name}: the entries are not {lowest()} to {highest()}"
    for value, text in item.entries.items():
        choose = getattr(made, f"Set{item.name}To{text.replace(' ', '')}", None)
        if choose is None:
            yield f"{proxy.name}.{item.name}: no method for the entry '{text}'"
            continue
        choose()
        if getattr(made, "Get" + item.name)() != value:
            yield f"{proxy.name}.{item.name}: '{text}' is {getattr(made, 'Get' + item.name)()} in C++"


def decorator_errors(proxy):
    known = proxy.properties
    for element in proxy.elements:
        for decorator in element.iter("PropertyWidgetDecorator"):
            chosen = known.get(decorator.get("property"))
            values = (decorator.get("value") or decorator.get("values") or "").split()
            if chosen is None or not values or not set(map(int, values)) <= set(chosen.entries or {0: "", 1: ""}):
                yield f"{proxy.name}.{element.get('name')}: shown for {decorator.attrib}, which cannot be"


def check_ports(folder):
    for cls, proxy in present(folder):
        if proxy.element.tag == "WriterProxy":
            continue
        made = cls()
        inputs = {int(e.get("port_index", 0)): e for e in proxy.all("InputProperty")}
        if sorted(inputs) != list(range(made.GetNumberOfInputPorts())):
            yield f"{proxy.name}: inputs {sorted(inputs)}, but the class has {made.GetNumberOfInputPorts()} ports"
            continue
        for port, element in inputs.items():
            information = made.GetInputPortInformation(port)
            optional = bool(information.Get(vtkAlgorithm.INPUT_IS_OPTIONAL()))
            if optional != (element.find("Hints/Optional") is not None):
                yield f"{proxy.name}.{element.get('name')}: optional in one place only"
            wanted = information.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)
            if [e.get("value") for e in element.iterfind("DataTypeDomain/DataType")] != [wanted]:
                yield f"{proxy.name}.{element.get('name')}: the class needs {wanted}"
        outputs = len(list(proxy.all("OutputPort"))) or 1
        if outputs != made.GetNumberOfOutputPorts():
            yield f"{proxy.name}: {outputs} outputs, but the class has {made.GetNumberOfOutputPorts()}"


def help_errors(where, documentation, needs_long):
    if documentation is None:
        yield f"{where}: no documentation"
        return
    attributes = ("short_help", "long_help") if needs_long else ("short_help",)
    for attribute in attributes:
        if not documentation.get(attribute):
            yield f"{where}: no {attribute}"
    text = documentation.text or ""
    if "To be written" in text or not re.search(r"\w.*\.\s*$", text, flags=re.S):
        yield f"{where}: no sentence of help"


def check_help(folder):
    for proxy in proxies.load(folder).values():
        if not proxy.is_internal:
            yield from help_errors(proxy.name, proxy.element.find("Documentation"), True)
        for element in proxy.elements:
            if element.tag.endswith("Property"):
                yield from help_errors(f"{proxy.name}.{element.get('name')}", element.find("Documentation"), False)


def main():
    violations = sorted(set(globals()["check_" + sys.argv[1]](sys.argv[2])))
    print("\n".join(violations))
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
