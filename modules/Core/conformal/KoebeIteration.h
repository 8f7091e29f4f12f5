/// @file
/// Koebe's iteration: one boundary loop after the other made round. Private to conformal/.
#pragma once

#include "Core/conformal/CircleDomainMap.h"

namespace authalic {

/// Fills image (outer loop outermost, not normalised), status, rounds, iterations, residual, holonomy and edgeFlips
/// of the result.
void koebeIteration(const PolyAnnulusMesh& surface, const CircleDomainOptions& options, const Execution& execution,
                    CircleDomainResult& result);

}  // namespace authalic
