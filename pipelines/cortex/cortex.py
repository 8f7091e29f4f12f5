#!/usr/bin/python3
"""The main job: from a T1 MRI to area-preserving flat maps of the cortex with statistics per element.

    cortex.py [--t1 FILE [--labels FILE] | --surface FILE] [--fast] [--out DIR] …  (--help says all)

Copy this file and change it: it is one VTK pipeline per hemisphere,

    vtkVolumeFileReader -> vtkCorticalSurface -> SulcalDepth -> vtkSampleVolumeOnSurface -> vtkLabelsOnSurface
        -> vtkCutToDisk -> vtkBarycentricMap, vtkAuthalicMap -> UprightMap -> vtkElementGrid
        -> vtkElementStatistics

Every filter is an ordinary VTK filter; the files beside this one draw pictures and write reports.
"""
import sys

import authalic

import arrays
import given
import options as command_line
import outputs
import steps
from hemisphere import AUTHALIC, INITIAL, SIDES, Hemisphere
from render import Display
from stages import StageError, Stages

FAST_FACES = 80000  # triangles per hemisphere with --fast
FACES = 140000  # per hemisphere at 0.5 mm


def read_volume(path, name, stages):
    reader = authalic.vtkVolumeFileReader()
    reader.SetFileName(str(path))
    stages.run(f"reading the {name}", reader)
    return reader


def extract(t1, labels, options):
    """The white surfaces: output port 0 is the left hemisphere, 1 the right."""
    surfaces = authalic.vtkCorticalSurface()
    surfaces.SetTargetFaces(options.faces or (FAST_FACES if options.fast else FACES))
    surfaces.SetInputConnection(0, t1.GetOutputPort())
    if labels is not None:
        surfaces.SetInputConnection(1, labels.GetOutputPort())
    return surfaces


def sample(surface, volume, name):
    """A volume read at every vertex of a surface."""
    sampler = authalic.vtkSampleVolumeOnSurface()
    sampler.SetInputConnection(0, surface)
    sampler.SetInputConnection(1, volume.GetOutputPort())
    sampler.SetArrayName(name)
    return sampler


def sample_along_normal(surface, volume, name, depths):
    """The mean along the normal; depths = (from, to, step) in mm, inward positive."""
    sampler = sample(surface, volume, name)
    sampler.SetModeToAlongNormal()
    sampler.SetDepthFrom(depths[0])
    sampler.SetDepthTo(depths[1])
    sampler.SetDepthStep(depths[2])
    return sampler


def grid(map_, options):
    """Squares on the domain, pulled back to the cortex."""
    elements = authalic.vtkElementGrid()
    elements.SetInputConnection(map_.GetOutputPort())
    if options.elements:
        elements.SetNumberOfElements(options.elements)
    if options.element_area:
        elements.SetElementArea(options.element_area)
    return elements


def statistics(elements, side, fields, names):
    """Tables per element (port 0) and per region (port 1)."""
    tables = authalic.vtkElementStatistics()
    tables.SetInputConnection(elements.GetOutputPort())
    tables.SetHemisphere(side[0].upper())
    for name, unit, meaning in fields:
        tables.AddFieldArray(name, unit, meaning)
    if names:
        tables.SetLabelArrayName("Label")
        for label, name in names.items():
            tables.AddRegion(label, name)
    return tables


def with_labels(surface, labels):
    """The point array Label: the nearest labelled voxel of every vertex."""
    label = authalic.vtkLabelsOnSurface()
    label.SetInputConnection(0, surface.GetOutputPort())
    label.SetInputConnection(1, labels.GetOutputPort())
    return label


def fields_of(surface, t1):
    """Reads the T1 at and around the surface: the last filter, and (array, unit, meaning) of each field."""
    fields = [("sulcal_depth", "mm", "depth below the surface without its folds; sulci positive")]
    if t1 is None:
        return surface, fields
    at_vertex = sample(surface.GetOutputPort(), t1, "t1")
    cortex = sample_along_normal(at_vertex.GetOutputPort(), t1, "t1_cortex", (-2.5, 0, 0.5))
    inward = sample_along_normal(cortex.GetOutputPort(), t1, "t1_inward", (0, 10, 1))
    return inward, fields + [("t1", "", "T1 signal at the vertex"),
                             ("t1_cortex", "", "T1 signal, mean of 0 to 2.5 mm outward: the cortex"),
                             ("t1_inward", "", "T1 signal, mean of 0 to 10 mm along the inward normal")]


def process(side, source, volumes, names, options, stages):
    """The pipeline of one hemisphere; `source` = (filter, port) of its surface, with the array MedialWall."""
    def run(name, filter_):
        return stages.run(f"{side}: {name}", filter_)

    white = source[0].GetOutputPort(source[1])
    topology = authalic.vtkSurfaceTopologyReport()
    topology.SetInputConnection(white)
    depth = steps.SulcalDepth()
    depth.SetInputConnection(white)
    sampled, fields = fields_of(depth, volumes["T1"])
    if volumes["labels"]:
        sampled = with_labels(sampled, volumes["labels"])
    cut = given.cut(sampled, side, options) if options.surface else authalic.vtkCutToDisk()
    cut.SetInputConnection(sampled.GetOutputPort())
    tutte = authalic.vtkBarycentricMap()
    tutte.SetInputConnection(cut.GetOutputPort())
    tutte.SetMethodToTutte()
    exact = authalic.vtkAuthalicMap()
    exact.SetInputConnection(cut.GetOutputPort())

    hemisphere = Hemisphere(side, arrays.field_numbers(run("topology", topology)), fields)
    run("sulcal depth", depth)
    hemisphere.white = run("sampling the volume", sampled)
    hemisphere.regions = hemisphere.names_present(names)
    hemisphere.cut = arrays.field_numbers(run("cut to a disk", cut))
    for name, method in ((INITIAL, tutte), (AUTHALIC, exact)):
        run(name, method)
        upright = steps.UprightMap()
        upright.SetInputConnection(method.GetOutputPort())
        elements = grid(upright, options)
        run(f"elements of the {name}", elements)
        hemisphere.keep(name, elements)
        tables = statistics(elements, side, fields, hemisphere.regions)
        run(f"statistics of the {name}", tables)
        hemisphere.tables[name] = tables
    return hemisphere


def surfaces(volumes, options, stages):
    """{side: (filter, output port) of the white surface}."""
    if options.surface:
        return given.surface(options, stages)
    extraction = extract(volumes["T1"], volumes["labels"], options)
    stages.run("white surfaces of both hemispheres", extraction)
    return {side: (extraction, port) for port, side in enumerate(SIDES)}


def main(arguments=None):
    options = command_line.parse(arguments)
    stages = Stages(command_line.count_stages(options), options.threads)
    try:
        volumes = {name: read_volume(path, name, stages) if path else None
                   for name, path in (("T1", options.t1), ("labels", options.labels))}
        sources = surfaces(volumes, options, stages)
        names = command_line.label_names(options.label_names)
        results = [process(side, source, volumes, names, options, stages) for side, source in sources.items()]
        with Display(not options.no_pictures) as display:
            page = outputs.write(results, options, stages, display.available)
    except StageError as failure:
        print(f"cortex.py: {failure}", file=sys.stderr)
        return failure.code
    except OSError as failure:
        print(f"cortex.py: {failure.strerror}: {failure.filename}.", file=sys.stderr)
        return 5
    print(f"Done in {stages.summary()}.", file=sys.stderr)
    print(page)
    return 0 if stages.converged else 4


if __name__ == "__main__":
    sys.exit(main())
