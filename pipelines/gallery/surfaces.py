"""What the scripts of the gallery start from: a disk of cortex out of the files that a user has."""
import pathlib
import sys

import numpy as np

import authalic

FIXTURES = pathlib.Path(__file__).resolve().parents[2] / "data"


def say(kind, failure, trace):
    """A failure of authalic in its one sentence, anything else with its trace."""
    if isinstance(failure, authalic.Error):
        print(f"{pathlib.Path(sys.argv[0]).name}: {failure}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, failure, trace)


sys.excepthook = say


def add_options(parser):
    """--surface, --region, --values, --keep and --out, as in `authalic cut`."""
    parser.add_argument("--surface", default=FIXTURES / "folded_sphere.off", type=pathlib.Path,
                        help="closed surface: FreeSurfer, GIFTI, OFF ... (default: a folded sphere)")
    parser.add_argument("--region",
                        metavar="ARRAY|FILE",
                        help="what is cut off: a point array, or a .label, .annot, .label.gii; "
                        "without it, what lies beyond a plane near the midline")
    parser.add_argument("--values", nargs="*", default=[], help="labels or names of regions of the file")
    parser.add_argument("--keep", action="store_true", help="the region is what to keep: FreeSurfer's cortex.label")
    parser.add_argument("--space", default="as-stated", help="scanner-ras where the file does not say that it is")
    parser.add_argument("--out",
                        type=pathlib.Path,
                        default=pathlib.Path("out/gallery"),
                        help="folder (default: %(default)s)")


def disk(options):
    """Reads the surface and opens it."""
    options.out.mkdir(parents=True, exist_ok=True)
    surface = authalic.read_surface(options.surface, options.space)
    if options.region:
        region = options.region
        if region not in surface.point_arrays:
            surface, region = authalic.read_vertex_data(region, surface, name="Region"), "Region"
        values = [int(value) if value.lstrip("-").isdigit() else value for value in options.values]
        return authalic.cut_to_disk(surface, region=region, values=values, keep=options.keep)
    x = surface.points[:, 0]
    inward = 1.0 if x.mean() <= 0 else -1.0
    beyond = (inward * x).max() - 0.08 * np.ptp(x)
    return authalic.cut_to_disk(surface, plane=((inward * beyond, 0, 0), (inward, 0, 0)))


def lateral(surface):
    """The direction in which one looks at the outer side of a hemisphere."""
    return (1, 0, 0) if surface.points[:, 0].mean() <= 0 else (-1, 0, 0)
