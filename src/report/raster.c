/* SPDX-License-Identifier: MIT */
#include "report/raster.h"

#include "gl/context.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct csg_raster {
    struct csg_gl *gl;
    struct csg_log log;
    GLuint program;
    GLuint framebuffer, color, depth;
    int width, height; /* of the framebuffer */
    float *pixels;     /* as read back */
};

static const char vertex_text[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 corner;\n"
    "layout(location = 1) in vec3 corner_normal;\n"
    "uniform vec4 row_x, row_y, row_z, row_w, row_distance;\n"
    "flat out vec3 normal;\n"
    "out float distance;\n"
    "void main()\n"
    "{\n"
    "    vec4 p = vec4(corner, 1.0);\n"
    "    normal = corner_normal;\n"
    "    distance = dot(row_distance, p);\n"
    "    gl_Position = vec4(dot(row_x, p), dot(row_y, p), dot(row_z, p), dot(row_w, p));\n"
    "}\n";

static const char fragment_text[] = "#version 330 core\n"
                                    "flat in vec3 normal;\n"
                                    "in float distance;\n"
                                    "out vec4 geometry;\n"
                                    "void main()\n"
                                    "{\n"
                                    "    geometry = vec4(normal, distance);\n"
                                    "}\n";

/* ---- the program and the targets ------------------------------------------------------------ */

static GLuint compile(const struct csg_gl *gl, GLenum stage, const char *text)
{
    const GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    return shader;
}

static bool link_program(struct csg_raster *raster)
{
    const struct csg_gl *gl = raster->gl;
    const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertex_text);
    const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_text);
    GLint ok = 0;
    raster->program = gl->CreateProgram();
    gl->AttachShader(raster->program, vertex);
    gl->AttachShader(raster->program, fragment);
    gl->LinkProgram(raster->program);
    gl->GetProgramiv(raster->program, GL_LINK_STATUS, &ok);
    gl->DeleteShader(vertex);
    gl->DeleteShader(fragment);
    if (!ok)
        csg_log_error(&raster->log, CSGCAST_MESSAGE_SHADER,
                      "the driver rejects the rasteriser's program");
    return ok;
}

static void delete_targets(struct csg_raster *raster)
{
    const struct csg_gl *gl = raster->gl;
    if (!raster->framebuffer)
        return;
    gl->DeleteFramebuffers(1, &raster->framebuffer);
    gl->DeleteTextures(1, &raster->color);
    gl->DeleteRenderbuffers(1, &raster->depth);
    free(raster->pixels);
    raster->framebuffer = 0;
    raster->pixels = NULL;
}

static bool make_targets(struct csg_raster *raster, int width, int height)
{
    const struct csg_gl *gl = raster->gl;
    if (raster->framebuffer && raster->width == width && raster->height == height)
        return true;
    delete_targets(raster);
    raster->width = width;
    raster->height = height;
    raster->pixels = malloc(4 * sizeof *raster->pixels * (size_t)width * (size_t)height);
    if (!raster->pixels)
        return csg_log_memory(&raster->log);
    gl->GenTextures(1, &raster->color);
    gl->BindTexture(GL_TEXTURE_2D, raster->color);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->GenRenderbuffers(1, &raster->depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, raster->depth);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    gl->GenFramebuffers(1, &raster->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, raster->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, raster->color, 0);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                raster->depth);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return true;
    csg_log_error(&raster->log, CSGCAST_MESSAGE_CONTEXT,
                  "the driver cannot draw into a float texture of %d x %d pixels", width, height);
    return false;
}

struct csg_raster *csg_raster_create(enum csgcast_backend backend, const struct csg_log *log)
{
    struct csg_raster *raster = calloc(1, sizeof *raster);
    if (!raster) {
        csg_log_memory(log);
        return NULL;
    }
    raster->log = *log;
    raster->gl = csg_gl_create(backend, log);
    bool ok = raster->gl && csg_gl_enter(raster->gl);
    if (ok) {
        ok = link_program(raster);
        ok = csg_gl_leave(raster->gl) && ok;
    }
    if (ok)
        return raster;
    csg_raster_destroy(raster);
    return NULL;
}

void csg_raster_destroy(struct csg_raster *raster)
{
    if (!raster)
        return;
    if (raster->gl && csg_gl_enter(raster->gl)) {
        delete_targets(raster);
        raster->gl->DeleteProgram(raster->program);
        csg_gl_leave(raster->gl);
    }
    if (raster->gl)
        csg_gl_destroy(raster->gl);
    free(raster);
}

/* ---- the mesh ------------------------------------------------------------------------------- */

static void put(float *to, struct csg_vec3 v)
{
    to[0] = (float)v.x;
    to[1] = (float)v.y;
    to[2] = (float)v.z;
}

/* Around the mesh's middle: floats hold it well there. */
static void fill_vertices(const struct csg_soup *soup, struct csg_vec3 center, float *to)
{
    for (size_t i = 0; i < soup->num_triangles; i++) {
        const struct csg_vec3 *p = soup->triangles[i].corner;
        const struct csg_vec3 normal =
            csg_normalize(csg_cross(csg_sub(p[1], p[0]), csg_sub(p[2], p[0])));
        for (int k = 0; k < 3; k++, to += 6) {
            put(to, csg_sub(p[k], center));
            put(to + 3, normal);
        }
    }
}

