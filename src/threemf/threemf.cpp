/* SPDX-License-Identifier: MIT */
/*
 * csgcast-3mf.so: the mesh objects of 3MF files. As OpenSCAD 2021.01 (import_3mf.cc) it takes each
 * object as it is: what the build says of them, components and units do not count.
 */
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <vector>

#include <Model/COM/NMR_DLLInterfaces.h>

#include "threemf/module.h"

namespace
{

using NMR::PLib3MFBase;

struct releaser {
    void operator()(PLib3MFBase *object) const
    {
        NMR::lib3mf_release(object);
    }
};

using handle = std::unique_ptr<PLib3MFBase, releaser>;

bool is_done(HRESULT result)
{
    return result == LIB3MF_OK;
}

void explain(PLib3MFBase *object, char *error, size_t size)
{
    DWORD code = 0;
    LPCSTR text = nullptr;
    if (object && is_done(NMR::lib3mf_getlasterror(object, &code, &text)) && text && *text)
        std::snprintf(error, size, "%s", text);
    else
        std::snprintf(error, size, "no 3MF file");
}

handle make_model()
{
    NMR::PLib3MFModel *model = nullptr;
    return handle(is_done(NMR::lib3mf_createmodel(&model)) ? model : nullptr);
}

/* Processor time after which a file is given up: lib3mf looks parts up one by one, which takes
 * minutes for files of a few hundred kilobytes that are made for it. */
constexpr double max_seconds = 30;

/* lib3mf asks now and then whether it may go on. */
bool has_time(int, NMR::ProgressIdentifier, void *start)
{
    return static_cast<double>(std::clock() - *static_cast<std::clock_t *>(start)) <
           max_seconds * CLOCKS_PER_SEC;
}

bool fill_model(PLib3MFBase *model, const char *data, size_t num, char *error, size_t size)
{
    NMR::PLib3MFModelReader *made = nullptr;
    const handle reader(is_done(NMR::lib3mf_model_queryreader(model, "3mf", &made)) ? made
                                                                                    : nullptr);
    std::clock_t start = std::clock();
    if (reader)
        NMR::lib3mf_reader_setprogresscallback(made, has_time, &start);
    /* lib3mf does not write to the buffer. */
    BYTE *bytes = reinterpret_cast<BYTE *>(const_cast<char *>(data));
    const bool ok = reader && is_done(NMR::lib3mf_reader_readfrombuffer(reader.get(), bytes, num));
    if (!ok && !has_time(0, {}, &start))
        std::snprintf(error, size, "it takes more than %g s to read", max_seconds);
    else if (!ok)
        explain(reader.get(), error, size);
    return ok;
}

bool hand_over(const std::vector<NMR::MODELMESHVERTEX> &points,
               const std::vector<NMR::MODELMESHTRIANGLE> &triangles, const csg_3mf_sink &sink)
{
    bool ok = sink.begin_mesh(sink.user);
    for (size_t i = 0; i < points.size() && ok; i++)
        ok = sink.add_point(sink.user, points[i].m_fPosition[0], points[i].m_fPosition[1],
                            points[i].m_fPosition[2]);
    for (size_t i = 0; i < triangles.size() && ok; i++) {
        const uint32_t corners[3] = {triangles[i].m_nIndices[0], triangles[i].m_nIndices[1],
                                     triangles[i].m_nIndices[2]};
        ok = sink.add_triangle(sink.user, corners);
    }
    return ok;
}

csg_3mf_result read_mesh(PLib3MFBase *object, const csg_3mf_sink &sink)
{
    DWORD num_points = 0, num_triangles = 0, taken = 0;
    if (!is_done(NMR::lib3mf_meshobject_getvertexcount(object, &num_points)) ||
        !is_done(NMR::lib3mf_meshobject_gettrianglecount(object, &num_triangles)))
        return CSG_3MF_MALFORMED;
    std::vector<NMR::MODELMESHVERTEX> points(num_points);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(num_triangles);
    if ((num_points &&
         !is_done(NMR::lib3mf_meshobject_getvertices(object, points.data(), num_points, &taken))) ||
        (num_triangles && !is_done(NMR::lib3mf_meshobject_gettriangleindices(
                              object, triangles.data(), num_triangles, &taken))))
        return CSG_3MF_MALFORMED;
    return hand_over(points, triangles, sink) ? CSG_3MF_DONE : CSG_3MF_ENDED;
}

csg_3mf_result read_meshes(PLib3MFBase *model, const csg_3mf_sink &sink)
{
    NMR::PLib3MFModelResourceIterator *made = nullptr;
    const handle iterator(is_done(NMR::lib3mf_model_getmeshobjects(model, &made)) ? made : nullptr);
    csg_3mf_result result = iterator ? CSG_3MF_DONE : CSG_3MF_MALFORMED;
    while (result == CSG_3MF_DONE) {
        BOOL has_next = 0;
        NMR::PLib3MFModelResource *resource = nullptr;
        if (!is_done(NMR::lib3mf_resourceiterator_movenext(iterator.get(), &has_next)))
            return CSG_3MF_MALFORMED;
        if (!has_next)
            break;
        if (!is_done(NMR::lib3mf_resourceiterator_getcurrent(iterator.get(), &resource)))
            return CSG_3MF_MALFORMED;
        const handle object(resource);
        result = read_mesh(object.get(), sink);
    }
    return result;
}

csg_3mf_result read(const char *data, size_t num, const csg_3mf_sink *sink, char *error,
                    size_t size)
{
    try {
        const handle model = make_model();
        if (!model)
            return CSG_3MF_ENDED;
        if (!fill_model(model.get(), data, num, error, size))
            return CSG_3MF_MALFORMED;
        return read_meshes(model.get(), *sink);
    } catch (const std::exception &) {
        return CSG_3MF_ENDED;
    }
}

} // namespace

extern "C" {
extern __attribute__((visibility("default"))) const csg_3mf_module CSG_3MF_MODULE;
const csg_3mf_module CSG_3MF_MODULE = {read};
}
