"""Maps of surfaces: one function over every map filter, the metrics of a map, and the curve of balanced maps."""
import dataclasses
import json
from typing import Any, Optional, Sequence

import numpy as np

from . import _arrays, _classes, _filters
from ._elements import Table, table_of
from ._errors import InvalidArgument, NotConverged, NotConvergedWarning
from ._surfaces import Progress, Surface, to_polydata


@dataclasses.dataclass(frozen=True)
class Method:
    """A method of flatten(): the name of its filter, the settings that make the filter that method, and the
    topology of surface that it takes: "disk", "sphere", "torus", "flat-cones" (genus 2 or more) or "annulus"."""
    filter: str
    settings: dict[str, Any] = dataclasses.field(default_factory=dict)
    surface: str = "disk"

    def make(self) -> Any:
        """The VTK filter, ready for its inputs."""
        algorithm = getattr(_classes, self.filter)()
        _filters.configure(algorithm, **self.settings)
        return algorithm


# A new map filter needs one line here; its options, domains and ports are found by looking at the class.
METHODS: dict[str, Method] = {
    "tutte": Method("vtkBarycentricMap", {"method": "tutte"}),
    "harmonic": Method("vtkBarycentricMap", {"method": "harmonic"}),
    "mean-value": Method("vtkBarycentricMap", {"method": "mean-value"}),
    "authalic": Method("vtkAuthalicMap"),
    "authalic-sphere": Method("vtkSphericalAuthalicMap", surface="sphere"),
    "authalic-torus": Method("vtkToroidalAuthalicMap", surface="torus"),
    "authalic-flat-cones": Method("vtkFlatConeAuthalicMap", surface="flat-cones"),
    "authalic-holes": Method("vtkCircleDomainAuthalicMap", surface="annulus"),
    "transport": Method("vtkOptimalTransportMap"),
    "transport-holes": Method("vtkPolyAnnulusTransportMap", surface="annulus"),
    "transport-sphere": Method("vtkSphericalTransportMap", surface="sphere"),
    "balanced": Method("vtkOptimalTransportMap", {"initial_method": "riemann", "finish": "authalic", "balance": 0.5}),
    "balanced-sphere": Method("vtkSphericalTransportMap", {"finish": "authalic", "balance": 0.5}, surface="sphere"),
    "lie-flow": Method("vtkDiscreteLieFlow"),
    "lie-flow-sphere": Method("vtkSphericalLieFlow", surface="sphere"),
    "lie-flow-holes": Method("vtkCircleDomainLieFlow", surface="annulus"),
    "lie-advection": Method("vtkLieAdvection"),
    "lie-advection-sphere": Method("vtkSphericalLieAdvection", surface="sphere"),
    "stretch-energy": Method("vtkStretchEnergyMap"),
    "stretch": Method("vtkStretchMinimisation"),
    "riemann": Method("vtkRiemannMap"),
    "yamabe": Method("vtkYamabeMap"),
    "lscm": Method("vtkLeastSquaresConformalMap"),
    "slim": Method("vtkSymmetricDirichletMap"),
    "annulus": Method("vtkAnnulusMap", surface="annulus"),
    "circle-domain": Method("vtkCircleDomainMap", surface="annulus"),
    "sphere": Method("vtkSphericalConformalMap", surface="sphere"),
    "welding": Method("vtkSphericalConformalMap", {"initial_method": "welding"}, surface="sphere"),
}


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class SurfaceMap(Surface):
    """A map: where each vertex of a surface goes, and how well.

    image         (n, 2) in the plane, or (n, 3) on the sphere
    points, faces the surface that was mapped, in its own order; cut open for handles (point_arrays["OriginalPointIds"])
    status        "converged", "not-converged", "stalled" or "cancelled"
    iterations    int
    residuals     (k,) what the method drives to 0, per iteration
    metrics       {name: number}: area_distortion, angle_distortion (ideal 2), flipped_faces ...
    face_arrays   with AreaDistortion (log2 of image share / target share), AngleDistortion, Flipped, and
                  BeltramiCoefficient (m, 2)
    point_arrays  with VertexAreaDistortion (log2)
    report        everything that the filter reports: options, seconds, topology, version ...
    """
    image: np.ndarray = dataclasses.field(default_factory=lambda: np.zeros((0, 2)))
    status: str = "not-run"
    iterations: int = 0
    residuals: np.ndarray = dataclasses.field(default_factory=lambda: np.zeros(0))
    metrics: dict[str, Any] = dataclasses.field(default_factory=dict)
    report: dict[str, Any] = dataclasses.field(default_factory=dict)

    @property
    def converged(self) -> bool:
        """Whether the method reached its tolerance."""
        return self.status == "converged"

    @classmethod
    def from_filter(cls, algorithm: Any) -> "SurfaceMap":
        """Copies the output and the report of a map filter; its output mode must be the map."""
        if algorithm.GetOutputMode() != algorithm.MAP:
            raise InvalidArgument(f"{algorithm.GetClassName()} must give the map: SetOutputModeToMap() first.")
        report = json.loads(algorithm.GetReport())
        drawn = Surface.from_vtk(algorithm.GetOutput())
        planar = not drawn.points[:, 2].any()
        arrays = dict(drawn.point_arrays)
        return cls(arrays.pop("OriginalPoints"), drawn.faces, arrays, drawn.face_arrays, drawn.fields,
                   drawn.points[:, :2].copy() if planar else drawn.points, report["status"], report["iterations"],
                   np.array(report["residual_history"], dtype=float), report["metrics"], report)

    def to_vtk(self) -> Any:
        """The map as the filters know it: points are the image, the point array OriginalPoints is the surface."""
        drawn = super().to_vtk()
        _arrays.add_arrays(drawn.GetPointData(), {"OriginalPoints": self.points}, len(self.points), "vertices")
        image = _arrays.coordinates(self.image, "image")
        _arrays.set_points(drawn, image)
        return drawn

    def __repr__(self) -> str:
        return (f"SurfaceMap({self.report.get('method')}, {self.status}, {len(self.points)} vertices, "
                f"{len(self.faces)} faces, flipped_faces={self.metrics.get('flipped_faces')})")


