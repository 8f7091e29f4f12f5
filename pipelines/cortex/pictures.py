"""The pictures of one hemisphere. Each is one function: what is in it, where, at what size."""
import numpy as np

import arrays
import colours
import flatmap
import histograms
import scenes
from hemisphere import AUTHALIC, INITIAL
from render import Panel, picture

CONTOUR = (0.70, 0.09, 0.11)
DISTORTION_LIMIT = 2  # log2: a quarter to four times the area
AREA_UNIT = "log2 of (area on the map / area of the cortex); 0 = preserved"


def draw(hemisphere, folder, progress):
    """Every picture of a hemisphere: {name: path}. Calls progress(fraction) as it goes."""
    pictures = {"cortex": cortex, "flatmap": flat, "checkerboard": checkerboard, "distortion": distortion,
                "histograms": histogram, "field": element_field}
    paths = {}
    for done, (name, make) in enumerate(pictures.items()):
        paths[name] = folder / f"{name}.png"
        make(hemisphere, paths[name])
        progress((done + 1) / len(pictures))
    return paths


def cortex(hemisphere, path):
    """Lateral, medial and flat, coloured by place on the map, with the lines between the elements."""
    flat_map = hemisphere.flat
    shade = 0.40 + 0.70 * colours.sulcal_grey(depth(hemisphere))
    rgb = colours.domain_colours(arrays.points(flat_map)[:, :2], shade)
    lines = hemisphere.borders[AUTHALIC]
    flat_lines = arrays.with_points(lines, arrays.point_array(lines, "ImagePoints"))
    native = arrays.native(flat_map)
    panels = []
    for view, name, left in zip(scenes.views(hemisphere.white, hemisphere.side), ("lateral", "medial"), (0, 0.35)):
        props = [scenes.behind(scenes.surface_actor(hemisphere.white)), scenes.surface_actor(native, rgb),
                 scenes.line_actor(lines, 0.9), scenes.caption(name)]
        panels.append(Panel(props, (left, 0, left + 0.35, 1), view))
    chart = [scenes.surface_actor(flat_map, rgb, lit=False), scenes.line_actor(flat_lines, 0.9),
             scenes.caption("flat, every element of equal cortical area")]
    panels.append(Panel(chart, (0.70, 0, 1, 1), flatmap.view(flat_map, 1.17)))
    picture(panels, (1800, 560), path)


def flat(hemisphere, path):
    """The chart: sulcal shading, contours and names of the regions, compass and scale."""
    flat_map = hemisphere.flat
    props = [flatmap.shaded(flat_map, depth(hemisphere))]
    if hemisphere.regions:
        image = flatmap.label_image(flat_map, "Label")
        props.append(scenes.line_actor(flatmap.contours(image), 1.3, CONTOUR))
        props += flatmap.name_actors(flatmap.name_places(image), hemisphere.regions)
    scale = np.abs(arrays.points(flat_map)).max()
    props += flatmap.compass(flat_map, scale)
    props += flatmap.scale_bar(arrays.millimetres_per_unit(flat_map), scale)
    picture([Panel(props, (0, 0, 1, 1), flatmap.view(flat_map))], (1300, 1300), path)


def checkerboard(hemisphere, path):
    """Equal squares of each map, carried back to the cortex."""
    def props(map_):
        return [scenes.checker_actor(map_)]
    _four_views(hemisphere, props, path)


def distortion(hemisphere, path):
    """Area distortion of each map on the cortex, with one colour bar."""
    table = colours.diverging(DISTORTION_LIMIT)

    def props(map_):
        return [scenes.cell_actor(arrays.native(map_), "AreaDistortion", table)]
    _four_views(hemisphere, props, path, table, AREA_UNIT)


