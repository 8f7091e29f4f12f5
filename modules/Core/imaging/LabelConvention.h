/// @file
/// What the numbers of a label volume mean for the extraction of the cortical surface.
#pragma once

#include <cstdint>
#include <vector>

namespace authalic {

/// Lists of label ids; an id may be in several (a left thalamus is `left` and `fill`). Ids in no list are
/// ignored.
struct LabelConvention {
  std::vector<std::int32_t> left;    ///< regions of the left hemisphere
  std::vector<std::int32_t> right;   ///< regions of the right hemisphere
  std::vector<std::int32_t> remove;  ///< cerebellum, brainstem, chiasm
  std::vector<std::int32_t> fill;    ///< ventricles and subcortical grey matter, taken as white
  /// True when the ids in `remove` and `fill` name the brainstem and the ventricles; false (AAL) lets
  /// CerebralPrior supply them.
  bool namesBrainstemAndVentricles = false;

  /// AAL: odd ids left, even right; 71–78 caudate, putamen, pallidum, thalamus; 91–116 cerebellum.
  [[nodiscard]] static LabelConvention aal();
  /// FreeSurfer's aseg and aparc+aseg (also aparc.a2009s+aseg).
  [[nodiscard]] static LabelConvention freeSurfer();
};

}  // namespace authalic
