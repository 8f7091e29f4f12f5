# `cpack` in the build tree makes authalic_VERSION_ARCHITECTURE.deb of everything that `cmake --install` installs.
set(doc "${CMAKE_INSTALL_DATADIR}/doc/authalic")
install(FILES "${PROJECT_SOURCE_DIR}/src/debian/copyright" "${PROJECT_SOURCE_DIR}/README.md" DESTINATION "${doc}")
find_program(GZIP_PROGRAM gzip)
if(GZIP_PROGRAM) # as Debian wants it; -n: the same bytes every time
  execute_process(COMMAND "${GZIP_PROGRAM}" -9nc "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/changelog.gz" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${CMAKE_BINARY_DIR}/changelog.gz" DESTINATION "${doc}")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME authalic)
set(CPACK_PACKAGE_VENDOR "the Authalic developers")
set(CPACK_PACKAGE_CONTACT "the Authalic developers <authalic@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "area-preserving maps of cortical and colon surfaces")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Authalic maps brain-cortex and colon surfaces to the plane: area-preserving,
measure-controlled or conformal, and makes statistics on elements of equal
native area.

This package has the command authalic, the Python package authalic, the C++
libraries with their headers (find_package(Authalic)), and VTK filters.
Nothing here is a medical device.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
if(AUTHALIC_VTK AND AUTHALIC_PYTHON)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(authalic_python "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
  set(authalic_next_python "${Python3_VERSION_MAJOR}.${next}")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${authalic_python}), python3 (<< ${authalic_next_python}), python3-numpy, python3-vtk9")
endif()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, libeigen3-dev, libvtk9-dev")
include(CPack)
