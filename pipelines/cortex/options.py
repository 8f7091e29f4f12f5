"""The options of the main job."""
import argparse
import os
import pathlib

TEMPLATES = pathlib.Path("/usr/share/mricron/templates")  # of Debian's mricron-data

DESCRIPTION = """From a T1 MRI to area-preserving flat maps of both hemispheres, with statistics per element.

Without --t1 and --surface the job runs on the T1 of Debian's package mricron-data (0.5 mm; 1 mm with
--fast) and its AAL labels. Everything goes to the folder --out; open its index.html. Nothing here is a
medical device."""


def parse(arguments=None):
    parser = argparse.ArgumentParser(
        prog="cortex.py", description=DESCRIPTION, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--t1", type=existing, metavar="FILE",
                        help="T1 volume, skull-stripped unless labels are given (NIfTI, MGH/MGZ)")
    parser.add_argument("--labels", type=existing, metavar="FILE", help="label volume in the space of the T1")
    parser.add_argument("--label-names", type=existing, metavar="FILE",
                        help="names of the labels: one 'number name' per line; "
                             "default: LABELS without .gz, with .txt")
    parser.add_argument("--surface", type=existing, metavar="FILE",
                        help="start from this white surface of one hemisphere (FreeSurfer, GIFTI, VTP); "
                             "no segmentation")
    parser.add_argument("--cortex", type=existing, metavar="FILE",
                        help="with --surface: its cortex (FreeSurfer .label, .annot, .label.gii); the rest is "
                             "the medial wall. Default: what lies beyond a plane near the midline is cut off")
    parser.add_argument("--hemisphere", choices=["lh", "rh"],
                        help="of --surface; default: from its file name, else from its side")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/cortex"), metavar="DIR",
                        help="folder for results (default: %(default)s)")
    parser.add_argument("--fast", action="store_true",
                        help="coarser surfaces, and the 1 mm T1 of mricron-data by default")
    parser.add_argument("--faces", type=positive, metavar="N",
                        help="triangles per hemisphere (140000; 80000 with --fast)")
    parser.add_argument("--elements", type=positive, metavar="N", help="elements per hemisphere")
    parser.add_argument("--element-area", type=float, metavar="MM2", help="area of an element instead of their number")
    parser.add_argument("--no-pictures", action="store_true", help="data only, no pictures and no index.html")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="0 = all; results do not depend on it")
    options = parser.parse_args(arguments)
    if options.t1 is None and options.surface is None:
        options.t1 = default_file(parser, "ch2bet.nii.gz" if options.fast else "ch2better.nii.gz")
        options.labels = options.labels or default_file(parser, "aal.nii.gz")
    if options.label_names is None and options.labels is not None:
        options.label_names = names_beside(options.labels)
    return options


def default_file(parser, name):
    path = TEMPLATES / name
    if not path.is_file():
        parser.error(f"{path} is not there: install the Debian package mricron-data, or give --t1 FILE.")
    return path


def names_beside(labels):
    path = labels.with_suffix(".txt") if labels.suffix == ".gz" else labels.with_suffix(labels.suffix + ".txt")
    return path if path.is_file() else None


def existing(text):
    path = pathlib.Path(text)
    if not path.is_file() or not os.access(path, os.R_OK):
        raise argparse.ArgumentTypeError(f"{text} is not a file that can be read")
    return path


def positive(text):
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a whole number above 0")
    return int(text)


def label_names(path):
    """{label: name} from lines 'number name …'; empty without a file."""
    if path is None:
        return {}
    rows = [line.split() for line in path.read_text(encoding="utf-8", errors="replace").splitlines()]
    return {int(row[0]): row[1] for row in rows if len(row) > 1 and row[0].lstrip("-").isdigit()}


def count_stages(options):
    """How many stages the job will have (see Stages)."""
    before = sum(1 for path in (options.t1, options.labels, options.cortex) if path) + 1
    each = 11 + (not options.no_pictures)
    return before + each * (1 if options.surface else 2)
