/* SPDX-License-Identifier: MIT */
#include "openscad/plain_text.h"

#include <string.h>

/* A binary STL: a header, the number of its triangles in little-endian, and their records. */
enum { stl_header = 80, stl_triangle = 50 };

static const struct signature {
    const char *bytes;
    size_t num;
    const char *name;
} signatures[] = {
    {"\xff\xfe\0\0", 4, "text in UTF-32; save it as UTF-8"},
    {"\0\0\xfe\xff", 4, "text in UTF-32; save it as UTF-8"},
    {"\xff\xfe", 2, "text in UTF-16; save it as UTF-8"},
    {"\xfe\xff", 2, "text in UTF-16; save it as UTF-8"},
    {"PK\3\4", 4, "a ZIP archive, such as a 3MF file"},
    {"\x1f\x8b", 2, "compressed by gzip"},
    {"\x89PNG", 4, "a PNG image"},
    {"\xff\xd8\xff", 3, "a JPEG image"},
    {"%PDF", 4, "a PDF document"},
    {"\177ELF", 4, "a program"},
};

static bool is_stl(const struct csg_bytes *bytes)
{
    unsigned char num[4];
    if (bytes->num < stl_header + sizeof num)
        return false;
    memcpy(num, bytes->data + stl_header, sizeof num);
    const size_t triangles =
        num[0] | (size_t)num[1] << 8 | (size_t)num[2] << 16 | (size_t)num[3] << 24;
    return bytes->num == stl_header + sizeof num + stl_triangle * triangles;
}

/* Without a mark at the beginning: of its first characters, which are ASCII's as a rule, every
 * second byte is zero and no other. */
static bool is_utf16(const struct csg_bytes *bytes)
{
    const size_t num = bytes->num < 64 ? bytes->num : 64;
    size_t zeros[2] = {0, 0};
    for (size_t i = 0; i < num; i++)
        zeros[i % 2] += bytes->data[i] == 0;
    return (zeros[0] == 0) != (zeros[1] == 0) && 8 * (zeros[0] + zeros[1]) > 3 * num;
}

static const char *name_of(const struct csg_bytes *bytes)
{
    for (size_t i = 0; i < sizeof signatures / sizeof *signatures; i++)
        if (bytes->num >= signatures[i].num &&
            memcmp(bytes->data, signatures[i].bytes, signatures[i].num) == 0)
            return signatures[i].name;
    if (is_stl(bytes))
        return "a binary STL mesh; import() it in a scene";
    return is_utf16(bytes) ? "text in UTF-16; save it as UTF-8" : "binary data";
}

bool csg_plain_text_check(const char *path, const struct csg_bytes *bytes,
                          const struct csg_log *log)
{
    const char *zero = bytes->num ? memchr(bytes->data, 0, bytes->num) : NULL;
    if (zero)
        csg_log_error(log, CSGCAST_MESSAGE_FILE,
                      "%s: no scene's text: byte %zu is zero; it seems to be %s", path,
                      (size_t)(zero - bytes->data) + 1, name_of(bytes));
    return !zero;
}
