/// @file
/// The stages of the Lie flows on any domain, and the steps that they share. Private to authalic/.
#pragma once

#include <memory>

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/LieAdvection.h"
#include "Core/initial/Unfold.h"

namespace authalic {

/// What a Lie flow needs to know of a surface and of the domain that it is mapped to.
class LieFlowDomain {
 public:
  LieFlowDomain(const Faces& faces, const TargetMeasure& target)
      : faces_(faces), target_(target), flowingTargets_(target.vertices()) {}
  virtual ~LieFlowDomain() = default;

  [[nodiscard]] const Faces& faces() const noexcept { return faces_; }
  [[nodiscard]] const TargetMeasure& target() const noexcept { return target_; }
  /// m flags: faces that do not flow; empty = none.
  [[nodiscard]] const std::vector<char>& frozen() const noexcept { return frozen_; }
  /// Target shares of the vertices of the faces that flow, summing to 1; 0 elsewhere.
  [[nodiscard]] const Eigen::VectorXd& flowingTargets() const noexcept { return flowingTargets_; }

  /// 3m×2: shifts of the corners of a periodic image, see periodicFaceAreas(); no rows for other images.
  [[nodiscard]] virtual const Points2& shifts() const;
  /// Areas and freedoms on a mesh with the vertices of the surface; kept by reference, and may flip edges.
  [[nodiscard]] virtual std::unique_ptr<AreaFunctional> areasOn(const Faces& faces, const Points2& shifts) const = 0;
  /// The same on the faces of the surface, for systems that must have one solution: where the domain can be moved into
  /// itself without deforming a face, a vertex is held.
  [[nodiscard]] virtual std::unique_ptr<AreaFunctional> heldAreas() const { return areasOn(faces_, shifts()); }
  /// The image with its folded faces unfolded, as far as that goes.
  [[nodiscard]] virtual Coordinates unfolded(const Coordinates& image, UnfoldReach reach) const = 0;
  /// The image with collapsed faces opened again.
  [[nodiscard]] virtual Coordinates revived(const Coordinates& image) const { return image; }
  /// Puts the vertices of frozen faces where the others have gone.
  virtual void carryFrozen(Coordinates&) const {}

 protected:
  /// Leaves faces out of the flow.
  void freeze(std::vector<char> faces);

 private:
  const Faces& faces_;
  const TargetMeasure& target_;
  std::vector<char> frozen_;
  Eigen::VectorXd flowingTargets_;
};

/// Folded faces of an image: those without a positive area.
[[nodiscard]] int countFolded(const AreaFunctional& areas, const Coordinates& image);

/// Residual and mean |ln r| of the vertex stars, see LieFlowIteration.
/// @param areas    image areas of the vertex stars, any scale
/// @param targets  target shares; vertices with target 0 are left out
[[nodiscard]] LieFlowIteration measureStars(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets);

/// The velocity ∇h of the flow at every vertex, along the domain: L h = rightHandSide (whose sum is 0) with natural
/// boundary, L the cotangent stiffness of the flat faces; face gradients averaged with the incident angles. 0 at
/// vertices that no face uses.
/// @throws SolverError when the matrix cannot be factorised
[[nodiscard]] Coordinates poissonVelocity(const AreaFunctional& areas, const Coordinates& image,
                                          const Eigen::VectorXd& rightHandSide, SolverBackend backend);

/// Removes from velocities (n×d) what would leave the domain.
void keepTangential(const AreaFunctional& areas, const Coordinates& image, Coordinates& velocity);

/// A triangle that moves rigidly cannot collapse: where a few triangles would pin the whole flow (they collapse
/// before the wanted part of the step), their corners take the mean velocity of their neighbours instead, a few
/// times over.
void relaxPinned(const AreaFunctional& areas, const Coordinates& image, double wanted, Coordinates& velocity);

/// A few thin triangles must not stop the whole map: slows vertices, and only those, whose faces collapse before the
/// wanted part of the step, to half of what would collapse them. @return how many
int slowPinned(const AreaFunctional& areas, const Coordinates& image, double wanted, Coordinates& displacement);

/// The smallest firstFlip of all faces.
[[nodiscard]] double flipFreeStep(const AreaFunctional& areas, const Coordinates& image, const Coordinates& velocity);

/// From a start without folds: the flow, the finish and the final measure, as options say. Fills everything but
/// balancedStart and startSeconds.
void runLieFlow(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                Coordinates& image, LieFlowSolution& solution);

/// Flows the image on a mesh that flips its edges; fills iterations, history, collapsed, status, and
/// flowUndone where a few faces pinned the flow far from its target.
void flowWithFlips(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                   Coordinates& image, LieFlowSolution& solution);

/// Least-squares Lie steps on the original connectivity; the image must have no fold, and keeps none.
void matchAreas(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                Coordinates& image, LieFlowSolution& solution);

/// From a start without folds: K steps of Lie advection. Fills everything but startSeconds.
void runLieAdvection(const LieFlowDomain& domain, const LieAdvectionOptions& options, const Execution& execution,
                     Coordinates& image, LieAdvectionSolution& solution);

}  // namespace authalic
