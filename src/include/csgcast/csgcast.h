/* SPDX-License-Identifier: MIT */
#ifndef CSGCAST_CSGCAST_H
#define CSGCAST_CSGCAST_H

/*
 * csgcast renders constructive solid geometry exactly, without a mesh.
 *
 *     struct csgcast_scene *scene = csgcast_scene_load("part.csg", NULL);
 *     struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
 *     struct csgcast_view view = {.width = 512, .height = 512};
 *     float rgba[512 * 512 * 4];
 *     struct csgcast_image image = {.rgba = rgba};
 *     csgcast_render(renderer, scene, &view, &image);
 *     csgcast_renderer_destroy(renderer);
 *     csgcast_scene_destroy(scene);
 *
 * Conventions are OpenSCAD's: right-handed, z up, degrees, column vectors. Lengths are in scene
 * units. Every params struct may be zero-initialised and every params pointer may be NULL: zero
 * and NULL mean the documented default.
 *
 * Failure: functions return NULL or false and report the reason through the log callback (standard
 * error when there is none). The library never exits or aborts and keeps no global state. What a
 * failed call returned may be passed on: given NULL in place of a scene, a renderer or an animation
 * a function fails as well, without another message, and destroying NULL does nothing.
 *
 * Threads: several renderers may read a scene at once. A thread that edits it (csgcast_scene_edit
 * and its kin, csgcast_scene_get_leaf) must be the only one that uses it. A renderer belongs to one
 * thread at a time. It makes its own context current during a call and restores what was current
 * before. Renderers that draw in software take turns, since Mesa's software rasteriser does not
 * bear two threads; so a log callback must not wait for another thread's renderer. With EGL a
 * process has one display per device: a program that calls eglTerminate for a display of Mesa's
 * surfaceless platform must destroy its renderers first.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CSGCAST_VERSION_MAJOR 0
#define CSGCAST_VERSION_MINOR 1
#define CSGCAST_VERSION_PATCH 0
#define CSGCAST_VERSION_STRING "0.1.0"

#if defined(__GNUC__)
#define CSGCAST_API __attribute__((visibility("default")))
#else
#define CSGCAST_API
#endif

/* The version of the linked library, "major.minor.patch". Never NULL. */
CSGCAST_API const char *csgcast_version(void);

/* ---- messages ---------------------------------------------------------------------------- */

enum csgcast_log_level {
    CSGCAST_LOG_ERROR,
    CSGCAST_LOG_WARNING,
    CSGCAST_LOG_INFO,
};

/* What a message is about, for callers that react to it. The text is for people. */
enum csgcast_message {
    CSGCAST_MESSAGE_MEMORY,      /* an allocation failed */
    CSGCAST_MESSAGE_FILE,        /* a file cannot be read or written */
    CSGCAST_MESSAGE_SYNTAX,      /* the scene text is malformed; the text starts file:line:column */
    CSGCAST_MESSAGE_SCENE,       /* a well-formed scene says something wrong; file:line:column */
    CSGCAST_MESSAGE_UNSUPPORTED, /* a node or feature that this version lacks; file:line:column */
    CSGCAST_MESSAGE_OPENSCAD,    /* openscad is missing, failed, or printed a warning */
    CSGCAST_MESSAGE_CONTEXT,     /* no OpenGL context, or a GL error */
    CSGCAST_MESSAGE_SHADER,      /* a shader does not compile: a bug here or in the driver */
    CSGCAST_MESSAGE_ARGUMENT,    /* a parameter of a call is out of range */
    CSGCAST_MESSAGE_IMAGE,       /* an image cannot be encoded or written */
    CSGCAST_MESSAGE_PROGRESS,    /* INFO: how far work has come that takes more than a second */
};

/* text: one message, no newline at its end, valid during the call only. */
typedef void csgcast_log_fn(void *user, enum csgcast_log_level level, enum csgcast_message id,
                            const char *text);

/* ---- scenes ------------------------------------------------------------------------------ */

/* What OpenSCAD's facetted circles mean. Default AUTO. */
enum csgcast_facets {
    CSGCAST_FACETS_AUTO,       /* explicit $fn of 3 to 12 is a polygon, everything else is exact */
    CSGCAST_FACETS_EXACT,      /* always the true quadric */
    CSGCAST_FACETS_AS_WRITTEN, /* OpenSCAD's vertices, as convex polyhedra */
};