def _four_views(hemisphere, props, path, table=None, title=""):
    """The initial map above, the area-preserving one below; lateral left, medial right."""
    foot = 0.09 if table else 0.0
    height = (1 - foot) / 2
    panels = []
    for row, (name, map_) in enumerate(hemisphere.maps.items()):
        bottom = foot + (1 - row) * height
        for view, side, left in zip(scenes.views(hemisphere.white, hemisphere.side), ("lateral", "medial"), (0, 0.5)):
            words = scenes.caption(f"{name}, {side}")
            here = [scenes.behind(scenes.surface_actor(hemisphere.white)), *props(map_), words]
            panels.append(Panel(here, (left, bottom, left + 0.5, bottom + height), view))
    if table:
        bar = [scenes.colour_bar(table, (0.3, 0.05), (0.4, 0.55)), scenes.caption(title, y=0.66, size=18)]
        panels.append(Panel(bar, (0, 0, 1, foot), None))
    picture(panels, (1500, 1240 if table else 1130), path)


def histogram(hemisphere, path):
    """Areas and angles of the faces and areas of the elements, before and after."""
    colour = {INITIAL: histograms.BEFORE, AUTHALIC: histograms.AFTER}
    weights = arrays.face_areas(arrays.native(hemisphere.flat))

    def series(array):
        return [(name, np.nan_to_num(arrays.cell_array(map_, array)), colour[name])
                for name, map_ in hemisphere.maps.items()]
    ratios = [(name, hemisphere.element_ratios(name), colour[name]) for name in hemisphere.maps]
    charts = [
        histograms.histogram_actor(series("AreaDistortion"), weights, np.arange(-4, 5), 0.1, "Areas of triangles",
                                   "log2 (area on the map / on the cortex)"),
        histograms.histogram_actor(series("AngleDistortion"), weights, np.arange(2, 11), 0.1, "Angles of triangles",
                                   "s1/s2 + s2/s1 (2 = angles kept)"),
        histograms.histogram_actor(ratios, None, np.arange(0, 3.1, 0.5), 0.02, "Areas of whole elements",
                                   "area / target area", "share of the elements in %")]
    panels = [Panel([chart], (k / 3, 0, (k + 1) / 3, 1), None) for k, chart in enumerate(charts)]
    picture(panels, (1800, 520), path)


def element_field(hemisphere, path):
    """A sampled field: per vertex on the flat map, and its mean per element there and on the cortex."""
    name, unit, meaning = hemisphere.shown_field()
    values = arrays.point_array(hemisphere.flat, name)
    table = colours.sequential(*np.nanpercentile(values, [2, 98]))
    flat_map = arrays.copy_of(hemisphere.flat)
    means = np.insert(hemisphere.element_column(name, "mean"), 0, np.nan)
    arrays.add_cell_array(flat_map, "ElementMean", means[arrays.cell_array(flat_map, "ElementId")])
    above = flatmap.view(flat_map, 1.17)
    lateral, _ = scenes.views(hemisphere.white, hemisphere.side)
    panels = [
        Panel([scenes.point_actor(flat_map, name, table, lit=False), scenes.caption("per vertex")],
              (0, 0.12, 0.3, 1), above),
        Panel([scenes.cell_actor(flat_map, "ElementMean", table, lit=False), scenes.caption("mean per element")],
              (0.3, 0.12, 0.6, 1), above),
        Panel([scenes.behind(scenes.surface_actor(hemisphere.white)),
               scenes.cell_actor(arrays.native(flat_map), "ElementMean", table),
               scenes.caption("mean per element, lateral")], (0.6, 0.12, 1, 1), lateral),
        Panel([scenes.colour_bar(table, (0.3, 0.05), (0.4, 0.55)),
               scenes.caption(f"{meaning}{', ' + unit if unit else ''}", y=0.66, size=18)], (0, 0, 1, 0.12), None)]
    picture(panels, (1800, 640), path)


def depth(hemisphere):
    """Sulcal depth per vertex of the maps."""
    return arrays.point_array(hemisphere.flat, "sulcal_depth")
