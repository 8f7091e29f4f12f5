#include "Console.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <unistd.h>

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace authalic::cli {
namespace {

volatile std::sig_atomic_t stopRequested = 0;

void requestStop(int) { stopRequested = 1; }

/// Swallows what VTK says: every failure reaches the user as a sentence of ours.
class SilentWindow : public vtkOutputWindow {
 public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

void prepareConsole() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkNew<SilentWindow>());
  struct sigaction action = {};
  action.sa_handler = requestStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() noexcept { return stopRequested != 0; }

void sayError(const std::string& sentence) { std::fprintf(stderr, "authalic: %s\n", oneLine(sentence).c_str()); }

void sayWarning(const std::string& sentence) {
  std::fprintf(stderr, "authalic: warning: %s\n", oneLine(sentence).c_str());
}

void sayNote(const std::string& sentence) { sayError(sentence); }

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (visible_ && !last_.empty()) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double fraction, const std::string& stage) {
  if (!visible_) return;
  constexpr int width = 30;
  const int done = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * width));
  const std::string line = "[" + std::string(static_cast<std::size_t>(done), '=') +
                           std::string(static_cast<std::size_t>(width - done), ' ') + "] " +
                           std::to_string(static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0))) + "% " + stage;
  if (line == last_) return;
  last_ = line;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
}

}  // namespace authalic::cli
