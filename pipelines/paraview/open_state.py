"""Opens a state file that flatten.py left and says what its maps measure, as the GUI would show them.

    pvpython open_state.py --plugin Authalic.so --state flattened.pvsm
"""
import argparse

from paraview import simple

NAMES = {"Mean-value map": "MeanValueMap", "Area-preserving map": "AreaPreservingMap"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--state", required=True)
    arguments = parser.parse_args()
    simple.LoadPlugin(arguments.plugin, remote=False, ns=globals())
    simple.LoadState(arguments.state)
    for title, name in NAMES.items():
        print(f"{title}: {describe(simple.FindSource(name))}", flush=True)


def describe(map_):
    """Status, distortions and folded faces of a map, in one line."""
    map_.UpdatePipeline()
    map_.UpdatePropertyInformation()
    status, area, angle, folded = (map_.SMProxy.GetProperty(name).GetElement(0) for name in (
        "Status", "TotalAreaDistortion", "TotalAngleDistortion", "FlippedFaces"))
    return f"{status}, D_area {area:.6g}, D_angle {angle:.4g}, {folded} folded faces"


if __name__ == "__main__":
    main()
