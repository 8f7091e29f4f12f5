#!/usr/bin/python3
"""Under two processes of pvbatch a surface is gathered before it is examined or mapped; failures end on both.

    check_distributed.py ROOT
"""
import json
import math
import sys

from plugin_build import PluginBuild


def violations(result):
    def differ(what, actual, expected):
        return [] if actual == expected else [f"{what}: {actual} instead of {expected}"]

    for name in ("spread pieces", "sphere pieces"):
        if len(result[name]) != 2 or min(result[name]) == 0:
            yield f"{name}: {result[name]}, not on both processes: nothing was tested"
    yield from differ("the spread disk", result["spread summary"], result["disk summary"])
    yield from differ("the sphere", result["sphere summary"],
                      ["1 component, Euler characteristic 2, genus 0, 0 boundary loops"])
    yield from differ("points of the map", sum(result["joined map pieces"]), sum(result["disk pieces"]))
    yield from differ("processes of the map", len(result["joined map pieces"]), 1)
    (status, *numbers), (wanted_status, *wanted) = result["joined map"], result["whole map"]
    yield from differ("status of the map", status, wanted_status)
    # Vertices come in another order and the disk is turned; what is measured does not depend on either.
    if not all(math.isclose(a, b, rel_tol=1e-6) for a, b in zip(numbers, wanted)):
        yield f"the map of the spread disk measures {numbers} instead of {wanted}"
    yield from differ("a map of a closed surface", result["refused"], ["", 3])


def main():
    text = PluginBuild(sys.argv[1]).run("mpi", "distribute_in_paraview.py")
    line = next(line for line in text.splitlines() if line.startswith("RESULT "))
    found = list(violations(json.loads(line[len("RESULT "):])))
    if "A topological disk is required" not in text:
        found.append("the refusal is not in words:\n" + text)
    print(line)
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
