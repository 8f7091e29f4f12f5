/// @file
/// Maps are global: a surface that several processes share is gathered before anything is computed.
#pragma once

#include <functional>

#include "Core/base/Execution.h"
#include "vtkAuthalicFiltersCommonModule.h"

class vtkAlgorithm;
class vtkInformationVector;

namespace authalic {

/// Asks the inputs for all of them: the whole extent of an image; on one process also the whole surface, whatever piece
/// of the output is asked for. For RequestUpdateExtent.
VTKAUTHALICFILTERSCOMMON_EXPORT void requestWholeInputs(vtkAlgorithm* filter, vtkInformationVector** inputs);

/// Says that the outputs come in as many pieces as asked for (the first is everything, the others are empty), so that
/// every process takes part. For RequestInformation.
VTKAUTHALICFILTERSCOMMON_EXPORT void announcePieces(vtkInformationVector* outputs);

/// What a body of work gets: its inputs, and where progress goes.
using WholeBody = std::function<void(vtkInformationVector** inputs, const Execution& execution)>;

/// runGuarded() on whole inputs.
///
/// On one process: the body runs where piece 0 of the output is asked for; other pieces are empty.
///
/// On several processes (VTK's global controller has more than one): the surfaces of every input port are gathered on
/// process 0 and joined (see joinPieces), the body runs there alone, the outputs of the other processes are empty, and
/// all of them end with the same `kind` and return value. Every process must call this, or the others wait for it.
/// Images are not gathered: requestWholeInputs() has asked for all of them.
VTKAUTHALICFILTERSCOMMON_EXPORT int runOnWholeInputs(vtkAlgorithm* filter, vtkInformationVector** inputs,
                                                     vtkInformationVector* outputs, int threads, int& kind,
                                                     const WholeBody& body);

}  // namespace authalic
