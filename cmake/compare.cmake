# SPDX-License-Identifier: MIT
#
# What `csgcast compare` and the tests measure meshes with. csgcast_compare: plain C, linked into
# the tool. csgcast-compare: the module with Embree and assimp, loaded at run time.

set(compare_dir ${PROJECT_SOURCE_DIR}/src/compare)
set(compare_common ${PROJECT_SOURCE_DIR}/src/common/array.c ${PROJECT_SOURCE_DIR}/src/common/linear.c
    ${PROJECT_SOURCE_DIR}/src/common/log.c)

add_library(csgcast_compare STATIC ${compare_dir}/compare.c ${compare_dir}/mesh_view.c
    ${compare_dir}/soup.c ${compare_dir}/module.c ${PROJECT_SOURCE_DIR}/src/common/module.c
    ${compare_common})
target_include_directories(csgcast_compare PUBLIC ${PROJECT_SOURCE_DIR}/src
    ${PROJECT_SOURCE_DIR}/src/include)
target_link_libraries(csgcast_compare PUBLIC dl m)
csgcast_strict(csgcast_compare)
set_target_properties(csgcast_compare PROPERTIES POSITION_INDEPENDENT_CODE ON)

find_path(EMBREE_INCLUDE_DIR embree3/rtcore.h)
find_library(EMBREE_LIBRARY embree3)
find_path(ASSIMP_INCLUDE_DIR assimp/cimport.h)
find_library(ASSIMP_LIBRARY assimp)
if(NOT EMBREE_INCLUDE_DIR OR NOT EMBREE_LIBRARY OR NOT ASSIMP_INCLUDE_DIR OR NOT ASSIMP_LIBRARY)
    message(WARNING "Embree 3 or assimp is not installed: `csgcast compare` will not work "
        "(Debian: libembree-dev libassimp-dev)")
    return()
endif()
csgcast_module(csgcast-compare ${compare_dir}/caster.c ${compare_dir}/import.c
    ${compare_dir}/entry.c ${compare_dir}/soup.c ${compare_common}
    LIBRARIES ${EMBREE_LIBRARY} ${ASSIMP_LIBRARY} m)
target_include_directories(csgcast-compare SYSTEM PRIVATE ${EMBREE_INCLUDE_DIR}
    ${ASSIMP_INCLUDE_DIR})
