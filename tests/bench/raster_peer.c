/* SPDX-License-Identifier: MIT */

/*
 * What the same OpenGL does by rasterising meshes, and by a shader written by hand:
 *
 *     raster_peer spheres LIST    instances of a sphere of 16 x 8 facets, and of a cylinder of 16
 *     raster_peer mesh FILE.stl   a finished mesh, ASCII STL
 *     raster_peer five -          the scene five, all constants in the shader: the limit
 */

#include "peer.h"

#include "gl/context.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846
#define NEAR_SHARE 1e-2F /* of the distance to the centre: the near plane */

static const char shade_text[] =
    "uniform vec3 right, up, forward;\n"
    "vec4 shade(vec3 color, vec3 n) {\n"
    "  vec3 e = vec3(dot(n, normalize(right)), dot(n, normalize(up)), -dot(n, forward));\n"
    "  return vec4(color * (0.2 + 0.57735027 * abs(-e.x + e.y + e.z)), 1.0);\n"
    "}\n";

static const char mesh_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec4 place;\n" /* instance: offset and radius */
    "layout(location = 3) in vec3 axis;\n"  /* instance: of a cylinder, else 0 */
    "uniform vec3 eye, right, up, forward;\n"
    "uniform float near;\n"
    "out vec3 world_normal;\n"
    "void main() {\n"
    "  vec3 p = place.w * position, n = normal;\n"
    "  if (dot(axis, axis) > 0.0) {\n"
    "    vec3 w = normalize(axis);\n"
    "    vec3 u = normalize(abs(w.x) < 0.9 ? vec3(0, -w.z, w.y) : vec3(w.z, 0, -w.x));\n"
    "    vec3 v = cross(w, u);\n"
    "    p = place.w * (position.x * u + position.y * v) + position.z * axis;\n"
    "    n = normal.x * u + normal.y * v + normal.z * w;\n"
    "  }\n"
    "  vec3 d = p + place.xyz - eye;\n"
    "  float z = dot(d, forward);\n"
    "  gl_Position = vec4(dot(d, right) / dot(right, right), dot(d, up) / dot(up, up),\n"
    "                     z - 2.0 * near, z);\n"
    "  world_normal = n;\n"
    "}\n";

static const char mesh_fragment[] = "in vec3 world_normal;\n"
                                    "out vec4 color;\n"
                                    "void main() {\n"
                                    "  color = shade(vec3(249, 215, 44) / 255.0,\n"
                                    "                normalize(world_normal));\n"
                                    "}\n";

static const char five_vertex[] =
    "#version 330 core\n"
    "uniform vec3 right, up, forward;\n"
    "out vec3 ray;\n"
    "void main() {\n"
    "  vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "  gl_Position = vec4(p, 0, 1);\n"
    "  ray = forward + p.x * right + p.y * up;\n"
    "}\n";

/* Interval jumping by hand: from the cube's entry past the intervals of what is taken away, until
 * none covers the point. Four passes are enough for four convex solids. */
static const char five_fragment[] =
    "in vec3 ray;\n"
    "uniform vec3 eye;\n"
    "out vec4 color;\n"
    "vec2 span(float a, float b, float c) {\n" /* of a t^2 + 2 b t + c <= 0 */
    "  float h = b * b - a * c;\n"
    "  float s = sqrt(max(h, 0.0));\n"
    "  return h > 0.0 ? vec2(-b - s, -b + s) / a : vec2(1e30, -1e30);\n"
    "}\n"
    "void main() {\n"
    "  vec3 lo = (-10.0 - eye) / ray, hi = (10.0 - eye) / ray;\n"
    "  vec3 near = min(lo, hi), far = max(lo, hi);\n"
    "  float t = max(near.x, max(near.y, near.z)), end = min(far.x, min(far.y, far.z));\n"
    "  if (!(t < end)) discard;\n"
    "  float start = t;\n"
    "  vec3 dd = ray * ray, de = ray * eye, ee = eye * eye;\n"
    "  vec2 s[4];\n"
    "  s[0] = span(dd.x + dd.y + dd.z, de.x + de.y + de.z, ee.x + ee.y + ee.z - 169.0);\n"
    "  s[1] = span(dd.x + dd.y, de.x + de.y, ee.x + ee.y - 36.0);\n"
    "  s[2] = span(dd.x + dd.z, de.x + de.z, ee.x + ee.z - 36.0);\n"
    "  s[3] = span(dd.y + dd.z, de.y + de.z, ee.y + ee.z - 36.0);\n"
    "  int face = -1;\n"
    "  for (int pass = 0; pass < 4; pass++)\n"
    "    for (int i = 0; i < 4; i++)\n"
    "      if (s[i].x <= t && s[i].y > t) { t = s[i].y; face = i; }\n"
    "  if (!(t < end)) discard;\n"
    "  vec3 p = eye + t * ray, n = p;\n"
    "  if (face < 0)\n"
    "    n = start == near.x ? vec3(1, 0, 0) : start == near.y ? vec3(0, 1, 0) : vec3(0, 0, 1);\n"
    "  else if (face > 0)\n"
    "    n *= face == 1 ? vec3(1, 1, 0) : face == 2 ? vec3(1, 0, 1) : vec3(0, 1, 1);\n"
    "  color = shade(face < 0 ? vec3(249, 215, 44) / 255.0 : vec3(157, 203, 81) / 255.0,\n"
    "                normalize(n));\n"
    "}\n";

