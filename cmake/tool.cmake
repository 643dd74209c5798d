# SPDX-License-Identifier: MIT
#
# The command line tool. It sees the public header and nothing else of the library.

file(GLOB tool_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.c)
add_executable(csgcast-tool ${tool_sources})
target_include_directories(csgcast-tool PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
target_link_libraries(csgcast-tool PRIVATE csgcast csgcast_compare m)
csgcast_strict(csgcast-tool)

# The installed tool finds its library under any prefix, also before ldconfig has run.
file(RELATIVE_PATH libdir_from_bindir ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(csgcast-tool PROPERTIES OUTPUT_NAME csgcast
    INSTALL_RPATH "$ORIGIN/${libdir_from_bindir}")

# What ./run render needs: the tool, and the module where it can be built.
add_custom_target(csgcast-runtime DEPENDS csgcast-tool)
if(TARGET csgcast-image)
    add_dependencies(csgcast-runtime csgcast-image)
endif()
if(TARGET csgcast-compare)
    add_dependencies(csgcast-runtime csgcast-compare)
endif()
