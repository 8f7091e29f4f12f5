# VTK itself.
# COMPONENTS are always listed: without them VTK looks for Qt.
set(AUTHALIC_VTK_COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMisc
  IOCore IOXML IOLegacy IOGeometry IOPLY ImagingCore FiltersCore ParallelCore)
set(authalic_vtk_components ${AUTHALIC_VTK_COMPONENTS})
if(AUTHALIC_PYTHON)
  list(APPEND authalic_vtk_components Python WrappingPythonCore)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${authalic_vtk_components})
# Debian's Python looks into dist-packages, below /usr as below /usr/local.
if(EXISTS /etc/debian_version)
  set(authalic_site_packages dist-packages)
else()
  set(authalic_site_packages site-packages)
endif()
set(AUTHALIC_PYTHON_DESTINATION
  "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/${authalic_site_packages}")
