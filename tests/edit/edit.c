/* SPDX-License-Identifier: MIT */

/*
 * Edits through the library against loading the edited text: pictures, bounds and counts equal to
 * the last bit, no program compiled, and edits that are wrong change nothing.
 *
 *     edit [--backend=egl|osmesa|reference] [--scenes=N] [--seed=S]
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "ideal/options.h"

int main(int argc, char **argv)
{
    static struct bench bench;
    unsigned long long seed = 1;
    int num_scenes = 10;
    bench.backend = CSGCAST_BACKEND_EGL;
    for (int i = 1; i < argc; i++)
        if (!option_int(argv[i], "--scenes=", &num_scenes) && !option_seed(argv[i], &seed) &&
            !option_backend(argv[i], &bench.backend))
            return fprintf(stderr, "edit: cannot use %s\n", argv[i]), 2;
    bench.fresh = bench_create_renderer(&bench);
    check_growth(&bench);
    for (int i = 0; i < num_scenes; i++)
        check_random(&bench, seed + (unsigned)i, 3 + 5 * (i % 10));
    for (int i = 0; i < num_scenes; i++)
        check_programs(&bench, seed + (unsigned)i, 3 + 5 * (i % 10));
    for (int i = 0; i < num_scenes / 5; i++)
        check_series(&bench, seed + 100 + (unsigned)i);
    for (int i = 0; i < num_scenes / 5; i++) {
        check_many(&bench, seed + 200 + (unsigned)i, i % 2, false);
        check_many(&bench, seed + 300 + (unsigned)i, i % 2, true);
    }
    check_upload(&bench);
    check_shading(&bench);
    check_batch(&bench);
    check_all(&bench);
    check_bar(&bench);
    check_cases(&bench);
    check_engraved(&bench);
    check_nodes(&bench);
    csgcast_renderer_destroy(bench.edited);
    csgcast_renderer_destroy(bench.fresh);
    printf("%s\n", num_failed ? "FAIL" : "ok");
    return num_failed != 0;
}
