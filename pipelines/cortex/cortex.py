#!/usr/bin/python3
"""The main job: from a T1 MRI to area-preserving flat maps of the cortex with statistics per element.

    cortex.py [--t1 FILE [--labels FILE] | --surface FILE] [--fast] [--out DIR]     (cortex.py --help says all)

Copy this file and change it: it is one VTK pipeline per hemisphere,

    T1, labels -> vtkCorticalSurface -> SulcalDepth -> vtkSampleVolumeOnSurface ... -> vtkCutToDisk
               -> vtkBarycentricMap -> vtkDiscreteLieFlow -> UprightMap -> vtkElementGrid -> vtkElementStatistics

Every filter is an ordinary VTK filter; the files beside this one draw pictures and write reports.
"""
import sys

import authalic

import options as command_line
import outputs
import steps
from pictures import AUTHALIC, INITIAL
from render import Display
from stages import StageError, Stages

STAGES_PER_HEMISPHERE = 13
FIELDS = [  # point array, unit, what it is
    ("T1", "", "T1 signal at the vertex"),
    ("T1Cortex", "", "T1 signal, mean of 0 to 2.5 mm outward: the cortex"),
    ("T1Normal", "", "T1 signal, mean of 0 to 10 mm along the inward normal"),
    ("SulcalDepth", "mm", "depth below the surface smoothed until its folds are gone; sulci positive"),
]


def volume(path):
    reader = authalic.vtkVolumeFileReader()
    reader.SetFileName(str(path))
    return reader


def extract(t1, labels):
    """White surface of both hemispheres; output port 0 is the left, 1 the right."""
    surface = authalic.vtkCorticalSurface()
    surface.SetInputConnection(0, t1.GetOutputPort())
    if labels is not None:
        surface.SetInputConnection(1, labels.GetOutputPort())
    return surface


def sample(surface, image, name):
    """A volume read at every vertex; the caller says where."""
    sampler = authalic.vtkSampleVolumeOnSurface()
    sampler.SetInputConnection(0, surface.GetOutputPort())
    sampler.SetInputConnection(1, image.GetOutputPort())
    sampler.SetArrayName(name)
    return sampler


def along_normal(sampler, start, stop, step):
    """Mean along the normal, mm; inward is positive."""
    sampler.SetModeToAlongNormal()
    sampler.SetDepthFrom(start)
    sampler.SetDepthTo(stop)
    sampler.SetDepthStep(step)
    return sampler
