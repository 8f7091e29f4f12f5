# VTK itself, and authalic_filters(): a VTK module of ours from every class of a folder.
# COMPONENTS are always listed: without them VTK looks for Qt.
set(AUTHALIC_VTK_COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMisc
  IOCore IOXML IOLegacy IOGeometry IOPLY ImagingCore FiltersCore)
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

# authalic_filters(NAME [LINK library ...]): module Authalic::NAME from this folder. Every vtk*.cxx is a class that
# Python sees; every other .cxx and .h is a helper that it does not. Core and friends are private to the module.
function(authalic_filters name)
  cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
  file(GLOB classes CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/vtk*.cxx")
  file(GLOB helpers CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/[A-Z]*.cxx")
  file(GLOB headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/[A-Z]*.h")
  list(TRANSFORM classes REPLACE "\\.cxx$" "")
  authalic_sort_headers(public private ${headers})
  vtk_module_add_module(Authalic::${name} CLASSES ${classes} SOURCES ${helpers}
    NOWRAP_HEADERS ${public} PRIVATE_HEADERS ${private})
  vtk_module_link(Authalic::${name} PRIVATE Authalic::Core ${arg_LINK})
  vtk_module_compile_features(Authalic::${name} PUBLIC cxx_std_17)
  vtk_module_compile_options(Authalic::${name} PRIVATE -Wall -Wextra -Wnon-virtual-dtor)
endfunction()
