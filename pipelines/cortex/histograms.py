"""Charts of what maps do to areas and angles: histograms weighted by native area, and curves."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkRenderingContext2D import vtkContextActor
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  VTK's factory for charts

import colours
from render import OVERSAMPLING

BEFORE, AFTER = (0.84, 0.37, 0.00), (0.00, 0.35, 0.70)  # Okabe and Ito: told apart by colour-blind readers


def histogram_actor(series, weights, ticks, width, title, unit, of="share of the cortex in %"):
    """A chart of outlines over the range of the ticks, with bins of `width`, one of them centred on each tick.

    series = [(name, values, colour)]; weights of the values, or None.
    """
    edges = np.arange(ticks[0] - width / 2, ticks[-1] + width, width)
    chart = vtkChartXY()
    chart.SetTitle(title)
    _style(chart.GetTitleProperties(), 20, bold=True)
    for name, values, colour in series:
        _outline(chart, name, _shares(values, weights, edges), edges, colour)
    _axis(chart.GetAxis(vtkAxis.BOTTOM), unit, ticks)
    top = 10 * np.ceil(max(_shares(values, weights, edges).max() for _, values, _ in series) / 10)
    _axis(chart.GetAxis(vtkAxis.LEFT), of, np.linspace(0, top, 6))
    return _shown(chart)


def curve_actor(series, x_ticks, y_ticks, title, x_title, y_title):
    """A chart of lines, the y axis logarithmic: series = [(name, x, y > 0, colour)], y_ticks powers of ten."""
    chart = vtkChartXY()
    chart.SetTitle(title)
    _style(chart.GetTitleProperties(), 20, bold=True)
    for name, x, y, colour in series:
        _line(chart, name, x, np.log10(y), colour)
    _axis(chart.GetAxis(vtkAxis.BOTTOM), x_title, x_ticks)
    axis = chart.GetAxis(vtkAxis.LEFT)
    _axis(axis, y_title, np.log10(y_ticks))
    labels = vtkStringArray()
    for tick in y_ticks:
        labels.InsertNextValue(f"{tick:g}")
    axis.SetCustomTickPositions(axis.GetTickPositions(), labels)
    return _shown(chart)


def _shown(chart):
    chart.SetShowLegend(True)
    _style(chart.GetLegend().GetLabelProperties(), 15)
    chart.GetLegend().SetPadding(12)
    actor = vtkContextActor()
    actor.GetScene().AddItem(chart)
    return actor


def _shares(values, weights, edges):
    """Percent of the weight per bin; what lies outside joins the outermost bins."""
    inside = np.clip(values, edges[0], np.nextafter(edges[-1], edges[0]))
    counts = np.histogram(inside, edges, weights=weights)[0]
    return 100 * counts / counts.sum()


def _outline(chart, name, shares, edges, colour):
    x = np.repeat(edges, 2)
    _line(chart, name, x, np.concatenate([[0], np.repeat(shares, 2), [0]]), colour)


def _line(chart, name, x, y, colour):
    table = vtkTable()
    for label, column in (("x", x), (name, y)):
        array = numpy_to_vtk(np.ascontiguousarray(column, dtype=float), deep=1)
        array.SetName(label)
        table.AddColumn(array)
    plot = chart.AddPlot(vtkChart.LINE)
    plot.SetInputData(table, 0, 1)
    plot.SetColor(*(int(255 * c) for c in colour), 255)
    plot.SetWidth(1.6 * OVERSAMPLING)
    plot.SetLabel(name)


def _axis(axis, title, ticks):
    axis.SetTitle(title)
    axis.SetBehavior(vtkAxis.FIXED)
    margin = 0.01 * (ticks[-1] - ticks[0]) if ticks[0] else 0
    axis.SetRange(ticks[0] - margin, ticks[-1] + margin)
    axis.SetCustomTickPositions(numpy_to_vtk(np.ascontiguousarray(ticks, dtype=float), deep=1))
    axis.SetNotation(vtkAxis.PRINTF_NOTATION)
    axis.SetLabelFormat("%g")
    axis.GetGridPen().SetColorF(0.9, 0.9, 0.9)
    _style(axis.GetTitleProperties(), 16)
    _style(axis.GetLabelProperties(), 15)


def _style(text, size, bold=False):
    text.SetFontFamilyToArial()
    text.SetFontSize(size)
    text.SetBold(bold)
    text.SetColor(*colours.INK)