struct csgcast_scene_params {
    const char *name;           /* file name in messages. NULL: the path, or "<memory>" */
    enum csgcast_facets facets; /* default AUTO */
    bool skip_unsupported;      /* leave unsupported nodes out, with a warning for each */
    const char *const *defines; /* num_defines texts "name=value", passed to openscad as -D */
    size_t num_defines;         /* default 0 */
    const char *parameter_file; /* a customizer's JSON file, openscad's -p, and */
    const char *parameter_set;  /* the name of the set in it, -P. NULL: none */
    const char *const *fonts;   /* num_fonts font files for text() besides the machine's; those that
                                 * a .scad names by use <x.ttf> are found without */
    size_t num_fonts;           /* default 0 */
    const char *directory;      /* where relative file names in the scene start. NULL: the path's
                                 * folder; for text in memory and "-" the working directory */
    const char *openscad;       /* program that flattens .scad. NULL: $OPENSCAD or "openscad" */
    uint64_t openscad_memory;   /* bytes that a run of it may take. 0: half of the machine's memory;
                                * UINT64_MAX: all that it gets */
    uint32_t openscad_seconds;  /* of processor time for a run of it. 0: without end */
    bool no_handoff;     /* subtrees that only openscad can evaluate are unsupported instead */
    const char *cache;   /* directory that keeps what openscad made of them; "": none. NULL:
                          * $CSGCAST_CACHE, $XDG_CACHE_HOME/csgcast or ~/.cache/csgcast */
    uint64_t cache_size; /* its bound in bytes. 0: $CSGCAST_CACHE_SIZE in MiB, or 256 MiB */
    csgcast_log_fn *log; /* NULL: standard error */
    void *log_user;      /* passed to log */
    int num_threads;     /* threads that read it, as in csgcast_renderer_params */
    bool fixed;          /* the scene is never edited: edits are errors, the text that they start
                          * from is not kept, and programs that they may need are not compiled */
};

struct csgcast_scene;

/*
 * Reads a scene file: .scad is flattened by the installed openscad, everything else is read as
 * .csg text (docs/scene-format.md). path "-" reads .csg text from standard input. All errors of
 * the text are logged, each with file:line:column. NULL on error.
 */
CSGCAST_API struct csgcast_scene *csgcast_scene_load(const char *path,
                                                     const struct csgcast_scene_params *params);

/* The same for .csg text in memory. text needs no terminating zero and may be freed afterwards. */
CSGCAST_API struct csgcast_scene *csgcast_scene_parse(const char *text, size_t size,
                                                      const struct csgcast_scene_params *params);

CSGCAST_API void csgcast_scene_destroy(struct csgcast_scene *scene);

/*
 * A .scad file at num_frames moments, $t = 0, 1 / num_frames, ..., as openscad --animate has it:
 * one run of openscad for all of them. num_frames: 1 to 100000. Each frame is a scene of its own,
 * whose camera moves where the file assigns $vpr and its like. params as for csgcast_scene_load;
 * its log is used until the animation is destroyed. Until then the texts are in a temporary folder.
 * NULL on error.
 */
struct csgcast_animation;
CSGCAST_API struct csgcast_animation *
csgcast_animation_load(const char *path, int num_frames, const struct csgcast_scene_params *params);

/* The scene of a frame, from 0; the caller destroys it. NULL on error. */
CSGCAST_API struct csgcast_scene *csgcast_animation_scene(const struct csgcast_animation *animation,
                                                          int frame);

CSGCAST_API void csgcast_animation_destroy(struct csgcast_animation *animation);

struct csgcast_kind_count {
    const char *name; /* as in docs/scene-format.md, e.g. "cylinder"; static */
    size_t count;     /* leaves of this kind */
};

/* How a node's surface comes about. */
enum csgcast_way {
    CSGCAST_WAY_EXACT,    /* as meant: quadrics, and what is polyhedral by nature */
    CSGCAST_WAY_FACETTED, /* OpenSCAD's facets in place of a curved surface */
    CSGCAST_WAY_MESH,     /* a mesh of triangles */
    CSGCAST_WAY_OPENSCAD, /* a mesh that openscad's kernel has made, or a drawing */
};

