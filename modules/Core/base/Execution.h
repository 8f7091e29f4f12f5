/// @file
/// Progress, cancellation and thread count: the separate last argument of every long computation.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace authalic {

/// Carries the caller's wishes into a long computation. A default-constructed Execution is silent,
/// cannot be cancelled and uses every core. Results never depend on it: same input, same bits.
class Execution {
 public:
  /// Called with the fraction done in [0, 1] and a short name of the stage.
  using ProgressFunction = std::function<void(double fraction, const std::string& stage)>;
  /// Returns true when the computation should stop at the next safe point.
  using CancelFunction = std::function<bool()>;

  Execution() = default;
  explicit Execution(ProgressFunction progress, CancelFunction cancel = {}, int threads = 0)
      : progress_(std::move(progress)), cancel_(std::move(cancel)), threads_(threads) {}

  /// Tell the caller how far we are; `fraction` is clamped to [0, 1].
  void report(double fraction, const std::string& stage) const;

  /// True when the caller asked to stop.
  [[nodiscard]] bool cancelled() const { return cancel_ && cancel_(); }

  /// Throws CancelledError when the caller asked to stop (for stages without a usable iterate).
  void throwIfCancelled() const;

  /// Threads to use, at least 1 (0 given = all cores).
  [[nodiscard]] int threads() const noexcept;

  /// An Execution whose 0…1 is shown to the caller as `from`…`to`.
  [[nodiscard]] Execution part(double from, double to) const;

  /// The same without progress, for work on another thread than the caller's, who is asked from there whether to stop.
  [[nodiscard]] Execution silent() const { return Execution({}, cancel_, threads_); }

 private:
  ProgressFunction progress_;
  CancelFunction cancel_;
  int threads_ = 0;
};

/// Calls body(begin, end) on contiguous chunks of [0, count) on `execution.threads()` threads.
///
/// The body may write only to places that belong to its own indices; then the result does not depend on
/// the number of threads. The first exception thrown by a chunk (in chunk order) is rethrown.
void parallelFor(std::size_t count, const Execution& execution,
                 const std::function<void(std::size_t begin, std::size_t end)>& body,
                 std::size_t minimumChunk = 1024);

}  // namespace authalic
