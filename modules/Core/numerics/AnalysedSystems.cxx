#include "Core/numerics/AnalysedSystems.h"

#include <algorithm>
#include <utility>

namespace authalic {
namespace {

constexpr std::size_t kMost = 6;  // two domains of a map, three systems each

}  // namespace

AssembledSystem::AssembledSystem(int unknownCount, std::vector<int> starts, std::vector<int> unknowns,
                                 SolverBackend backend, PatternUse use, int threads)
    : unknownCount_(unknownCount), starts_(std::move(starts)), unknowns_(std::move(unknowns)), backend_(backend),
      use_(use), assembly_(unknownCount, starts_, unknowns_), solver_(backend, use, threads) {}

void AssembledSystem::factorize(const SparseMatrix& lower) {
  if (!analysed_) solver_.analyze(lower);
  analysed_ = true;
  solver_.factorize(lower);
}

std::shared_ptr<AssembledSystem> AnalysedSystems::of(int unknownCount, std::vector<int> starts,
                                                     std::vector<int> unknowns, SolverBackend backend,
                                                     PatternUse use) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& system) {
    return system->unknownCount_ == unknownCount && system->backend_ == backend && system->use_ == use &&
           system->starts_ == starts && system->unknowns_ == unknowns;
  });
  std::shared_ptr<AssembledSystem> system;
  if (found != kept_.end()) {
    system = *found;
    kept_.erase(found);
  } else {
    if (kept_.size() == kMost) kept_.erase(kept_.begin());
    system = std::make_shared<AssembledSystem>(unknownCount, std::move(starts), std::move(unknowns), backend, use,
                                               threads_);
  }
  kept_.push_back(system);
  return system;
}

std::shared_ptr<AssembledSystem> AnalysedSystems::of(int unknownCount, const ElementAssembly::Unknowns& elements,
                                                     SolverBackend backend, PatternUse use) {
  std::vector<int> starts(static_cast<std::size_t>(elements.rows()) + 1);
  for (std::size_t e = 0; e < starts.size(); ++e) starts[e] = static_cast<int>(e) * static_cast<int>(elements.cols());
  return of(unknownCount, std::move(starts), std::vector<int>(elements.data(), elements.data() + elements.size()),
            backend, use);
}

}  // namespace authalic