/* Nodes of one name that come about in one way; nodes of CSGCAST_WAY_OPENSCAD each by itself. */
struct csgcast_scene_way {
    enum csgcast_way way;
    const char *name;   /* of the node, e.g. "cylinder" */
    const char *reason; /* why it is not exact; NULL where it is */
    size_t num_nodes;
    size_t num_leaves;     /* that they became; 0 for a drawing, which is part of other nodes */
    unsigned line, column; /* of the first of them; of .scad: in the flattened text */
    double seconds;        /* OPENSCAD: what openscad took, now or when it went to the cache */
    bool cached;           /* OPENSCAD: it comes from the cache */
};

/* What a scene consists of. kinds and ways live until the scene is edited or destroyed. */
struct csgcast_scene_info {
    /* Leaves: the solids of the text. */
    size_t num_leaves;      /* that take part, highlighted and background ones included */
    size_t num_exact;       /* whose curved surface is exact */
    size_t num_facetted;    /* drawn with OpenSCAD's facets */
    size_t num_highlighted; /* under # */
    size_t num_background;  /* under % */
    size_t num_dropped;     /* left out because they are empty or cannot be seen */
    size_t num_kinds;       /* entries in kinds */
    const struct csgcast_kind_count *kinds; /* kinds in use */
    /* The Boolean tree after simplification. */
    size_t num_nodes;     /* Boolean nodes */
    size_t depth;         /* one leaf alone has depth 0 */
    size_t num_objects;   /* independent union terms, drawn separately */
    size_t max_crossings; /* most boundary crossings that one ray can have */
    /* Surfaces. */
    size_t num_planes;    /* distinct plane carriers after coincident ones were merged */
    size_t num_quadrics;  /* distinct quadric carriers, likewise */
    size_t num_shared;    /* faces that share another face's carrier: flush, abutting, equal */
    size_t num_triangles; /* of the leaves that are surfaces of triangles */
    /* Differences from what is meant. */
    double sagitta;        /* OpenSCAD's facets are at most this far from the exact surfaces; scene
                            * units, 0: there are none */
    size_t num_handed_off; /* nodes that openscad has evaluated */
    size_t num_rounded;    /* numbers of the text that may be rounded to six digits, as OpenSCAD
                            * writes them; .scad: 0 where it could be made to write all */
    size_t num_ways;       /* entries in ways */
    const struct csgcast_scene_way *ways; /* how nodes come about, in the order of the enum */
};

CSGCAST_API void csgcast_scene_get_info(const struct csgcast_scene *scene,
                                        struct csgcast_scene_info *info);

/* Box of the drawn solids in scene units; false when empty. Unbounded directions are infinite. */
CSGCAST_API bool csgcast_scene_get_bounds(const struct csgcast_scene *scene, double lo[3],
                                          double hi[3]);

/* ---- edits ---------------------------------------------------------------------------------- */

/*
 * A scene's leaves are its solids in the order of the text; their index is what the channel id
 * shows. An edit changes the matrix, parameters or colour of some of them, and the result is that
 * of loading the changed text, to the last bit: what follows from them (bounds, what is left out,
 * coincident faces) is made anew.
 *
 * The frame after an edit uploads bytes and compiles no program: what newly shows is drawn by
 * programs that are there, and the first frame of a scene compiles those that edits may need (not
 * of a fixed scene, see csgcast_scene_params). The next frame without an edit before it may compile
 * a program that draws faster, as a frame with a moved camera may.
 *
 * Nodes that become several solids (extrusions, polyhedra that are not convex, hulls) have several
 * leaves: a matrix, a colour or the parameters of one of them are those of all. What is in a
 * render() has one colour, as in OpenSCAD: that of one of its leaves is that of all.
 *
 * New parameters of an extrusion, a hull and their like, or of a node in one (the circle that is
 * extruded, see csgcast_scene_get_node), have it read anew, with openscad where only that can
 * evaluate it. Where it becomes another number of leaves, those behind it are renumbered as loading
 * the changed text would number them: csgcast_scene_num_leaves and csgcast_scene_get_leaf tell.
 */
