"""Pictures for the gallery: surfaces and flat maps side by side, drawn with the tools of the main job
(pipelines/cortex)."""
import pathlib
import sys

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cortex"))
# pylint: disable=wrong-import-position
import colours  # noqa: E402
import histograms  # noqa: E402
import render  # noqa: E402
import scenes  # noqa: E402
from whole_file import write_text  # noqa: E402 F401  for the scripts

import authalic  # noqa: E402

PANEL = 420  # pixels


def drawn(surface, points):
    """The triangles of a surface at (n, 2) or (n, 3) places, with all arrays."""
    places = points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])
    return authalic.Surface(places, surface.faces, surface.point_arrays, surface.face_arrays).to_vtk()


def look(points, direction=None):
    """A camera that sees all points: from above for flat ones, else along `direction`."""
    flat = points.shape[1] == 2
    low, high = points.min(axis=0), points.max(axis=0)
    centre = np.append((low + high) / 2, 0.0)[:3]
    if flat:
        return render.View(centre, (0, 0, -1), (0, 1, 0), 1.08 * (high - low))
    reach = 1.06 * np.linalg.norm(points - centre, axis=1).max() * 2
    up = (0, 1, 0) if abs(direction[2]) > 0.9 else (0, 0, 1)
    height = max(0.75 * reach, 1.06 * np.ptp(points @ np.array(up)))
    return render.View(centre, direction, up, (reach, height))


def by_place(image):
    """A colour per vertex that tells where on the map it is, (n, 3) bytes."""
    centred = image - (image.min(axis=0) + image.max(axis=0)) / 2
    return colours.domain_colours(centred, np.ones(len(image)))


class Gallery:
    """Panels in a row; save() writes the picture if there is a display, and says so if not."""

    def __init__(self):
        self.panels = []

    def add(self, caption, surface, points, direction=(1, 0, 0), rgb=None, array=None, table=None):
        """A surface at `points`, coloured by (n, 3) bytes, or by a face or point array through a colour table."""
        lit = points.shape[1] == 3
        mesh = drawn(surface, points)
        if array is None:
            prop = scenes.surface_actor(mesh, rgb, lit)
        elif array in surface.face_arrays:
            prop = scenes.cell_actor(mesh, array, table, lit)
        else:
            prop = scenes.point_actor(mesh, array, table, lit)
        self.add_prop(caption, prop, points, direction, table)

    @staticmethod
    def faces(surface, array, table):
        """An actor: the triangles where they are, each in the colour of its face array."""
        return scenes.cell_actor(drawn(surface, surface.points), array, table)

    def add_prop(self, caption, prop, points, direction=(1, 0, 0), table=None):
        """Anything that VTK draws, seen as `points` are."""
        self.panels.append((caption, prop, look(points, direction), table))

    def add_chart(self, maps, histogram, ticks, title, unit, bins=1):
        """Outlines of a histogram of each of two maps, {name: SurfaceMap}, as their reports hold it, `bins` of its bins
        taken together; the range is that of the ticks."""
        series = []
        for (name, found), colour in zip(maps.items(), (histograms.BEFORE, histograms.AFTER)):
            counted = found.report["histograms"][histogram]
            edges = np.array(counted["edges"])
            series.append((name, np.repeat((edges[1:] + edges[:-1]) / 2, counted["counts"]), colour))
        chart = histograms.histogram_actor(series, None, ticks, bins * (edges[1] - edges[0]), title, unit, "share in %")
        self.panels.append((None, chart, None, None))

    def add_curves(self, series, x_ticks, y_ticks, title, x_title, y_title):
        """Lines over a logarithmic axis, [(name, x, y, colour)]."""
        self.add_prop_chart(histograms.curve_actor(series, x_ticks, y_ticks, title, x_title, y_title))

    def add_prop_chart(self, chart):
        """A chart that was made already."""
        self.panels.append((None, chart, None, None))

    def save(self, path):
        with render.Display() as display:
            if not display.available:
                print(f"No display and no Xvfb: {path} is not drawn.", file=sys.stderr)
                return
            share, panels = 1 / len(self.panels), []
            for k, (caption, prop, view, table) in enumerate(self.panels):
                if view is None:
                    panels.append(render.Panel([], (k * share, 0, (k + 1) * share, 1), None))
                    panels.append(render.Panel([prop], (k * share, 0, (k + 1) * share, 0.97), None))
                    continue
                words = [scenes.caption(caption, y=0.93, size=17)]
                if table is not None:
                    words.append(scenes.colour_bar(table, (0.2, 0.03), (0.6, 0.07)))
                panels.append(render.Panel([prop], (k * share, 0.1, (k + 1) * share, 0.92), view))
                panels.append(render.Panel(words, (k * share, 0, (k + 1) * share, 1), None))
            render.picture(sorted(panels, key=lambda panel: panel.view is not None),
                           (PANEL * len(self.panels), PANEL), path)
            print(path)
