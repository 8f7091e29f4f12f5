"""Imports the package that the .deb installed, maps the fixture with it, and compares with what the command wrote."""
import json

import authalic

reader = authalic.vtkSurfaceFileReader()
reader.SetFileName("/tmp/bumpy_disk.off")
flow = authalic.vtkDiscreteLieFlow()
flow.SetInputConnection(reader.GetOutputPort())
flow.Update()
report, written = json.loads(flow.GetReport()), json.load(open("/tmp/map.json", encoding="utf-8"))
assert authalic.__file__.startswith("/usr/lib/python3"), authalic.__file__
assert authalic.__version__ == report["version"] == written["version"], (authalic.__version__, written["version"])
assert report["metrics"] == written["metrics"], "command and Python differ"
assert report["status"] == "converged", report["status"]
print("Python maps the fixture as the command does:", report["metrics"]["area_distortion"])
