/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* sched_getaffinity */
#endif

/* Contexts of both platforms: creation, drawing, and leaving the caller's context alone. */

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "gl/context.h"
#include "gl/egl_api.h"
#include "gl/osmesa_api.h"
#include "gl/threads.h"
#include "messages.h"

enum { SIZE = 4 };

static int num_failures;

static void check(bool ok, const char *name, const char *what)
{
    printf("%s %s %s\n", ok ? "ok" : "FAIL", name, what);
    num_failures += !ok;
}

/* ---- drawing ---- */

struct target {
    GLuint texture, framebuffer;
};

static struct target make_target(const struct csg_gl *gl)
{
    struct target target;
    gl->GenTextures(1, &target.texture);
    gl->BindTexture(GL_TEXTURE_2D, target.texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, SIZE, SIZE, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->GenFramebuffers(1, &target.framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture,
                             0);
    return target;
}

static void free_target(const struct csg_gl *gl, struct target target)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteFramebuffers(1, &target.framebuffer);
    gl->DeleteTextures(1, &target.texture);
}

/* Clears the bound framebuffer to the value and reads it back. */
static bool clears_to(const struct csg_gl *gl, float value)
{
    const GLfloat color[4] = {value, 2 * value, -value, 1};
    GLfloat pixels[SIZE * SIZE][4] = {{0}};
    gl->Viewport(0, 0, SIZE, SIZE);
    gl->ClearBufferfv(GL_COLOR, 0, color);
    gl->ReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, pixels);
    for (int i = 0; i < SIZE * SIZE; i++)
        if (memcmp(pixels[i], color, sizeof color) != 0)
            return false;
    return true;
}

static void test_drawing(struct csg_gl *gl)
{
    check(csg_gl_enter(gl), gl->name, "enter");
    const struct target target = make_target(gl);
    check(gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, gl->name, "fbo");
    check(clears_to(gl, 0.25f), gl->name, "float pixels outside 0 to 1 come back");
    free_target(gl, target);
    check(csg_gl_leave(gl), gl->name, "leave without GL errors");
}

static void test_errors(enum csgcast_backend backend)
{
    struct messages messages = {0};
    struct csg_gl *gl = csg_gl_create(backend, &(struct csg_log){keep_message, &messages});
    if (!gl)
        return;
    csg_gl_enter(gl);
    gl->Enable(0xffff);
    check(!csg_gl_leave(gl), gl->name, "leave reports a GL error");
    check(messages.num == 1 && strstr(messages.last, "invalid enum"), gl->name, "and names it");
    csg_gl_enter(gl);
    check(csg_gl_leave(gl), gl->name, "once only");
    csg_gl_destroy(gl);
}

/* ---- what was current ---- */

/* a draws, b interrupts it, a goes on where it was. */
static void test_nested(struct csg_gl *a, struct csg_gl *b, const char *name)
{
    csg_gl_enter(a);
    const struct target in_a = make_target(a);
    check(clears_to(a, 0.5f), name, "outer before");
    csg_gl_enter(b);
    const struct target in_b = make_target(b);
    check(clears_to(b, 0.75f), name, "inner");
    csg_gl_enter(b);
    check(clears_to(b, 1.5f), name, "inner entered twice");
    check(csg_gl_leave(b), name, "inner left once");
    check(clears_to(b, 2.5f), name, "inner is still current");
    free_target(b, in_b);
    check(csg_gl_leave(b), name, "inner leave");
    GLint bound = 0;
    a->GetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    check((GLuint)bound == in_a.framebuffer, name, "outer's framebuffer is still bound");
    check(clears_to(a, 1.25f), name, "outer after");
    free_target(a, in_a);
    check(csg_gl_leave(a), name, "outer leave");
}

/* The API that EGL has bound is a state of the thread; OpenGL ES is the default. */
static void test_egl_untouched(struct csg_gl *gl)
{
    struct csg_egl_api egl;
    if (!csg_egl_api_open(&egl))
        return;
    egl.BindAPI(EGL_OPENGL_ES_API);
    csg_gl_enter(gl);
    csg_gl_leave(gl);
    check(egl.QueryAPI() == EGL_OPENGL_ES_API, gl->name, "the thread's EGL API is kept");
    check(egl.GetCurrentContext() == EGL_NO_CONTEXT, gl->name, "no EGL context stays current");
    csg_egl_api_close(&egl);
}

