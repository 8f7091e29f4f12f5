# find_package(Authalic): Core, Formats and Reports always; the VTK modules when they were built.
include(CMakePackageConfigHelpers)
set(authalic_module_names ${AUTHALIC_MODULES})
list(TRANSFORM authalic_module_names REPLACE "^Authalic::" "")
if(AUTHALIC_VTK)
  math(EXPR authalic_vtk_next "${VTK_MINOR_VERSION} + 1")
  set(authalic_vtk_range "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}...<${VTK_MAJOR_VERSION}.${authalic_vtk_next}")
endif()
set(authalic_config "${CMAKE_BINARY_DIR}/${AUTHALIC_CMAKE_DESTINATION}/AuthalicConfig.cmake")
set(authalic_config_version "${CMAKE_BINARY_DIR}/${AUTHALIC_CMAKE_DESTINATION}/AuthalicConfigVersion.cmake")
configure_package_config_file("${PROJECT_SOURCE_DIR}/src/cmake/AuthalicConfig.cmake.in" "${authalic_config}"
  INSTALL_DESTINATION "${AUTHALIC_CMAKE_DESTINATION}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${authalic_config_version}" COMPATIBILITY ${AUTHALIC_COMPATIBILITY})
install(FILES "${authalic_config}" "${authalic_config_version}" DESTINATION "${AUTHALIC_CMAKE_DESTINATION}")