bool csg_raster_upload(struct csg_raster *raster, const struct csg_soup *soup,
                       struct csg_raster_mesh *mesh)
{
    const struct csg_gl *gl = raster->gl;
    const size_t size = soup->num_triangles * 18 * sizeof(float);
    float *vertices = malloc(size + 1);
    *mesh = (struct csg_raster_mesh){.num_triangles = soup->num_triangles};
    if (!vertices)
        return csg_log_memory(&raster->log);
    if (soup->num_triangles) {
        mesh->center = csg_box_middle(&soup->bounds);
        mesh->radius = 0.5 * csg_length(csg_sub(soup->bounds.hi, soup->bounds.lo));
    }
    fill_vertices(soup, mesh->center, vertices);
    bool ok = csg_gl_enter(raster->gl);
    if (ok) {
        gl->GenVertexArrays(1, &mesh->array);
        gl->BindVertexArray(mesh->array);
        gl->GenBuffers(1, &mesh->buffer);
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffer);
        gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, vertices, GL_STATIC_DRAW);
        for (GLuint i = 0; i < 2; i++) {
            gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 24,
                                    (const void *)(i * 3 * sizeof(float)));
            gl->EnableVertexAttribArray(i);
        }
        ok = csg_gl_leave(raster->gl);
    }
    free(vertices);
    return ok;
}

void csg_raster_delete(struct csg_raster *raster, struct csg_raster_mesh *mesh)
{
    if (mesh->array && csg_gl_enter(raster->gl)) {
        raster->gl->DeleteVertexArrays(1, &mesh->array);
        raster->gl->DeleteBuffers(1, &mesh->buffer);
        csg_gl_leave(raster->gl);
    }
    *mesh = (struct csg_raster_mesh){0};
}

/* ---- a frame -------------------------------------------------------------------------------- */

/* scale (v . (p - eye)) + shift, for p counted from the mesh's middle. */
static void set_row(const struct csg_raster *raster, const char *name, struct csg_vec3 v,
                    struct csg_vec3 from_eye, double scale, double shift)
{
    raster->gl->Uniform4f(raster->gl->GetUniformLocation(raster->program, name),
                          (float)(scale * v.x), (float)(scale * v.y), (float)(scale * v.z),
                          (float)(scale * csg_dot(v, from_eye) + shift));
}

static void set_camera(const struct csg_raster *raster, const struct csg_raster_mesh *mesh,
                       const struct csgcast_frustum *frustum)
{
    const struct csg_vec3 zero = {0, 0, 0}, forward = csg_vec3_of(frustum->forward);
    const struct csg_vec3 from_eye = csg_sub(mesh->center, csg_vec3_of(frustum->eye));
    const double middle = csg_dot(forward, from_eye), radius = 1.01 * mesh->radius;
    const double far = middle + radius;
    const double near =
        frustum->orthographic ? middle - radius : fmax(middle - radius, 1e-3 * mesh->radius);
    set_row(raster, "row_x", csg_vec3_of(frustum->right), from_eye, 1 / frustum->half_width, 0);
    set_row(raster, "row_y", csg_vec3_of(frustum->up), from_eye, 1 / frustum->half_height, 0);
    set_row(raster, "row_distance", forward, from_eye, 1, 0);
    if (frustum->orthographic) {
        set_row(raster, "row_w", zero, from_eye, 0, 1);
        set_row(raster, "row_z", forward, from_eye, 2 / (far - near), -(far + near) / (far - near));
    } else {
        set_row(raster, "row_w", forward, from_eye, 1, 0);
        set_row(raster, "row_z", forward, from_eye, (far + near) / (far - near),
                -2 * far * near / (far - near));
    }
}

/* GL counts rows from the bottom. */
static void copy_pixels(const struct csg_raster *raster, const struct csgcast_image *image)
{
    const size_t width = (size_t)raster->width;
    for (int row = 0; row < raster->height; row++) {
        const float *from = raster->pixels + 4 * width * (size_t)row;
        const size_t to = (size_t)(raster->height - 1 - row) * width;
        for (size_t x = 0; x < width; x++, from += 4) {
            image->z[to + x] = from[3];
            memcpy(image->normal + 3 * (to + x), from, 3 * sizeof *from);
        }
    }
}

bool csg_raster_draw(struct csg_raster *raster, const struct csg_raster_mesh *mesh,
                     const struct csgcast_frustum *frustum, int width, int height,
                     const struct csgcast_image *image)
{
    static const GLfloat nowhere[4] = {0, 0, 0, INFINITY}, far = 1;
    const struct csg_gl *gl = raster->gl;
    if (!csg_gl_enter(raster->gl))
        return false;
    const bool ok = make_targets(raster, width, height);
    if (ok) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, raster->framebuffer);
        gl->Viewport(0, 0, width, height);
        gl->ClearBufferfv(GL_COLOR, 0, nowhere);
        gl->ClearBufferfv(GL_DEPTH, 0, &far);
        gl->Enable(GL_DEPTH_TEST);
        gl->DepthFunc(GL_LESS);
        gl->UseProgram(raster->program);
        set_camera(raster, mesh, frustum);
        gl->BindVertexArray(mesh->array);
        gl->DrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * mesh->num_triangles));
        gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
        gl->ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, raster->pixels);
        copy_pixels(raster, image);
    }
    return csg_gl_leave(raster->gl) && ok;
}
