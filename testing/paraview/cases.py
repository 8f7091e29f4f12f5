"""Small runs of every filter, reader and writer, described once and run twice: by ParaView, and by VTK alone.

A case is (name, class without vtk, inputs, properties). An input is (property of the proxy, case, output port);
inputs stand in the order of the ports. Properties are the ivars of the class; a list goes to its AddX method, item by
item. FIXTURES/ and OUT/ at the start of a text stand for folders.
"""
import pathlib

import numpy as np
import proxies

# Properties that say how a run ended.
RESULTS = ("Status", "Iterations", "TotalAreaDistortion", "TotalAngleDistortion", "FlippedFaces", "Summary",
           "ErrorKind")
DISK = [("Input", "disk", 0)]
TUBE = [("Input", "tube", 0)]
CASES = [
    ("disk", "SurfaceFileReader", [], {"FileName": "FIXTURES/bumpy_disk.off"}),
    ("torus", "SurfaceFileReader", [], {"FileName": "FIXTURES/torus.off"}),
    ("doubletorus", "SurfaceFileReader", [], {"FileName": "FIXTURES/double_torus.off"}),
    ("tube", "SurfaceFileReader", [], {"FileName": "FIXTURES/bent_tube.off"}),
    ("tutte", "BarycentricMap", DISK, {"Method": 0}),
    ("textured", "BarycentricMap", DISK, {"OutputMode": 1}),
    ("harmonic", "BarycentricMap", DISK, {"Method": 1, "StartVertex": -1, "Threads": 1}),
    ("rectangle", "BarycentricMap", DISK, {"Domain": 2, "Aspect": 3.0}),
    ("polygon", "BarycentricMap", DISK, {"Domain": 3, "PolygonCorner": [(0, 0), (4, 0), (0, 5)]}),
    ("flow", "DiscreteLieFlow", DISK, {}),
    ("advected", "LieAdvection", DISK, {"NumberOfSteps": 10, "Domain": 1}),
    ("stretched", "StretchMinimisation", DISK, {"Weights": 0, "Domain": 1}),
    ("fixedpoint", "StretchEnergyMap", DISK, {"Boundary": 1, "MaximumIterations": 20}),
    ("transported", "OptimalTransportMap", DISK, {"Tolerance": 1e-8, "MaximumIterations": 40}),
    ("transportedsquare", "OptimalTransportMap", DISK + [("InitialMap", "rectangle", 0)],
     {"Domain": 2, "Aspect": 3.0, "Finish": 1}),
    ("riemannsites", "OptimalTransportMap", DISK, {"InitialMethod": 1}),
    ("balanced", "OptimalTransportMap", DISK, {"InitialMethod": 1, "Balance": 0.5, "Finish": 1}),
    ("fromdensity", "OptimalTransportMap", DISK + [("InitialMap", "harmonic", 0), ("SourceMesh", "transported", 0)],
     {"SourceDensityArrayName": "CellArea"}),
    ("curve", "BalanceCurve", DISK, {"NumberOfBalances": 3}),
    ("unfolded", "DiscreteLieFlow", DISK + [("InitialMap", "harmonic", 0)], {"Finish": 1, "StepRatio": 0.5}),
    ("square", "DiscreteLieFlow", DISK, {"Domain": 1, "Tolerance": 0.01, "InitialMethod": 2, "KeepInitial": 1}),
    ("ball", "SurfaceFileReader", [], {"FileName": "FIXTURES/folded_sphere.off"}),
    ("sphere", "SphericalConformalMap", [("Input", "ball", 0)], {}),
    ("transportedball", "SphericalTransportMap", [("Input", "ball", 0)], {}),
    ("finishedball", "SphericalTransportMap", [("Input", "ball", 0), ("InitialMap", "sphere", 0)],
     {"Finish": 1, "Tolerance": 1e-8, "MaximumIterations": 30}),
    ("projectedball", "SphericalTransportMap", [("Input", "ball", 0)], {"Formulation": 1, "Pole": (0.0, 0.6, 0.8)}),
    ("balancedball", "SphericalTransportMap", [("Input", "ball", 0)], {"Balance": 0.5}),
    ("ballcurve", "BalanceCurve", [("Input", "ball", 0)], {"Balance": [(0.25,), (0.75,)]}),
    ("axes", "SphericalConformalMap", [("Input", "ball", 0)], {"InitialMethod": 2, "Rotation": 1, "TimeStep": 0.2}),
    ("welded", "SphericalConformalMap", [("Input", "ball", 0)],
     {"InitialMethod": 3, "Rotation": 2, "NorthVertex": 0, "MeridianVertex": 9}),
    ("upper", "SurfaceFileReader", [], {"FileName": "FIXTURES/upper_shell.off"}),
    ("lower", "SurfaceFileReader", [], {"FileName": "FIXTURES/lower_shell.off"}),
    ("uppermap", "BarycentricMap", [("Input", "upper", 0)], {"Method": 1}),
    ("lowermap", "BarycentricMap", [("Input", "lower", 0)], {"Method": 1}),
    ("shells", "ConformalWelding", [("Input", "uppermap", 0), ("Second", "lowermap", 0)], {}),
    ("onsphere", "MapDistortion", [("Input", "shells", 0)], {"Details": True}),
    ("distortion", "MapDistortion", [("Input", "flow", 0), ("Surface", "disk", 0)], {"Details": True}),
    ("riemann", "RiemannMap", DISK, {"Road": 1, "Centre": 1, "CentreId": 40}),
    ("refined", "RiemannMap", DISK, {"Refine": True}),
    ("yamabe", "YamabeMap", DISK, {"StartVertex": -1}),
    ("lscm", "LeastSquaresConformalMap", DISK, {"Pins": 1}),
    ("slim", "SymmetricDirichletMap", DISK + [("InitialMap", "tutte", 0)], {"Boundary": 1}),
    ("circles", "CircleDomainMap", TUBE, {"Centre": 1, "CentreId": 300}),
    ("koebe", "CircleDomainMap", TUBE, {"Road": 1, "RoundnessTolerance": 1e-3}),
    ("ring", "AnnulusMap", TUBE, {}),
    ("concentric", "CircleDomainAuthalicMap", TUBE,
     {"Tolerance": 0.05, "Domain": 1, "OuterVertex": -1, "HoleArea": [(150.0,)]}),
    ("freering", "CircleDomainAuthalicMap", TUBE, {"Tolerance": 0.05, "HoldCentres": 0, "FreeRadii": 1}),
    ("holes", "PolyAnnulusTransportMap", TUBE, {"HoleShare": 0.2, "Tolerance": 1e-8, "MaximumIterations": 60}),
    ("roundholes", "PolyAnnulusTransportMap", TUBE,
     {"OuterVertex": -1, "HoleArea": [(650.0,)], "Finish": 1}),
    ("exactsleeve", "CircleDomainAuthalicMap", TUBE, {"Tolerance": 0.05, "Domain": 2}),
    ("flowingsleeve", "CircleDomainLieFlow", TUBE, {"Domain": 2}),
    ("flowingring", "CircleDomainLieFlow", TUBE,
     {"Domain": 1, "OuterVertex": -1, "HoleArea": [(150.0,)], "StepRatio": 0.5}),
    ("flowingball", "SphericalLieFlow", [("Input", "ball", 0), ("InitialMap", "axes", 0)], {"Tolerance": 0.01}),
    ("advectedball", "SphericalLieAdvection", [("Input", "ball", 0)], {"NumberOfSteps": 10}),
    ("rectangle2", "AnnulusMap", TUBE, {"Domain": 1}),
    ("exact", "AuthalicMap", DISK, {"Tolerance": 0.02}),
    ("halfway", "AuthalicMap", DISK, {"Balance": 0.5, "Tolerance": 0.05}),
    ("region", "RegionDensity", DISK, {"RegionMode": 1, "Centre": (0.0, 0.0, 21.0), "Radius": 12.0, "Blend": 10.0}),
    ("regions", "RegionDensity", [("Input", "region", 0)],
     {"RegionMode": 2, "Centre": (30.0, 0.0, 0.0), "Radius": 8.0, "Factor": 0.5, "RegionLabel": "side"}),
    ("enlarged", "AuthalicMap", [("Input", "regions", 0)], {"MeasureArrayName": "RegionDensity", "Tolerance": 0.05}),
    ("bent", "CurvatureDensity", DISK, {"Weight": 0.3}),
    ("bentmap", "DiscreteLieFlow", [("Input", "bent", 0)], {"MeasureArrayName": "CurvatureDensity", "Tolerance": 0.05}),
    ("middling", "SphericalAuthalicMap", [("Input", "ball", 0)], {"Balance": 0.5, "Tolerance": 0.05}),
    ("exactsquare", "AuthalicMap", DISK + [("InitialMap", "square", 0)], {"Domain": 1}),
    ("periodic", "ToroidalAuthalicMap", [("Input", "torus", 0)], {"Tolerance": 0.05}),
    ("cones", "FlatConeAuthalicMap", [("Input", "doubletorus", 0)], {"Tolerance": 0.05}),
    ("report", "SurfaceTopologyReport", [("Input", "torus", 0)], {}),
    ("repaired", "SurfaceRepair", [("Input", "torus", 0)], {}),
    ("repairedmap", "SphericalConformalMap", [("Input", "repaired", 0)], {}),
    ("withhandle", "SurfaceRepair", [("Input", "torus", 0)],
     {"LargestHandle": 0.0, "LargestHole": 5.0, "StrayShare": 1.0, "SewSeams": False, "JunctionTolerance": 0.01}),
    ("t1", "VolumeFileReader", [], {"FileName": "FIXTURES/phantom_t1.nii.gz"}),
    ("labels", "VolumeFileReader", [], {"FileName": "FIXTURES/phantom_labels.nii.gz", "Frame": 0}),
    ("cortex", "CorticalSurface", [("Input", "t1", 0), ("Labels", "labels", 0)],
     {"TargetFaces": 4000, "SmoothingIterations": 10}),
    ("cut", "CutToDisk", [("Input", "cortex", 0)], {"LoopSmoothing": 5, "RegionValue": [1]}),
    ("half", "CutToDisk", [("Input", "cortex", 1)], {"RegionMode": 1, "PlaneNormal": (-1.0, 0.0, 0.0),
                                                     "PlaneOrigin": (15.0, 0.0, 0.0)}),
    ("cutflow", "DiscreteLieFlow", [("Input", "cut", 0)], {"MaximumIterations": 100}),
    ("sampled", "SampleVolumeOnSurface", [("Input", "cutflow", 0), ("Volume", "t1", 0)],
     {"Mode": 1, "DepthTo": 4.0, "Reducer": 1, "ArrayName": "T1"}),
    ("labelled", "LabelsOnSurface", [("Input", "sampled", 0), ("Labels", "labels", 0)], {"MaximumDistance": 8.0}),
    ("grid", "ElementGrid", [("Input", "labelled", 0)], {"NumberOfElements": 60}),
    ("tables", "ElementStatistics", [("Input", "grid", 0)],
     {"FieldArray": [("T1",)], "LabelArrayName": "Label", "Hemisphere": "L"}),
    ("written", "SurfaceFileWriter", [("Input", "cut", 0)], {"FileName": "OUT/cut.gii"}),
    ("metrics", "VertexDataWriter", [("Input", "labelled", 0)],
     {"FileName": "OUT/T1.func.gii", "ArrayName": [("T1",)]}),
    ("volume", "VolumeFileWriter", [("Input", "t1", 0)], {"FileName": "OUT/t1.mgh"}),
    ("reread", "SurfaceFileReader", [], {"FileName": "OUT/cut.gii", "AssumeSpace": 1}),
    ("withdata", "VertexDataReader", [("Input", "reread", 0)], {"FileName": "OUT/T1.func.gii", "ArrayName": "Again"}),
]