struct csgcast_leaf {
    const char *kind;      /* of the node, e.g. "cylinder"; static */
    unsigned line, column; /* of the node in the text, from 1; of .scad: in the flattened text */
    size_t first, num;     /* the leaves of its node; of most nodes this one alone */
    size_t num_nodes;      /* its node and those in it that it is read with; of a solid 1 */
    bool empty;            /* an edit has left nothing of it; it keeps its index */
    /* From the solid's own space (docs/solids.md) to the world: the product of all matrices around
     * it, the outermost one on the left. By rows, as in multmatrix; the last row is 0 0 0 1. */
    double matrix[16];
    float color[4]; /* r g b a as the outermost color() says; below 0: the scheme's */
    /* What stands between the node's parentheses, "h = 10, r1 = 2, r2 = 2". Lives until the scene
     * is edited or destroyed. */
    const char *parameters;
};

/* A leaf's node, or one in it. */
struct csgcast_node {
    const char *name;       /* e.g. "circle"; static */
    unsigned line, column;  /* as in struct csgcast_leaf */
    size_t num;             /* of this and those in it: node + num is the one beside it */
    const char *parameters; /* as in struct csgcast_leaf */
};

/* How many leaves there are, empty ones and those that were left out included. */
CSGCAST_API size_t csgcast_scene_num_leaves(const struct csgcast_scene *scene);

/* The first call on a scene, or the first edit, reads its text once more. false, with a message,
 * where there is no such leaf, the scene is fixed or memory is out. */
CSGCAST_API bool csgcast_scene_get_leaf(struct csgcast_scene *scene, size_t leaf,
                                        struct csgcast_leaf *info);

/* The node of that number, in the order of the text, among those of a leaf: 0 is the leaf's own.
 * Fails as csgcast_scene_get_leaf does. */
CSGCAST_API bool csgcast_scene_get_node(struct csgcast_scene *scene, size_t leaf, size_t node,
                                        struct csgcast_node *info);

/* A change of one leaf; what is NULL stays as it is. */
struct csgcast_edit {
    size_t leaf;
    /* 16 numbers by rows, as in struct csgcast_leaf: replaces all matrices around the leaf. All
     * finite, the last row 0 0 0 1. A singular matrix leaves nothing of the leaf. The numbers count
     * as those of a multmatrix right at the leaf; numbers that do not change keep the rounding that
     * they have from the file (docs/coincidence.md). */
    const double *matrix;
    /* All of the node's arguments as scene text: "r = 3, $fn = 40". What is not given takes its
     * default. Parameters that make nothing (r = 0) leave nothing of the node's leaves. */
    const char *parameters;
    /* r g b a, finite. A component below 0 is the scheme's; all below 0: as without color(). */
    const float *color;
    /* Whose arguments parameters are: 0 the leaf's node, else one in it (csgcast_scene_get_node).
     */
    size_t node;
};

/*
 * Makes all changes, then once what follows from them. false, with a message for the first change
 * that is wrong, where none was made. Of several changes of the same leaf the last one counts; all
 * leaves go by the numbers that they have before the call. Messages about parameters begin with
 * "<edit of leaf N>:line:column:". What # or % shows of an extrusion or its like by itself has
 * parameters that cannot be set, nor can those of nodes in that one.
 */
CSGCAST_API bool csgcast_scene_edit(struct csgcast_scene *scene, const struct csgcast_edit *edits,
                                    size_t num_edits);

/* One change each; parameters: of the leaf's own node. */
CSGCAST_API bool csgcast_scene_set_matrix(struct csgcast_scene *scene, size_t leaf,
                                          const double matrix[16]);
CSGCAST_API bool csgcast_scene_set_parameters(struct csgcast_scene *scene, size_t leaf,
                                              const char *parameters);
CSGCAST_API bool csgcast_scene_set_color(struct csgcast_scene *scene, size_t leaf,
                                         const float color[4]);

/* ---- the cache ----------------------------------------------------------------------------- */

/*
 * The cache on disk keeps what openscad made of subtrees that only it can evaluate, by content: the
 * text of the subtree, the files that it reads, openscad's version, the fonts where it has text.
 * Where it becomes larger than its bound, what was not used for the longest time is removed. It may
 * be cleared or deleted at any time, and several processes may use it at once.
 */
struct csgcast_cache_info {
    char path[4096]; /* the directory; empty: there is none, as no home directory is known */
    size_t num_entries;
    uint64_t size;  /* bytes in use */
    uint64_t limit; /* bytes allowed by the environment */
};

/* directory: as cache in struct csgcast_scene_params. false: nothing was ever stored there. */
CSGCAST_API bool csgcast_cache_get_info(const char *directory, struct csgcast_cache_info *info);

