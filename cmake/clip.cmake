# SPDX-License-Identifier: MIT
#
# csgcast-clip: the module that makes the Booleans of drawings as OpenSCAD does, with Clipper. It is
# loaded at run time, for --facets=as-written.

find_path(CLIPPER_INCLUDE_DIR polyclipping/clipper.hpp)
find_library(CLIPPER_LIBRARY polyclipping)
if(NOT CLIPPER_INCLUDE_DIR OR NOT CLIPPER_LIBRARY)
    message(WARNING "Clipper is not installed: with --facets=as-written drawings will differ from "
        "OpenSCAD's by its rounding to 2^-16 (Debian: libpolyclipping-dev)")
    return()
endif()

csgcast_module(csgcast-clip ${PROJECT_SOURCE_DIR}/src/clip/clip.cpp LIBRARIES ${CLIPPER_LIBRARY})
target_include_directories(csgcast-clip SYSTEM PRIVATE ${CLIPPER_INCLUDE_DIR})