def methods() -> dict[str, dict[str, Any]]:
    """{method: {option: default}} of every method of flatten(); options with a few words show one of them."""
    hidden = ("domain", "aspect", "measure_array_name", "balance", "balance_array_name", "initial_method",
              "output_mode", "source_density_array_name")
    return {name: {key: value for key, value in _filters.options_of(method.make()).items()
                   if key not in hidden and key not in method.settings} for name, method in METHODS.items()}


def flatten(points: Any,
            faces: Any = None,
            method: str = "authalic",
            domain: Any = None, measure: Any = None, initial: Any = None,
            tolerance: Optional[float] = None, max_iterations: Optional[int] = None,
            *,
            roi: Any = None, roi_blend: float = 0.0, balance: Any = None,
            hole_areas: Any = None, source: Any = None, source_density: Any = None, threads: int = 0,
            progress: Progress = None, on_not_converged: str = "warn",
            **options: Any) -> SurfaceMap:
    """Maps a surface; every vertex gets a place in the domain.

    points      (n, 3) mm, with faces (m, 3) vertex indices from 0; or one Surface or vtkPolyData alone.
                Maps to the plane need a topological disk: connected, manifold, one boundary loop (see cut_to_disk)
    method      "authalic": preserves areas, or gives every region the share that `measure` asks for, exactly at
                every vertex; "authalic-sphere", "authalic-torus": the same for closed surfaces of genus 0 and 1,
                "authalic-flat-cones" for genus 2 or more, "authalic-holes" for boundary loops: onto the disk without
                round holes (free_radii, hold_centres), or domain="annulus", or, tubes cut open, "periodic-rectangle";
                "transport", "transport-sphere", "transport-holes": optimal transport; finish="authalic" makes it exact;
                "lie-flow", "lie-flow-sphere", "lie-flow-holes", "lie-advection", "lie-advection-sphere",
                "stretch-energy": methods of the literature for the same; "stretch": one for little stretch;
                "balanced", "balanced-sphere": the same between angles and areas, see `balance` (0.5);
                "tutte", "harmonic", "mean-value": barycentric maps;
                "riemann", "yamabe", "lscm": conformal maps of a disk; "slim": as isometric as can be without a fold;
                "annulus", "circle-domain": conformal maps of surfaces with boundary loops; "sphere": conformal map of
                a closed surface of genus 0 to the unit sphere, "welding": the same by that road; methods() has all
                with their options
    domain      None or "disk": the unit disk; "square"; ("rectangle", aspect): [0, aspect] x [0, 1]; or the
                corners of a polygon, (k, 2); "sphere", "torus", "flat-cones" make "authalic-sphere" of "authalic" …
    measure     density relative to the native area, one number > 0 per vertex (n) or per face (m), or the name of
                such an array of the surface; a region with 4 gets four times the share that its area has. None = 1
                everywhere. Where n = m the numbers are per vertex
    roi         regions of interest, (region, factor) or a list of them: each gets `factor` times its area, relative to
                the rest; exact at every vertex for "authalic" methods. A region is (n,) flags; the name of an array
                (all but 0); (array, value) or (array, name of a label); ("sphere", x, y, z, radius) in mm, or
                ("geodesic", x, y, z, radius). report["regions"] has the shares
    roi_blend   width over which the density passes across the borders of the regions, mm
    balance     of "authalic", "transport", "balanced" to disk and sphere: 1 = areas, 0 = angles, or between; one
                number, one per vertex (n), or the name of a point array
    initial     where an iteration starts: a barycentric method by name (or "riemann"), or an image (n, 2) or SurfaceMap
                to the same domain; for "sphere" the road: "harmonic", "stereographic", "mean-curvature-flow", "welding"
    tolerance, max_iterations  residual at which an iteration is done, and most steps; None = the method's default
    hole_areas  of "authalic-holes", "transport-holes", "lie-flow-holes": area of every hole but the outer loop, mm^2,
                in the order of the loops' smallest vertex ids; None = of the cones that close them
    source      of "transport" in the plane: a planar mesh that covers the domain, (points, faces), Surface, SurfaceMap
                (its image) or vtkPolyData; None = uniform. Not with a finish or a balance. source_density is its
                density > 0, linear in every triangle: one number per vertex, or the name of a point array
    threads     0 = every core; the result does not depend on it
    progress    progress(fraction, stage) is called often; returning False cancels
    on_not_converged  "warn" (NotConvergedWarning), "raise" (NotConverged, with the best map as .result) or "ignore"
    options     further options of the method by name, see methods()

    Returns a SurfaceMap; its status says whether the tolerance was reached, its metrics count flipped faces.
    Raises SurfaceError (wrong topology, degenerate geometry), InvalidArgument, SolverError, Cancelled,
    NotConverged, KeyboardInterrupt after Ctrl-C.

    >>> import authalic
    >>> disk = authalic.cut_to_disk(authalic.read_surface("lh.pial"), region=cortex_flags, keep=True)
    >>> map = authalic.flatten(disk)
    >>> map.image.shape, map.status, map.metrics["flipped_faces"]
    """
    _check_policy(on_not_converged)
    method, domain = _method_and_domain(method, domain)
    algorithm = METHODS[method].make()
    mesh = to_polydata(points, faces)
    _set_domain(algorithm, method, domain)
    _set_measure(algorithm, method, mesh, measure)
    _set_balance(algorithm, method, mesh, balance)
    mesh = _with_regions(algorithm, method, mesh, roi, roi_blend)
    _set_initial(algorithm, method, mesh, initial)
    _set_hole_areas(algorithm, method, hole_areas)
    _set_source(algorithm, method, source, source_density)
    _refuse_unknown(algorithm, method, dict(options, tolerance=tolerance, max_iterations=max_iterations))
    _filters.configure(algorithm, threads=threads, tolerance=tolerance, max_iterations=max_iterations, **options)
    algorithm.SetInputData(0, mesh)
    kind, doubts = _filters.run(algorithm, progress)
    return _judged(SurfaceMap.from_filter(algorithm), kind, doubts, on_not_converged)