struct vertex {
    float position[3], normal[3];
};

struct instance {
    float place[4], axis[3];
};

struct part {
    GLuint array;
    GLsizei num_vertices, num_instances;
};

struct state {
    const struct peer *peer;
    struct csg_gl *gl;
    GLuint program;
    struct part parts[2];
    int num_parts;
};

/* ---- OpenGL --------------------------------------------------------------------------------- */

static GLuint compile(struct csg_gl *gl, GLenum stage, const char *const *texts, int num)
{
    char log[1024];
    GLint ok;
    const GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, num, texts, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "%s\n", log);
    }
    return shader;
}

static bool make_program(struct state *state, const char *vertex, const char *fragment)
{
    struct csg_gl *gl = state->gl;
    const char *const texts[] = {"#version 330 core\n", shade_text, fragment};
    GLint ok;
    state->program = gl->CreateProgram();
    gl->AttachShader(state->program, compile(gl, GL_VERTEX_SHADER, &vertex, 1));
    gl->AttachShader(state->program, compile(gl, GL_FRAGMENT_SHADER, texts, 3));
    gl->LinkProgram(state->program);
    gl->GetProgramiv(state->program, GL_LINK_STATUS, &ok);
    return ok;
}

static void make_target(struct state *state)
{
    struct csg_gl *gl = state->gl;
    GLuint buffers[2], framebuffer;
    gl->GenRenderbuffers(2, buffers);
    gl->BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, state->peer->width, state->peer->height);
    gl->BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, state->peer->width,
                            state->peer->height);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    gl->Viewport(0, 0, state->peer->width, state->peer->height);
}

static void set_attribute(struct csg_gl *gl, GLuint index, GLint size, size_t stride, size_t offset,
                          GLuint divisor)
{
    gl->VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void *)offset);
    gl->EnableVertexAttribArray(index);
    gl->VertexAttribDivisor(index, divisor);
}

static void add_part(struct state *state, const struct vertex *vertices, size_t num_vertices,
                     const struct instance *instances, size_t num_instances)
{
    struct csg_gl *gl = state->gl;
    struct part *part = &state->parts[state->num_parts++];
    GLuint buffers[2];
    part->num_vertices = (GLsizei)num_vertices;
    part->num_instances = (GLsizei)num_instances;
    gl->GenVertexArrays(1, &part->array);
    gl->BindVertexArray(part->array);
    gl->GenBuffers(2, buffers);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(num_vertices * sizeof *vertices), vertices,
                   GL_STATIC_DRAW);
    set_attribute(gl, 0, 3, sizeof *vertices, 0, 0);
    set_attribute(gl, 1, 3, sizeof *vertices, offsetof(struct vertex, normal), 0);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(num_instances * sizeof *instances), instances,
                   GL_STATIC_DRAW);
    set_attribute(gl, 2, 4, sizeof *instances, 0, 1);
    set_attribute(gl, 3, 3, sizeof *instances, offsetof(struct instance, axis), 1);
}

