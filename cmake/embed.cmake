# SPDX-License-Identifier: MIT
#
#   cmake -D DIR=shaders -D LIST=names.txt -D OUT=shader_files.c -P embed.cmake
#
# Writes the files of DIR named in LIST, one a line, as the C tables of src/shader/files.h. Bytes
# and not string literals: C11 guarantees only 4095 characters in a literal.

file(STRINGS ${LIST} names)
set(arrays "")
set(rows "")
set(num 0)
foreach(name IN LISTS names)
    file(READ ${DIR}/${name} hex HEX)
    string(REGEX REPLACE "(................................)" "\\1\n    " hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
    string(APPEND arrays "\nstatic const unsigned char text_${num}[] = {\n    ${bytes}0x00};\n")
    string(APPEND rows "    {\"${name}\", (const char *)text_${num}},\n")
    math(EXPR num "${num} + 1")
endforeach()

file(WRITE ${OUT} "/* Made by cmake/embed.cmake from shaders/. */
#include \"shader/files.h\"
${arrays}
const struct csg_shader_file csg_shader_files[] = {
${rows}    {NULL, NULL},
};
const size_t csg_num_shader_files = ${num};
")