def _check_policy(on_not_converged):
    if on_not_converged not in ("warn", "raise", "ignore"):
        raise InvalidArgument(f"on_not_converged must be warn, raise or ignore; it is {on_not_converged!r}.")


def _method_and_domain(method, domain):
    """The method, and the domain its filter is to be told; "sphere", "torus", "flat-cones" are methods of their own."""
    if method not in METHODS:
        raise InvalidArgument(f"method must be one of {', '.join(METHODS)}; it is {method!r}.")
    if isinstance(domain, str) and f"{method}-{domain}" in METHODS:
        return f"{method}-{domain}", None
    return method, domain


def _judged(result, kind, doubts, on_not_converged):
    """The result, after what its filter doubted was said to the caller of the function that calls this."""
    if kind == _filters.NOT_CONVERGED:
        sentence = doubts.pop()
        if on_not_converged == "raise":
            raise NotConverged(sentence, result)
        if on_not_converged == "warn":
            _filters.warn([sentence], NotConvergedWarning, stacklevel=4)
    _filters.warn(doubts, stacklevel=4)
    return result


def _refuse_unknown(algorithm, method, options):
    known = methods()[method]
    for name, value in options.items():
        if value is not None and name not in known:
            raise InvalidArgument(
                f"Method {method} has no option '{name}'; it has: {', '.join(sorted(known)) or 'none'}.")


