/* SPDX-License-Identifier: MIT */
/*
 * csgcast-xml.so: elements of XML files, plain or in ZIP archives, with libxml2's reader. Entities
 * in texts are not replaced: those that name other files would be read, and texts that need it are
 * rare. Attributes cannot have such ones; libxml2 limits how much others may grow.
 */
#include "xml/module.h"

#include <libxml/xmlreader.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

struct input {
    const char *at, *end; /* of plain text */
    zip_t *archive;
    zip_file_t *entry; /* NULL: plain text */
};

struct reader {
    xmlTextReaderPtr xml;
    const struct csg_xml_sink *sink;
    struct csg_xml_error *error;
    struct csg_xml_attribute *attributes;
    size_t capacity; /* of attributes */
    enum csg_xml_result result;
};

/* ---- input ---------------------------------------------------------------------------------- */

static int read_input(void *context, char *buffer, int length)
{
    struct input *input = context;
    if (input->entry)
        return (int)zip_fread(input->entry, buffer, (zip_uint64_t)length);
    const size_t left = (size_t)(input->end - input->at);
    const size_t size = left < (size_t)length ? left : (size_t)length;
    memcpy(buffer, input->at, size);
    input->at += size;
    return (int)size;
}

static zip_t *open_archive(const char *data, size_t size)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *source = zip_source_buffer_create(data, size, 0, &error);
    zip_t *archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
    if (source && !archive)
        zip_source_free(source);
    zip_error_fini(&error);
    return archive;
}

/* Not a ZIP archive: plain text. false: an archive without the entry. */
static bool open_input(struct input *input, const char *data, size_t size, const char *archived)
{
    *input = (struct input){.at = data, .end = data + size};
    input->archive = archived ? open_archive(data, size) : NULL;
    if (!input->archive)
        return true;
    input->entry = zip_fopen(input->archive, archived, ZIP_FL_NODIR);
    if (!input->entry && zip_get_num_entries(input->archive, 0) == 1)
        input->entry = zip_fopen_index(input->archive, 0, 0);
    return input->entry != NULL;
}

static void close_input(struct input *input)
{
    if (input->entry)
        zip_fclose(input->entry);
    if (input->archive)
        zip_discard(input->archive);
}

/* ---- elements ------------------------------------------------------------------------------- */

/* libxml2's types: what is const in 2.12 was not before, so the call is made through a cast. */
static void take_error(void *user, xmlErrorPtr error)
{
    struct reader *reader = user;
    if (reader->error->text[0] || error->level < XML_ERR_ERROR || !error->message)
        return;
    reader->error->line = error->line > 0 ? (size_t)error->line : 0;
    snprintf(reader->error->text, sizeof reader->error->text, "%.*s",
             (int)strcspn(error->message, "\n"), error->message);
}

static bool add_attribute(struct reader *reader, size_t *num)
{
    if (*num == reader->capacity) {
        const size_t capacity = 2 * *num + 16;
        void *bigger = realloc(reader->attributes, capacity * sizeof *reader->attributes);
        if (!bigger)
            return false;
        reader->attributes = bigger;
        reader->capacity = capacity;
    }
    const char *name = (const char *)xmlTextReaderConstName(reader->xml);
    char *value = (char *)xmlTextReaderValue(reader->xml);
    reader->attributes[*num] = (struct csg_xml_attribute){name, value};
    *num += value != NULL;
    return name && value;
}

static void free_values(struct reader *reader, size_t num)
{
    for (size_t i = 0; i < num; i++)
        xmlFree((void *)(uintptr_t)reader->attributes[i].value);
}

static enum csg_xml_result begin(struct reader *reader)
{
    const char *name = (const char *)xmlTextReaderConstName(reader->xml);
    const bool is_empty = xmlTextReaderIsEmptyElement(reader->xml) == 1;
    size_t num = 0;
    bool ok = name != NULL, done = false;
    while (ok && xmlTextReaderMoveToNextAttribute(reader->xml) == 1)
        ok = add_attribute(reader, &num);
    if (ok)
        done = reader->sink->begin(reader->sink->user, name, reader->attributes, num, is_empty);
    free_values(reader, num);
    return !ok ? CSG_XML_NO_MEMORY : done ? CSG_XML_DONE : CSG_XML_ENDED;
}

static void note_line(const struct reader *reader)
{
    const int line = xmlTextReaderGetParserLineNumber(reader->xml);
    reader->error->line = line > 0 ? (size_t)line : 0;
}

static enum csg_xml_result refuse_entity(const struct reader *reader)
{
    note_line(reader);
    snprintf(reader->error->text, sizeof reader->error->text, "the entity '%.40s'",
             (const char *)xmlTextReaderConstName(reader->xml));
    return CSG_XML_ENTITY;
}

static enum csg_xml_result take(struct reader *reader)
{
    const struct csg_xml_sink *sink = reader->sink;
    switch (xmlTextReaderNodeType(reader->xml)) {
    case XML_READER_TYPE_ELEMENT:
        return begin(reader);
    case XML_READER_TYPE_END_ELEMENT:
        return sink->end(sink->user, (const char *)xmlTextReaderConstName(reader->xml))
                   ? CSG_XML_DONE
                   : CSG_XML_ENDED;
    case XML_READER_TYPE_TEXT:
        return !sink->text ||
                       sink->text(sink->user, (const char *)xmlTextReaderConstValue(reader->xml))
                   ? CSG_XML_DONE
                   : CSG_XML_ENDED;
    case XML_READER_TYPE_ENTITY_REFERENCE:
        return refuse_entity(reader);
    default:
        return CSG_XML_DONE;
    }
}

static enum csg_xml_result read_elements(struct reader *reader)
{
    enum csg_xml_result result = CSG_XML_DONE;
    int more = xmlTextReaderRead(reader->xml);
    while (more == 1) {
        result = take(reader);
        if (result == CSG_XML_ENDED)
            note_line(reader);
        if (result != CSG_XML_DONE)
            return result;
        more = xmlTextReaderRead(reader->xml);
    }
    return more == 0 ? CSG_XML_DONE : CSG_XML_MALFORMED;
}

static enum csg_xml_result read_input_with(const struct csg_xml_sink *sink, struct input *input,
                                           struct csg_xml_error *error)
{
    const int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
    struct reader reader = {.sink = sink, .error = error};
    reader.xml = xmlReaderForIO(read_input, NULL, input, NULL, NULL, options);
    if (!reader.xml)
        return CSG_XML_NO_MEMORY;
    xmlTextReaderSetStructuredErrorHandler(reader.xml, (xmlStructuredErrorFunc)take_error, &reader);
    const enum csg_xml_result result = read_elements(&reader);
    xmlFreeTextReader(reader.xml);
    free(reader.attributes);
    return result;
}

static enum csg_xml_result read_file(const char *data, size_t size, const char *archived,
                                     const struct csg_xml_sink *sink, struct csg_xml_error *error)
{
    struct input input;
    enum csg_xml_result result = CSG_XML_MALFORMED;
    *error = (struct csg_xml_error){0};
    if (open_input(&input, data, size, archived))
        result = read_input_with(sink, &input, error);
    else
        snprintf(error->text, sizeof error->text, "a ZIP archive without an entry of that name");
    close_input(&input);
    return result;
}

extern const struct csg_xml_module CSG_XML_MODULE;
__attribute__((visibility("default"))) const struct csg_xml_module CSG_XML_MODULE = {read_file};
