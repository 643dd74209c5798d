/* SPDX-License-Identifier: MIT */
/* Keys of random numbers, many equal: in their order, and equal ones in that of the list. */
#include "common/keys.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "dice.h"

static double random_number(void)
{
    static const double special[6] = {0.0, -0.0, 1.0, -1.0, INFINITY, -INFINITY};
    return random_below(3) ? random_between(-1, 1) * exp(random_between(-600, 600))
                           : special[random_below(6)];
}

static void check_sorted(size_t num)
{
    double *numbers = malloc((num + 1) * sizeof *numbers);
    struct csg_keys keys = {.list = {0}};
    for (uint32_t i = 0; i < num; i++) {
        numbers[i] = random_number();
        const struct csg_key key = {csg_key_of(numbers[i]), i};
        CHECK(csg_array_push(&keys.list, key), "out of memory");
    }
    CHECK(csg_keys_sort(&keys) && keys.list.num == num, "%zu of %zu", keys.list.num, num);
    for (size_t i = 1; i < num; i++) {
        const uint32_t a = keys.list.data[i - 1].index, b = keys.list.data[i].index;
        CHECK(numbers[a] < numbers[b] || (numbers[a] == numbers[b] && a < b),
              "%zu of %zu: %g (%u) before %g (%u)", i, num, numbers[a], (unsigned)a, numbers[b],
              (unsigned)b);
    }
    free(keys.list.data);
    free(keys.room.data);
    free(numbers);
}

int main(void)
{
    static const size_t nums[] = {0, 1, 2, 100, 255, 256, 20000};
    for (size_t i = 0; i < sizeof nums / sizeof *nums; i++)
        check_sorted(nums[i]);
    return num_failed != 0;
}