def _set_domain(algorithm, method, domain):
    if domain is None:
        return
    if not hasattr(algorithm, "SetDomain"):
        raise InvalidArgument(f"Method {method} has one domain only; leave domain out.")
    if isinstance(domain, str):
        if domain in ("rectangle", "polygon") and hasattr(algorithm, "SetAspect"):
            raise InvalidArgument('domain must be ("rectangle", aspect) or the corners of a polygon, (k, 2).')
        _filters.configure(algorithm, domain=domain)
    elif isinstance(domain, tuple) and domain and domain[0] == "rectangle":
        if len(domain) != 2:
            raise InvalidArgument('domain must be ("rectangle", aspect), aspect = width / height.')
        _filters.configure(algorithm, domain="rectangle", aspect=domain[1])
    else:
        _filters.configure(algorithm, domain="polygon")
        for x, y in _arrays.numbers(domain, "domain", (None, 2)):
            algorithm.AddPolygonCorner(x, y)


def _set_measure(algorithm, method, mesh, measure):
    if measure is None:
        return
    if not hasattr(algorithm, "SetMeasureArrayName"):
        raise InvalidArgument(f"Method {method} takes no measure; it has one of its own.")
    if isinstance(measure, str):
        return algorithm.SetMeasureArrayName(measure)
    values = _arrays.numbers(measure, "measure", (None,))
    vertices, cells = mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()
    if len(values) not in (vertices, cells):
        raise InvalidArgument(f"measure must have one number for each of the {vertices} vertices or {cells} faces; "
                              f"it has {len(values)}.")
    data = mesh.GetPointData() if len(values) == vertices else mesh.GetCellData()
    mesh.GetPointData().RemoveArray("Measure")
    _arrays.add_arrays(data, {"Measure": values}, len(values), "rows")
    algorithm.SetMeasureArrayName("Measure")


def _set_balance(algorithm, method, mesh, balance):
    if balance is None:
        return
    if not hasattr(algorithm, "SetBalanceArrayName"):
        raise InvalidArgument(f"Method {method} has no balance; it is for authalic, transport and balanced maps to the "
                              "disk and to the sphere.")
    if isinstance(balance, str):
        return algorithm.SetBalanceArrayName(balance)
    if np.ndim(balance) == 0:
        return _filters.configure(algorithm, balance=float(balance))
    values = _arrays.numbers(balance, "balance", (mesh.GetNumberOfPoints(),))
    _arrays.add_arrays(mesh.GetPointData(), {"Balance": values}, len(values), "vertices")
    algorithm.SetBalanceArrayName("Balance")


def _with_regions(algorithm, method, mesh, roi, blend):
    """The surface with a density for its regions of interest, which becomes the measure of the map."""
    if roi is None:
        if blend:
            raise InvalidArgument("roi_blend needs a region of interest; give roi.")
        return mesh
    if not hasattr(algorithm, "SetMeasureArrayName"):
        raise InvalidArgument(f"Method {method} takes no regions; it has a measure of its own.")
    pairs = roi if isinstance(roi, list) else [roi]
    for number, pair in enumerate(pairs, 1):
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise InvalidArgument(f"roi must be (region, factor) or a list of them; number {number} is {pair!r:.60}.")
        density = _classes.vtkRegionDensity()
        _mark(density, mesh, pair[0], f"region {number}")
        _filters.configure(density, factor=pair[1], blend=blend)
        density.SetMeasureArrayName(algorithm.GetMeasureArrayName())
        density.SetInputData(mesh)
        _filters.warn(_filters.run(density)[1])
        mesh = density.GetOutput()
        algorithm.SetMeasureArrayName("RegionDensity")
    return mesh


