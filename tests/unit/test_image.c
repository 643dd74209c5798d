/* SPDX-License-Identifier: MIT */

/*
 * Image files: what OpenImageIO's own iinfo and oiiotool read back, and what is left in the folder
 * when writing fails.
 */

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "csgcast/csgcast.h"
#include "image/module.h"

enum { WIDTH = 5, HEIGHT = 70, NUM_PIXELS = WIDTH * HEIGHT };

static int num_failures;

static void check(bool ok, const char *name)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    num_failures += !ok;
}

/* ---- the picture ---- */

static float rgba[NUM_PIXELS * 4], depth[NUM_PIXELS], normal[NUM_PIXELS * 3], id[NUM_PIXELS];

static const struct csgcast_image image = {.rgba = rgba, .z = depth, .normal = normal, .id = id};

static const struct csgcast_metadata metadata[] = {
    {"csgcast:scene", "part.csg"},
    {"csgcast:camera", "0,0,0,55,0,25,140"},
};

/* Red grows by column and green by row, so that a flip or a transposition shows. */
static void fill_image(void)
{
    for (int i = 0; i < NUM_PIXELS; i++) {
        rgba[4 * i] = (float)(i % WIDTH) / (WIDTH - 1);
        rgba[4 * i + 1] = (float)(i / WIDTH) / (HEIGHT - 1);
        rgba[4 * i + 2] = 0.5f;
        rgba[4 * i + 3] = 1;
        depth[i] = i % 2 ? INFINITY : (float)i + 0.1f;
        normal[3 * i + 2] = -0.25f;
        id[i] = i % 2 ? -1.0f : (float)i;
    }
}

/* ---- files ---- */

static char folder[] = "/tmp/csgcast-test-XXXXXX";

static const char *path_of(const char *name)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path; /* until the next call */
}

static char *run(const char *format, ...)
{
    static char output[1 << 17];
    char command[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(command, sizeof command, format, args);
    va_end(args);
    FILE *pipe = popen(command, "r");
    const size_t size = pipe ? fread(output, 1, sizeof output - 1, pipe) : 0;
    output[size] = '\0';
    if (pipe)
        pclose(pipe);
    return output;
}

static bool has(const char *text, const char *word)
{
    const bool found = strstr(text, word) != NULL;
    if (!found)
        printf("     no \"%s\" in: %s\n", word, text);
    return found;
}

/* Files in the folder whose name begins as the temporary ones do. */
static int count_temporaries(void)
{
    int num = 0;
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir));)
        num += strncmp(entry->d_name, ".csgcast-", 9) == 0;
    if (dir)
        closedir(dir);
    return num;
}

static char last_message[4096];
static enum csgcast_message last_id;
static int num_messages;

static void collect(void *user, enum csgcast_log_level level, enum csgcast_message message,
                    const char *text)
{
    (void)user;
    (void)level;
    last_id = message;
    num_messages++;
    snprintf(last_message, sizeof last_message, "%s", text);
}

static bool write_image(const char *path, struct csgcast_write_params params)
{
    params.log = collect;
    params.metadata = metadata;
    params.num_metadata = 2;
    num_messages = 0;
    last_message[0] = '\0';
    const bool ok = csgcast_image_write(path, WIDTH, HEIGHT, &image, &params);
    if (ok != (num_messages == 0))
        printf("     %d messages, the last: %s\n", num_messages, last_message);
    return ok;
}

/* ---- tests of what is written ---- */

static void test_png(void)
{
    check(write_image(path_of("a.png"), (struct csgcast_write_params){0}), "png is written");
    const char *info = run("iinfo -v %s 2>&1", path_of("a.png"));
    check(has(info, "5 x   70, 3 channel, uint8 png"), "png has 8 bits, RGB");
    check(has(info, "csgcast:scene: \"part.csg\""), "png keeps the scene");
    check(has(info, "Software: \"csgcast 0.1.0\""), "png names the version");
    info = run("oiiotool --dumpdata %s 2>&1", path_of("a.png"));
    check(has(info, "Pixel (4, 0): 255 0 128"), "png has row 0 on top, red to the right");
    check(has(info, "Pixel (1, 1): 64 4 128"), "png values are rounded, not converted");
    check(has(info, "Pixel (0, 69): 0 255 128"), "png has the last row");
}

