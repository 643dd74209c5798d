/* SPDX-License-Identifier: MIT */
/*
 * csgcast-digits.so, loaded by LD_PRELOAD into the openscad that flattens a .scad file. OpenSCAD
 * writes six digits of each number of a .csg, through two functions of shared libraries:
 * double_conversion::DoubleToStringConverter::ToPrecision and operator<<(std::ostream &, double).
 * These stand in front of them and ask for as many digits as it takes to read the same double
 * again, but only while a file in the folder that CSGCAST_DIGITS names is open for writing: then
 * the program has been evaluated, so that str(), echo() and text() say what they always say. If
 * openscad prints by both, the file's last line says that no number in it is rounded
 * (src/document/digits.h); what another version of openscad prints in other ways stays as it is.
 *
 * Where such a file is the only one, openscad ends with it, at once: in a large scene a tenth of
 * the time passes before its memory is free.
 *
 * A third one stands in front of fontconfig's FcConfigAppFontAddFile, by which openscad takes what
 * use <x.ttf> names, and notes the file's name in that folder.
 *
 * It needs nothing but libc and libm, so that it can be loaded into any program; where it cannot,
 * ld.so leaves it out.
 */
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ostream>

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include "document/digits.h"

#define TO_PRECISION                                                                               \
    "_ZNK17double_conversion23DoubleToStringConverter11ToPrecisionEdiPNS_13StringBuilderE"
#define TO_SHORTEST                                                                                \
    "_ZNK17double_conversion23DoubleToStringConverter20ToShortestIeeeNumberEd"                     \
    "PNS_13StringBuilderENS0_8DtoaModeE"
#define INSERT "_ZNSo9_M_insertIdEERSoT_"
#define ADD_FONT "FcConfigAppFontAddFile"

/* A function of ours in front of the one of that name. */
#define INSTEAD_OF(name) __asm__(name) __attribute__((visibility("default")))

extern "C" {
bool csgcast_digits_convert(const void *converter, double value, int digits, void *builder)
    INSTEAD_OF(TO_PRECISION);
std::ostream *csgcast_digits_insert(std::ostream *stream, double value) INSTEAD_OF(INSERT);
int csgcast_digits_font(void *config, const unsigned char *file) INSTEAD_OF(ADD_FONT);
FILE *csgcast_digits_open(const char *name, const char *mode) INSTEAD_OF("fopen");
FILE *csgcast_digits_open64(const char *name, const char *mode) INSTEAD_OF("fopen64");
int csgcast_digits_close(FILE *file) INSTEAD_OF("fclose");
}

namespace
{

const int six = 6; /* what OpenSCAD asks for */

FILE *output;                     /* the file that is being written, NULL: none */
bool is_last;                     /* nothing is written after it */
bool has_converted, has_inserted; /* the functions are those that openscad calls */

/* The name in the folder; NULL: it is elsewhere. */
const char *name_of_output(const char *path, const char *mode)
{
    const char *folder = getenv("CSGCAST_DIGITS");
    const size_t length = folder ? strlen(folder) : 0;
    const bool is_there = length > 0 && strncmp(path, folder, length) == 0 && path[length] == '/';
    return is_there && mode[0] == 'w' ? path + length + 1 : nullptr;
}

bool text_reads_back(double value, int digits)
{
    char text[64];
    snprintf(text, sizeof text, "%.*e", digits - 1, value);
    return strtod(text, nullptr) == value;
}

/*
 * At most 15 digits. Without a text where that can be, since a large scene has a million numbers: a
 * whole number below 2^53 over a power of ten up to 10^22 is rounded once, as a reader rounds the
 * digits (Clinger 1990).
 */
bool reads_back(double value, int digits)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const double size = std::fabs(value);
    const double places = digits - 1 - std::floor(std::log10(size)); /* NaN and infinity: none */
    if (!(places >= 0 && places <= 22))
        return size == 0 || text_reads_back(value, digits);
    const double power = powers[static_cast<int>(places)], whole = std::round(size * power);
    if (whole >= powers[digits] || whole < powers[digits - 1])
        return text_reads_back(value, digits);
    return whole / power == size;
}

/* 17 digits always do (Steele and White 1990); 15 are what people write at most. */
int digits_of(double value)
{
    const int written = 15, all = 17;
    if (!std::isfinite(value) || reads_back(value, six))
        return six;
    return reads_back(value, written) ? written : all;
}

/* The function that ours stands in front of: of what was loaded behind us, or, in programs that
 * load the library later and for themselves, of what the caller was linked with. */
template <typename Function> Function *find(Function *known, const char *name, const void *caller)
{
    void *found = known ? reinterpret_cast<void *>(known) : dlsym(RTLD_NEXT, name);
    Dl_info info;
    if (!found && dladdr(caller, &info)) {
        void *library = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
        found = library ? dlsym(library, name) : nullptr;
    }
    return reinterpret_cast<Function *>(found);
}