/* A program that draws with OSMesa itself gets its context, buffer and picture back. */
static void test_osmesa_kept(struct csg_gl *gl)
{
    static const int attributes[] = {CSG_OSMESA_FORMAT, CSG_OSMESA_RGBA, 0};
    struct csg_osmesa_api osmesa;
    if (!csg_osmesa_api_open(&osmesa))
        return;
    GLubyte pixels[SIZE * SIZE * 4] = {0};
    csg_osmesa_context own = osmesa.CreateContextAttribs(attributes, NULL);
    osmesa.MakeCurrent(own, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE);
    const PFNGLCLEARCOLORPROC clear_color =
        (PFNGLCLEARCOLORPROC)osmesa.GetProcAddress("glClearColor");
    const PFNGLCLEARPROC clear = (PFNGLCLEARPROC)osmesa.GetProcAddress("glClear");
    const PFNGLFINISHPROC finish = (PFNGLFINISHPROC)osmesa.GetProcAddress("glFinish");
    clear_color(1, 0, 0, 1);
    clear(GL_COLOR_BUFFER_BIT);
    csg_gl_enter(gl);
    const struct target target = make_target(gl);
    check(clears_to(gl, 0.125f), gl->name, "draws inside a program that uses OSMesa");
    free_target(gl, target);
    csg_gl_leave(gl);
    check(osmesa.GetCurrentContext() == own, gl->name, "the program's OSMesa context is back");
    check(pixels[0] == 255 && pixels[SIZE * SIZE * 4 - 4] == 255, gl->name, "with its picture");
    clear_color(0, 1, 0, 1);
    clear(GL_COLOR_BUFFER_BIT);
    finish();
    check(pixels[0] == 0 && pixels[1] == 255, gl->name, "and draws on");
    osmesa.MakeCurrent(NULL, NULL, 0, 0, 0);
    osmesa.DestroyContext(own);
    csg_osmesa_api_close(&osmesa);
}

/* ---- the driver's threads ---- */

/* Threads that may run on one core only, no two of them on the same. */
static size_t count_spread(const struct csg_gl_threads *threads)
{
    cpu_set_t taken;
    size_t num = 0;
    CPU_ZERO(&taken);
    for (size_t i = 0; i < threads->num; i++) {
        cpu_set_t cores, both;
        sched_getaffinity(threads->ids[i], sizeof cores, &cores);
        CPU_AND(&both, &cores, &taken);
        CPU_OR(&taken, &taken, &cores);
        num += CPU_COUNT(&cores) == 1 && CPU_COUNT(&both) == 0;
    }
    return num;
}

/* Call it first: it looks at all rasterizers of the process. */
static void test_threads(void)
{
    cpu_set_t allowed;
    struct csg_gl_threads threads;
    struct csg_gl *gl = csg_gl_create(CSGCAST_BACKEND_EGL, NULL);
    if (!gl)
        return;
    test_drawing(gl);
    csg_gl_threads_list(&threads);
    sched_getaffinity(0, sizeof allowed, &allowed);
    const bool one_each = threads.num > 1 && (size_t)CPU_COUNT(&allowed) == threads.num;
    check(count_spread(&threads) == (one_each ? threads.num : 0), gl->name,
          one_each ? "a core for each rasterizer" : "rasterizers run where they like");
    check(CPU_COUNT(&allowed) == sysconf(_SC_NPROCESSORS_ONLN) || !one_each, gl->name,
          "the caller runs where it likes");
    csg_gl_destroy(gl);
}

