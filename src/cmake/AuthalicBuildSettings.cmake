# Output directories, warnings, sanitizers and run-time paths shared by every target.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(AUTHALIC_INCLUDE_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/authalic")
set(AUTHALIC_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Authalic")
set(AUTHALIC_SOVERSION 1)

# -ffp-contract=off: the same bits whether or not the compiler finds a fused multiply-add.
add_compile_options(-ffp-contract=off)
if(AUTHALIC_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
else()
  add_link_options($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,SHARED_LIBRARY>:-Wl,--no-undefined>)
endif()

# Strict warnings for a target of ours (not for VTK's generated code).
function(authalic_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
endfunction()

# authalic_library(NAME [LINK_PUBLIC ...] [LINK_PRIVATE ...]): a library of ours from every .cxx below this folder.
function(authalic_library name)
  cmake_parse_arguments(arg "" "" "LINK_PUBLIC;LINK_PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cxx" "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
  add_library(Authalic${name} ${sources})
  add_library(Authalic::${name} ALIAS Authalic${name})
  set_target_properties(Authalic${name} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${AUTHALIC_SOVERSION})
  target_include_directories(Authalic${name} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/modules>" "$<INSTALL_INTERFACE:${AUTHALIC_INCLUDE_DESTINATION}>")
  target_compile_features(Authalic${name} PUBLIC cxx_std_17)
  target_link_libraries(Authalic${name} PUBLIC ${arg_LINK_PUBLIC} PRIVATE ${arg_LINK_PRIVATE})
  authalic_warnings(Authalic${name})
  if(AUTHALIC_PARAVIEW) # inside the folder of the plugin
    install(TARGETS Authalic${name} LIBRARY DESTINATION "${AUTHALIC_PLUGIN_DESTINATION}" NAMELINK_SKIP)
    return()
  endif()
  install(TARGETS Authalic${name} EXPORT Authalic)
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/" DESTINATION "${AUTHALIC_INCLUDE_DESTINATION}/${name}"
    FILES_MATCHING PATTERN "*.h")
endfunction()
