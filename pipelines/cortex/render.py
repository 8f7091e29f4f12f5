"""Off-screen pictures with VTK: panels side by side, twice the size, averaged down, written as PNG."""
import os
import shutil
import subprocess

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401  VTK's factories: a picture needs these three
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

OVERSAMPLING = 2


class Display:
    """An X server for VTK, which dies without one: the user's, or a private Xvfb that ends with the block.

    `available` is False when there is neither; then no window may be made.
    """

    def __init__(self, wanted=True):
        self.server, self.wanted = None, wanted
        self.available = wanted and bool(os.environ.get("DISPLAY"))

    def __enter__(self):
        if self.wanted and not self.available and shutil.which("Xvfb"):
            self.available = self._start()
        return self

    def _start(self):
        reading, writing = os.pipe()
        command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset"]
        self.server = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if number:
            os.environ["DISPLAY"] = ":" + number
        return bool(number)

    def __exit__(self, *_):
        if self.server is not None:
            os.environ.pop("DISPLAY", None)
            self.server.terminate()
            self.server.wait()


class Panel:
    """A part of a picture: what is in it, and the camera that looks at it (parallel projection)."""

    def __init__(self, props, viewport, view):
        self.props, self.viewport, self.view = props, viewport, view

    def renderer(self, size):
        renderer = vtkRenderer()
        renderer.SetViewport(*self.viewport)
        renderer.SetBackground(1, 1, 1)
        for prop in self.props:
            renderer.AddViewProp(prop)
        if self.view is not None:
            width = size[0] * (self.viewport[2] - self.viewport[0])
            height = size[1] * (self.viewport[3] - self.viewport[1])
            self.view.apply(renderer, width / height)
        return renderer


class View:
    """Where a camera stands. `extent` = (width, height) in world units that must fit in the panel."""

    def __init__(self, focus, direction, up, extent):
        self.focus, self.direction, self.up, self.extent = focus, direction, up, extent

    def apply(self, renderer, aspect):
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*self.focus)
        camera.SetPosition(*(np.asarray(self.focus) - 1000 * np.asarray(self.direction)))
        camera.SetViewUp(*self.up)
        camera.SetParallelScale(max(self.extent[1] / 2, self.extent[0] / (2 * aspect)))
        renderer.ResetCameraClippingRange()


def picture(panels, size, path):
    """Renders panels into a PNG of `size` pixels."""
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(1)
    window.SetSize(size[0] * OVERSAMPLING, size[1] * OVERSAMPLING)
    window.SetDPI(72 * OVERSAMPLING)
    for panel in panels:
        window.AddRenderer(panel.renderer(size))
    window.Render()
    write_png(_pixels(window), path)
    window.Finalize()


def _pixels(window):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    rgb = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)
    k = OVERSAMPLING
    total = sum(rgb[row::k, column::k].astype(np.uint16) for row in range(k) for column in range(k))
    return ((total + k * k // 2) // (k * k)).astype(np.uint8)


def write_png(rgb, path):
    """h×w×3 bytes, bottom row first, to a PNG that is there whole or not at all."""
    image = vtkImageData()
    image.SetDimensions(rgb.shape[1], rgb.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(rgb).reshape(-1, 3), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(4)
    partial = f"{path}.partial"
    writer.SetFileName(partial)
    writer.Write()
    os.replace(partial, path)