static bool draw(void *user, const struct peer_camera *camera, unsigned char *rgba)
{
    static const float background[4] = {1, 1, 229 / 255.F, 1}, far = 1;
    struct state *state = user;
    struct csg_gl *gl = state->gl;
    float distance = 0;
    for (int i = 0; i < 3; i++)
        distance += powf(camera->eye[i] - (float)state->peer->center[i], 2);
    gl->UseProgram(state->program);
    gl->Uniform3fv(gl->GetUniformLocation(state->program, "eye"), 1, camera->eye);
    gl->Uniform3fv(gl->GetUniformLocation(state->program, "right"), 1, camera->right);
    gl->Uniform3fv(gl->GetUniformLocation(state->program, "up"), 1, camera->up);
    gl->Uniform3fv(gl->GetUniformLocation(state->program, "forward"), 1, camera->forward);
    gl->Uniform1f(gl->GetUniformLocation(state->program, "near"), NEAR_SHARE * sqrtf(distance));
    gl->ClearBufferfv(GL_COLOR, 0, background);
    gl->ClearBufferfv(GL_DEPTH, 0, &far);
    for (int i = 0; i < state->num_parts; i++) {
        gl->BindVertexArray(state->parts[i].array);
        gl->DrawArraysInstanced(GL_TRIANGLES, 0, state->parts[i].num_vertices,
                                state->parts[i].num_instances);
    }
    gl->ReadPixels(0, 0, state->peer->width, state->peer->height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return gl->GetError() == GL_NO_ERROR;
}

/* ---- what is drawn -------------------------------------------------------------------------- */

static size_t add_triangle(struct vertex *to, size_t num, const struct vertex corners[3])
{
    memcpy(to + num, corners, 3 * sizeof *corners);
    return num + 3;
}

static struct vertex on_sphere(int i, int j)
{
    const float a = (float)(2 * PI * i / 16), b = (float)(PI * j / 8);
    struct vertex v = {{sinf(b) * cosf(a), sinf(b) * sinf(a), cosf(b)}, {0}};
    memcpy(v.normal, v.position, sizeof v.normal);
    return v;
}

static size_t make_sphere(struct vertex *to)
{
    size_t num = 0;
    for (int i = 0; i < 16; i++)
        for (int j = 0; j < 8; j++) {
            const struct vertex a = on_sphere(i, j), b = on_sphere(i, j + 1),
                                c = on_sphere(i + 1, j + 1), d = on_sphere(i + 1, j);
            if (j < 7)
                num = add_triangle(to, num, (struct vertex[3]){a, b, c});
            if (j > 0)
                num = add_triangle(to, num, (struct vertex[3]){a, c, d});
        }
    return num;
}

static struct vertex on_cylinder(int i, float z)
{
    const float a = (float)(2 * PI * i / 16);
    return (struct vertex){{cosf(a), sinf(a), z}, {cosf(a), sinf(a), 0}};
}

/* Without caps: they are inside of spheres. */
static size_t make_cylinder(struct vertex *to)
{
    size_t num = 0;
    for (int i = 0; i < 16; i++) {
        const struct vertex a = on_cylinder(i, 0), b = on_cylinder(i + 1, 0),
                            c = on_cylinder(i + 1, 1), d = on_cylinder(i, 1);
        num = add_triangle(to, num, (struct vertex[3]){a, b, c});
        num = add_triangle(to, num, (struct vertex[3]){a, c, d});
    }
    return num;
}

static bool load_spheres(struct state *state)
{
    static struct vertex vertices[16 * 8 * 6];
    struct peer_solids solids;
    if (!peer_read_solids(state->peer, &solids))
        return false;
    struct instance *instances = calloc(solids.num, sizeof *instances);
    for (size_t i = 0; i < solids.num && instances; i++) {
        const struct peer_solid *s = &solids.data[i];
        memcpy(instances[i].place, s->a, sizeof s->a);
        instances[i].place[3] = s->r;
        for (int j = 0; j < 3 && i >= solids.num_spheres; j++)
            instances[i].axis[j] = s->b[j] - s->a[j];
    }
    if (instances) {
        add_part(state, vertices, make_sphere(vertices), instances, solids.num_spheres);
        if (solids.num > solids.num_spheres)
            add_part(state, vertices, make_cylinder(vertices), instances + solids.num_spheres,
                     solids.num - solids.num_spheres);
    }
    free(solids.data);
    free(instances);
    return instances != NULL;
}

static size_t read_stl(FILE *file, struct vertex **vertices)
{
    char line[256];
    struct vertex v = {{0}, {0}};
    size_t num = 0, capacity = 0;
    while (fgets(line, sizeof line, file)) {
        sscanf(line, " facet normal %f %f %f", &v.normal[0], &v.normal[1], &v.normal[2]);
        if (sscanf(line, " vertex %f %f %f", &v.position[0], &v.position[1], &v.position[2]) != 3)
            continue;
        if (num == capacity) {
            capacity = 2 * capacity + 1024;
            struct vertex *data = realloc(*vertices, capacity * sizeof *data);
            if (!data)
                return 0;
            *vertices = data;
        }
        (*vertices)[num++] = v;
    }
    return num;
}

static bool load_mesh(struct state *state)
{
    static const struct instance one = {{0, 0, 0, 1}, {0, 0, 0}};
    struct vertex *vertices = NULL;
    FILE *file = fopen(state->peer->input, "r");
    if (!file)
        return perror(state->peer->input), false;
    const size_t num = read_stl(file, &vertices);
    fclose(file);
    if (num)
        add_part(state, vertices, num, &one, 1);
    free(vertices);
    return num > 0;
}

static bool load_five(struct state *state)
{
    static const struct vertex vertices[3];
    static const struct instance one;
    add_part(state, vertices, 3, &one, 1);
    return true;
}

static bool load(struct state *state)
{
    const char *mode = state->peer->mode;
    if (!strcmp(mode, "five"))
        return make_program(state, five_vertex, five_fragment) && load_five(state);
    state->gl->Enable(GL_DEPTH_TEST);
    return make_program(state, mesh_vertex, mesh_fragment) &&
           (!strcmp(mode, "spheres") ? load_spheres(state) : load_mesh(state));
}

int main(int argc, char **argv)
{
    struct peer peer;
    if (!peer_parse(&peer, argc, argv))
        return 1;
    struct state state = {.peer = &peer, .gl = csg_gl_create(CSGCAST_BACKEND_EGL, NULL)};
    if (!state.gl || !csg_gl_enter(state.gl))
        return 1;
    make_target(&state);
    const bool good = load(&state) && peer_run(&peer, draw, &state, true);
    csg_gl_leave(state.gl);
    csg_gl_destroy(state.gl);
    return !good;
}
