/* SPDX-License-Identifier: MIT */

/* csgcast-image.so: writes one image with OpenImageIO. All but PNG, see png.c. */

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "image/module.h"

namespace
{

/* Rows handed over at once: enough for OpenEXR to compress in parallel (its blocks are 16 rows). */
constexpr int rows_at_once = 64;

/* libjpeg ends the process beyond these: pixels, and bytes of text (64 KB with what is around). */
constexpr int jpeg_max_size = 65500;
constexpr size_t jpeg_max_text = 30000;

/* OpenImageIO's message as part of a sentence; it does not always have one. */
std::string message_or(const std::string &message, const char *otherwise)
{
    std::string text = message.empty() ? otherwise : message;
    while (!text.empty() && (text.back() == '\n' || text.back() == '.'))
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

[[noreturn]] void fail(const std::string &text)
{
    throw std::runtime_error(text);
}

OIIO::TypeDesc sample_type(int bits)
{
    return bits == 8    ? OIIO::TypeDesc::UINT8
           : bits == 16 ? OIIO::TypeDesc::UINT16
                        : OIIO::TypeDesc::FLOAT;
}

/* Every format keeps a description, few keep names of one's own: both are written. */
void set_metadata(OIIO::ImageSpec &spec, const csg_image_file &file, bool is_jpeg)
{
    std::string description;
    for (size_t i = 0; i < file.num_metadata; i++) {
        const csgcast_metadata &entry = file.metadata[i];
        description += std::string(entry.name) + ": " + entry.value + "\n";
        if (!is_jpeg)
            spec.attribute(entry.name, std::string(entry.value));
    }
    if (is_jpeg && description.size() > jpeg_max_text)
        description.resize(jpeg_max_text);
    if (!spec.find_attribute("Software"))
        spec.attribute("Software", "csgcast " CSGCAST_VERSION_STRING);
    if (!description.empty() && !spec.find_attribute("ImageDescription"))
        spec.attribute("ImageDescription", description);
}

OIIO::ImageSpec make_spec(const csg_image_file &file, bool is_jpeg)
{
    OIIO::ImageSpec spec(file.width, file.height, file.num_channels, sample_type(file.bits));
    spec.channelnames.clear();
    spec.alpha_channel = spec.z_channel = -1;
    for (int c = 0; c < file.num_channels; c++) {
        const std::string name = file.channels[c].name;
        spec.channelnames.push_back(name);
        if (name == "A")
            spec.alpha_channel = c;
        if (name == "Z")
            spec.z_channel = c;
    }
    /* The values are what a screen shows: nothing may convert them, nor divide by alpha. */
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("jpeg:subsampling", "4:4:4"); /* edges between faces stay sharp */
    spec.attribute("DateTime", "");              /* the same call writes the same bytes */
    set_metadata(spec, file, is_jpeg);
    return spec;
}

/* Outside 0 to 1, NaN included, an integer format has the nearest thing to it. */
float clean(float value)
{
    return value > 0 ? std::min(value, 1.0f) : 0.0f;
}

void gather(const csg_image_file &file, int first_row, int num_rows, std::vector<float> &pixels)
{
    const size_t num = size_t(num_rows) * size_t(file.width);
    const size_t start = size_t(first_row) * size_t(file.width);
    const size_t stride = size_t(file.num_channels);
    pixels.resize(num * stride);
    for (size_t c = 0; c < stride; c++) {
        const csg_image_channel &channel = file.channels[c];
        const float *from = channel.first + start * channel.stride;
        for (size_t i = 0; i < num; i++, from += channel.stride)
            pixels[i * stride + c] = file.bits == 32 ? *from : clean(*from);
    }
}

/* What open would accept, or take for a reason to end the process. */
void check_format(const OIIO::ImageOutput &out, const csg_image_file &file)
{
    const std::string name = out.format_name();
    if (name == "null" || name == "term")
        fail(name + " is not a file format");
    if (name == "jpeg" && std::max(file.width, file.height) > jpeg_max_size)
        fail("JPEG holds at most " + std::to_string(jpeg_max_size) + " pixels a side");
    if (file.num_channels > 4 && !out.supports("nchannels"))
        fail(std::string(file.format) + " holds colour only: Z, N and id need EXR or 32-bit TIFF");
}

/* Formats take fewer bits than asked for without a word. */
void check_bits(const OIIO::ImageOutput &out, const csg_image_file &file)
{
    if (out.spec().format.basesize() * 8 < size_t(file.bits))
        fail(std::string(file.format) + " does not hold " + std::to_string(file.bits) +
             " bits per channel" + (file.bits == 32 ? ": EXR and TIFF hold float" : ""));
}

void write_rows(OIIO::ImageOutput &out, const csg_image_file &file)
{
    std::vector<float> pixels;
    for (int row = 0; row < file.height; row += rows_at_once) {
        const int num = std::min(rows_at_once, file.height - row);
        gather(file, row, num, pixels);
        if (!out.write_scanlines(row, row + num, 0, OIIO::TypeDesc::FLOAT, pixels.data()))
            fail(message_or(out.geterror(), "cannot be written"));
    }
}

void encode(OIIO::ImageOutput &out, const csg_image_file &file)
{
    if (!out.open(file.path, make_spec(file, !std::strcmp(out.format_name(), "jpeg"))))
        fail(message_or(out.geterror(), "cannot be opened"));
    write_rows(out, file);
    if (!out.close())
        fail(message_or(out.geterror(), "cannot be completed"));
    check_bits(out, file); /* now: libpng complains about a file that is closed half way */
}

void save(const char *path, const std::vector<unsigned char> &bytes)
{
    std::FILE *const to = std::fopen(path, "wb");
    bool ok = to && std::fwrite(bytes.data(), 1, bytes.size(), to) == bytes.size();
    ok = to && std::fclose(to) == 0 && ok;
    if (!ok)
        fail(std::strerror(errno));
}

/* For formats whose writers do not tell of a full disk or of what they cannot encode. */
void read_back(const csg_image_file &file)
{
    OIIO::ImageSpec spec;
    const auto in = OIIO::ImageInput::create(file.format); /* the path need not tell */
    bool ok =
        in && in->open(file.path, spec) && spec.width == file.width && spec.height == file.height;
    std::vector<float> row(ok ? size_t(file.width) * size_t(in->spec().nchannels) : 0);
    for (int y = 0; ok && y < file.height; y++)
        ok = in->read_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data());
    if (!ok)
        fail("what was written cannot be read again");
}

/*
 * Encodes into memory where the format can: OpenImageIO's PNG writer takes a full disk for success,
 * and libjpeg ends the process. TIFF cannot: libtiff reads again what it has written.
 */
void write(const csg_image_file &file)
{
    const auto out = OIIO::ImageOutput::create(file.format);
    if (!out)
        fail(message_or(OIIO::geterror(), "OpenImageIO does not write this format"));
    check_format(*out, file);
    const std::string name = out->format_name();
    OIIO::Filesystem::IOVecOutput memory;
    const bool in_memory = name != "tiff" && out->supports("ioproxy") && out->set_ioproxy(&memory);
    encode(*out, file);
    if (in_memory)
        save(file.path, memory.buffer());
    if (name != "png" && name != "openexr" &&
        name != "jpeg") /* those three are known to be right */
        read_back(file);
}

} // namespace

extern "C" __attribute__((visibility("default"))) bool
CSG_IMAGE_MODULE_WRITE(const csg_image_file *file, csg_image_error *error)
{
    try {
        write(*file);
        return true;
    } catch (const std::exception &exception) {
        std::snprintf(error->text, sizeof error->text, "%s", exception.what());
    } catch (...) {
        std::snprintf(error->text, sizeof error->text, "unknown exception");
    }
    return false;
}
