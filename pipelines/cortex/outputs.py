"""The files that the job leaves, per hemisphere in a folder of its own, and the page that shows them."""
import hashlib
import json
import platform

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

import arrays
import authalic
import colours
import numbers_table
import report
import whole_file
from hemisphere import AUTHALIC, INITIAL, SIDES
from stages import StageError

LEAD = ("Each hemisphere's white surface was opened at the medial wall, mapped to a disk so that every vertex "
        "has exactly its share of area. Equal squares on that disk are elements of equal cortical area.")


def write(results, options, stages, can_draw):
    """Writes everything; returns the path of index.html."""
    options.out.mkdir(parents=True, exist_ok=True)
    shown = {}
    for hemisphere in results:
        folder = options.out / hemisphere.side
        folder.mkdir(exist_ok=True)
        with stages.stage(f"{hemisphere.side}: files"):
            write_data(hemisphere, folder)
        shown[hemisphere.side] = draw(hemisphere, folder, stages) if can_draw else {}
    for hemisphere in results:
        write_report(hemisphere, options, stages)
    page = options.out / "index.html"
    tables = numbers_table.tables(results, options, stages, versions())
    report.write(page, "Cortex: area-preserving maps", LEAD, tables, shown, stages.warnings)
    return page


def draw(hemisphere, folder, stages):
    import pictures  # rendering modules only where there is a display
    with stages.stage(f"{hemisphere.side}: pictures") as stage:
        return pictures.draw(hemisphere, folder, stage.progress)


def write_data(hemisphere, folder):
    """Surfaces, map, fields, tables and labels."""
    white = arrays.copy_of(hemisphere.white)
    structure = "Cortex" + SIDES[hemisphere.side].capitalize()
    annotate(white, AnatomicalStructurePrimary=structure, AnatomicalStructureSecondary="GrayWhite",
             GeometricType="Anatomical")
    write_surface(white, folder / "white.surf.gii")
    write_surface(white, folder / "white.vtp")
    flat = flat_surface(hemisphere)
    annotate(flat, AnatomicalStructurePrimary=structure, GeometricType="Flat", CoordinateSpace="unknown")
    write_surface(flat, folder / "flat.surf.gii")
    write_surface(hemisphere.flat, folder / "map.vtp")
    for name, _, _ in hemisphere.fields:
        write_values(white, name, folder / f"{name}.func.gii")
    write_labels(hemisphere, white, folder)
    for name, suffix in ((AUTHALIC, ""), (INITIAL, "_initial")):
        tables = hemisphere.tables[name]
        check(tables.WriteElements(str(folder / f"elements{suffix}.tsv")), tables, folder)
    if hemisphere.regions:
        check(tables.WriteRegions(str(folder / "regions.tsv")), tables, folder)


def flat_surface(hemisphere):
    """The map in mm, in the vertex order of the white surface: vertices that are not mapped sit at the image of
    the nearest vertex of the rim, and the faces of the medial wall are gone."""
    flat, ids = hemisphere.flat, hemisphere.original_ids()
    rim = rim_vertices(flat)
    locator = vtkStaticPointLocator()
    native_rim = arrays.with_points(vtkPolyData(), arrays.point_array(flat, "OriginalPoints")[rim])
    locator.SetDataSet(native_rim)
    locator.BuildLocator()
    white = arrays.points(hemisphere.white)
    image = np.zeros_like(white)
    image[ids] = arrays.points(flat)
    for vertex in np.setdiff1d(np.arange(len(white)), ids):
        image[vertex] = arrays.points(flat)[rim[locator.FindClosestPoint(white[vertex])]]
    return arrays.triangles(image * arrays.millimetres_per_unit(flat), ids[arrays.faces(flat)])


def rim_vertices(map_):
    """Vertices of the boundary loop."""
    numbered = arrays.copy_of(map_)
    arrays.add_point_array(numbered, "Vertex", np.arange(map_.GetNumberOfPoints()))
    edges = vtkFeatureEdges()
    edges.SetInputData(numbered)
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return np.sort(arrays.point_array(edges.GetOutput(), "Vertex"))


