/* SPDX-License-Identifier: MIT */

/*
 * host: a program that draws with OpenGL itself. csgcast has a context of its own, which is current
 * only during a call; the host's context stays as it was, and takes the picture as a texture.
 */

#include <csgcast/csgcast.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <stdio.h>
#include <string.h>

enum { size = 64 };

/* The host's OpenGL, found at run time; a real one has its loader for that. */
struct gl {
    EGLDisplay display;
    EGLContext context;
    void (*gen_textures)(GLsizei, GLuint *);
    void (*bind_texture)(GLenum, GLuint);
    void (*tex_image)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *);
    void (*get_tex_image)(GLenum, GLint, GLenum, GLenum, void *);
    void (*get_integer)(GLenum, GLint *);
    GLenum (*get_error)(void);
};

static void find(const char *name, void *function, size_t bytes)
{
    const __eglMustCastToProperFunctionPointerType found = eglGetProcAddress(name);
    memcpy(function, &found, bytes);
}

/* Any way will do; this one needs no display. */
static bool begin(struct gl *gl)
{
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display;
    find("eglGetPlatformDisplayEXT", &get_display, sizeof get_display);
    gl->display =
        get_display ? get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL) : NULL;
    if (!gl->display || !eglInitialize(gl->display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    gl->context = eglCreateContext(gl->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, NULL);
    find("glGenTextures", &gl->gen_textures, sizeof gl->gen_textures);
    find("glBindTexture", &gl->bind_texture, sizeof gl->bind_texture);
    find("glTexImage2D", &gl->tex_image, sizeof gl->tex_image);
    find("glGetTexImage", &gl->get_tex_image, sizeof gl->get_tex_image);
    find("glGetIntegerv", &gl->get_integer, sizeof gl->get_integer);
    find("glGetError", &gl->get_error, sizeof gl->get_error);
    return gl->context && eglMakeCurrent(gl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, gl->context);
}

/* A picture between two calls of the host's OpenGL: nothing of its state has changed. */
static bool take_picture(const struct gl *gl, struct csgcast_renderer *renderer,
                         const struct csgcast_scene *scene)
{
    static uint8_t rgba8[size * size * 4], back[size * size * 4];
    const struct csgcast_image image = {.rgba8 = rgba8};
    const struct csgcast_view view = {.width = size, .height = size};
    GLuint texture = 0;
    GLint bound = 0;
    gl->gen_textures(1, &texture);
    gl->bind_texture(GL_TEXTURE_2D, texture);
    if (!csgcast_render(renderer, scene, &view, &image))
        return false;
    gl->get_integer(GL_TEXTURE_BINDING_2D, &bound);
    gl->tex_image(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba8);
    gl->get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back);
    return eglGetCurrentContext() == gl->context && bound == (GLint)texture &&
           gl->get_error() == GL_NO_ERROR && memcmp(rgba8, back, sizeof back) == 0;
}

int main(void)
{
    static const char text[] = "difference() { cube(20, center = true); sphere(13); }";
    struct gl gl = {0};
    struct csgcast_scene *scene = csgcast_scene_parse(text, sizeof text - 1, NULL);
    bool ok = begin(&gl);
    struct csgcast_renderer *renderer = ok ? csgcast_renderer_create(NULL) : NULL;
    ok = scene && renderer && eglGetCurrentContext() == gl.context &&
         take_picture(&gl, renderer, scene) && take_picture(&gl, renderer, scene);
    csgcast_renderer_destroy(renderer);
    ok = ok && eglGetCurrentContext() == gl.context; /* csgcast shares nothing with the host */
    csgcast_scene_destroy(scene);
    if (gl.display)
        eglTerminate(gl.display);
    printf("%s\n", ok ? "the picture is a texture of the host's" : "something is wrong");
    return !ok;
}
