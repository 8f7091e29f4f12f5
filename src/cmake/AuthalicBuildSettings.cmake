# Output directories, warnings, sanitizers and run-time paths shared by every target.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(AUTHALIC_INCLUDE_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/authalic")
set(AUTHALIC_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Authalic")

# The version of the binary interface: every minor version breaks it before 1.0, every major version after.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(AUTHALIC_SOVERSION "0.${PROJECT_VERSION_MINOR}") # never a plain 0: VTK drops that
  set(AUTHALIC_COMPATIBILITY SameMinorVersion)
else()
  set(AUTHALIC_SOVERSION "${PROJECT_VERSION_MAJOR}")
  set(AUTHALIC_COMPATIBILITY SameMajorVersion)
endif()

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

# authalic_sort_headers(PUBLIC PRIVATE HEADER ...): private are those that say "Private to FOLDER/." in their first lines;
# they are not installed, and House.private-headers keeps them inside their folder.
function(authalic_sort_headers public private)
  set(public_headers)
  set(private_headers)
  foreach(header IN LISTS ARGN)
    file(READ "${header}" text LIMIT 600)
    if(text MATCHES "Private to [A-Za-z]+/")
      list(APPEND private_headers "${header}")
    else()
      list(APPEND public_headers "${header}")
    endif()
  endforeach()
  set(${public} ${public_headers} PARENT_SCOPE)
  set(${private} ${private_headers} PARENT_SCOPE)
endfunction()

# authalic_install_library(NAME HEADER ...): the library, its public headers and what find_package() reads of it.
function(authalic_install_library name)
  authalic_sort_headers(public private ${ARGN})
  foreach(header IN LISTS public)
    file(RELATIVE_PATH path "${PROJECT_SOURCE_DIR}/modules" "${header}")
    get_filename_component(folder "${path}" DIRECTORY)
    install(FILES "${header}" DESTINATION "${AUTHALIC_INCLUDE_DESTINATION}/${folder}")
  endforeach()
  set(targets Authalic${name}-targets)
  install(TARGETS Authalic${name} EXPORT ${targets})
  install(EXPORT ${targets} NAMESPACE Authalic:: DESTINATION "${AUTHALIC_CMAKE_DESTINATION}")
  export(EXPORT ${targets} NAMESPACE Authalic::
    FILE "${CMAKE_BINARY_DIR}/${AUTHALIC_CMAKE_DESTINATION}/${targets}.cmake")
endfunction()

# authalic_library(NAME [LINK_PUBLIC ...] [LINK_PRIVATE ...]): a library of ours from every .cxx below this folder;
# component NAME of find_package(Authalic).
function(authalic_library name)
  cmake_parse_arguments(arg "" "" "LINK_PUBLIC;LINK_PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cxx")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
  add_library(Authalic${name} ${sources} ${headers})
  add_library(Authalic::${name} ALIAS Authalic${name})
  set_target_properties(Authalic${name} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${AUTHALIC_SOVERSION})
  target_include_directories(Authalic${name} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/modules>" "$<INSTALL_INTERFACE:${AUTHALIC_INCLUDE_DESTINATION}>")
  target_compile_features(Authalic${name} PUBLIC cxx_std_17)
  target_link_libraries(Authalic${name} PUBLIC ${arg_LINK_PUBLIC} PRIVATE ${arg_LINK_PRIVATE})
  authalic_warnings(Authalic${name})
  authalic_install_library(${name} ${headers})
endfunction()