def _mark(density, mesh, region, label):
    """Says to the filter what the region is."""
    if isinstance(region, str):
        return density.SetRegionArrayName(region)
    if isinstance(region, tuple) and len(region) == 5 and region[0] in ("sphere", "geodesic"):
        _filters.configure(density, region_mode="ball" if region[0] == "sphere" else "geodesic-ball", radius=region[4])
        return density.SetCentre(*_arrays.numbers(region[1:4], "centre of a region", (3,)))
    if isinstance(region, tuple) and len(region) == 2 and isinstance(region[0], str):
        density.SetRegionArrayName(region[0])
        return density.AddRegionName(region[1]) if isinstance(region[1], str) else density.AddRegionValue(region[1])
    flags = _arrays.numbers(region, "a region of roi", (mesh.GetNumberOfPoints(),))
    _arrays.add_arrays(mesh.GetPointData(), {label: flags}, len(flags), "vertices")
    density.SetRegionArrayName(label)
    density.SetRegionLabel(label)


def _set_hole_areas(algorithm, method, hole_areas):
    if hole_areas is None:
        return
    if not hasattr(algorithm, "AddHoleArea"):
        raise InvalidArgument(f"Method {method} takes no hole_areas; leave them out.")
    for area in _arrays.numbers(hole_areas, "hole_areas", (None,)):
        algorithm.AddHoleArea(area)


def _set_source(algorithm, method, source, density):
    if source is None and density is None:
        return
    if not hasattr(algorithm, "SetSourceDensityArrayName"):
        raise InvalidArgument(f"Method {method} takes no source; it is for transport to the plane.")
    if source is None or density is None:
        missing, given = ("source", "source_density") if source is None else ("source_density", "source")
        raise InvalidArgument(f"source and source_density belong together; {given} was given without {missing}.")
    mesh = to_polydata(*source) if isinstance(source, tuple) else to_polydata(source)
    if not isinstance(density, str):
        values = _arrays.numbers(density, "source_density", (mesh.GetNumberOfPoints(),))
        _arrays.add_arrays(mesh.GetPointData(), {"SourceDensity": values}, len(values), "vertices")
        density = "SourceDensity"
    algorithm.SetInputData(2, mesh)
    algorithm.SetSourceDensityArrayName(density)


def _set_initial(algorithm, method, mesh, initial):
    if initial is None:
        return
    if "initial_method" in METHODS[method].settings:
        raise InvalidArgument(f"Method {method} has a start of its own; leave initial out.")
    if isinstance(initial, str) and hasattr(algorithm, "SetInitialMethod"):
        return _filters.configure(algorithm, initial_method=initial)
    if algorithm.GetNumberOfInputPorts() < 2:
        raise InvalidArgument(f"Method {method} does not start from a map; leave initial out.")
    image = _arrays.coordinates(getattr(initial, "image", initial), "initial")
    if len(image) != mesh.GetNumberOfPoints():
        raise InvalidArgument(f"initial must have one row for each of the {mesh.GetNumberOfPoints()} vertices; "
                              f"it has {len(image)}.")
    start = mesh.NewInstance()
    start.CopyStructure(mesh)
    _arrays.set_points(start, image)
    algorithm.SetInputData(1, start)


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Distortion:
    """How much a map changes areas and angles.

    metrics       {name: number} of the map as a whole, named as in SurfaceMap.metrics
    face_arrays   AreaDistortion, AngleDistortion, BeltramiCoefficient (m, 2), Flipped, SigmaMax, SigmaMin
    point_arrays  VertexAreaDistortion
    histograms    {name: (bins + 3, 3)}: lower edge, upper edge and count; then what is below, above, undefined
    """
    metrics: dict[str, Any]
    face_arrays: dict[str, np.ndarray]
    point_arrays: dict[str, np.ndarray]
    histograms: dict[str, np.ndarray]

    def __repr__(self) -> str:
        return f"Distortion({self.metrics})"