/* OpenImageIO's own PNG of a picture, through the module, for csgcast_image_write's to equal. */
static bool write_with_module(const char *path, int bits, int num_channels)
{
    static const char *const names[] = {"R", "G", "B", "A"};
    struct csg_image_channel channels[4];
    struct csg_image_error error = {{0}};
    void *const module = dlopen(getenv("CSGCAST_IMAGE_MODULE"), RTLD_NOW | RTLD_NODELETE);
    void *const address = module ? dlsym(module, CSG_IMAGE_MODULE_WRITE_NAME) : NULL;
    csg_image_module_write_fn *write_file = NULL;
    memcpy(&write_file, &address, sizeof write_file);
    for (int c = 0; c < num_channels; c++)
        channels[c] = (struct csg_image_channel){.name = names[c], .first = rgba + c, .stride = 4};
    const struct csg_image_file file = {path,     "png",        WIDTH,    HEIGHT, bits,
                                        channels, num_channels, metadata, 2};
    const bool ok = write_file && write_file(&file, &error);
    if (!ok)
        printf("     %s\n", error.text);
    return ok;
}

/* Values in and around 0 to 1, half of them on the edge between two steps of 8 or of 16 bits. */
static void fill_random(unsigned seed, bool is_opaque)
{
    const int steps = seed % 2 ? 255 : 65535;
    for (int i = 0; i < NUM_PIXELS * 4; i++) {
        seed = seed * 1664525u + 1013904223u;
        const float random = (float)(seed >> 8) / (float)(1 << 24);
        rgba[i] = seed >> 31 ? random * 1.2f - 0.1f
                             : ((float)(int)(random * (float)steps) + 0.5f) / (float)steps;
        if (i % 4 == 3 && is_opaque)
            rgba[i] = 1;
    }
}

/* What iinfo and oiiotool tell of a PNG, without its name and without the line of JPEG's. */
static const char *tell(const char *name)
{
    return run("cd %s && cp %s told.png && { iinfo -v told.png | grep -v jpeg:; "
               "oiiotool --dumpdata told.png; } 2>&1",
               folder, name);
}

static void test_equals_openimageio(void)
{
    for (unsigned i = 0; i < 8; i++) {
        const int bits = i & 1 ? 8 : 16, num_channels = i & 2 ? 3 : 4;
        char label[64];
        fill_random(i, num_channels == 3);
        bool ok = write_image(path_of("own.png"), (struct csgcast_write_params){.bits = bits}) &&
                  write_with_module(path_of("theirs.png"), bits, num_channels);
        char *own = strdup(tell("own.png"));
        ok = ok && own && strlen(own) > 1000 && !strcmp(own, tell("theirs.png"));
        snprintf(label, sizeof label, "png is OpenImageIO's: %d bits, %d channels", bits,
                 num_channels);
        check(ok, label);
        free(own);
    }
    fill_image();
}

static void test_deep_formats(void)
{
    check(write_image(path_of("b.png"), (struct csgcast_write_params){.bits = 16}), "png 16");
    check(has(run("iinfo %s 2>&1", path_of("b.png")), "3 channel, uint16 png"), "png has 16 bits");
    check(write_image(path_of("b.tif"), (struct csgcast_write_params){.bits = 16}), "tiff 16");
    const char *info = run("iinfo -v %s 2>&1", path_of("b.tif"));
    check(has(info, "3 channel, uint16 tiff"), "tiff has 16 bits");
    check(has(info, "csgcast:camera: 0,0,0,55,0,25,140"), "tiff keeps the camera");
    check(write_image(path_of("c.TIFF"), (struct csgcast_write_params){.bits = 32}), "tiff 32");
    check(has(run("iinfo %s 2>&1", path_of("c.TIFF")), "3 channel, float tiff"), "tiff has float");
}

static void test_exr(void)
{
    const struct csgcast_write_params all = {
        .write_z = true, .write_normal = true, .write_id = true};
    check(write_image(path_of("a.exr"), all), "exr is written");
    const char *info = run("iinfo -v %s 2>&1", path_of("a.exr"));
    check(has(info, "9 channel, float openexr"), "exr is float");
    check(has(info, "channel list: R, G, B, A, Z, id, N.X, N.Y, N.Z"), "exr names its channels");
    check(has(info, "csgcast:scene: \"part.csg\""), "exr keeps the scene");
    info = run("oiiotool --dumpdata %s 2>&1", path_of("a.exr"));
    check(has(info, "Pixel (0, 0): 0.000000000 0.000000000 0.500000000 1.000000000 0.100000001 "
                    "0.000000000 0.000000000 0.000000000 -0.250000000"),
          "exr has every value");
    check(has(info, " inf "), "exr keeps infinity");
    check(write_image(path_of("b.exr"), (struct csgcast_write_params){0}), "exr of colour");
    check(has(run("iinfo %s 2>&1", path_of("b.exr")), "4 channel, float"), "exr keeps A");
    const struct csgcast_image only_z = {.z = depth};
    check(csgcast_image_write(path_of("z.exr"), WIDTH, HEIGHT, &only_z,
                              &(struct csgcast_write_params){.write_z = true}) &&
              has(run("iinfo -v %s 2>&1", path_of("z.exr")), "channel list: Z"),
          "exr of depth alone");
}

