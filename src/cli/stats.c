/* SPDX-License-Identifier: MIT */
#include "stats.h"

#include <string.h>

/* The numbers of struct csgcast_stats, in the order in which they are printed. */
struct row {
    const char *key, *label;
    size_t offset;
    bool is_time; /* a double, in ms; else a size_t */
};

#define SIZE(key, label)                                                                           \
    {                                                                                              \
#key, label, offsetof(struct csgcast_stats, key), false                                    \
    }
#define TIME(key, label)                                                                           \
    {                                                                                              \
#key, label, offsetof(struct csgcast_stats, key), true                                     \
    }

static const struct row rows[] = {
    SIZE(texture_bytes, "texture bytes"),
    SIZE(bytes_uploaded, "bytes uploaded"),
    SIZE(programs, "programs"),
    TIME(compile_ms, "compile ms"),
    TIME(load_ms, "load ms"),
    TIME(csg_ms, "csg ms"),
    TIME(tile_ms, "tile ms"),
    TIME(pack_ms, "pack ms"),
    TIME(cpu_ms, "cpu ms"),
    TIME(upload_ms, "upload ms"),
    TIME(draw_ms, "draw ms"),
    TIME(read_ms, "read ms"),
    TIME(frame_ms, "frame ms"),
    SIZE(objects_drawn, "objects drawn"),
    SIZE(tiles_empty, "tiles, empty"),
    SIZE(tiles_opaque, "tiles, opaque"),
    SIZE(tiles_mixed, "tiles, mixed"),
    SIZE(proxy_pixels, "proxy pixels"),
    SIZE(hit_pixels, "hit pixels"),
    SIZE(solid_tests, "solid tests"),
    SIZE(precise_objects, "in double"),
    SIZE(overflowed_objects, "overflowed"),
    SIZE(unfinished_pixels, "cast on the CPU"),
};

#define NUM_ROWS (sizeof rows / sizeof *rows)

static const void *value_of(const struct csgcast_stats *stats, const struct row *row)
{
    return (const char *)stats + row->offset;
}

static double tests_per_pixel(const struct csgcast_stats *stats)
{
    return stats->proxy_pixels ? (double)stats->solid_tests / (double)stats->proxy_pixels : 0;
}

/* Toledo and Levy 2004, section 3: the share of the pixels that were drawn and show nothing.
 * What is hidden by something nearer counts as that, too. */
static double waste(size_t proxy_pixels, size_t hit_pixels)
{
    const double drawn = (double)proxy_pixels, shown = (double)hit_pixels;
    return drawn > shown ? (drawn - shown) / drawn : 0;
}

/* Their Table 1. */
static void print_waste(FILE *file, const struct csgcast_stats *stats)
{
    fprintf(file, "%-18s %.1f %% of the proxy pixels show nothing\n", "waste",
            100 * waste(stats->proxy_pixels, stats->hit_pixels));
    for (size_t i = 0; i < stats->num_single_kinds; i++) {
        const struct csgcast_kind_waste *kind = &stats->single_kinds[i];
        fprintf(file, "  %-16s %.1f %% of %zu, %zu drawn by themselves\n", kind->name,
                100 * waste(kind->proxy_pixels, kind->hit_pixels), kind->proxy_pixels, kind->num);
    }
}

static void print_waste_json(struct csg_json *json, const struct csgcast_stats *stats)
{
    csg_json_number(json, "waste", waste(stats->proxy_pixels, stats->hit_pixels));
    csg_json_list_open(json, "waste_by_kind");
    for (size_t i = 0; i < stats->num_single_kinds; i++) {
        const struct csgcast_kind_waste *kind = &stats->single_kinds[i];
        csg_json_open(json, NULL);
        csg_json_string(json, "kind", kind->name);
        csg_json_size(json, "solids", kind->num);
        csg_json_size(json, "proxy_pixels", kind->proxy_pixels);
        csg_json_size(json, "hit_pixels", kind->hit_pixels);
        csg_json_number(json, "waste", waste(kind->proxy_pixels, kind->hit_pixels));
        csg_json_close(json);
    }
    csg_json_list_close(json);
}

static bool is_known(const struct csgcast_stats *stats, const struct row *row)
{
    return stats->has_hit_pixels || row->offset != offsetof(struct csgcast_stats, hit_pixels);
}

void csg_cli_print_stats(FILE *file, const char *renderer, const struct csgcast_stats *stats)
{
    fprintf(file, "%-18s %s\n%-18s %s\n", "renderer", renderer, "variants", stats->variants);
    for (size_t i = 0; i < NUM_ROWS; i++) {
        const void *value = value_of(stats, &rows[i]);
        if (!is_known(stats, &rows[i]))
            fprintf(file, "%-18s not counted\n", rows[i].label);
        else if (rows[i].is_time)
            fprintf(file, "%-18s %.3f\n", rows[i].label, *(const double *)value);
        else
            fprintf(file, "%-18s %zu\n", rows[i].label, *(const size_t *)value);
    }
    fprintf(file, "%-18s %.3f\n", "tests a pixel", tests_per_pixel(stats));
    if (stats->has_hit_pixels)
        print_waste(file, stats);
}

void csg_cli_print_numerics(FILE *file, const struct csgcast_stats *stats)
{
    for (const char *line = stats->numerics; *line;) {
        const size_t length = strcspn(line, "\n");
        fprintf(file, "%-18s %.*s\n", line == stats->numerics ? "numerics" : "", (int)length, line);
        line += length + (line[length] != 0);
    }
    if (!stats->numerics[0])
        fprintf(file, "%-18s %s\n", "numerics", "float holds everything in this view");
}

void csg_cli_print_stats_json(struct csg_json *json, const struct csgcast_stats *stats)
{
    for (size_t i = 0; i < NUM_ROWS; i++) {
        const void *value = value_of(stats, &rows[i]);
        if (!is_known(stats, &rows[i]))
            continue;
        if (rows[i].is_time)
            csg_json_number(json, rows[i].key, *(const double *)value);
        else
            csg_json_size(json, rows[i].key, *(const size_t *)value);
    }
    csg_json_number(json, "tests_per_pixel", tests_per_pixel(stats));
    if (stats->has_hit_pixels)
        print_waste_json(json, stats);
}
