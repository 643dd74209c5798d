# SPDX-License-Identifier: MIT
#
# csgcast-text: the module that draws text() with FreeType, HarfBuzz and fontconfig. It is loaded
# at run time, when a scene has text.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(text_libraries QUIET IMPORTED_TARGET freetype2 harfbuzz fontconfig)
endif()
if(NOT text_libraries_FOUND)
    message(WARNING "FreeType, HarfBuzz or fontconfig is not installed: csgcast will leave text() to openscad "
        "(Debian: libfreetype-dev libharfbuzz-dev libfontconfig-dev)")
    return()
endif()

csgcast_module(csgcast-text ${PROJECT_SOURCE_DIR}/src/text/text.c
    ${PROJECT_SOURCE_DIR}/src/text/fonts.c
    LIBRARIES PkgConfig::text_libraries m)