def write_labels(hemisphere, white, folder):
    """The element and the region of every vertex, with their names and colours."""
    elements = arrays.copy_of(white)
    arrays.add_point_array(elements, "Element", hemisphere.vertex_values("ElementId", 0).astype(np.int32))
    cells = hemisphere.cells[AUTHALIC]
    ids, first = np.unique(arrays.cell_array(cells, "ElementId"), return_index=True)
    centres = arrays.points(cells)[arrays.corners(cells)].mean(axis=1)[first, :2]
    name_labels(elements, "Element", ids, [f"element {k}" for k in ids],
                colours.domain_colours(centres, np.ones(len(ids))))
    write_values(elements, "Element", folder / "elements.label.gii")
    if hemisphere.regions:
        regions = arrays.copy_of(white)
        ids = np.array(sorted(hemisphere.regions))
        name_labels(regions, "Label", ids, [hemisphere.regions[k] for k in ids], colours.distinct(len(ids)))
        write_values(regions, "Label", folder / "regions.label.gii")


def name_labels(surface, array, ids, names, rgb):
    """Field data from which vtkVertexDataWriter makes the label table; 0 is no label."""
    words, keys = vtkStringArray(), vtkIntArray()
    words.SetName(array + "Names")
    keys.SetName(array + "Ids")
    for key, name in zip([0, *ids], ["???", *names]):
        words.InsertNextValue(name)
        keys.InsertNextValue(int(key))
    rgba = np.column_stack([rgb, np.full(len(rgb), 255)])
    tint = numpy_to_vtk(np.vstack([[255, 255, 255, 0], rgba]).astype(np.uint8), deep=1)
    tint.SetName(array + "Colors")
    for data in (words, keys, tint):
        surface.GetFieldData().AddArray(data)


def annotate(surface, **metadata):
    """Field data that the writers turn into GIFTI metadata."""
    for name, value in metadata.items():
        text = vtkStringArray()
        text.SetName(name)
        text.InsertNextValue(value)
        surface.GetFieldData().AddArray(text)


def write_surface(surface, path):
    writer = authalic.vtkSurfaceFileWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(path))
    check(writer.Write(), writer, path)


def write_values(surface, array, path):
    writer = authalic.vtkVertexDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(path))
    writer.AddArrayName(array)
    check(writer.Write(), writer, path)


def check(written, writer, path):
    if not written:
        raise StageError(f"{path} could not be written.", writer.GetErrorKind() or 5)


def write_report(hemisphere, options, stages):
    """report.json: everything but the member `seconds` is the same in two runs."""
    content = {
        "software": versions(),
        "hemisphere": hemisphere.side,
        "inputs": {name: {"file": str(path), "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}
                   for name, path in inputs(options).items()},
        "options": {"elements": options.elements, "element_area_mm2": options.element_area},
        "white": hemisphere.topology,
        "cut": hemisphere.cut,
        "fields": [{"name": name, "unit": unit, "meaning": meaning}
                   for name, unit, meaning in hemisphere.fields],
        "initial": hemisphere.numbers(INITIAL),
        "area_preserving": hemisphere.numbers(AUTHALIC),
        "warnings": stages.warnings,
        "note": report.NOTE,
        "seconds": stages.seconds,
    }
    path = options.out / hemisphere.side / "report.json"
    whole_file.write_text(path, json.dumps(content, indent=2, ensure_ascii=False) + "\n")


def inputs(options):
    """Files that went in, by option."""
    chosen = {"t1": options.t1, "labels": options.labels, "label_names": options.label_names,
              "surface": options.surface}
    return {name: path for name, path in chosen.items() if path is not None}


def versions():
    return {"authalic": authalic.__version__, "vtk": vtkVersion.GetVTKVersion(),
            "python": platform.python_version()}
