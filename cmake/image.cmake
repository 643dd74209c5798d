# SPDX-License-Identifier: MIT
#
# csgcast-image: the module that writes image files other than PNG. It is loaded at run time, since
# OpenImageIO brings some 260 shared libraries that a preview does not need.

# pkg-config first: Debian's CMake package of OpenImageIO wants openimageio-tools installed as well.
set(image_library "")
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(openimageio QUIET IMPORTED_TARGET OpenImageIO)
    if(openimageio_FOUND)
        set(image_library PkgConfig::openimageio)
    endif()
endif()
if(NOT image_library)
    find_package(OpenImageIO QUIET)
    if(OpenImageIO_FOUND)
        set(image_library OpenImageIO::OpenImageIO)
    endif()
endif()
if(NOT image_library)
    message(WARNING "OpenImageIO is not installed: csgcast will write PNG and no other image files "
        "(Debian: libopenimageio-dev)")
    return()
endif()

csgcast_module(csgcast-image ${PROJECT_SOURCE_DIR}/src/image/oiio.cpp LIBRARIES ${image_library})
