# SPDX-License-Identifier: MIT
#
# csgcast-xml: the module that reads XML, plain or in ZIP archives, with libxml2 and libzip. It is
# loaded at run time, when a scene imports SVG or AMF.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(xml_libraries QUIET IMPORTED_TARGET libxml-2.0 libzip)
endif()
if(NOT xml_libraries_FOUND)
    message(WARNING "libxml2 or libzip is not installed: csgcast will leave the import of SVG and "
        "AMF to openscad (Debian: libxml2-dev libzip-dev)")
    return()
endif()

csgcast_module(csgcast-xml ${PROJECT_SOURCE_DIR}/src/xml/xml.c LIBRARIES PkgConfig::xml_libraries)
