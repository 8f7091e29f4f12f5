# find_package(Authalic): Core, Formats and Reports always; the VTK modules when they were built.
include(CMakePackageConfigHelpers)
export(EXPORT Authalic NAMESPACE Authalic:: FILE "${CMAKE_BINARY_DIR}/${AUTHALIC_CMAKE_DESTINATION}/Authalic-libraries.cmake")
install(EXPORT Authalic NAMESPACE Authalic:: FILE Authalic-libraries.cmake DESTINATION "${AUTHALIC_CMAKE_DESTINATION}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/src/cmake/AuthalicConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/AuthalicConfig.cmake" INSTALL_DESTINATION "${AUTHALIC_CMAKE_DESTINATION}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/AuthalicConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/AuthalicConfig.cmake" "${CMAKE_BINARY_DIR}/AuthalicConfigVersion.cmake"
  DESTINATION "${AUTHALIC_CMAKE_DESTINATION}")
