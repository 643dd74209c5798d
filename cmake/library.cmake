# SPDX-License-Identifier: MIT
#
# csgcast: the library that is installed. csgcast_internal: the same objects with every symbol in
# reach, for the unit tests.

file(GLOB library_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/*.c
    ${PROJECT_SOURCE_DIR}/src/*/*/*.c)
list(FILTER library_sources EXCLUDE REGEX "/src/(cli|clip|compare|report|tess|text|threemf|xml)/")

# shaders: some constants stand in .glsl files that C includes as well.
set(internal_includes ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/include
    ${PROJECT_SOURCE_DIR}/shaders)

add_library(csgcast_objects OBJECT ${library_sources} ${shader_source})
target_include_directories(csgcast_objects PRIVATE ${internal_includes})
set_target_properties(csgcast_objects PROPERTIES POSITION_INDEPENDENT_CODE ON)
csgcast_strict(csgcast_objects)
# Loops over pixels without branches: vectors need a root that sets no errno and compares that do
# not trap.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/crowd/cast.c
    ${PROJECT_SOURCE_DIR}/src/crowd/balls.c ${PROJECT_SOURCE_DIR}/src/crowd/tree_cast.c
    ${PROJECT_SOURCE_DIR}/src/tile/range.c ${PROJECT_SOURCE_DIR}/src/tile/flat.c PROPERTIES
    COMPILE_OPTIONS "-ftree-vectorize;-fno-math-errno;-fno-trapping-math")

# Convex hulls. Where Qhull is missing, hull() and minkowski() are left to openscad.
option(CSGCAST_QHULL "Use the Qhull library for hull() and minkowski()" ON)
set(qhull_library "")
if(CSGCAST_QHULL)
    find_path(QHULL_INCLUDE_DIR libqhull_r/libqhull_r.h)
    find_library(QHULL_LIBRARY qhull_r)
    if(QHULL_INCLUDE_DIR AND QHULL_LIBRARY)
        set(qhull_library ${QHULL_LIBRARY})
        target_include_directories(csgcast_objects SYSTEM PRIVATE ${QHULL_INCLUDE_DIR})
        target_compile_definitions(csgcast_objects PRIVATE CSGCAST_QHULL)
    else()
        message(WARNING "Qhull is not installed: csgcast will leave hull() and minkowski() to "
            "openscad (Debian: libqhull-dev)")
    endif()
endif()

# PNG files; all others are OpenImageIO's, see image.cmake.
find_package(PNG REQUIRED)
target_include_directories(csgcast_objects SYSTEM PRIVATE ${PNG_INCLUDE_DIRS})

add_library(csgcast_internal STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:csgcast_objects>)
target_include_directories(csgcast_internal PUBLIC ${internal_includes})
target_link_libraries(csgcast_internal PUBLIC ${qhull_library} ${PNG_LIBRARIES} m dl pthread)

add_library(csgcast $<TARGET_OBJECTS:csgcast_objects>)
add_library(csgcast::csgcast ALIAS csgcast)
target_include_directories(csgcast PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# By name where it is installed: a static libcsgcast hands it on to its users.
target_link_libraries(csgcast PRIVATE $<BUILD_INTERFACE:${qhull_library}>
    "$<BUILD_INTERFACE:${PNG_LIBRARIES}>" $<INSTALL_INTERFACE:png> $<INSTALL_INTERFACE:z>
    m dl pthread $<BUILD_INTERFACE:csgcast_compiler>)
if(qhull_library)
    target_link_libraries(csgcast PRIVATE $<INSTALL_INTERFACE:qhull_r>)
endif()
if(NOT CSGCAST_SANITIZE) # the sanitizers' runtime comes with the executable
    target_link_options(csgcast PRIVATE -Wl,--no-undefined)
endif()
set_target_properties(csgcast PROPERTIES LINKER_LANGUAGE C
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
