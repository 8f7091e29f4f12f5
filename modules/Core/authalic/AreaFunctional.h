/// @file
/// The areas of the faces of an image as functions of what its vertices may do, one class per kind of domain.
/// Private to authalic/.
#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "Core/authalic/EarsOnCircle.h"
#include "Core/base/Arrays.h"

namespace authalic {

struct Patch;

/// n×d points of an image: d = 2 in the plane, 3 on the sphere.
using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How corners in the plane move with parameters of the domain: linear in them.
struct CornerMoves {
  using Table = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<int> row;  ///< per corner 3 f + k, −1 for those that no parameter moves
  Table moves;           ///< by each of the complex parameters
};

/// Areas a_t(x) of the faces of an image x whose vertices may move in 0, 1 or 2 directions each.
///
/// A vertex with freedom f has the unknowns unknown(v, 0) … unknown(v, f − 1): steps along f orthonormal
/// directions, its frame, which depends on the image (tangents of the circle or the sphere). A *displacement* is
/// n×d, the frames applied to a step. Moving by a displacement ends on the domain again (retraction), so it is
/// exact to first order only.
class AreaFunctional {
 public:
  /// Row v holds the f directions of vertex v, one after the other: n×(2 d), zeros where there is none.
  using Frames = Coordinates;
  /// Derivatives of the areas by steps: entry (t, 2 k + j) belongs to direction j of corner k.
  using Gradients = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
  /// Where the corners of one face lie, as the face sees them: 3×d.
  using Corners = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor, 3, 3>;
  /// Directions of the corners of one face, as the face sees them: row 2 k + j is direction j of corner k.
  using Directions = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor, 6, 3>;

  virtual ~AreaFunctional() = default;

  [[nodiscard]] const Faces& faces() const noexcept { return faces_; }
  [[nodiscard]] int vertexCount() const noexcept { return static_cast<int>(first_.size()); }
  [[nodiscard]] int unknownCount() const noexcept { return unknownCount_; }
  [[nodiscard]] int freedom(int vertex) const { return freedom_[static_cast<std::size_t>(vertex)]; }
  /// Number of direction j of a vertex, −1 when the vertex has none such.
  [[nodiscard]] int unknown(int vertex, int j) const {
    return j < freedom(vertex) ? first_[static_cast<std::size_t>(vertex)] + j : -1;
  }

  /// 3m×2: corner 3 f + k of a periodic image lies at x_v + shift; no rows for other images.
  [[nodiscard]] virtual const Points2& shifts() const;
  /// Signed areas of all faces: m values, > 0 where a face is not folded. O(m)
  [[nodiscard]] virtual Eigen::VectorXd areas(const Coordinates& image) const = 0;
  [[nodiscard]] virtual Frames frames(const Coordinates& image) const = 0;
  /// ∂a_t along the frames. O(m)
  [[nodiscard]] virtual Gradients gradients(const Coordinates& image, const Frames& frames) const = 0;
  /// By default the rows of the image.
  [[nodiscard]] virtual Corners corners(const Coordinates& image, int face) const;
  /// By default the rows of the frames.
  [[nodiscard]] virtual Directions directions(const Frames& frames, int face) const;
  /// image + t · displacement, back on the domain.
  [[nodiscard]] virtual Coordinates moved(const Coordinates& image, const Coordinates& displacement,
                                          double t) const = 0;
  /// Displacements that move many vertices at once, free like the unknowns: of circles in the plane. By default none.
  [[nodiscard]] virtual std::vector<Coordinates> jointMoves(const Coordinates& image) const;
  /// Parameters of the domain, free like the unknowns, whose values are the last rows of images and displacements; by
  /// default none.
  [[nodiscard]] virtual const CornerMoves* parameters() const { return nullptr; }
  /// A displacement with every row made shorter to its part in [0, 1]; joint moves stay such.
  [[nodiscard]] virtual Coordinates slowed(const Coordinates& image, const Coordinates& displacement,
                                           const Eigen::VectorXd& part) const;
  /// The image with vertices where their areas are right that derivatives do not lead there; by default the image.
  [[nodiscard]] virtual Coordinates eased(Coordinates image) const { return image; }
  /// Whether face steps look at the stars of vertices with one freedom, see BoundaryStars; not with joint moves.
  [[nodiscard]] virtual bool looksAtBoundaryStars() const { return true; }
  /// Ears whose tips have a freedom of their own, as the ends of their bases have; by default none.
  [[nodiscard]] virtual const std::vector<EarOnCircle>& slidingEars() const;
  /// The same areas in a patch whose rim is held, of an image of its vertices alone. The patch is kept by reference.
  /// @param image  of the whole: what else it says of the corners in the patch is held as well
  [[nodiscard]] virtual std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const = 0;
  /// First t > 0 at which the corners of a face that move by `displacement` are in line, +infinity when never;
  /// 0 for a folded face. Exact for straight motion; see moved().
  [[nodiscard]] virtual double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const = 0;

  /// The frames applied to a step of unknownCount() numbers: n×d.
  [[nodiscard]] virtual Coordinates displacement(const Frames& frames, const Eigen::VectorXd& step) const;

 protected:
  /// @param freedom  n values 0, 1 or 2
  AreaFunctional(const Faces& faces, std::vector<char> freedom);

 private:
  const Faces& faces_;
  std::vector<char> freedom_;
  std::vector<int> first_;
  int unknownCount_ = 0;
};

}  // namespace authalic
