# SPDX-License-Identifier: MIT
#
# Turns shaders/**/*.glsl into one C file, see src/shader/files.h. The list is kept in a file of its
# own so that adding or removing a shader rebuilds it like editing one does.

set(shader_dir ${PROJECT_SOURCE_DIR}/shaders)
set(shader_list ${PROJECT_BINARY_DIR}/shader_files.txt)
set(shader_source ${PROJECT_BINARY_DIR}/shader_files.c)

file(GLOB_RECURSE shader_files RELATIVE ${shader_dir} CONFIGURE_DEPENDS ${shader_dir}/*.glsl)
list(SORT shader_files)
string(JOIN "\n" shader_names ${shader_files})
file(CONFIGURE OUTPUT ${shader_list} CONTENT "${shader_names}\n" @ONLY)
list(TRANSFORM shader_files PREPEND ${shader_dir}/ OUTPUT_VARIABLE shader_paths)

add_custom_command(
    OUTPUT ${shader_source}
    COMMAND ${CMAKE_COMMAND} -D DIR=${shader_dir} -D LIST=${shader_list} -D OUT=${shader_source}
        -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${shader_paths} ${shader_list} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    COMMENT "Embedding the shaders" VERBATIM)
