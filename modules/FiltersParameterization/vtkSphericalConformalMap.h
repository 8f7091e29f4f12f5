/**
 * @class vtkSphericalConformalMap
 * @brief Conformal map of a topological sphere to the unit sphere, by one of four roads, in a normal position.
 *
 * The map exists and is unique up to the six parameters of a Möbius transformation; these are fixed by the centre of
 * mass of the surface at 0 (to 1e-12) and a rotation. The roads agree as meshes refine. Faces that a road folded are
 * repaired in small patches; what stays folded is counted, and the Status is then stalled.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 0 |
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | sphere; welding by that road |
 * | field | InitialMethod | 1 string | the road: harmonic, stereographic, mean-curvature-flow, welding |
 * | field | CentreOfMass | 1 double | length of Σ m y / Σ m, m the star areas on the surface, y the image |
 * | field | FlippedBeforeUnfolding, UnfoldedVertices | 1 int | what the repair of folds found and moved |
 * | field | Coverage | 1 double | Σ solid angles / 4π; 1 for a homeomorphism |
 * | field | FlatAreaDistortion | 1 double | D_area of the flat triangles through the image's points |
 * | field | SphericalAngleError | 1 double | degrees, mean over corners, of the spherical triangles |
 *
 * See gu2004, haker2000, choi2015, kazhdan2012 and nadeem2017 in docs/references.bib, and
 * docs/methods/spherical-conformal-map.md.
 *
 * @sa vtkConformalWelding vtkSphericalAuthalicMap
 */
#ifndef vtkSphericalConformalMap_h
#define vtkSphericalConformalMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct SphericalConformalMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalConformalMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkSphericalConformalMap* New();
  vtkTypeMacro(vtkSphericalConformalMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    HARMONIC = 0,
    STEREOGRAPHIC = 1,
    MEAN_CURVATURE_FLOW = 2,
    WELDING = 3
  };

  ///@{
  /**
   * The road: least harmonic energy; a dipole and a second chart; conformalized mean curvature flow; or two Riemann
   * maps welded along the zero set of the first Laplacian eigenfunction. Default:
   * authalic::SphericalConformalMapOptions, as below.
   */
  vtkSetClampMacro(InitialMethod, int, HARMONIC, WELDING);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToStereographic() { this->SetInitialMethod(STEREOGRAPHIC); }
  void SetInitialMethodToMeanCurvatureFlow() { this->SetInitialMethod(MEAN_CURVATURE_FLOW); }
  void SetInitialMethodToWelding() { this->SetInitialMethod(WELDING); }
  ///@}

  enum HarmonicStartType
  {
    DIPOLE = 0,
    TUTTE = 1,
    GAUSS_MAP = 2
  };

  ///@{
  /** Where the harmonic road starts; it ends at the same map. */
  vtkSetClampMacro(HarmonicStart, int, DIPOLE, GAUSS_MAP);
  vtkGetMacro(HarmonicStart, int);
  void SetHarmonicStartToDipole() { this->SetHarmonicStart(DIPOLE); }
  void SetHarmonicStartToTutte() { this->SetHarmonicStart(TUTTE); }
  void SetHarmonicStartToGaussMap() { this->SetHarmonicStart(GAUSS_MAP); }
  ///@}

  ///@{
  /** Face that holds the pole of the stereographic road and of the starts Dipole and Tutte; -1 = the most regular. */
  vtkSetClampMacro(PuncturedFace, int, -1, VTK_INT_MAX);
  vtkGetMacro(PuncturedFace, int);
  ///@}

  ///@{
  /** Share of the area around the pole that the second solve of the stereographic road places anew, 0 to below 1. */
  vtkSetMacro(CorrectedShare, double);
  vtkGetMacro(CorrectedShare, double);
  ///@}

  ///@{
  /** Time step of the mean curvature flow, the area being 4π; above 0. */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Residual at which the road is done, above 0; 0 = the default of the road. Harmonic: relative tangential residual;
   * mean curvature flow: change of the radii in a step; welding: largest curvature left, radians. Default 0.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most iterations of the road, 0 or more; -1 = the default of the road. Default -1. */
  vtkSetClampMacro(MaximumIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /** Whether folded faces are unfolded in small patches. */
  vtkSetMacro(Unfold, bool);
  vtkGetMacro(Unfold, bool);
  vtkBooleanMacro(Unfold, bool);
  ///@}

  enum RotationType
  {
    TO_SURFACE = 0,
    TO_PRINCIPAL_AXES = 1,
    TO_LANDMARKS = 2,
    NO_ROTATION = 3
  };

  ///@{
  /**
   * The rotation, once the centre of mass is at 0: image closest to the surface; principal axes to z, x, y; two
   * landmarks; none.
   */
  vtkSetClampMacro(Rotation, int, TO_SURFACE, NO_ROTATION);
  vtkGetMacro(Rotation, int);
  void SetRotationToSurface() { this->SetRotation(TO_SURFACE); }
  void SetRotationToPrincipalAxes() { this->SetRotation(TO_PRINCIPAL_AXES); }
  void SetRotationToLandmarks() { this->SetRotation(TO_LANDMARKS); }
  void SetRotationToNone() { this->SetRotation(NO_ROTATION); }
  ///@}

  ///@{
  /** With the rotation Landmarks: the vertex that goes to the north pole (0, 0, 1). */
  vtkSetClampMacro(NorthVertex, int, -1, VTK_INT_MAX);
  vtkGetMacro(NorthVertex, int);
  ///@}

  ///@{
  /** With the rotation Landmarks: the vertex that goes to the half-plane y = 0, x > 0. */
  vtkSetClampMacro(MeridianVertex, int, -1, VTK_INT_MAX);
  vtkGetMacro(MeridianVertex, int);
  ///@}

protected:
  vtkSphericalConformalMap();
  ~vtkSphericalConformalMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod;
  int HarmonicStart;
  int PuncturedFace;
  double CorrectedShare;
  double TimeStep;
  double Tolerance = 0;
  int MaximumIterations = -1;
  bool Unfold;
  int Rotation;
  int NorthVertex;
  int MeridianVertex;

private:
  authalic::SphericalConformalMapOptions Options() const;

  vtkSphericalConformalMap(const vtkSphericalConformalMap&) = delete;
  void operator=(const vtkSphericalConformalMap&) = delete;
};

#endif
