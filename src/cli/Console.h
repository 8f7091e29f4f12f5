/// @file
/// Words to the user: one line per failure, a progress bar on a terminal, Ctrl-C as a cancel request.
#pragma once

#include <stdexcept>
#include <string>

namespace authalic::cli {

/// Exit codes of the command (docs/cli.md).
enum ExitCode : int {
  Success = 0,
  SolverProblem = 1,
  UsageProblem = 2,
  SurfaceProblem = 3,
  NotConverged = 4,
  FileProblem = 5,
  Interrupted = 130,
};

/// A failure with its exit code and the one sentence that stderr gets.
class Failure : public std::runtime_error {
 public:
  Failure(int code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  [[nodiscard]] int code() const noexcept { return code_; }

 private:
  int code_;
};

/// Silences VTK's own output window and lets SIGINT and SIGTERM ask for a stop. Call once, first.
void prepareConsole();

/// True after SIGINT or SIGTERM. A second signal ends the process at once.
[[nodiscard]] bool interrupted() noexcept;

/// "authalic: sentence" on stderr, line breaks made spaces.
void sayError(const std::string& sentence);
void sayWarning(const std::string& sentence);
/// "authalic: sentence" on stderr: what went well.
void sayNote(const std::string& sentence);

/// A bar on stderr, shown only when stderr is a terminal and `quiet` is off; erased when it goes.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction, const std::string& stage);

 private:
  bool visible_;
  std::string last_;
};

}  // namespace authalic::cli
