# SPDX-License-Identifier: MIT
#
#   csgcast_module(csgcast-NAME SOURCE... LIBRARIES LIBRARY...)
#
# Modules: parts of ours that bring libraries of their own, built where those are installed and
# loaded at run time (src/common/module.h) when a scene needs them.

set(csgcast_modules "")

file(RELATIVE_PATH libdir_from_bindir ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/common/module.c PROPERTIES
    COMPILE_DEFINITIONS "CSGCAST_MODULE_DIR=\"${CMAKE_INSTALL_FULL_LIBDIR}/csgcast\";\
CSGCAST_MODULE_FROM_BINDIR=\"${libdir_from_bindir}/csgcast\"")

function(csgcast_module name)
    cmake_parse_arguments(PARSE_ARGV 1 module "" "" "LIBRARIES")
    add_library(${name} MODULE ${module_UNPARSED_ARGUMENTS})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src
        ${PROJECT_SOURCE_DIR}/src/include)
    target_link_libraries(${name} PRIVATE ${module_LIBRARIES})
    csgcast_strict(${name})
    set_target_properties(${name} PROPERTIES PREFIX "")
    install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/csgcast)
    set(csgcast_modules ${csgcast_modules} ${name} PARENT_SCOPE)
endfunction()
