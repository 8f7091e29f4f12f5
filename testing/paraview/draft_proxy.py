#!/usr/bin/python3
"""A first draft of the XML of a class, from what its Python wrapping says; to be read and improved by hand.

    draft_proxy.py CLASS FOLDER > FOLDER/NAME.xml       CLASS without vtk; FOLDER holds the XML files
"""
import re
import sys
import textwrap
from xml.sax.saxutils import escape, quoteattr

import authalic
import check_proxies
import proxies
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

BASES = {"vtkDiskMapAlgorithm": "AuthalicDiskMapAlgorithm", "vtkSurfaceMapAlgorithm": "AuthalicSurfaceMapAlgorithm",
         "vtkSurfaceAlgorithm": "AuthalicSurfaceFilter"}
WIDTH = 115


def words(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def help_of(method):
    """The sentences of the header, without the signatures that the wrapper puts before them."""
    text = re.split(r"\n\s*\n", method.__doc__ or "", maxsplit=1)[-1]
    return " ".join(text.split()) or "To be written."


def about(cls):
    """What the class is in one sentence, and the first paragraph on it."""
    brief, *paragraphs = re.split(r"\n\s*\n", cls.__doc__)
    told = [" ".join(p.split()) for p in paragraphs if not p.startswith("Superclass") and "|" not in p]
    return " ".join(brief.split(" - ", 1)[-1].split()), told[0] if told else "To be written."


def element(tag, attributes, inner, text):
    head = f"      <{tag} "
    lines, line = [], head
    for name, value in attributes:
        part = f"{name}={quoteattr(str(value))}"
        if len(line) + len(part) > WIDTH:
            lines.append(line.rstrip())
            line = " " * len(head)
        line += part + " "
    lines.append(line.rstrip() + ">")
    short = text if len(text) < 80 else re.split(r"[:.;(]", text)[0] + "."
    paragraph = textwrap.fill(escape(text), WIDTH, initial_indent=" " * 10, subsequent_indent=" " * 10)
    return lines + inner + [f"        <Documentation short_help={quoteattr(short)}>", *paragraph.split("\n"),
                            "        </Documentation>", f"      </{tag}>"]


def domain(made, name, value):
    """(tag, lines of the domain) by the type of the default."""
    choices = [m for m in check_proxies.own_methods(type(made)) if m.startswith(f"Set{name}To")]
    if isinstance(value, bool):
        return "IntVectorProperty", ['        <BooleanDomain name="bool"/>']
    if isinstance(value, str):
        return "StringVectorProperty", []
    if choices:
        entries = {}
        for choice in choices:
            getattr(made, choice)()
            entries[getattr(made, "Get" + name)()] = words(choice[len(f"Set{name}To"):])
        lines = [f'          <Entry value="{k}" text="{entries[k]}"/>' for k in sorted(entries)]
        lines = ['        <EnumerationDomain name="enum">', *lines, "        </EnumerationDomain>"]
        return "IntVectorProperty", lines
    kind = "Int" if isinstance(value, int) else "Double"
    ends = ""
    for end in ("Min", "Max"):
        limit = getattr(made, f"Get{name}{end}Value", None)
        if limit is not None and abs(limit()) < 2**31 - 1:
            ends += f' {end.lower()}="{limit()}"'
    return f"{kind}VectorProperty", [f'        <{kind}RangeDomain name="range"{ends}/>']


def ports(cls):
    """Second and further inputs, and the outputs when there are several."""
    made = cls()
    for port in range(1, made.GetNumberOfInputPorts()):
        information = made.GetInputPortInformation(port)
        optional = bool(information.Get(vtkAlgorithm.INPUT_IS_OPTIONAL()))
        inner = ['        <ProxyGroupDomain name="groups">', '          <Group name="sources"/>',
                 '          <Group name="filters"/>', "        </ProxyGroupDomain>",
                 '        <DataTypeDomain name="input_type">',
                 f'          <DataType value="{information.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)}"/>',
                 "        </DataTypeDomain>"]
        if optional:
            inner += ["        <Hints>", "          <Optional/>", "        </Hints>"]
        attributes = [("name", f"Input{port}"), ("command", "SetInputConnection"), ("port_index", port),
                      ("null_on_empty", int(optional))]
        yield from element("InputProperty", attributes, inner, "To be written.")
    for port in range(made.GetNumberOfOutputPorts() if made.GetNumberOfOutputPorts() > 1 else 0):
        yield f'      <OutputPort name="Output {port}" index="{port}" id="port{port}"/>'


def properties(cls, inherited):
    made = cls()
    for command in check_proxies.setters(cls):
        if command in inherited or command.startswith("Add"):
            continue
        name = command[3:]
        value = getattr(cls(), "Get" + name)()
        value = "" if value is None else value
        tag, inner = domain(made, name, value)
        many = isinstance(value, tuple)
        default = " ".join(map(str, value)) if many else int(value) if isinstance(value, bool) else value
        attributes = [("name", name), ("command", command), ("number_of_elements", len(value) if many else 1),
                      ("default_values", default), ("label", words(name))]
        yield from element(tag, attributes, inner, help_of(getattr(cls, command)))
    for command in check_proxies.results(cls):
        if command not in inherited:
            value = getattr(made, command)()
            kind = {int: "Int", float: "Double"}.get(type(value), "String")
            attributes = [("name", command[3:]), ("command", command), ("number_of_elements", 1),
                          ("information_only", 1)]
            inner = [f"        <Simple{kind}InformationHelper/>"]
            yield from element(f"{kind}VectorProperty", attributes, inner, help_of(getattr(cls, command)))


def main():
    name, folder = sys.argv[1:3]
    cls = getattr(authalic, "vtk" + name)
    base = next(BASES[parent.__name__] for parent in cls.__mro__ if parent.__name__ in BASES)
    inherited = {p.command for p in proxies.load(folder)["internal_filters", base].properties.values()}
    brief, told = about(cls)
    print("<ServerManagerConfiguration>", '  <ProxyGroup name="filters">',
          f'    <SourceProxy name="{name}" class="vtk{name}" label="{words(name)}"',
          f'                 base_proxygroup="internal_filters" base_proxyname="{base}">',
          f"      <Documentation short_help={quoteattr(re.split('[.:;,]', brief)[0] + '.')}",
          f"                     long_help={quoteattr(brief)}>",
          textwrap.fill(escape(told), WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 8),
          "      </Documentation>", *ports(cls), *properties(cls, inherited), "      <Hints>",
          '        <ShowInMenu category="Authalic"/>', "      </Hints>", "    </SourceProxy>", "  </ProxyGroup>",
          "</ServerManagerConfiguration>", sep="\n")


if __name__ == "__main__":
    main()
