/**
 * @class vtkSurfaceTopologyReport
 * @brief Topology, size and defects of a surface, each defect with its place.
 *
 * Any set of triangles is examined, however broken; only an empty or non-triangular input is an error.
 * χ = V − E + F over the vertices that faces use; genus = (2 c − χ − loops)/2, −1 when the surface is not an oriented
 * manifold.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, triangles, mm |
 * | output 0 | the input with the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | BoundaryLoop | 1 int | | 0 inside, else the number of the loop (in the order of their smallest vertex) |
 * | point | Defect | 1 unsigned char | | 1 on vertices of non-manifold or inconsistently oriented edges, non-manifold and isolated vertices |
 * | cell | Component | 1 int | | number of the component, from 0 in the order of first faces |
 * | cell | Defect | 1 unsigned char | | 1 on degenerate and duplicate faces |
 * | field | VertexCount, EdgeCount, FaceCount, EulerCharacteristic, Genus, Components, BoundaryLoops | 1 int | | |
 * | field | SurfaceArea, EnclosedVolume | 1 double | mm², mm³ | signed volume: > 0 when faces look outward |
 * | field | LoopLengths | 1 double each | mm | longest first |
 * | field | NonManifoldEdges, InconsistentEdges, NonManifoldVertices, IsolatedVertices, DegenerateFaces, DuplicateFaces | 1 int | | counts |
 */
#ifndef vtkSurfaceTopologyReport_h
#define vtkSurfaceTopologyReport_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for Summary and Report

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSurfaceTopologyReport : public vtkSurfaceAlgorithm
{
public:
  static vtkSurfaceTopologyReport* New();
  vtkTypeMacro(vtkSurfaceTopologyReport, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What the last execution found, in one line; empty before it. */
  vtkGetMacro(Summary, std::string);

  /** All of it as JSON, every defect with its place; empty before the first execution and after an error. */
  vtkGetMacro(Report, std::string);

protected:
  vtkSurfaceTopologyReport() = default;
  ~vtkSurfaceTopologyReport() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  std::string Summary, Report;

private:
  vtkSurfaceTopologyReport(const vtkSurfaceTopologyReport&) = delete;
  void operator=(const vtkSurfaceTopologyReport&) = delete;
};

#endif