typedef FILE *open_function(const char *, const char *);

FILE *open_file(open_function *next, const char *path, const char *mode)
{
    FILE *file = next ? next(path, mode) : nullptr;
    const char *name = file && !output ? name_of_output(path, mode) : nullptr;
    if (name) {
        output = file;
        is_last = strcmp(name, CSG_DIGITS_STILL) == 0;
    }
    return file;
}

/*
 * Whether the program prints by operator<<, ours: a scene of polyhedra alone has no number that it
 * is used for. What a program takes from libraries it names in its strings for the linker.
 */
bool imports_insert()
{
    void *program = dlopen(nullptr, RTLD_LAZY), *insert = dlsym(RTLD_DEFAULT, INSERT);
    struct link_map *map = nullptr;
    const char *strings = nullptr;
    size_t size = 0;
    if (insert != reinterpret_cast<void *>(csgcast_digits_insert) || !program ||
        dlinfo(program, RTLD_DI_LINKMAP, &map) != 0)
        return false;
    for (const ElfW(Dyn) *entry = map->l_ld; entry->d_tag != DT_NULL; entry++) {
        if (entry->d_tag == DT_STRTAB) /* where it has been loaded, by glibc */
            strings = reinterpret_cast<const char *>(entry->d_un.d_ptr);
        if (entry->d_tag == DT_STRSZ)
            size = entry->d_un.d_val;
    }
    return strings && memmem(strings, size, INSERT, sizeof INSERT);
}

/* The name from the root on: openscad changes its folder later. */
void note_font(const char *list, const char *file)
{
    char *path = realpath(file, nullptr);
    FILE *fonts = std::fopen(list, "a");
    if (path && fonts)
        std::fprintf(fonts, "%s\n", path);
    if (fonts)
        std::fclose(fonts);
    std::free(path);
}

} // namespace

/* The fewest digits that do, where that function is there: with 17 the library counts in large
 * integers. */
bool csgcast_digits_convert(const void *converter, double value, int digits, void *builder)
{
    typedef bool function(const void *, double, int, void *);
    typedef bool shortest_function(const void *, double, void *, int);
    static function *next;
    static shortest_function *shortest;
    const int of_double = 0; /* DtoaMode: SHORTEST */
    next = find(next, TO_PRECISION, __builtin_return_address(0));
    if (!has_converted)
        shortest = find(shortest, TO_SHORTEST, __builtin_return_address(0));
    has_converted = true;
    if (output && digits == six && shortest)
        return shortest(converter, value, builder, of_double);
    if (output && digits == six)
        digits = digits_of(value);
    return next && next(converter, value, digits, builder);
}

std::ostream *csgcast_digits_insert(std::ostream *stream, double value)
{
    typedef std::ostream *function(std::ostream *, double);
    static function *next;
    next = find(next, INSERT, __builtin_return_address(0));
    has_inserted = true;
    if (!next)
        return stream;
    if (!output || stream->precision() != six || (stream->flags() & std::ios_base::floatfield))
        return next(stream, value);
    stream->precision(digits_of(value));
    next(stream, value);
    stream->precision(six);
    return stream;
}

int csgcast_digits_font(void *config, const unsigned char *file)
{
    typedef int function(void *, const unsigned char *);
    static function *next;
    next = find(next, ADD_FONT, __builtin_return_address(0));
    const int added = next ? next(config, file) : 0;
    const char *folder = getenv("CSGCAST_DIGITS");
    char name[PATH_MAX];
    if (added && folder &&
        snprintf(name, sizeof name, "%s/" CSG_DIGITS_FONTS, folder) < (int)sizeof name)
        note_font(name, reinterpret_cast<const char *>(file));
    return added;
}

FILE *csgcast_digits_open(const char *name, const char *mode)
{
    static open_function *next;
    next = find(next, "fopen", __builtin_return_address(0));
    return open_file(next, name, mode);
}

FILE *csgcast_digits_open64(const char *name, const char *mode)
{
    static open_function *next;
    next = find(next, "fopen64", __builtin_return_address(0));
    return open_file(next, name, mode);
}

int csgcast_digits_close(FILE *file)
{
    typedef int function(FILE *);
    static function *next;
    next = find(next, "fclose", __builtin_return_address(0));
    const bool is_output = file && file == output;
    const bool is_whole = is_output && has_converted && (has_inserted || imports_insert());
    if (is_output)
        output = nullptr;
    if (is_whole)
        fputs(CSG_DIGITS_MARK, file);
    const int result = next ? next(file) : EOF;
    if (is_whole && is_last && result == 0) { /* what openscad would still do is free its memory */
        fflush(nullptr);
        _exit(0);
    }
    return result;
}
