#!/usr/bin/python3
"""A checkerboard on the cortex, through texture coordinates, for any 3-D program: checkerboard.obj and .gltf.

    checkerboard.py --surface lh.pial --region lh.cortex.label --keep

The filter leaves the points where they are and gives the map as texture coordinates
(SetOutputModeToTextureCoordinates). Equal squares of the map are pieces of cortex of equal area. Leaves
checkerboard.png, drawn from the .obj that was written.
"""
import argparse
import json

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOExport import vtkGLTFExporter
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkOBJWriter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture

import authalic
import surfaces
from show import Gallery

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--squares", type=int, default=24, help="across the map")
options = parser.parse_args()
obj, gltf, png = (options.out / f"checkerboard.{ending}" for ending in ("obj", "gltf", "png"))


def checkerboard(squares, pixels=16):
    """Light and dark squares as an image, tinted so that left, right, top and bottom can be told apart."""
    i, j = np.indices((squares * pixels, squares * pixels)) // pixels
    light = np.where((i + j) % 2 == 0, 0.95, 0.35)
    tint = np.stack([0.6 + 0.4 * j / squares, np.full(i.shape, 0.75), 0.6 + 0.4 * i / squares], axis=-1)
    image = vtkImageData()
    image.SetDimensions(*light.shape, 1)
    rgb = np.rint(255 * light[..., None] * tint).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(rgb.reshape(-1, 3), deep=1))
    return image


def textured(surface, image):
    """An actor: the triangles with the image on them."""
    actor, mapper, texture, normals = vtkActor(), vtkPolyDataMapper(), vtkTexture(), vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()  # no vertex is doubled
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    texture.SetInputData(image)
    texture.InterpolateOn()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def write_obj(surface, image):
    """checkerboard.obj, .mtl and .texture.png; the material names its picture without a folder, so that all three
    can move."""
    writer = vtkOBJWriter()
    writer.SetInputData(0, surface)
    writer.SetFileName(str(obj))
    writer.Write()
    picture = vtkPNGWriter()
    picture.SetInputData(image)
    picture.SetFileName(str(obj.with_suffix(".texture.png")))
    picture.Write()
    obj.with_suffix(".mtl").write_text(f"newmtl map\nKd 1 1 1\nmap_Kd {obj.stem}.texture.png\n", encoding="utf-8")
    lines = obj.read_text(encoding="utf-8").splitlines()
    head = [f"mtllib {obj.stem}.mtl", "usemtl map"]
    obj.write_text("\n".join([*head, *(line for line in lines if not line.startswith(("mtllib", "usemtl"))), ""]),
                   encoding="utf-8")


def write_gltf(actor):
    """checkerboard.gltf, one file with the picture inside. Nothing is drawn: no display is needed."""
    window, renderer, exporter = vtkRenderWindow(), vtkRenderer(), vtkGLTFExporter()
    window.SetOffScreenRendering(1)
    renderer.AddActor(actor)
    window.AddRenderer(renderer)
    exporter.SetRenderWindow(window)
    exporter.SetFileName(str(gltf))
    exporter.InlineDataOn()
    exporter.Write()


def read_back():
    """The surfaces of both files."""
    for reader, path in ((vtkOBJReader(), obj), (vtkGLTFReader(), gltf)):
        reader.SetFileName(str(path))
        reader.Update()
        data = reader.GetOutputDataObject(0)
        while data.IsA("vtkMultiBlockDataSet"):
            data = next(block for block in map(data.GetBlock, range(data.GetNumberOfBlocks())) if block is not None)
        yield path, data


disk = surfaces.disk(options)
exact = authalic.vtkAuthalicMap()
exact.SetInputData(disk.to_vtk())
exact.SetOutputModeToTextureCoordinates()
exact.Update()
surface, board = exact.GetOutput(), checkerboard(options.squares)
write_obj(surface, board)
write_gltf(textured(surface, board))

places = vtk_to_numpy(surface.GetPointData().GetTCoords())
for path, back in read_back():
    off = np.abs(vtk_to_numpy(back.GetPointData().GetTCoords())[:, :2] - places).max()
    print(f"{path}: {back.GetNumberOfPoints()} vertices, texture coordinates {off:.1e} off at most")
kinds = [image["mimeType"] for image in json.loads(gltf.read_text(encoding="utf-8"))["images"]]
print(f"pictures in the glTF file: {kinds}")

stored = vtkPNGReader()
stored.SetFileName(str(obj.with_suffix(".texture.png")))
stored.Update()
shown = next(read_back())[1]
direction = np.array(surfaces.lateral(disk))
gallery = Gallery()
gallery.add_prop("from checkerboard.obj", textured(shown, stored.GetOutput()), disk.points, direction)
gallery.add_prop("the other side", textured(shown, stored.GetOutput()), disk.points, -direction)
gallery.save(png)
