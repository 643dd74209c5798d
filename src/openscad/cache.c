/* SPDX-License-Identifier: MIT */
#include "openscad/cache.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "common/destination.h"
#include "common/hash.h"
#include "common/join.h"

/* 256 MiB: some thousand subtrees of real files. */
static const uint64_t default_limit = (uint64_t)256 << 20;

/* Temporary files older than that, in seconds, are what a killed process has left. */
enum { abandoned_after = 3600 };

#define ENTRY_ENDING ".csgcast"
#define ENTRY_NAME_LENGTH (16 + sizeof ENTRY_ENDING - 1)

/* Stands at the begin of an entry. Another version of its layout gets another magic. */
struct header {
    char magic[8];
    uint64_t key_size, value_size;
    uint64_t checksum; /* of key and value */
};

static const char magic[8] = "csgcast1";

/* ---- where it is -------------------------------------------------------------------------- */

static bool is_absolute(const char *path)
{
    return path && path[0] == '/';
}

/* The XDG base directory specification: a path that is not absolute is to be ignored. */
static char *default_folder(void)
{
    const char *named = getenv("CSGCAST_CACHE"), *xdg = getenv("XDG_CACHE_HOME");
    const char *home = getenv("HOME");
    if (named)
        return named[0] ? csg_join(named, "") : NULL;
    if (is_absolute(xdg))
        return csg_join(xdg, "/csgcast");
    return is_absolute(home) ? csg_join(home, "/.cache/csgcast") : NULL;
}

/* $CSGCAST_CACHE_SIZE, in MiB. */
static uint64_t limit_of_environment(void)
{
    const char *text = getenv("CSGCAST_CACHE_SIZE");
    char *end = NULL;
    const double number = text ? strtod(text, &end) : -1;
    const bool is_number = text && end != text && *end == '\0' && number >= 0 && number < 1e12;
    return is_number ? (uint64_t)(number * (1 << 20)) : default_limit;
}

void csg_cache_init(struct csg_cache *cache, const char *folder, uint64_t limit)
{
    cache->folder = !folder ? default_folder() : folder[0] ? csg_join(folder, "") : NULL;
    cache->limit = limit > 0 ? limit : limit_of_environment();
}

void csg_cache_finish(struct csg_cache *cache)
{
    free(cache->folder);
    cache->folder = NULL;
}

/* mkdir -p; only for its owner, as the specification wants it. */
static bool make_folder(const struct csg_cache *cache)
{
    char *path = csg_join(cache->folder, "");
    if (!path)
        return false;
    for (char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        mkdir(path, 0700);
        *slash = '/';
    }
    const bool done = mkdir(path, 0700) == 0 || errno == EEXIST;
    free(path);
    return done;
}

/* ---- entries ------------------------------------------------------------------------------ */

/* false: the name is too long. */
static bool entry_path(const struct csg_cache *cache, const struct csg_bytes *key,
                       char path[PATH_MAX])
{
    const uint64_t hash = csg_hash(CSG_HASH_START, key->data, key->num);
    const int length = snprintf(path, PATH_MAX, "%s/%016" PRIx64 ENTRY_ENDING, cache->folder, hash);
    return length > 0 && length < PATH_MAX;
}

static struct header make_header(const struct csg_bytes *key, const struct csg_bytes *value)
{
    struct header header = {.key_size = key->num, .value_size = value->num};
    const uint64_t hash = csg_hash(CSG_HASH_START, key->data, key->num);
    memcpy(header.magic, magic, sizeof magic);
    header.checksum = csg_hash(hash, value->data, value->num);
    return header;
}

/* Cuts the value out of an entry; false where anything about it is not as it was written. */
static bool take_value(const struct csg_bytes *key, struct csg_bytes *entry)
{
    struct header header;
    if (entry->num < sizeof header)
        return false;
    memcpy(&header, entry->data, sizeof header);
    const size_t rest = entry->num - sizeof header;
    if (header.key_size != key->num || rest < key->num || header.value_size != rest - key->num)
        return false;
    const char *data = entry->data + sizeof header;
    const struct csg_bytes value = {.data = entry->data + sizeof header + key->num,
                                    .num = rest - key->num};
    const struct header expected = make_header(key, &value);
    if (memcmp(data, key->data, key->num) != 0 || memcmp(&header, &expected, sizeof header) != 0)
        return false;
    memmove(entry->data, value.data, value.num);
    entry->num = value.num;
    return true;
}

bool csg_cache_get(const struct csg_cache *cache, const struct csg_bytes *key,
                   struct csg_bytes *value)
{
    char path[PATH_MAX];
    *value = (struct csg_bytes){0};
    if (!cache->folder || !entry_path(cache, key, path) ||
        !csg_file_read(path, value, &csg_log_silent))
        return false;
    if (!take_value(key, value)) {
        free(value->data);
        *value = (struct csg_bytes){0};
        return false;
    }
    utimensat(AT_FDCWD, path, NULL, 0); /* used just now */
    return true;
}