XMLS = pathlib.Path(__file__).resolve().parents[2] / "src/paraview/Authalic"


def all_cases():
    """The cases above; filters of surfaces that have none run with their defaults on a disk and on a closed surface,
    where they may refuse, alike."""
    covered = {kind for _, kind, _, _ in CASES}
    found = list(CASES)
    for (group, kind), proxy in sorted(proxies.load(XMLS).items()):
        if group != "filters" or kind in covered:
            continue
        types = [e.get("value") for e in proxy.all("InputProperty/DataTypeDomain/DataType")]
        if types[:1] == ["vtkPolyData"]:
            found += [(f"{kind}-{surface}", kind, [("Input", surface, 0)], {}) for surface in ("disk", "cortex")]
    return found


def failed(information):
    """Whether the run left no output."""
    return int(information.get("information:ErrorKind", 0)) not in (0, 4)


def placed(value, folders):
    for name, folder in folders.items():
        if isinstance(value, str) and value.startswith(name + "/"):
            return folder + value[len(name):]
    return value


def arrays_of(data, to_numpy):
    """Everything in a data object, as {name: numpy array}; numbers bit by bit, texts as they are."""
    found = {}
    if data.IsA("vtkTable"):
        groups = [("row", data.GetRowData())]
    else:
        groups = [("point", data.GetPointData()), ("cell", data.GetCellData())]
        if data.IsA("vtkPolyData") and data.GetNumberOfPoints():
            found["points"] = to_numpy(data.GetPoints().GetData())
            for kind, cells in (("polys", data.GetPolys()), ("lines", data.GetLines())):
                found[kind] = to_numpy(cells.GetConnectivityArray())
        if data.IsA("vtkImageData"):
            found["frame"] = np.array([*data.GetOrigin(), *data.GetSpacing(), *data.GetExtent()])
    for kind, attributes in groups + [("field", data.GetFieldData())]:
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            if array.IsA("vtkStringArray"):
                value = np.array([array.GetValue(k) for k in range(array.GetNumberOfValues())], dtype=str)
            else:
                value = to_numpy(array)
            found[f"{kind}:{array.GetName()}"] = value
    return found
