# SPDX-License-Identifier: MIT
#
# csgcast-tess: the module that cuts faces that are not plane, with GLU. It is loaded at run time,
# when a scene has such faces.

find_path(GLU_INCLUDE_DIR GL/glu.h)
find_library(GLU_LIBRARY GLU)
if(NOT GLU_INCLUDE_DIR OR NOT GLU_LIBRARY)
    message(WARNING "GLU is not installed: csgcast will cut faces that are not plane otherwise "
        "than OpenSCAD does, and say so (Debian: libglu1-mesa-dev)")
    return()
endif()

csgcast_module(csgcast-tess ${PROJECT_SOURCE_DIR}/src/tess/tess.c LIBRARIES ${GLU_LIBRARY})
target_include_directories(csgcast-tess SYSTEM PRIVATE ${GLU_INCLUDE_DIR})
