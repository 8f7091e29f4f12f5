/// @file
/// The discrete Laplacian: cotangent stiffness, mean-value weights, and the operators that go with them.
#pragma once

#include <Eigen/Core>

#include "Core/mesh/TriangleMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// One number per half-edge: entry (f, k) belongs to the half-edge from corner k to corner k+1 of face f.
using HalfEdgeWeights = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// ½ cot of the angle opposite to each half-edge. @cite pinkall1993
///
/// The double area in the denominator is kept above 1e-10 of the squared edge lengths, so that a degenerate face
/// gives large finite weights whose element matrix is still positive semi-definite.
[[nodiscard]] HalfEdgeWeights cotangentWeights(const TriangleMesh& surface);
[[nodiscard]] HalfEdgeWeights cotangentWeights(const Points3& points, const Faces& faces);
/// The same in the plane (angles do not depend on orientation).
/// @param shifts  3m×2 or empty: corner 3 f + k of a periodic image lies at points(v) + shift; also below
[[nodiscard]] HalfEdgeWeights cotangentWeights(const Points2& points, const Faces& faces, const Points2& shifts = {});

/// Mean-value weights @cite floater2003 of each half-edge i→j, this face's part: tan(α_i/2)/|ij| forwards and
/// tan(α_j/2)/|ij| backwards. Positive on every face with positive area; not symmetric.
struct MeanValueWeights {
  HalfEdgeWeights forward, backward;
};
[[nodiscard]] MeanValueWeights meanValueWeights(const TriangleMesh& surface);
/// The same in the plane, with unsigned angles: positive also on folded faces. Where no face around an inner vertex is
/// folded, the vertex is the mean of its neighbours with these weights.
[[nodiscard]] MeanValueWeights meanValueWeights(const Points2& points, const Faces& faces, const Points2& shifts = {});

/// Cotangent stiffness L (n×n, lower triangle): L_ij = −½(cot α + cot β), L_ii = −Σ_j L_ij.
///
/// Positive semi-definite, L·1 = 0, uᵀLu = ∫|∇u|². This is minus the Laplace operator, integrated: on a surface
/// of n vertices it does not depend on scale. Complexity O(m). @cite pinkall1993
[[nodiscard]] SparseMatrix cotangentStiffness(const TriangleMesh& surface);
[[nodiscard]] SparseMatrix cotangentStiffness(const Points2& points, const Faces& faces);

/// Gradient of the piecewise linear function u on each face of a planar mesh, m×2.
/// Faces without area have gradient 0.
[[nodiscard]] Points2 faceGradients(const Points2& points, const Faces& faces, const Eigen::VectorXd& u,
                                    const Points2& shifts = {});

/// Face gradients averaged to the vertices with the incident angles as weights, n×2.
/// @cite zou2011 (eq. 16)
[[nodiscard]] Points2 vertexGradients(const Points2& points, const Faces& faces, const Eigen::VectorXd& u,
                                      const Points2& shifts = {});
/// The same on a surface, n×3: the gradients of the flat faces, which need not be tangential at a vertex.
[[nodiscard]] Points3 vertexGradients(const Points3& points, const Faces& faces, const Eigen::VectorXd& u);

}  // namespace authalic
