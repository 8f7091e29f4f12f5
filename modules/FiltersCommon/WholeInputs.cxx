#include "WholeInputs.h"

#include <vector>

#include <vtkAlgorithm.h>
#include <vtkCommunicator.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include "FilterGuard.h"
#include "GatheredSurface.h"

namespace authalic {
namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The controller when there are several processes, else nothing.
vtkMultiProcessController* severalProcesses() {
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

bool wantsLaterPiece(vtkInformationVector* outputs) {
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
    vtkInformation* output = outputs->GetInformationObject(port);
    if (output->Has(Pipeline::UPDATE_PIECE_NUMBER()) && output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0) return true;
  }
  return false;
}

void emptyAll(vtkInformationVector* outputs) {
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port)) output->Initialize();
  }
}

/// The surfaces of one connection on process 0, in the order of the processes. Every process calls this.
std::vector<vtkSmartPointer<vtkPolyData>> gatherPieces(vtkPolyData* own, vtkMultiProcessController* controller) {
  const int elsewhere = controller->GetLocalProcessId() == 0 ? 0 : static_cast<int>(own->GetNumberOfPoints());
  int anyElsewhere = 0;
  controller->AllReduce(&elsewhere, &anyElsewhere, 1, vtkCommunicator::MAX_OP);
  if (anyElsewhere == 0) return {own};
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  controller->Gather(own, received, 0);
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  for (const auto& object : received) pieces.emplace_back(vtkPolyData::SafeDownCast(object));
  return pieces;
}

/// Copies of the input information, in which surfaces can be replaced without touching the pipeline's own.
class Inputs {
 public:
  Inputs(vtkAlgorithm* filter, vtkInformationVector** inputs) {
    for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port) {
      ports_.push_back(vtkSmartPointer<vtkInformationVector>::New());
      ports_.back()->Copy(inputs[port], 1);
      raw_.push_back(ports_.back());
    }
  }
  [[nodiscard]] vtkInformationVector** get() { return raw_.data(); }

  template <class Work>
  void forEachSurface(const Work& work) {
    for (vtkInformationVector* port : raw_) {
      for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i) {
        vtkInformation* information = port->GetInformationObject(i);
        if (vtkPolyData* surface = vtkPolyData::GetData(information)) work(information, surface);
      }
    }
  }

 private:
  std::vector<vtkSmartPointer<vtkInformationVector>> ports_;
  std::vector<vtkInformationVector*> raw_;
};

int runOnProcessZero(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs, int threads,
                     int& kind, vtkMultiProcessController* controller, const WholeBody& body) {
  const bool works = controller->GetLocalProcessId() == 0;
  Inputs whole(filter, inputs);
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> pieces;
  whole.forEachSurface([&](vtkInformation*, vtkPolyData* own) { pieces.push_back(gatherPieces(own, controller)); });
  int ended[2] = {1, NoFailure};
  if (works) {
    ended[0] = runGuarded(filter, outputs, threads, kind, [&](const Execution& execution) {
      auto next = pieces.begin();
      whole.forEachSurface([&](vtkInformation* information, vtkPolyData*) {
        information->Set(vtkDataObject::DATA_OBJECT(), joinPieces(*next++));
      });
      body(whole.get(), execution);
    });
    ended[1] = kind;
  } else {
    emptyAll(outputs);
  }
  controller->Broadcast(ended, 2, 0);
  kind = ended[1];
  return ended[0];
}

}  // namespace

void requestWholeInputs(vtkAlgorithm* filter, vtkInformationVector** inputs) {
  const bool alone = severalProcesses() == nullptr;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port) {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i) {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (input->Has(Pipeline::WHOLE_EXTENT())) {
        int extent[6];
        input->Get(Pipeline::WHOLE_EXTENT(), extent);
        input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
      } else if (alone) {
        input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
        input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      }
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
}

void announcePieces(vtkInformationVector* outputs) {
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
    outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
}

int runOnWholeInputs(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs, int threads,
                     int& kind, const WholeBody& body) {
  if (vtkMultiProcessController* controller = severalProcesses()) {
    return runOnProcessZero(filter, inputs, outputs, threads, kind, controller, body);
  }
  if (wantsLaterPiece(outputs)) {
    emptyAll(outputs);
    kind = NoFailure;
    return 1;
  }
  return runGuarded(filter, outputs, threads, kind,
                    [&](const Execution& execution) { body(inputs, execution); });
}

}  // namespace authalic
