/// White surfaces of more than a hundred thousand vertices, from a T1 volume to their exact maps.
#include <gtest/gtest.h>

#include <vtkAuthalicMap.h>
#include <vtkCorticalSurface.h>
#include <vtkCutToDisk.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalAuthalicMap.h>
#include <vtkVolumeFileReader.h>

#include "support/SharedData.h"

namespace {

using authalic::testing::sharedData;

template <class Map>
void expectExact(Map* map) {
  map->Update();
  EXPECT_EQ(map->GetStatus(), "converged");
  EXPECT_EQ(map->GetFlippedFaces(), 0);
  EXPECT_GT(map->GetOutput()->GetNumberOfPoints(), 100'000);
}

}  // namespace

TEST(LargeCorticesSlow, AreMappedExactlyThoughTheyAreHardlySmoothed) {
  const std::string t1 = sharedData("cortex/subject1_fs/brain.mgz"),
                    labels = sharedData("cortex/subject1_fs/aparc+aseg.mgz");
  AUTHALIC_NEEDS(t1);
  AUTHALIC_NEEDS(labels);
  vtkNew<vtkVolumeFileReader> volume, regions;
  volume->SetFileName(t1.c_str());
  regions->SetFileName(labels.c_str());
  vtkNew<vtkCorticalSurface> surfaces;
  surfaces->SetInputConnection(0, volume->GetOutputPort());
  surfaces->SetInputConnection(1, regions->GetOutputPort());
  surfaces->SetLabelConventionToFreeSurfer();
  surfaces->SetTargetFaces(240'000);
  surfaces->SetSmoothingIterations(8);
  for (const int side : {0, 1}) {
    vtkNew<vtkSphericalAuthalicMap> sphere;
    sphere->SetInputConnection(surfaces->GetOutputPort(side));
    expectExact(sphere.Get());
    vtkNew<vtkCutToDisk> cut;
    cut->SetInputConnection(surfaces->GetOutputPort(side));
    cut->SetRegionArrayName("MedialWall");
    vtkNew<vtkAuthalicMap> disk;
    disk->SetInputConnection(cut->GetOutputPort());
    expectExact(disk.Get());
  }
}
