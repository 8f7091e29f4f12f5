#include <cmath>
#include <iostream>

#include "Core/authalic/AuthalicMap.h"

int main() {
  const int n = 41;  // points per side of a bumpy sheet, mm
  authalic::Points3 points(n * n, 3);
  authalic::Faces faces(2 * (n - 1) * (n - 1), 3);
  for (int i = 0; i < n * n; ++i) points.row(i) << i % n, i / n, 8 * std::sin(0.2 * (i % n)) * std::cos(0.15 * (i / n));
  for (int q = 0, f = 0; q < n * (n - 1); ++q) {
    if (q % n == n - 1) continue;
    faces.row(f++) << q, q + 1, q + n;
    faces.row(f++) << q + 1, q + n + 1, q + n;
  }
  const authalic::DiskMesh disk(authalic::TriangleMesh(points, faces));  // throws unless it is a topological disk
  authalic::AuthalicMapOptions options;
  options.tolerance = 0.02;  // of the faces; vertices are exact whatever it is
  const authalic::AuthalicMapResult flat =
      authalic::authalicMap(disk, authalic::TargetMeasure(disk.mesh()), options);
  std::cout << authalic::statusName(flat.status) << ", residual " << flat.faceResidual << ", " << flat.flippedFaces
            << " folded faces\n";
  return flat.status == authalic::Status::Converged ? 0 : 4;
}