/* Removes all entries, nothing else. false: some of them cannot be removed. */
CSGCAST_API bool csgcast_cache_clear(const char *directory);

/* ---- camera and view ---------------------------------------------------------------------- */

enum csgcast_camera_kind {
    CSGCAST_CAMERA_DEFAULT, /* that of a .scad which assigns $vpt, $vpr, $vpd or $vpf; else
                             * OpenSCAD's: rotation 55, 0, 25, the whole scene in view */
    CSGCAST_CAMERA_GIMBAL,  /* translate, rotate, distance */
    CSGCAST_CAMERA_VECTOR,  /* eye, center */
};

enum csgcast_projection { CSGCAST_PERSPECTIVE, CSGCAST_ORTHOGRAPHIC };

struct csgcast_camera {
    enum csgcast_camera_kind kind;
    double translate[3]; /* GIMBAL: the point looked at */
    double rotate[3];    /* GIMBAL: degrees, as in --camera=tx,ty,tz,rx,ry,rz,d */
    double distance;     /* GIMBAL: from eye to the point looked at */
    double eye[3];       /* VECTOR */
    double center[3];    /* VECTOR: the point looked at; up is as close to +z as can be */
    enum csgcast_projection projection; /* default perspective */
    double fov;                         /* vertical, degrees, 0 < fov < 180. 0: 22.5 as OpenSCAD */
    bool viewall;                       /* move the eye so that the whole scene is in view */
    bool autocenter;                    /* with viewall: look at the centre of the scene's box */
};

/* Whose colour shades a face that a subtracted solid has cut. */
enum csgcast_cut_color {
    CSGCAST_CUT_OPENSCAD, /* the subtracted solid's own color(), else the scheme's cut colour */
    CSGCAST_CUT_MINUEND,  /* the colour of the solid that was cut */
};

struct csgcast_view {
    int width, height; /* pixels, 1 to 16384. 0: 512 */
    struct csgcast_camera camera;
    const char *colorscheme; /* a name of csgcast_colorscheme_name. NULL: "Cornfield" */
    enum csgcast_cut_color cut_color;
    const char *variant; /* resolver: NULL or "auto", or one of csgcast_variant_name */
};

/* The names of the colour schemes, index 0 the default; NULL past the last. */
CSGCAST_API const char *csgcast_colorscheme_name(size_t index);

/* The names of the resolvers that can be forced; NULL past the last. All give the same picture
 * except "textbook", a baseline for comparisons: the quadratic formula in world space, in float32.
 * "shared" suits callers that draw a picture or two of a scene: it is auto without programs for the
 * scene's own structures, each of which takes some 100 ms to compile on a machine that has not seen
 * it.
 *
 * A renderer's first picture of a fixed scene by "auto" is drawn as by "shared", so that it does not
 * wait for programs that only later ones repay; only parts of which there are many have theirs at
 * once. Those after it compile them: as many as a driver has from its cache in some 10 ms, else a
 * few a picture. Draw until csgcast_stats' programs stays the same to have that over before an
 * animation begins. */
CSGCAST_API const char *csgcast_variant_name(size_t index);

/* A camera resolved against a scene: what is rendered. All vectors in scene units. */
struct csgcast_frustum {
    double eye[3];
    double right[3], up[3], forward[3]; /* orthonormal */
    double half_width, half_height;     /* perspective: at unit distance; orthographic: units */
    bool orthographic;
};

/* Resolves defaults, viewall and autocenter. false, with a message, for an impossible camera. */
CSGCAST_API bool csgcast_view_resolve(const struct csgcast_scene *scene,
                                      const struct csgcast_view *view,
                                      struct csgcast_frustum *frustum);

/* ---- rendering ---------------------------------------------------------------------------- */

enum csgcast_backend {
    CSGCAST_BACKEND_AUTO,      /* EGL where it works, else OSMesa */
    CSGCAST_BACKEND_EGL,       /* surfaceless or device: no display needed */
    CSGCAST_BACKEND_OSMESA,    /* software, loaded at run time */
    CSGCAST_BACKEND_REFERENCE, /* double-precision ray caster in C: no OpenGL, slow, the oracle */
};

