#include <iostream>

#include <vtkAuthalicMap.h>
#include <vtkNew.h>
#include <vtkSurfaceFileReader.h>
#include <vtkSurfaceFileWriter.h>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: flatten_file DISK MAP.vtp\n";
    return 2;
  }
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkAuthalicMap> exact;
  exact->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkSurfaceFileWriter> writer;
  writer->SetInputConnection(exact->GetOutputPort());
  writer->SetFileName(argv[2]);
  const int written = writer->Write();  // runs the pipeline
  std::cout << exact->GetReport() << '\n';
  return written ? exact->GetErrorKind() : writer->GetErrorKind();
}
