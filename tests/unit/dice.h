/* SPDX-License-Identifier: MIT */
#ifndef TESTS_UNIT_DICE_H
#define TESTS_UNIT_DICE_H

/* Random numbers, the same on every machine. */

/* A test may define its seed before it includes this. */
#ifndef DICE_SEED
#define DICE_SEED 42
#endif

/* The constants are those of Knuth's MMIX. */
static unsigned long long dice = DICE_SEED;

static inline unsigned long long dice_next(void)
{
    return dice = dice * 6364136223846793005ull + 1442695040888963407ull;
}

/* 0 to 1 */
static inline double random_unit(void)
{
    return (double)(dice_next() >> 11) / 9007199254740992.0;
}

static inline double random_between(double lo, double hi)
{
    return lo + (hi - lo) * random_unit();
}

/* 0 to n - 1 */
static inline unsigned random_below(unsigned n)
{
    return (unsigned)(dice_next() >> 33) % n;
}

#endif