static void test_alpha(void)
{
    rgba[3] = 0.5f;
    check(write_image(path_of("alpha.png"), (struct csgcast_write_params){0}), "png with alpha");
    check(has(run("iinfo %s 2>&1", path_of("alpha.png")), "4 channel"), "png has an alpha channel");
    check(has(run("oiiotool --dumpdata %s 2>&1", path_of("alpha.png")),
              "Pixel (0, 0): 0 0 64 128"), /* oiiotool multiplies by alpha when it reads */
          "colour is not divided by alpha");
    rgba[3] = 1;
}

static void test_strange_values(void)
{
    const float kept = rgba[0];
    rgba[0] = NAN;
    rgba[1] = 1e30f;
    rgba[2] = -INFINITY;
    check(write_image(path_of("nan.png"), (struct csgcast_write_params){0}), "nan and inf in png");
    check(has(run("oiiotool --dumpdata %s 2>&1", path_of("nan.png")), "Pixel (0, 0): 0 255 0"),
          "are the nearest value");
    rgba[0] = kept;
    rgba[1] = 0;
    rgba[2] = 0.5f;
}

static void test_other_formats(void)
{
    static const char *const names[] = {"a.jpg", "a.bmp", "a.tga",  "a.ppm", "a.gif",
                                        "a.hdr", "a.sgi", "a.webp", "a.JPEG"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        check(write_image(path_of(names[i]), (struct csgcast_write_params){0}), names[i]);
    const char *info = run("cd %s; iinfo a.jpg a.bmp a.tga a.ppm a.gif a.hdr a.sgi a.webp a.JPEG "
                           "2>&1 | grep -c '   5 x   70'",
                           folder);
    check(has(info, "9"), "all of them are read");
}

static void test_repeated(void)
{
    bool ok = write_image(path_of("1.exr"), (struct csgcast_write_params){.write_id = true});
    sleep(1);
    ok &= write_image(path_of("2.exr"), (struct csgcast_write_params){.write_id = true});
    check(ok && !*run("cmp %s/1.exr %s/2.exr 2>&1", folder, folder),
          "the same call, the same bytes");
}

static void test_named_format(void)
{
    const struct csgcast_write_params png = {.format = "PNG"};
    check(write_image(path_of("without-extension"), png), "format without an extension");
    check(!memcmp(run("cat %s", path_of("without-extension")), "\x89PNG", 4), "is a PNG");
}

/* ---- tests of where it goes ---- */

static void test_replaced(void)
{
    run("printf old > %s", path_of("old.png"));
    chmod(path_of("old.png"), 0600);
    check(write_image(path_of("old.png"), (struct csgcast_write_params){0}), "replaces a file");
    struct stat status;
    check(stat(path_of("old.png"), &status) == 0 && (status.st_mode & 0777) == 0600,
          "and keeps its mode");
    run("ln -s old.png %s/link.png; printf old > %s/old.png", folder, folder);
    check(write_image(path_of("link.png"), (struct csgcast_write_params){0}), "follows a link");
    check(lstat(path_of("link.png"), &status) == 0 && S_ISLNK(status.st_mode), "which stays");
    check(has(run("iinfo %s 2>&1", path_of("old.png")), "png"), "to the file");
}

static void test_device(void)
{
    struct stat status;
    const struct csgcast_write_params png = {.format = "png"};
    check(write_image("/dev/null", png), "writes to a device");
    check(stat("/dev/null", &status) == 0 && S_ISCHR(status.st_mode), "which stays a device");
    const bool is_full = write_image("/dev/full", png);
    check(!is_full && last_id == CSGCAST_MESSAGE_FILE, "a full device is an error");
}

static void test_stdout(void)
{
    fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    const int file = open(path_of("stdout"), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(file, STDOUT_FILENO);
    const bool ok = write_image("-", (struct csgcast_write_params){0});
    dup2(kept, STDOUT_FILENO);
    close(file);
    close(kept);
    check(ok && has(run("mv %s/stdout %s/stdout.png; iinfo %s/stdout.png", folder, folder, folder),
                    "uint8 png"),
          "- is a PNG on standard output");
}

/* ---- tests of failure ---- */

static void check_refused(const char *path, struct csgcast_write_params params, const char *word,
                          const char *name)
{
    const bool ok = write_image(path, params);
    check(!ok && num_messages == 1 && has(last_message, word), name);
    check(count_temporaries() == 0, "and nothing is left");
}

static void test_refused(void)
{
    const struct csgcast_write_params none = {0}, z = {.write_z = true};
    check_refused(path_of("a.xyz"), none, "xyz", "unknown format");
    check_refused(path_of("a.null"), none, "not a file format", "null");
    check_refused(path_of("noextension"), none, "extension", "no format");
    check_refused(path_of("aov.png"), z, "EXR", "Z in PNG");
    check_refused(path_of("aov.jpg"), z, "EXR", "Z in JPEG");
    check_refused(path_of("d.jpg"), (struct csgcast_write_params){.bits = 16}, "16 bits",
                  "JPEG 16");
    check_refused(path_of("d.png"), (struct csgcast_write_params){.bits = 32}, "32 bits", "PNG 32");
    check_refused(path_of("d.png"), (struct csgcast_write_params){.bits = 12}, "bits", "12 bits");
    check_refused(path_of("d.exr"), (struct csgcast_write_params){.bits = 8}, "float", "EXR 8");
    check_refused(path_of("no/folder/a.png"), none, "No such file", "no such folder");
    check_refused(folder, (struct csgcast_write_params){.format = "png"}, "directory", "a folder");
    check_refused(path_of("a.png"), (struct csgcast_write_params){.format = "../x"}, "format",
                  "a path as format");
    check(access(path_of("aov.png"), F_OK) != 0, "no target of a failure");
}

static void test_arguments(void)
{
    const struct csgcast_image none = {0};
    const struct csgcast_write_params quiet = {.log = collect};
    const struct csgcast_write_params z = {.log = collect, .write_z = true};
    check(!csgcast_image_write(path_of("x.png"), 0, 1, &image, &quiet), "no width");
    check(!csgcast_image_write(path_of("x.png"), 1, -1, &image, &quiet), "negative height");
    check(!csgcast_image_write(path_of("x.png"), 1, 1, &none, &quiet), "no channels");
    check(!csgcast_image_write(path_of("x.png"), 1, 1, NULL, &quiet), "no image");
    check(!csgcast_image_write(NULL, 1, 1, &image, &quiet), "no path");
    check(!csgcast_image_write(path_of("x.exr"), 1, 1, &none, &z), "Z that is not there");
    check(last_id == CSGCAST_MESSAGE_ARGUMENT, "are wrong arguments");
    check(csgcast_image_write(path_of("x.png"), 1, 1, &image, NULL), "no parameters are fine");
}

/* libjpeg ends the process on either; here the call has to come back. */
static void test_jpeg_limits(void)
{
    enum { LONG = 70000 };
    static char text[LONG];
    static float wide[LONG * 4];
    memset(text, 'x', LONG - 1);
    const struct csgcast_metadata entry = {"csgcast:scene", text};
    const struct csgcast_image picture = {.rgba = wide};
    const struct csgcast_write_params params = {
        .metadata = &entry, .num_metadata = 1, .log = collect};
    check(csgcast_image_write(path_of("text.jpg"), WIDTH, HEIGHT, &image, &params),
          "JPEG with a long text");
    check(!csgcast_image_write(path_of("wide.jpg"), LONG, 1, &picture, &params), "too wide a JPEG");
    check(has(last_message, "65500"), "names the limit");
}

static void test_no_module(void)
{
    const char *module = getenv("CSGCAST_IMAGE_MODULE");
    char *kept = module ? strdup(module) : NULL;
    setenv("CSGCAST_IMAGE_MODULE", "/nowhere/csgcast-image.so", 1);
    check_refused(path_of("m.tif"), (struct csgcast_write_params){0}, "libopenimageio",
                  "a missing module");
    check(write_image(path_of("m.png"), (struct csgcast_write_params){0}), "PNG needs none");
    unsetenv("CSGCAST_IMAGE_MODULE");
    if (kept)
        setenv("CSGCAST_IMAGE_MODULE", kept, 1);
    free(kept);
}

int main(void)
{
    if (!mkdtemp(folder))
        return EXIT_FAILURE;
    fill_image();
    test_no_module();
    csgcast_image_preload();
    csgcast_image_preload();
    test_png();
    test_equals_openimageio();
    test_deep_formats();
    test_exr();
    test_alpha();
    test_strange_values();
    test_other_formats();
    test_repeated();
    test_named_format();
    test_replaced();
    test_device();
    test_stdout();
    test_refused();
    test_arguments();
    test_jpeg_limits();
    check(count_temporaries() == 0, "no temporary files are left");
    run("rm -r %s", folder);
    return num_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
