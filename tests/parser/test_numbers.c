/* SPDX-License-Identifier: MIT */
/* Numbers: read as strtod does, and how far a written one may have been rounded. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"

struct rounding_case {
    const char *text;
    double rounding;
};

static const struct rounding_case rounding_cases[] = {
    {"0.707107", 5e-7},
    {"0.70711", 5e-7},
    {"0.7071", 0},
    {"0.5", 0},
    {"12345", 0},
    {"123457", 0.5},
    {"100000", 0},
    {"123000", 0},
    {"1234567", 0},
    {"1.23457e+06", 5},
    {"1e-07", 0},
    {"0.1234567", 0},
    {"1.50000", 0},
    {"12.3456", 5e-5},
    {"00012.3456", 5e-5},
    {"12345.6", 0.05},
    {"123.4560000000000000000000", 5e-4},
    {"1234560000000000000000000", 5e18},
    {"0.00123457", 5e-9},
    {"0", 0},
    {"0.00000", 0},
    {"99999.9", 0.05},
};

static const char *const malformed[] = {
    "", ".", "e5", "1e", "1e+", "1.2.3", "12abc", "0x10", "1 ", " 1", "-1", "1e5.5", "inf", "nan",
};

/* Each is also read with every other exponent. */
static const char *const digits[] = {
    "0",
    "1",
    "5.",
    ".5",
    "0.333333",
    "123457",
    "9007199254740993",
    "18446744073709551616",
    "123456789012345678901234567890",
    "0.000000000000000000000000000001",
    "1.7976931348623157",
    "000000000000000000000000000000000000123.456000000000000000000000000000000",
    "2.2250738585072011",
    "4.9406564584124654",
    "6.6666666666666666666666666",
};

static bool check_value(const char *text)
{
    struct csg_number number;
    const double expected = strtod(text, NULL);
    if (csg_number_read(text, strlen(text), &number) &&
        memcmp(&number.value, &expected, sizeof expected) == 0)
        return true;
    fprintf(stderr, "%s is read as %.17g, not %.17g\n", text, number.value, expected);
    return false;
}

static int check_values(void)
{
    int num_failed = 0;
    for (size_t i = 0; i < sizeof digits / sizeof digits[0]; i++)
        for (int exponent = -345; exponent < 320; exponent++) {
            char text[128];
            snprintf(text, sizeof text, "%se%+d", digits[i], exponent);
            num_failed += !check_value(exponent == 0 ? digits[i] : text);
        }
    return num_failed;
}

/* Of 17 and 19 digits, and nearly or exactly halfway between two doubles. */
static int check_many(void)
{
    uint64_t state = 88172645463325252u;
    int num_failed = 0;
    for (int i = 0; i < 300000; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const double value = ldexp((double)(state >> 11), -(int)(state % 90));
        const uint64_t whole = state >> 12 | UINT64_C(1) << 52;
        char text[64];
        if (i % 3 == 0)
            snprintf(text, sizeof text, "%.17g", value);
        else if (i % 3 == 1)
            snprintf(text, sizeof text, "%llue%d", (unsigned long long)state, (int)(i % 59) - 29);
        else
            snprintf(text, sizeof text, "%llu.5", (unsigned long long)whole);
        num_failed += !check_value(text);
    }
    return num_failed;
}

static int check_roundings(void)
{
    int num_failed = 0;
    for (size_t i = 0; i < sizeof rounding_cases / sizeof rounding_cases[0]; i++) {
        const struct rounding_case *expected = &rounding_cases[i];
        struct csg_number number;
        if (csg_number_read(expected->text, strlen(expected->text), &number) &&
            fabs((double)number.rounding - expected->rounding) <= 1e-6 * expected->rounding)
            continue;
        fprintf(stderr, "%s may be off by %g, not %g\n", expected->text, (double)number.rounding,
                expected->rounding);
        num_failed++;
    }
    return num_failed;
}

static int check_malformed(void)
{
    int num_failed = 0;
    char large[2 * CSG_NUMBER_LENGTH_MAX];
    struct csg_number number;
    memset(large, '1', sizeof large);
    num_failed += csg_number_read(large, sizeof large, &number);
    for (size_t i = 0; i < sizeof malformed / sizeof malformed[0]; i++)
        if (csg_number_read(malformed[i], strlen(malformed[i]), &number)) {
            fprintf(stderr, "'%s' is read as a number\n", malformed[i]);
            num_failed++;
        }
    return num_failed;
}

int main(void)
{
    const int num_failed = check_values() + check_many() + check_roundings() + check_malformed();
    printf("%d checks failed\n", num_failed);
    return num_failed > 0;
}
