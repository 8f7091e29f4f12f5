"""From a cortical surface to flat maps in ParaView: pictures and a state file.

    pvbatch flatten.py --plugin Authalic.so [--surface FILE [--cortex FILE]] [--faces N] [--out DIR]

Copy this file and change it: it is one ParaView pipeline,

    SurfaceFileReader -> CutToDisk -> BarycentricMap (mean value), and
                                   -> AuthalicMap (area-preserving) -> ElementGrid

and every proxy of it is also in the menu Filters > Authalic. Without --surface it takes the left hemisphere that
pipelines/cortex/run.sh left in out/cortex, else it extracts one from the 1 mm T1 of Debian's mricron-data.
"""
import argparse
import pathlib
import sys

from paraview.simple import *  # noqa: F403  ParaView's way; LoadPlugin adds the proxies of the plugin

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import scene  # noqa: E402
from open_state import describe  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
FROM_MAIN_JOB = ROOT / "out/cortex/lh/white.vtp"
TEMPLATES = pathlib.Path("/usr/share/mricron/templates")  # of Debian's mricron-data
FACES = 80000  # per hemisphere, where one is extracted
MEDIAL_SHARE = 0.08  # of the width of the hemisphere lies beyond the plane that opens it


def read_arguments():
    parser = argparse.ArgumentParser(prog="pipelines/paraview/run.sh", description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--surface", type=pathlib.Path, metavar="FILE",
                        help="a white surface of one hemisphere, closed, or a disk")
    parser.add_argument("--cortex", type=pathlib.Path, metavar="FILE",
                        help="label of its cortex (lh.cortex.label); without it a plane near the midline opens it")
    parser.add_argument("--faces", type=int, default=FACES, metavar="N", help="triangles of an extracted surface")
    parser.add_argument("--elements", type=int, default=400, metavar="N", help="elements of equal area")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/paraview", metavar="DIR")
    return parser.parse_args()


def results(proxy, *names):
    """Values of information properties after an update; ends the run when the filter failed."""
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    if proxy.SMProxy.GetProperty("ErrorKind").GetElement(0) not in (0, 4):  # 4: not converged, with a map
        sys.exit(1)  # ParaView has said why
    return [proxy.SMProxy.GetProperty(name).GetElement(0) for name in names]


def extract(folder, faces):
    """The left white surface of the 1 mm T1 of mricron-data, in a file."""
    t1, labels = TEMPLATES / "ch2bet.nii.gz", TEMPLATES / "aal.nii.gz"
    if not t1.exists():
        sys.exit(f"{t1} is not there: install the Debian package mricron-data, or give --surface FILE.")
    surfaces = CorticalSurface(Input=VolumeFileReader(FileName=str(t1)),
                               Labels=VolumeFileReader(FileName=str(labels)), TargetFaces=faces)
    results(surfaces)
    path = folder / "lh.white.vtp"
    SaveData(str(path), proxy=OutputPort(surfaces, 0))
    return path


def opened(surface, cortex):
    """The surface as a disk: it is one already, or its cortex is kept, or what lies beyond a plane goes."""
    (summary,) = results(SurfaceTopologyReport(Input=surface), "Summary")
    if "genus 0, 1 boundary loop" in summary:
        return surface
    if cortex:
        labelled = VertexDataReader(Input=surface, FileName=str(cortex), ArrayName="Cortex")
        results(labelled)
        return CutToDisk(Input=labelled, RegionArrayName="Cortex", KeepRegion=1)
    if surface.PointData.GetArray("MedialWall"):
        return CutToDisk(Input=surface, RegionArrayName="MedialWall")
    low, high = surface.GetDataInformation().GetBounds()[:2]
    inward = 1 if low + high < 0 else -1
    medial = (high if inward > 0 else low) - inward * MEDIAL_SHARE * (high - low)
    return CutToDisk(Input=surface, RegionMode="Plane", PlaneOrigin=[medial, 0, 0], PlaneNormal=[inward, 0, 0])


def main():
    arguments = read_arguments()
    arguments.out.mkdir(parents=True, exist_ok=True)
    LoadPlugin(arguments.plugin, remote=False, ns=globals())
    path = arguments.surface or (FROM_MAIN_JOB if FROM_MAIN_JOB.exists() else extract(arguments.out, arguments.faces))
    surface = SurfaceFileReader(registrationName="Surface", FileName=str(path.resolve()))
    results(surface)
    disk = opened(surface, arguments.cortex)
    RenameSource("Disk", disk)
    results(disk)
    angles = BarycentricMap(registrationName="MeanValueMap", Input=disk)
    areas = AuthalicMap(registrationName="AreaPreservingMap", Input=disk)
    for map_ in (angles, areas):
        results(map_)
        print(f"{scene.TITLES[map_ is areas]}: {describe(map_)}", flush=True)
    elements = ElementGrid(registrationName="Elements", Input=areas, NumberOfElements=arguments.elements)
    results(elements)
    SaveData(str(arguments.out / "map.vtp"), proxy=OutputPort(elements, 0))
    scene.draw(surface, angles, elements, arguments.out)
    state = arguments.out / "flattened.pvsm"
    SaveState(str(state))
    folder = pathlib.Path(arguments.plugin).resolve().parents[1]
    print(f"Open it with:  PV_PLUGIN_PATH={folder} paraview --state={state.resolve()}", flush=True)


main()
