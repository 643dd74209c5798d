/* SPDX-License-Identifier: MIT */
/* replay FOLDER: hands each file of the corpus to the fuzz target, without the fuzzer. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static bool replay(const char *folder, const char *name)
{
    char path[4096];
    struct csg_bytes bytes;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!csg_file_read(path, &bytes, NULL))
        return false;
    LLVMFuzzerTestOneInput((const uint8_t *)bytes.data, bytes.num);
    free(bytes.data);
    return true;
}

int main(int argc, char **argv)
{
    size_t num = 0, num_failed = 0;
    DIR *directory = argc == 2 ? opendir(argv[1]) : NULL;
    if (!directory) {
        fprintf(stderr, "replay: needs the folder of the corpus\n");
        return 2;
    }
    for (const struct dirent *entry; (entry = readdir(directory));)
        if (entry->d_name[0] != '.') {
            num_failed += !replay(argv[1], entry->d_name);
            num++;
        }
    closedir(directory);
    printf("%zu files replayed, %zu could not be read\n", num, num_failed);
    return num == 0 || num_failed > 0;
}
