"""The XML of the plugin, as plain Python: proxies with what they inherit, and their properties."""
import pathlib
import xml.etree.ElementTree as ElementTree

PROPERTIES = {"IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty"}


class Property:
    def __init__(self, element):
        self.element, self.tag = element, element.tag
        self.name, self.command = element.get("name"), element.get("command")
        self.clean_command = element.get("clean_command")
        self.is_information = element.get("information_only") == "1"
        self.entries = {int(e.get("value")): e.get("text") for e in element.findall("EnumerationDomain/Entry")}
        self.label = element.get("label", self.name)

    @property
    def default(self):
        """The default as Python has it; None where there is none."""
        text = self.element.get("default_values")
        if text is None:
            return None
        if self.tag == "StringVectorProperty":
            return text
        numbers = tuple((int if self.tag == "IntVectorProperty" else float)(word) for word in text.split())
        return numbers[0] if self.element.get("number_of_elements", "1") == "1" else numbers

    def range(self):
        """(min, max) as written, None where open."""
        for domain in ("IntRangeDomain", "DoubleRangeDomain"):
            found = self.element.find(domain)
            if found is not None:
                return tuple(None if found.get(end) is None else float(found.get(end)) for end in ("min", "max"))
        return None, None


class Proxy:
    def __init__(self, group, element):
        self.group, self.element = group, element
        self.name, self.vtk_class = element.get("name"), element.get("class")
        self.elements = list(element)  # own, later with those of the bases in front

    @property
    def is_internal(self):
        return self.group.startswith("internal")

    @property
    def properties(self):
        return {e.get("name"): Property(e) for e in self.elements if e.tag in PROPERTIES}

    def all(self, path):
        """Elements below this proxy and its bases; `path` starts with the tag of a child."""
        tag, _, rest = path.partition("/")
        for element in self.elements:
            if element.tag == tag:
                yield from (element.iterfind(rest) if rest else [element])


def load(folder):
    """{(group, name): Proxy} of every XML file of the folder, bases resolved."""
    proxies, bases = {}, {}
    for path in sorted(pathlib.Path(folder).glob("*.xml")):
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            for element in group:
                proxy = Proxy(group.get("name"), element)
                proxies[proxy.group, proxy.name] = proxy
                bases[proxy] = (element.get("base_proxygroup"), element.get("base_proxyname"))

    def inherit(proxy):
        base = proxies.get(bases.pop(proxy, (None, None)))
        if base is not None:
            inherit(base)
            proxy.elements = base.elements + proxy.elements

    for proxy in proxies.values():
        inherit(proxy)
    return proxies