def measure_distortion(image: Any, points: Any, faces: Any = None, measure: Optional[Any] = None) -> Distortion:
    """Metrics of any map to the plane or to a sphere around 0, ours or another program's.

    image          (n, 2), (n, 3), or a SurfaceMap's
    points, faces  the surface, or one Surface or vtkPolyData
    measure        (m,) target measures of the faces, any scale; None = their areas on the surface

    Raises SurfaceError, InvalidArgument.
    """
    surface = to_polydata(points, faces)
    flat = surface.NewInstance()
    flat.CopyStructure(surface)
    places = _arrays.coordinates(getattr(image, "image", image), "image")
    if len(places) != surface.GetNumberOfPoints():
        raise InvalidArgument(f"image must have one row for each of the {surface.GetNumberOfPoints()} vertices; "
                              f"it has {len(places)}.")
    _arrays.set_points(flat, places)
    algorithm = _classes.vtkMapDistortion()
    if measure is not None:
        values = _arrays.numbers(measure, "measure", (surface.GetNumberOfPolys(),))
        _arrays.add_arrays(flat.GetCellData(), {"Measure": values}, len(values), "faces")
        algorithm.SetMeasureArrayName("Measure")
    algorithm.DetailsOn()
    algorithm.SetInputData(0, flat)
    algorithm.SetInputData(1, surface)
    _filters.warn(_filters.run(algorithm)[1])
    done = Surface.from_vtk(algorithm.GetOutput())
    cells = {name: done.face_arrays[name] for name in
             ("AreaDistortion", "AngleDistortion", "Flipped", "BeltramiCoefficient", "SigmaMax", "SigmaMin")}
    return Distortion(json.loads(algorithm.GetReport()), cells,
                      {"VertexAreaDistortion": done.point_arrays["VertexAreaDistortion"]},
                      {name: values for name, values in done.fields.items() if name.endswith("Histogram")})


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class BalanceCurve:
    """What angles cost areas on one surface.

    table    {column: (k,) array}, a row per balance: balance, angle_distortion, area_distortion (ideal 2),
             angle_error_mean_degrees, flipped_faces; the same four with transport_ in front, before the finish; status
    status   "converged" when every row is
    report   version, status, seconds (conformal, maps: one per row, total), options
    """
    table: Table
    status: str
    report: dict[str, Any]

    def __repr__(self) -> str:
        return f"BalanceCurve({self.status}, {len(self.table['balance'])} balances)"


def balance_curve(points: Any,
                  faces: Any = None,
                  balances: Optional[Sequence[float]] = None,
                  measure: Any = None,
                  *,
                  roi: Any = None, roi_blend: float = 0.0,
                  threads: int = 0,
                  progress: Progress = None,
                  on_not_converged: str = "warn") -> BalanceCurve:
    """Maps a surface with several balances, and says what each does to angles and areas.

    The maps are those of flatten(..., method="balanced", balance=t), to tolerances that are enough to choose t by.

    points, faces  a disk or a closed surface of genus 0, as for flatten()
    balances       each from 0 (conformal) to 1 (area-preserving), best in order; None = 0, 0.1 ... 1
    measure, roi, roi_blend  the measure at balance 1, as for flatten()
    threads, progress, on_not_converged  as for flatten()

    Raises SurfaceError, InvalidArgument, SolverError, Cancelled, NotConverged (with the curve as .result).

    >>> curve = authalic.balance_curve(surface)
    >>> curve.table["balance"], curve.table["angle_distortion"], curve.table["area_distortion"]
    """
    _check_policy(on_not_converged)
    algorithm = _classes.vtkBalanceCurve()
    mesh = to_polydata(points, faces)
    if balances is not None:
        values = _arrays.numbers(balances, "balances", (None,))
        if not len(values):
            raise InvalidArgument("At least one balance is required; leave balances out for 0, 0.1 ... 1.")
        for balance in values:
            algorithm.AddBalance(balance)
    _set_measure(algorithm, "balanced", mesh, measure)
    mesh = _with_regions(algorithm, "balanced", mesh, roi, roi_blend)
    _filters.configure(algorithm, threads=threads)
    algorithm.SetInputData(mesh)
    kind, doubts = _filters.run(algorithm, progress)
    report = json.loads(algorithm.GetReport())["Curve"]
    curve = BalanceCurve(table_of(algorithm.GetOutput()), report["status"], report)
    return _judged(curve, kind, doubts, on_not_converged)
