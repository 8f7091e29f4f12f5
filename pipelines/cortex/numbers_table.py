"""The tables of index.html: key numbers, seconds, inputs and files."""
from hemisphere import AUTHALIC, INITIAL, SIDES


def tables(results, options, stages, versions):
    return [key_numbers(results), seconds(stages), provenance(options, versions), files(results, options)]


def key_numbers(results):
    """One column per hemisphere."""
    rows = [[name, *(value(hemisphere) for hemisphere in results)] for name, value in ROWS]
    return "Key numbers", ["", *(SIDES[h.side] for h in results)], rows


def _white(name):
    return lambda hemisphere: hemisphere.topology.get(name, "n/a")


def _cut(name):
    return lambda hemisphere: hemisphere.cut.get(name, "n/a")


def _map(map_, name, factor=1):
    def value(hemisphere):
        number = hemisphere.numbers(map_).get(name, "n/a")
        return number * factor if factor != 1 and number != "n/a" else number
    return value


ROWS = [
    ("white surface, vertices", _white("VertexCount")),
    ("white surface, triangles", _white("FaceCount")),
    ("white surface, area in mm²", _white("SurfaceArea")),
    ("white surface, genus", _white("Genus")),
    ("mapped cortex, area in mm²", _cut("KeptArea")),
    ("medial wall, area in mm²", _cut("RemovedArea")),
    ("area distortion (ideal 2), initial map", _map(INITIAL, "TotalAreaDistortion")),
    ("area distortion (ideal 2), area-preserving map", _map(AUTHALIC, "TotalAreaDistortion")),
    ("angle distortion (ideal 2), initial map", _map(INITIAL, "TotalAngleDistortion")),
    ("angle distortion (ideal 2), area-preserving map", _map(AUTHALIC, "TotalAngleDistortion")),
    ("flipped triangles, initial map", _map(INITIAL, "FlippedFaces")),
    ("flipped triangles, area-preserving map", _map(AUTHALIC, "FlippedFaces")),
    ("elements", _map(AUTHALIC, "Elements")),
    ("whole elements: largest deviation from equal area in %, initial map",
     _map(INITIAL, "InteriorMaximumDeviation", 100)),
    ("whole elements: largest deviation from equal area in %, area-preserving map",
     _map(AUTHALIC, "InteriorMaximumDeviation", 100)),
    ("whole elements: mean deviation from equal area in %, initial map", _map(INITIAL, "InteriorMeanDeviation", 100)),
    ("whole elements: mean deviation from equal area in %, area-preserving map",
     _map(AUTHALIC, "InteriorMeanDeviation", 100)),
    ("solve: status", _map(AUTHALIC, "Status")),
    ("solve: steps", _map(AUTHALIC, "Iterations")),
    ("solve: largest |ln| of a vertex's share over its target", _map(AUTHALIC, "VertexResidual")),
]


def seconds(stages):
    rows = [[name, float(value)] for name, value in stages.seconds.items()]
    return "Seconds per stage", ["stage", "s"], [*rows, ["whole job", stages.summary()]]


def provenance(options, versions):
    import outputs
    rows = [[name, str(path)] for name, path in outputs.inputs(options).items()]
    return "Inputs and versions", ["", ""], [*rows, *([name, version] for name, version in versions.items())]


FILES = [
    ("white.surf.gii, white.vtp", "the closed white surface, scanner RAS mm; the .vtp with every sampled array"),
    ("flat.surf.gii", "the flat map in mm with all vertices of the white surface in their order; medial wall without "
                      "faces, its vertices parked on the rim"),
    ("map.vtp", "the map: points on the unit disk, OriginalPoints, OriginalPointIds, distortion per triangle, fields"),
    ("*.func.gii", "sampled fields per vertex of the white surface"),
    ("elements.tsv, elements.json", "one row per element: place, area, majority region, statistics of every field"),
    ("elements_initial.tsv, elements_initial.json", "the same grid on the initial map, for comparison"),
    ("regions.tsv, regions.json", "the same statistics per region of the atlas"),
    ("elements.label.gii, regions.label.gii", "element and region of each vertex"),
    ("report.json", "every number of this page, inputs with checksums, options, versions"),
]


def files(results, options):
    where = " and ".join(str(options.out / h.side) for h in results)
    return f"Files in {where}", ["file", "what"], [list(row) for row in FILES]