/* What the program has started for itself runs where it likes. */
static void test_others(void)
{
    struct csg_gl_threads all, others;
    csg_gl_threads_list(&all);
    cpu_set_t allowed;
    sched_getaffinity(0, sizeof allowed, &allowed);
    for (size_t i = 0; i < all.num; i++)
        sched_setaffinity(all.ids[i], sizeof allowed, &allowed);
    others = all;
    csg_gl_threads_spread(&others);
    check(count_spread(&all) == 0 || CPU_COUNT(&allowed) == 1, "threads", "others are left alone");
    others.num = 0;
    csg_gl_threads_spread(&others);
    check(all.num < 2 || (size_t)CPU_COUNT(&allowed) != all.num || count_spread(&all) == all.num,
          "threads", "the same ones are spread where they are not others");
}

/* ---- failures ---- */

static void test_device(void)
{
    struct messages messages = {0};
    const struct csg_log log = {keep_message, &messages};
    setenv("CSGCAST_EGL_DEVICE", "4711", 1);
    check(!csg_gl_create(CSGCAST_BACKEND_EGL, &log), "device", "4711 does not exist");
    check(messages.num == 1 && strstr(messages.last, "4711"), "device", "one message names it");
    check(!csg_gl_create(CSGCAST_BACKEND_AUTO, &log), "device", "auto keeps to the device");
    setenv("CSGCAST_EGL_DEVICE", "gpu", 1);
    check(!csg_gl_create(CSGCAST_BACKEND_EGL, &log), "device", "a word is no number");
    setenv("CSGCAST_EGL_DEVICE", "0", 1);
    struct csg_gl *gl = csg_gl_create(CSGCAST_BACKEND_EGL, &log);
    check(gl != NULL, "device", gl ? gl->name : messages.last);
    if (gl)
        test_drawing(gl);
    csg_gl_destroy(gl);
    unsetenv("CSGCAST_EGL_DEVICE");
}

static void test_backends(void)
{
    struct messages messages = {0};
    const struct csg_log log = {keep_message, &messages};
    check(!csg_gl_create(CSGCAST_BACKEND_REFERENCE, &log), "reference", "is no OpenGL backend");
    check(messages.num == 1, "reference", "one message");
    csg_gl_destroy(NULL);
}

static void test_repeated(enum csgcast_backend backend)
{
    bool ok = true;
    for (int i = 0; i < 20 && ok; i++) {
        struct csg_gl *gl = csg_gl_create(backend, NULL);
        ok = gl && csg_gl_enter(gl) && csg_gl_leave(gl);
        csg_gl_destroy(gl);
    }
    check(ok, "repeated", "twenty contexts one after the other");
}

int main(void)
{
    test_threads();
    test_others();
    struct csg_gl *egl = csg_gl_create(CSGCAST_BACKEND_EGL, NULL);
    struct csg_gl *other_egl = csg_gl_create(CSGCAST_BACKEND_EGL, NULL);
    if (egl) {
        test_drawing(egl);
        test_osmesa_kept(egl); /* which the process loads only now */
    }
    struct csg_gl *osmesa = csg_gl_create(CSGCAST_BACKEND_OSMESA, NULL);
    struct csg_gl *automatic = csg_gl_create(CSGCAST_BACKEND_AUTO, NULL);
    check(egl && other_egl, "egl", egl ? egl->name : "no context");
    check(osmesa != NULL, "osmesa", osmesa ? osmesa->name : "no context");
    check(automatic != NULL, "auto", automatic ? automatic->name : "no context");
    if (egl && other_egl && osmesa && automatic) {
        test_drawing(egl);
        test_drawing(osmesa);
        test_drawing(automatic);
        test_nested(egl, other_egl, "egl in egl");
        test_nested(egl, osmesa, "osmesa in egl");
        test_nested(osmesa, egl, "egl in osmesa");
        test_egl_untouched(egl);
        test_egl_untouched(osmesa);
        test_osmesa_kept(egl);
        test_osmesa_kept(osmesa);
        test_repeated(CSGCAST_BACKEND_EGL);
        test_repeated(CSGCAST_BACKEND_OSMESA);
    }
    csg_gl_destroy(egl);
    csg_gl_destroy(automatic);
    csg_gl_destroy(osmesa);
    csg_gl_destroy(other_egl);
    test_errors(CSGCAST_BACKEND_EGL);
    test_errors(CSGCAST_BACKEND_OSMESA);
    test_device();
    test_backends();
    return num_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
