# SPDX-License-Identifier: MIT
#
# csgcast-digits: preloaded into the openscad that flattens .scad files, so that it writes its
# numbers with all their digits. Not with sanitizers, whose runtime no openscad has.

if(CSGCAST_SANITIZE)
    message(STATUS "No csgcast-digits with CSGCAST_SANITIZE: .scad files are read with six digits")
    return()
endif()

csgcast_module(csgcast-digits ${PROJECT_SOURCE_DIR}/src/digits/digits.cpp
    LIBRARIES ${CMAKE_DL_LIBS})
target_compile_options(csgcast-digits PRIVATE -fno-exceptions -fno-rtti)
# Nothing of the C++ library is called, and programs without it must be able to load this.
target_link_options(csgcast-digits PRIVATE -Wl,--as-needed -Wl,-z,defs)
