#!/usr/bin/python3
"""The tables of docs/formats.md against what `convert` and `info` do.

    test_format_table.py --authalic PROGRAM --fixtures FOLDER --data FOLDER
"""
import pathlib
import struct

from command_line import main
from format_files import Formats

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs/formats.md"
TESTING = pathlib.Path(__file__).resolve().parents[1]
# What convert says is lost: the word for it in the tables.
LOST = {"Arrays are not kept": "arrays", "Names of overlays": "names of arrays", "coordinates are": "space",
        "volume geometry": "volume geometry", "Metadata": "metadata",
        "Coordinates are rounded": "64-bit coordinates",
        "order of the vertices": "order of vertices", "Names and colours of the regions": "regions",
        "name of the array": "name of the array", "structure is not kept": "structure", "become label 0": "-1",
        "Numbers of the affine": "64-bit affine", "its space is": "kind of space",
        "Parts of the header": "header notes"}


def tables():
    """Rows of the three tables of the page: {heading: [{column: cell}]}."""
    found, heading, columns = {}, None, None
    for line in DOCS.read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            heading, columns = line[3:], None
        elif line.startswith("|") and heading in ("Surfaces", "Values per vertex", "Volumes"):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if columns is None and "format" in cells:
                columns = cells
                found[heading] = []
            elif columns and not set(line) <= set("|-"):
                found[heading].append(dict(zip(columns, cells)))
        else:
            columns = None
    return found


class Table(Formats):
    """The tables of docs/formats.md against what the command does."""

    def rich_surface(self):
        """Everything that a file can lose: arrays, regions, metadata, geometry, digits, a space that is known."""
        metadata = {"AnatomicalStructurePrimary": "CortexLeft", "GeometricType": "Anatomical"}
        numbers = (64, 72, 80, 1.5, 1, 0.75, -0.8, 0.6, 0, 0, 0, -1, 0.6, 0.8, 0, 3.5, -20.25, 7)
        names = ["Width", "Height", "Depth", "Xsize", "Ysize", "Zsize", *(a + "_" + r for a in "XYZC" for r in "RAS")]
        metadata |= {"VolGeom" + name: str(number) for name, number in zip(names, numbers)}
        pairs = "".join(f"<MD><Name>{name}</Name><Value>{value}</Value></MD>" for name, value in metadata.items())
        array = ('<DataArray Intent="NIFTI_INTENT_{}" DataType="NIFTI_TYPE_{}" ArrayIndexingOrder="RowMajorOrder" '
                 'Dimensionality="2" Dim0="{}" Dim1="3" Encoding="ASCII" Endian="LittleEndian">{}<Data>{}</Data>'
                 '</DataArray>')
        space = ("<CoordinateSystemTransformMatrix><DataSpace>NIFTI_XFORM_SCANNER_ANAT</DataSpace><TransformedSpace>"
                 "NIFTI_XFORM_SCANNER_ANAT</TransformedSpace></CoordinateSystemTransformMatrix>")
        points = " ".join(repr(x + 1 / 3) for p in self.points for x in p)
        faces = " ".join(str(i) for f in self.faces for i in f)
        self.path("rich.surf.gii").write_text(
            '<?xml version="1.0"?><GIFTI Version="1.0" NumberOfDataArrays="2">' +
            array.format("POINTSET", "FLOAT64", len(self.points), f"<MetaData>{pairs}</MetaData>{space}", points) +
            array.format("TRIANGLE", "INT32", len(self.faces), "", faces) + "</GIFTI>")
        self.annot("lh.parts.annot")
        self.path("lh.some.label").write_text("#!ascii label\n1\n4 0 0 0 0\n")
        self.succeeds("convert", "rich.surf.gii", "rich.vtp", "-q", "--data", "lh.parts.annot", "lh.some.label")
        ids = struct.pack(">ii", -1, 81) + b"".join(struct.pack(">i3f", i + 1, *p) for i, p in enumerate(self.points))
        self.path("all.patch.3d").write_bytes(ids)
        self.succeeds("convert", "all.patch.3d", "patch.vtp", "-q", "--whole", "rich.surf.gii", "--data",
                      "lh.parts.annot", "--space", "scanner-ras")  # in tkRAS its coordinates then have more digits

    def rich_volume(self):
        """An oblique qform of MNI space, a description."""
        header = bytearray(352)
        struct.pack_into("<i", header, 0, 348)
        struct.pack_into("<8h", header, 40, 3, 2, 3, 4, 1, 1, 1, 1)
        struct.pack_into("<hh", header, 70, 4, 16)
        struct.pack_into("<4f", header, 76, 1, 2, 2.5, 3)
        struct.pack_into("<f", header, 108, 352)
        header[123], header[148:152] = 2, b"mine"
        struct.pack_into("<hh6f", header, 252, 4, 0, 0.1, 0.2, 0.3, 5, 6, 7)
        header[344:348] = b"n+1\0"
        self.path("rich.nii").write_bytes(bytes(header) + struct.pack("<24h", *range(24)))

    def lost(self, *words):
        """The words of the table for what convert says, or None when it refuses."""
        result = self.run_verb("convert", *words)
        if result.returncode:
            self.assertIn(result.returncode, (2, 5), result.stderr)
            return None
        lines = [line for line in result.stderr.splitlines() if " lost in " in line]
        return {next(word for start, word in LOST.items() if start in line) for line in lines}

    def words_for(self, heading, name):
        """What to convert to that name."""
        if heading == "Volumes":
            return "rich.nii", name
        if heading == "Surfaces":
            return "patch.vtp" if ".patch." in name else "rich.vtp", name
        return "rich.vtp", name, "--array", "some" if name.endswith(".label") else "parts"

    def test_every_name_is_written_or_refused_and_loses_what_its_row_says(self):
        self.rich_surface()
        self.rich_volume()
        rows = tables()
        self.assertEqual([len(rows[heading]) for heading in ("Surfaces", "Values per vertex", "Volumes")], [11, 11, 4])
        tried = 0
        for heading, found in rows.items():
            for row in found:
                for name in (part.strip("` ") for part in row["name"].split(",") if part.strip().startswith("`")):
                    if name.startswith("."):
                        continue  # an ending that is read in place of the others
                    tried += 1
                    lost = self.lost(*self.words_for(heading, name))
                    self.assertEqual(lost is not None, row["write"].startswith("✓"), f"{name}: {row['write']}")
                    said = {word.strip() for word in row["lost in writing"].split(",") if word.strip()}
                    self.assertEqual(lost or set(), said, name)
                    if lost is not None and row["read"].startswith("✓"):
                        whole = ["--whole", "rich.surf.gii"] if ".patch." in name else []
                        self.succeeds("info", name, *whole)
        self.assertGreater(tried, 25)

    def test_every_test_that_a_row_names_is_there(self):
        text = "".join(path.read_text(encoding="utf-8") for folder in ("cli", "formats", "vtk")
                       for path in sorted((TESTING / folder).glob("*.*")) if path.suffix in (".cxx", ".py"))
        for row in (row for found in tables().values() for row in found):
            named = [part.strip("` ") for part in row["tests"].split(",")]
            self.assertTrue(named[0], row)
            for name in named:
                wanted = f"def {name}(" if name.startswith("test_") else f"({name.replace('.', ', ')})"
                self.assertIn(wanted, text, row["format"])


if __name__ == "__main__":
    main("test_format_table.py")
