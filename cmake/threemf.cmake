# SPDX-License-Identifier: MIT
#
# csgcast-3mf: the module that reads 3MF with lib3mf 1. It is loaded at run time, when a scene
# imports one.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(threemf_library QUIET IMPORTED_TARGET lib3MF<2)
endif()
if(NOT threemf_library_FOUND)
    message(WARNING "lib3mf 1 is not installed: csgcast will leave the import of 3MF to openscad "
        "(Debian: lib3mf-dev)")
    return()
endif()

csgcast_module(csgcast-3mf ${PROJECT_SOURCE_DIR}/src/threemf/threemf.cpp
    LIBRARIES PkgConfig::threemf_library)
