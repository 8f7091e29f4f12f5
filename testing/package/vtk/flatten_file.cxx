#include <iostream>

#include <vtkDiscreteLieFlow.h>
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
  vtkNew<vtkDiscreteLieFlow> flow;
  flow->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkSurfaceFileWriter> writer;
  writer->SetInputConnection(flow->GetOutputPort());
  writer->SetFileName(argv[2]);
  const int written = writer->Write();  // runs the pipeline
  std::cout << flow->GetReport() << '\n';
  return written ? flow->GetErrorKind() : writer->GetErrorKind();
}
