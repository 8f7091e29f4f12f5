// Flattens a closed hemisphere in C++: read, cut where a plane says, map, write.
//
//   flatten SURFACE MAP.vtp X Y Z NX NY NZ     removes the side of the plane that (NX, NY, NZ) points to
//
// Ends with the exit codes of the command `authalic`, see docs/cli.md.
#include <array>
#include <cstdlib>
#include <iostream>

#include <vtkAuthalicMap.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCutToDisk.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSurfaceFileReader.h>
#include <vtkSurfaceFileWriter.h>

namespace {

// No exception leaves a filter: an error is a sentence in its ErrorEvent, an empty output and an ErrorKind.
void say(vtkObject*, unsigned long, void*, void* sentence) { std::cerr << static_cast<const char*>(sentence); }

void progress(vtkObject* caller, unsigned long, void*, void*) {
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  std::cerr << '\r' << static_cast<int>(100 * filter->GetProgress()) << " % "
            << (filter->GetProgressText() ? filter->GetProgressText() : "") << "        ";
}

double number(vtkDataObject* object, const char* field) {
  vtkDataArray* array = object->GetFieldData()->GetArray(field);
  return array ? array->GetComponent(0, 0) : 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 9) {
    std::cerr << "usage: flatten SURFACE MAP.vtp X Y Z NX NY NZ\n";
    return 2;
  }
  double plane[6];
  for (int k = 0; k < 6; ++k) plane[k] = std::atof(argv[3 + k]);

  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkCutToDisk> cut;
  cut->SetInputConnection(reader->GetOutputPort());
  cut->SetRegionModeToPlane();
  cut->SetPlaneOrigin(plane);
  cut->SetPlaneNormal(plane + 3);
  vtkNew<vtkAuthalicMap> exact;
  exact->SetInputConnection(cut->GetOutputPort());

  vtkNew<vtkCallbackCommand> speaker, bar;
  speaker->SetCallback(say);
  bar->SetCallback(progress);
  const std::array<vtkSurfaceAlgorithm*, 3> filters = {reader.Get(), cut.Get(), exact.Get()};
  for (vtkSurfaceAlgorithm* filter : filters) {
    filter->AddObserver(vtkCommand::ErrorEvent, speaker);
    filter->AddObserver(vtkCommand::ProgressEvent, bar);
  }
  exact->Update();  // the whole pipeline
  std::cerr << "\n";
  for (vtkSurfaceAlgorithm* filter : filters) {
    const int kind = filter->GetErrorKind();
    if (kind != vtkSurfaceAlgorithm::NONE && kind != vtkSurfaceAlgorithm::NOT_CONVERGED) return kind;
  }

  vtkNew<vtkSurfaceFileWriter> writer;
  writer->SetFileName(argv[2]);
  writer->SetInputConnection(exact->GetOutputPort());
  if (!writer->Write()) return writer->GetErrorKind();
  std::cout << exact->GetOutput()->GetNumberOfPoints() << " vertices, total area distortion "
            << number(exact->GetOutput(), "TotalAreaDistortion") << " (ideal 2), flipped faces "
            << number(exact->GetOutput(), "FlippedFaces") << "\n";
  return exact->GetErrorKind();
}
