/// @file
/// What an algorithm of VTK says, held for a test and kept from the console.
#pragma once

#include <string>
#include <vector>

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

namespace authalic::testing {

/// Holds the errors and warnings of an algorithm for as long as it lives; what the executive adds to an error
/// ("Algorithm … returned failure") is kept from the console and not held.
class VtkWords {
 public:
  explicit VtkWords(vtkAlgorithm* algorithm) : algorithm_(algorithm) {
    note_->SetClientData(this);
    note_->SetCallback([](vtkObject*, unsigned long event, void* self, void* words) {
      static_cast<VtkWords*>(self)->add(event, static_cast<const char*>(words));
    });
    tags_ = {algorithm->AddObserver(vtkCommand::ErrorEvent, note_),
             algorithm->AddObserver(vtkCommand::WarningEvent, note_)};
    executiveTag_ = algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet_);
  }
  ~VtkWords() {
    for (const unsigned long tag : tags_) algorithm_->RemoveObserver(tag);
    algorithm_->GetExecutive()->RemoveObserver(executiveTag_);
  }
  VtkWords(const VtkWords&) = delete;
  VtkWords& operator=(const VtkWords&) = delete;

  [[nodiscard]] const std::string& errors() const noexcept { return errors_; }
  [[nodiscard]] const std::string& warnings() const noexcept { return warnings_; }
  /// The errors and then the warnings.
  [[nodiscard]] std::string text() const { return errors_ + warnings_; }
  [[nodiscard]] bool contain(const std::string& words) const { return text().find(words) != std::string::npos; }

 private:
  void add(unsigned long event, const char* words) {
    (event == vtkCommand::ErrorEvent ? errors_ : warnings_) += words ? words : "";
  }

  vtkSmartPointer<vtkAlgorithm> algorithm_;
  vtkNew<vtkCallbackCommand> note_, quiet_;
  std::vector<unsigned long> tags_;
  unsigned long executiveTag_ = 0;
  std::string errors_, warnings_;
};

/// Runs the algorithm; what it said.
inline std::string wordsOf(vtkAlgorithm* algorithm) {
  const VtkWords words(algorithm);
  algorithm->Update();
  return words.text();
}

}  // namespace authalic::testing
