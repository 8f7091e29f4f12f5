#!/usr/bin/python3
"""The plugin hands its definitions to ParaView bases first: its window asks for them while they are read, and ends
where a base is not known yet.

    check_order.py ROOT
"""
import pathlib
import re
import sys

from plugin_build import PluginBuild


def definitions(binary):
    """(name, name of its base or None) of every proxy, in the order in which the plugin has them."""
    for tag in re.findall(rb"<(?:\w*Proxy) name=[^>]*>", binary):
        name, base = (re.search(attribute + rb'="([^"]*)"', tag) for attribute in (rb" name", rb"base_proxyname"))
        yield name[1].decode(), base[1].decode() if base else None


known, late, based = set(), [], 0
for proxy, base in definitions(pathlib.Path(PluginBuild(sys.argv[1]).plugin).read_bytes()):
    based += base is not None
    if base and base.startswith("Authalic") and base not in known:
        late.append(f"{proxy} comes before its base {base}")
    known.add(proxy)
if not based:
    late.append("no proxy with a base was found in the plugin")
print("\n".join(late) or f"{len(known)} proxies, {based} with a base")
sys.exit(bool(late))