struct csgcast_renderer_params {
    enum csgcast_backend backend;
    csgcast_log_fn *log; /* NULL: standard error */
    void *log_user;
    /* csgcast_renderer_create returns at once and a thread loads the driver and makes the context,
     * some 60 ms with llvmpipe, while the caller loads its scene. The first csgcast_render waits
     * for it, and fails where the backend is not available; messages come from that thread. */
    bool background;
    /* Threads that prepare a picture, or cast it where OpenGL does not, csgcast_render's caller one
     * of them, 1 to 64. 0 and anything else: as many as there are cores. Pictures do not depend on
     * it. The driver has threads of its own: llvmpipe's number is set by LP_NUM_THREADS; where
     * there are as many as cores, those that a renderer starts are bound to one each. */
    int num_threads;
};

struct csgcast_renderer;

/* NULL, with a message, where the backend is not available; see background. */
CSGCAST_API struct csgcast_renderer *
csgcast_renderer_create(const struct csgcast_renderer_params *params);
CSGCAST_API void csgcast_renderer_destroy(struct csgcast_renderer *renderer);

/* "egl: llvmpipe (LLVM 15, 256 bits), 4.5 core": for people. Lives as long as the renderer. Of a
 * renderer made in the background it is known after the first picture. */
CSGCAST_API const char *csgcast_renderer_name(const struct csgcast_renderer *renderer);

/*
 * Draws nothing with each of the programs that pictures of most scenes take, all with the variant
 * "shared", with "auto" all but those for a scene's own structures. A driver that keeps what it
 * compiles, as Mesa does on disk for each user, has them then in other processes as well. With
 * llvmpipe some twelve seconds, with a message each second; a tenth of that where they are there
 * already. csgcast_renderer_destroy then ends the EGL display, for the driver to write all of it,
 * and so every context that the process has on that: for processes of their own. false, with a
 * message, on failure.
 */
CSGCAST_API bool csgcast_renderer_warm(struct csgcast_renderer *renderer);

/*
 * The caller's buffers, row 0 on top, tightly packed; a NULL channel is not computed.
 * A pixel's ray goes through its centre. Where the eye is inside a solid, the first surface seen
 * is the one through which the ray leaves it.
 */
struct csgcast_image {
    float *rgba;    /* width * height * 4: colour as OpenSCAD shows it, 0 to 1, alpha 1 */
    float *z;       /* width * height: distance along the view axis, infinity on a miss */
    float *normal;  /* width * height * 3: unit, world space, out of the solid, 0 on a miss */
    float *id;      /* width * height: index of the visible leaf in file order, -1 on a miss */
    uint8_t *rgba8; /* width * height * 4: rgba * 255, rounded; alone it is cheaper than rgba */
};

/* Blocks until image is filled. false, with a message, on failure: image is then undefined. */
CSGCAST_API bool csgcast_render(struct csgcast_renderer *renderer,
                                const struct csgcast_scene *scene, const struct csgcast_view *view,
                                const struct csgcast_image *image);

/* Solids of one kind that are drawn by themselves, by programs for a single solid (Toledo and Levy
 * 2004, Table 1): how much of their rectangles shows them. */
struct csgcast_kind_waste {
    const char *name;    /* as in csgcast_kind_count */
    size_t num;          /* solids drawn so */
    size_t proxy_pixels; /* of their rectangles */
    size_t hit_pixels;   /* of these the ones that show one of them */
};

/* More kinds of solid than there are. */
#define CSGCAST_MAX_KINDS 32

