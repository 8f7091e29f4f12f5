# VTK itself.
# COMPONENTS are always listed: without them VTK looks for Qt.
set(AUTHALIC_VTK_COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMisc
  IOCore IOXML IOLegacy IOGeometry IOPLY ImagingCore FiltersCore ParallelCore)
set(authalic_vtk_components ${AUTHALIC_VTK_COMPONENTS})
if(AUTHALIC_PYTHON)
  list(APPEND authalic_vtk_components Python WrappingPythonCore)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${authalic_vtk_components})
set(AUTHALIC_PYTHON_DESTINATION
  "${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages")
