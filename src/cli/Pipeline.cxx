#include "Pipeline.h"

#include <string>
#include <vector>

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace authalic::cli {
namespace {

/// "ERROR: In file, line 7\nvtkClass (0x1234): sentence\n\n" -> "sentence"
std::string sentenceOf(const char* text) {
  std::string message = text ? text : "";
  const std::size_t line = message.find('\n'), start = message.find("): ", line == std::string::npos ? 0 : line);
  if (start != std::string::npos) message.erase(0, start + 3);
  message.erase(message.find_last_not_of(" \n") + 1);
  return message;
}

class Listener : public vtkCommand {
 public:
  static Listener* New() { return new Listener; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (event == vtkCommand::ErrorEvent) errors.push_back(sentenceOf(static_cast<const char*>(data)));
    if (event == vtkCommand::WarningEvent) warnings.push_back(sentenceOf(static_cast<const char*>(data)));
    if (event != vtkCommand::ProgressEvent || !algorithm) return;
    if (interrupted()) algorithm->SetAbortExecute(1);
    const char* stage = algorithm->GetProgressText();
    if (bar) bar->show(*static_cast<double*>(data), stage ? stage : "");
  }

  ProgressBar* bar = nullptr;
  std::vector<std::string> errors, warnings;
};

}  // namespace

void runAlgorithm(vtkAlgorithm* algorithm, const std::function<void()>& action, const std::function<int()>& kind) {
  vtkNew<Listener> listener;
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ErrorEvent, listener);
  action();
  algorithm->RemoveObserver(tag);
  const int code = kind();
  if (code == Success && listener->errors.empty()) return;
  throw Failure(code == Success ? SolverProblem : code,
                listener->errors.empty() ? "The file could not be written." : listener->errors.front());
}

int updateAlgorithm(vtkAlgorithm* algorithm, const Session& session, const std::function<int()>& kind) {
  vtkNew<Listener> listener;
  {
    ProgressBar bar(session.quiet);
    listener->bar = &bar;
    const unsigned long tags[] = {algorithm->AddObserver(vtkCommand::ErrorEvent, listener),
                                  algorithm->AddObserver(vtkCommand::WarningEvent, listener),
                                  algorithm->AddObserver(vtkCommand::ProgressEvent, listener)};
    algorithm->Update();
    for (const unsigned long tag : tags) algorithm->RemoveObserver(tag);
    listener->bar = nullptr;
  }
  for (const std::string& warning : listener->warnings) {
    if (!session.quiet) sayWarning(warning);
  }
  const int code = kind();
  if (interrupted() || code == Interrupted) throw Failure(Interrupted, "Interrupted; nothing was written.");
  if (code == Success && listener->errors.empty()) return Success;
  if (code == NotConverged) return NotConverged;
  throw Failure(code == Success ? SolverProblem : code,
                listener->errors.empty() ? "The computation failed." : listener->errors.front());
}

}  // namespace authalic::cli