/* What the last csgcast_render of this renderer did. Times are in ms. */
struct csgcast_stats {
    /* Objects, and what draws them. */
    char variants[256];        /* resolvers used, with the number of objects each drew */
    size_t objects_drawn;      /* the others are outside the view */
    size_t overflowed_objects; /* too large for the variant that was forced: the loop drew them */
    size_t precise_objects;    /* drawn in double, where float does not hold them */
    char numerics[1024];       /* which, and why: a line for each, as many as fit; "": none */
    size_t programs;           /* shader programs that this renderer has compiled so far */
    /* Bytes. */
    size_t texture_bytes;  /* the float texture: parameters and programs */
    size_t bytes_uploaded; /* in this frame */
    /* Pixels. */
    size_t proxy_pixels;      /* covered by the objects' bounds, overlaps counted */
    size_t solid_tests;       /* solids in the programs of the rectangles that were drawn, times
                               * their pixels; divided by proxy_pixels: tests per pixel */
    bool has_hit_pixels;      /* z or id was asked for, which hit_pixels is counted from */
    size_t hit_pixels;        /* that show a solid, where has_hit_pixels */
    size_t unfinished_pixels; /* too much for a fragment program: cast on the CPU instead */
    /* Large objects are drawn in tiles: those in which nothing is left, those in which some solid
     * fills the tile and hides the rest, and the others. */
    size_t tiles_empty, tiles_opaque, tiles_mixed;
    /* Where id was asked for, but not of the reference backend; else none. */
    struct csgcast_kind_waste single_kinds[CSGCAST_MAX_KINDS];
    size_t num_single_kinds;
    /* The scene's: reading it, openscad included, and preparing it (trees, coincident faces), by
     * the load or the last edit. */
    double load_ms, csg_ms;
    /* The frame's. For the reference backend all but frame_ms are 0. */
    double frame_ms;         /* the whole call */
    double compile_ms;       /* of that: compiling programs */
    double cpu_ms;           /* preparing it in double precision, made up of the next two */
    double tile_ms, pack_ms; /* tiling; terms, records and what cannot show */
    double upload_ms;        /* handing it over to the driver */
    double draw_ms;          /* until the driver has drawn */
    double read_ms;          /* until the caller's buffers are filled */
};

CSGCAST_API void csgcast_renderer_get_stats(const struct csgcast_renderer *renderer,
                                            struct csgcast_stats *stats);

/* ---- image files -------------------------------------------------------------------------- */

struct csgcast_metadata {
    const char *name, *value;
};

struct csgcast_write_params {
    const char *format; /* "png", "exr", ... NULL: the path's extension */
    int bits; /* per channel: 8, 16, or 32 for float. 0: 32 for EXR, HDR, Z N id; else 8 */
    bool write_z, write_normal, write_id;    /* EXR and TIFF: float channels besides R G B A */
    const struct csgcast_metadata *metadata; /* num_metadata texts kept in the file */
    size_t num_metadata;
    csgcast_log_fn *log; /* NULL: standard error */
    void *log_user;
};

/*
 * Writes image, PNG with libpng and everything else with OpenImageIO, beside the target first and
 * then renamed: never half a file. path "-" writes to standard output, as PNG unless format says
 * otherwise; a device or a pipe is written to and not replaced.
 *
 * Colour is rgba, or where that is NULL rgba8: in a file of 8 bits the same bytes, in others those
 * values / 255. Values are written as they are, without conversion. Where alpha is 1 everywhere
 * there is no alpha channel, except in EXR. EXR channels: R G B A Z N.X N.Y N.Z id; without colour
 * only those after A. What the format cannot hold is an error.
 *
 * Any thread; OpenImageIO is loaded by the first call for another format than PNG.
 */
CSGCAST_API bool csgcast_image_write(const char *path, int width, int height,
                                     const struct csgcast_image *image,
                                     const struct csgcast_write_params *params);

/*
 * Optional, and of no use for PNG: starts to load OpenImageIO and its 260 shared libraries (about
 * 0.25 s) in a background thread; csgcast_image_write waits for the rest. May be called any number
 * of times, from the thread that will end the program, whose exit waits for the loading. Failures
 * show in csgcast_image_write. Does nothing where the C library is not glibc.
 */
CSGCAST_API void csgcast_image_preload(void);

/* ---- export ------------------------------------------------------------------------------- */

/*
 * Writes the scene for another program, which then draws the same solids from the same camera in
 * the same colours. view: NULL for the default; its variant does not matter, and of its size only
 * the ratio does. format: a name of csgcast_export_format_name. NULL: the path's extension. path
 * and failures as with csgcast_image_write; messages go to the scene's log.
 *
 * "pov" is POV-Ray 3.7: its own spheres, boxes, cylinders, cones, quadrics and planes under its own
 * Booleans, exact as here, without shadows and reflections. POV-Ray does not know coincident faces:
 * where a subtracted solid's face lies in another's, it is moved by a millionth of the scene; of
 * other coincident faces rounding decides which one shows. Polyhedra of more than 64 faces become
 * meshes, whose points POV-Ray keeps in single precision, and meshes stay meshes.
 */
CSGCAST_API bool csgcast_export(const char *path, const struct csgcast_scene *scene,
                                const struct csgcast_view *view, const char *format);

/* The names of the formats; NULL past the last. */
CSGCAST_API const char *csgcast_export_format_name(size_t index);

#ifdef __cplusplus
}
#endif

#endif
