/**
 * @class vtkSurfaceAlgorithm
 * @brief What the surface filters of Authalic share: one guard, progress, abort and a thread count.
 *
 * A filter overrides Compute(), which may throw; RequestData() catches everything. A failure goes to the error
 * macro as one sentence (required, found, where, what to do), the outputs are emptied and the pipeline is told that
 * the request failed. GetErrorKind() says which kind of failure it was. Inputs are never modified.
 *
 * Maps are global. Where a pipeline streams pieces, piece 0 is the whole output and the others are empty. On several
 * processes (MPI) the pieces of every input surface are gathered and joined on process 0, which alone computes; the
 * outputs of the others are empty. A surface whose pieces meet along a seam is refused in words.
 *
 * Abort is honoured between the iterations of a method: set AbortExecute from an observer of ProgressEvent. The
 * name of the stage is in ProgressText.
 */
#ifndef vtkSurfaceAlgorithm_h
#define vtkSurfaceAlgorithm_h

#include "vtkAuthalicFiltersCommonModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

namespace authalic
{
class Execution;
}

class VTKAUTHALICFILTERSCOMMON_EXPORT vtkSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Kinds of failure; the numbers are the exit codes of the command line. */
  enum ErrorKindType
  {
    NONE = 0,
    SOLVER = 1,
    ARGUMENT = 2,
    SURFACE = 3,
    NOT_CONVERGED = 4,
    FORMAT = 5,
    CANCELLED = 130
  };

  /** How the last execution ended. NOT_CONVERGED comes with an output (the best iterate), the others without. */
  vtkGetMacro(ErrorKind, int);

  ///@{
  /** Threads to use; 0 = every core. The result does not depend on it. Range 0 to 1024, default 0. */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkSurfaceAlgorithm() = default;
  ~vtkSurfaceAlgorithm() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** Says that every piece of the output can be asked for. */
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** Asks every input for all of it: volumes of different sizes may meet in one filter. */
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** The work of the filter; may throw. */
  virtual void Compute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, const authalic::Execution& execution) = 0;

  int Threads = 0;
  int ErrorKind = NONE;

private:
  vtkSurfaceAlgorithm(const vtkSurfaceAlgorithm&) = delete;
  void operator=(const vtkSurfaceAlgorithm&) = delete;
};

#endif
