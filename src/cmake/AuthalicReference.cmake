# Target docs: the C++ reference in reference/html of the build tree. Fails on any warning of Doxygen.
find_package(Doxygen QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  message(STATUS "C++ reference: target docs is left out (no Doxygen)")
  return()
endif()
set(AUTHALIC_REFERENCE "${CMAKE_BINARY_DIR}/reference")
file(GLOB module_files "${PROJECT_SOURCE_DIR}/modules/*/vtk.module") # headers of these are included without a folder
list(TRANSFORM module_files REPLACE "^(.*)/vtk.module$" "\"\\1\"")
list(JOIN module_files " " AUTHALIC_MODULE_FOLDERS)
file(MAKE_DIRECTORY "${AUTHALIC_REFERENCE}")
configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${AUTHALIC_REFERENCE}/Doxyfile" @ONLY)
add_custom_target(docs
  COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/docs/bibliography.py"
    "${PROJECT_SOURCE_DIR}/docs/references.bib" "${AUTHALIC_REFERENCE}/bibliography.md"
  COMMAND "${DOXYGEN_EXECUTABLE}" "${AUTHALIC_REFERENCE}/Doxyfile"
  COMMAND "${CMAKE_COMMAND}" -E echo "${AUTHALIC_REFERENCE}/html/index.html"
  VERBATIM)
