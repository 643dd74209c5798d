# SPDX-License-Identifier: MIT
#
# The command line tool. It sees the public header and nothing else of the library; its instruments,
# compare and report, bring their own copies of what they need below it.

# What `csgcast report` draws meshes with: a context of its own, as the library shows none.
file(GLOB report_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/report/*.c
    ${PROJECT_SOURCE_DIR}/src/gl/*.c)
add_library(csgcast_report STATIC ${report_sources})
target_include_directories(csgcast_report PUBLIC ${PROJECT_SOURCE_DIR}/src
    ${PROJECT_SOURCE_DIR}/src/include)
target_link_libraries(csgcast_report PUBLIC csgcast_compare dl m)
csgcast_strict(csgcast_report)

file(GLOB tool_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.c)
add_executable(csgcast-tool ${tool_sources} ${PROJECT_SOURCE_DIR}/src/common/file.c
    ${PROJECT_SOURCE_DIR}/src/common/folder.c
    ${PROJECT_SOURCE_DIR}/src/common/heap.c
    ${PROJECT_SOURCE_DIR}/src/common/join.c
    ${PROJECT_SOURCE_DIR}/src/common/process.c
    ${PROJECT_SOURCE_DIR}/src/common/spelling.c)
target_include_directories(csgcast-tool PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
target_link_libraries(csgcast-tool PRIVATE csgcast csgcast_report csgcast_compare m)
# `csgcast report` measures the shipped scenes: installed ones, else those of the source tree.
file(RELATIVE_PATH datadir_from_bindir ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR})
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/cli/cmd_report.c PROPERTIES
    COMPILE_DEFINITIONS
    "CSGCAST_SCENES_FROM_TOOL=\"${datadir_from_bindir}/csgcast/scenes\";CSGCAST_SCENES_SOURCE=\"${PROJECT_SOURCE_DIR}/scenes\"")
csgcast_strict(csgcast-tool)

# The installed tool finds its library under any prefix, also before ldconfig has run.
set_target_properties(csgcast-tool PROPERTIES OUTPUT_NAME csgcast
    INSTALL_RPATH "$ORIGIN/${libdir_from_bindir}")

# What ./run render needs: the tool, and the module where it can be built.
add_custom_target(csgcast-runtime DEPENDS csgcast-tool)
if(csgcast_modules)
    add_dependencies(csgcast-runtime ${csgcast_modules})
endif()
