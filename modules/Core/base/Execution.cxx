#include "Core/base/Execution.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

#include "Core/base/Error.h"

namespace authalic {

void Execution::report(double fraction, const std::string& stage) const {
  if (progress_) progress_(std::clamp(fraction, 0.0, 1.0), stage);
}

void Execution::throwIfCancelled() const {
  if (cancelled()) throw CancelledError();
}

int Execution::threads() const noexcept {
  if (threads_ > 0) return threads_;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

Execution Execution::part(double from, double to) const {
  Execution result(*this);
  if (progress_) {
    result.progress_ = [progress = progress_, from, to](double fraction, const std::string& stage) {
      progress(from + (to - from) * fraction, stage);
    };
  }
  return result;
}

void parallelFor(std::size_t count, const Execution& execution,
                 const std::function<void(std::size_t, std::size_t)>& body, std::size_t minimumChunk) {
  const std::size_t most = (count + minimumChunk - 1) / std::max<std::size_t>(minimumChunk, 1);
  const std::size_t chunks = std::min<std::size_t>(static_cast<std::size_t>(execution.threads()), most);
  if (chunks <= 1) {
    if (count > 0) body(0, count);
    return;
  }
  std::vector<std::exception_ptr> failures(chunks);
  const auto run = [&](std::size_t chunk) {
    try {
      body(count * chunk / chunks, count * (chunk + 1) / chunks);
    } catch (...) {
      failures[chunk] = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  for (std::size_t chunk = 1; chunk < chunks; ++chunk) workers.emplace_back(run, chunk);
  run(0);
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace authalic
