/* SPDX-License-Identifier: MIT */
#include "common/number.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A decimal number taken apart: digits * 10^exponent. */
struct decimal {
    uint64_t digits; /* the first 19 significant ones */
    int num_digits;  /* all significant ones, up to the last that is not 0 */
    int num_zeros;   /* zeros after that one so far */
    long exponent;   /* of the unit of digits */
    bool is_integer; /* written without a point and exponent */
};

enum { max_digits = 19 };

static void add_digit(struct decimal *decimal, char digit, bool fraction)
{
    if (decimal->num_digits + decimal->num_zeros < max_digits) {
        decimal->digits = decimal->digits * 10 + (uint64_t)(digit - '0');
        decimal->exponent -= fraction;
    } else {
        decimal->exponent += !fraction;
    }
    if (digit != '0') {
        decimal->num_digits += decimal->num_zeros + 1;
        decimal->num_zeros = 0;
    } else if (decimal->num_digits > 0) {
        decimal->num_zeros++;
    }
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Returns the bytes used, 0 when there is no digit. */
static size_t read_mantissa(const char *text, size_t length, struct decimal *decimal)
{
    size_t at = 0, num_digits = 0;
    bool fraction = false;
    for (; at < length && (is_digit(text[at]) || (text[at] == '.' && !fraction)); at++) {
        if (text[at] == '.') {
            fraction = true;
        } else {
            add_digit(decimal, text[at], fraction);
            num_digits++;
        }
    }
    decimal->is_integer = !fraction;
    return num_digits > 0 ? at : 0;
}

/* Adds the exponent's value; returns the bytes used, 0 when it is malformed. */
static size_t read_exponent(const char *text, size_t length, struct decimal *decimal)
{
    size_t at = 1; /* behind the e */
    const bool negative = at < length && text[at] == '-';
    if (at < length && (text[at] == '-' || text[at] == '+'))
        at++;
    const size_t first = at;
    long exponent = 0;
    for (; at < length && is_digit(text[at]); at++)
        if (exponent < 100000) /* beyond any double; keeps the sum in range */
            exponent = exponent * 10 + (text[at] - '0');
    decimal->exponent += negative ? -exponent : exponent;
    decimal->is_integer = false;
    return at > first ? at : 0;
}

static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

enum { max_power = sizeof powers / sizeof powers[0] - 1 };

/* Correctly rounded where digits and the power are both exact doubles (Clinger's fast path). */
static bool convert_exactly(const struct decimal *decimal, double *value)
{
    const long exponent = decimal->exponent;
    if (decimal->num_digits + decimal->num_zeros > max_digits ||
        decimal->digits > UINT64_C(1) << 53 || exponent < -max_power || exponent > max_power)
        return false;
    const double digits = (double)decimal->digits;
    *value = exponent < 0 ? digits / powers[-exponent] : digits * powers[exponent];
    return true;
}

/*
 * The same with long doubles of 64 bits and more, which hold all digits. Their quotient is rounded
 * once more, which is right unless it lies halfway between two doubles: then 2 * quotient - nearest
 * is a double, the one behind the nearest.
 */
static bool convert_widely(const struct decimal *decimal, double *value)
{
#if LDBL_MANT_DIG >= 64
    static const long double wide[] = {1e23L, 1e24L, 1e25L, 1e26L, 1e27L};
    const long exponent = decimal->exponent, size = labs(exponent);
    if (decimal->num_digits + decimal->num_zeros > max_digits || size > max_power + 5)
        return false;
    const long double power = size > max_power ? wide[size - max_power - 1] : powers[size];
    const long double digits = decimal->digits;
    const long double quotient = exponent < 0 ? digits / power : digits * power;
    const double nearest = (double)quotient;
    const long double behind = 2 * quotient - nearest;
    *value = nearest;
    return behind == nearest || (double)behind != behind;
#else
    (void)decimal, (void)value;
    return false;
#endif
}

/* strtod wants the locale's decimal point and a terminating zero. */
static bool convert_slowly(const char *text, size_t length, double *value)
{
    char copy[CSG_NUMBER_LENGTH_MAX + 1];
    if (length > CSG_NUMBER_LENGTH_MAX)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    const locale_t neutral = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (neutral == (locale_t)0)
        return false;
    const locale_t before = uselocale(neutral);
    *value = strtod(copy, NULL);
    uselocale(before);
    freelocale(neutral);
    return true;
}

/*
 * OpenSCAD writes six significant digits and drops zeros at the end, so a number with five or six
 * may be a rounded one, off by half a unit of the sixth. Fewer are hardly ever, more never are;
 * integers below 10^5 are written in full.
 */
static float rounding_of(const struct decimal *decimal, double value)
{
    const bool exact_integer = decimal->is_integer && value < 1e5;
    if (exact_integer || decimal->num_digits < 5 || decimal->num_digits > 6)
        return 0;
    const long num_digits = decimal->num_digits + decimal->num_zeros;
    const long num_kept = num_digits < max_digits ? num_digits : max_digits;
    const long sixth = num_kept - 6 + decimal->exponent;
    const double unit = sixth >= 0 && sixth <= max_power   ? powers[sixth]
                        : sixth < 0 && sixth >= -max_power ? 1 / powers[-sixth]
                                                           : pow(10, (double)sixth);
    return (float)fmin(0.5 * unit, (double)FLT_MAX);
}

bool csg_number_read(const char *text, size_t length, struct csg_number *number)
{
    struct decimal decimal = {0};
    size_t at = read_mantissa(text, length, &decimal);
    if (at == 0 || length > CSG_NUMBER_LENGTH_MAX)
        return false;
    if (at < length && (text[at] == 'e' || text[at] == 'E')) {
        const size_t used = read_exponent(text + at, length - at, &decimal);
        if (used == 0)
            return false;
        at += used;
    }
    if (at != length)
        return false;
    if (!convert_exactly(&decimal, &number->value) && !convert_widely(&decimal, &number->value) &&
        !convert_slowly(text, length, &number->value))
        return false;
    number->rounding = rounding_of(&decimal, number->value);
    return true;
}

bool csg_number_read_signed(const char *text, size_t length, double *value)
{
    const bool is_negative = length > 0 && text[0] == '-';
    const bool has_sign = is_negative || (length > 0 && text[0] == '+');
    struct csg_number number;
    if (!csg_number_read(text + has_sign, length - has_sign, &number) || !isfinite(number.value))
        return false;
    *value = is_negative ? -number.value : number.value;
    return true;
}