/* ---- what is there ------------------------------------------------------------------------ */

struct entry {
    char name[ENTRY_NAME_LENGTH + 1];
    uint64_t size;
    struct timespec used;
};

struct entries {
    CSG_ARRAY(struct entry) list;
    uint64_t size; /* of all */
};

static bool is_entry_name(const char *name)
{
    return strlen(name) == ENTRY_NAME_LENGTH && strspn(name, "0123456789abcdef") == 16 &&
           strcmp(name + 16, ENTRY_ENDING) == 0;
}

/* Looks at every file of ours; removes temporary ones that nobody will finish. */
static bool list_entries(int folder, DIR *stream, struct entries *entries)
{
    const time_t now = time(NULL);
    for (struct dirent *item = readdir(stream); item; item = readdir(stream)) {
        struct stat status;
        if (fstatat(folder, item->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0 ||
            !S_ISREG(status.st_mode))
            continue;
        if (!is_entry_name(item->d_name)) {
            if (strncmp(item->d_name, ".csgcast-", 9) == 0 &&
                now - status.st_mtime > abandoned_after)
                unlinkat(folder, item->d_name, 0);
            continue;
        }
        struct entry entry = {.size = (uint64_t)status.st_size, .used = status.st_mtim};
        strcpy(entry.name, item->d_name);
        entries->size += entry.size;
        if (!csg_array_push(&entries->list, entry))
            return false;
    }
    return true;
}

static int compare_use(const void *left, const void *right)
{
    const struct entry *a = left, *b = right;
    if (a->used.tv_sec != b->used.tv_sec)
        return a->used.tv_sec < b->used.tv_sec ? -1 : 1;
    return (a->used.tv_nsec > b->used.tv_nsec) - (a->used.tv_nsec < b->used.tv_nsec);
}

/* Removes the entries used longest ago until the others are within the limit. Says what is left. */
static bool trim(const struct csg_cache *cache, uint64_t limit, struct csgcast_cache_info *info)
{
    struct entries entries = {0};
    bool done = true;
    DIR *stream = cache->folder ? opendir(cache->folder) : NULL;
    if (!stream)
        return false;
    const int folder = dirfd(stream);
    if (list_entries(folder, stream, &entries) && entries.list.num)
        qsort(entries.list.data, entries.list.num, sizeof *entries.list.data, compare_use);
    size_t num = entries.list.num;
    for (size_t i = 0; i < entries.list.num && entries.size > limit; i++) {
        const bool is_gone = unlinkat(folder, entries.list.data[i].name, 0) == 0 || errno == ENOENT;
        entries.size -= is_gone ? entries.list.data[i].size : 0;
        num -= is_gone;
        done = done && is_gone;
    }
    if (info) {
        info->num_entries = num;
        info->size = entries.size;
    }
    free(entries.list.data);
    closedir(stream);
    return done;
}

static bool write_all(FILE *file, const void *data, size_t size)
{
    return size == 0 || fwrite(data, 1, size, file) == size;
}

static bool write_entry(const char *path, const struct csg_bytes *key,
                        const struct csg_bytes *value)
{
    const struct header header = make_header(key, value);
    FILE *file = fopen(path, "wb");
    if (!file)
        return false;
    const bool done = write_all(file, &header, sizeof header) &&
                      write_all(file, key->data, key->num) &&
                      write_all(file, value->data, value->num);
    return fclose(file) == 0 && done;
}

void csg_cache_put(const struct csg_cache *cache, const struct csg_bytes *key,
                   const struct csg_bytes *value)
{
    char path[PATH_MAX];
    struct csg_destination to = {.path = path, .log = &csg_log_silent};
    const uint64_t size = sizeof(struct header) + key->num + value->num;
    if (!cache->folder || size > cache->limit || !entry_path(cache, key, path) ||
        !make_folder(cache))
        return;
    if (csg_destination_open(&to, "csgcast") && write_entry(to.temporary, key, value) &&
        csg_destination_commit(&to))
        trim(cache, cache->limit, NULL);
    csg_destination_close(&to);
}

/* ---- for the tool ------------------------------------------------------------------------- */

bool csgcast_cache_get_info(const char *directory, struct csgcast_cache_info *info)
{
    struct csg_cache cache;
    csg_cache_init(&cache, directory, 0);
    *info = (struct csgcast_cache_info){.limit = cache.limit};
    snprintf(info->path, sizeof info->path, "%s", cache.folder ? cache.folder : "");
    const bool exists = trim(&cache, UINT64_MAX, info);
    csg_cache_finish(&cache);
    return exists;
}

bool csgcast_cache_clear(const char *directory)
{
    struct csg_cache cache;
    csg_cache_init(&cache, directory, 0);
    const bool is_there = cache.folder && access(cache.folder, F_OK) == 0;
    const bool done = trim(&cache, 0, NULL);
    csg_cache_finish(&cache);
    return !is_there || done;
}
