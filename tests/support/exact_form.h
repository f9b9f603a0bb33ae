/* tests/support/exact_form.h -- the reference of quadratic forms and convex nets: whole numbers and
 * 113 bits
 * SPDX-License-Identifier: MIT
 *
 * Entries are multiples of 2^-16 below 2^15 here.
 */
#ifndef LOFT_TESTS_EXACT_FORM_H
#define LOFT_TESTS_EXACT_FORM_H

#include "support/exact_whole.h"        /* wide, vast */

/* The determinant of the rows and columns in `rows` and `columns`, by permutations: up to 24
 * products of four. */
static inline vast exact_minor(wide m[4][4], const int rows[], const int columns[], int n)
{
    vast sum = vast_of(0);

    for (int code = 0; code < 256; code++) {
        int p[4] = { code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6 & 3 }, sign = 1;
        bool good = true;
        for (int i = 0; i < 4; i++) {
            good = good && (i < n ? p[i] < n : p[i] == i);
            for (int j = 0; j < i; j++) {
                good = good && p[i] != p[j];
                sign = p[j] > p[i] ? -sign : sign;
            }
        }
        if (!good)
            continue;
        vast term = vast_of(sign);
        for (int i = 0; i < n; i++)
            term = vast_times(m[rows[i]][columns[p[i]]], term);
        sum = vast_add(sum, term);
    }
    return sum;
}

/* Is there a principal submatrix with a negative determinant and an adjugate without negative
 * entries? */
static inline bool exact_copositive(wide m[4][4], int n)
{
    for (int set = 1; set < 1 << n; set++) {
        int at[4] = { 0 }, size = 0;
        for (int i = 0; i < n; i++)
            if (set >> i & 1)
                at[size++] = i;
        bool witness = vast_sign(exact_minor(m, at, at, size)) < 0;
        for (int i = 0; i < size && size > 1; i++)
            for (int j = 0; j < size; j++) {
                int r[4] = { 0 }, c[4] = { 0 };
                for (int k = 0; k + 1 < size; k++) {
                    r[k] = at[k + (k >= i)];
                    c[k] = at[k + (k >= j)];
                }
                witness = witness &&
                          vast_sign(exact_minor(m, r, c, size - 1)) * ((i + j) % 2 ? -1 : 1) >= 0;
            }
        if (witness)
            return false;
    }
    return true;
}

/* The square root of a whole number below 2^62, to 112 bits. */
static inline quad exact_root(wide x)
{
    quad r = sqrtl((long double)x);
    return x > 0 ? (r + (quad)x / r) / 2 : 0;
}

/* x >= 0, up to 2^-100 of the size of the terms of its sum */
static inline bool exact_at_least_zero(quad x, quad size) { return x >= -size * 0x1p-100L; }

/* sqrt(A B C) + a sqrt A + b sqrt B + c sqrt C >= 0, for A, B, C >= 0 */
static inline bool exact_roots(const wide s[3], const wide x[3])
{
    const quad r[3] = { exact_root(s[0]), exact_root(s[1]), exact_root(s[2]) };
    quad sum = r[0] * r[1] * r[2], size = sum;

    for (int i = 0; i < 3; i++) {
        const quad term = (quad)x[i] * r[i];
        sum += term;
        size += term < 0 ? -term : term;
    }
    return exact_at_least_zero(sum, size);
}

/* (j, k) of a net: rows of 1, 2, 3 .. coefficients */
static inline unsigned exact_place(unsigned j, unsigned k) { return (j + k) * (j + k + 1) / 2 + k; }

/* A coefficient by its index, as (i, j, k). */
static inline wide exact_net(const loft_real b[], const int at[3])
{
    return whole_of(b[exact_place((unsigned)at[1], (unsigned)at[2])]);
}

/* The second difference (Ea - Eb) (Ec - Ed) b at a base index. */
static inline wide exact_second(const loft_real b[], const int base[3], int a, int bb, int c, int d)
{
    const int first[2] = { a, bb }, second[2] = { c, d };
    wide sum = 0;

    for (int p = 0; p < 2; p++)
        for (int q = 0; q < 2; q++) {
            int at[3] = { base[0], base[1], base[2] };
            at[first[p]]++;
            at[second[q]]++;
            sum += p == q ? exact_net(b, at) : -exact_net(b, at);
        }
    return sum;
}

typedef struct {
    bool net, weak, line[3];
    int trend[3];
} exact_convexity_of_net;

static inline exact_convexity_of_net exact_net_shape(const loft_real b[], int n)
{
    exact_convexity_of_net c = { true, true, { true, true, true }, { 0, 0, 0 } };

    for (int i = n - 2; i >= 0; i--)
        for (int j = n - 2 - i; j >= 0; j--) {
            const int at[3] = { i, j, n - 2 - i - j };
            const wide d1 = exact_second(b, at, 0, 1, 0, 2), d2 = exact_second(b, at, 1, 2, 1, 0),
                       d3 = exact_second(b, at, 2, 0, 2, 1);
            c.net = c.net && d1 >= 0 && d2 >= 0 && d3 >= 0;
            c.line[0] = c.line[0] && exact_second(b, at, 1, 2, 1, 2) >= 0;
            c.line[1] = c.line[1] && exact_second(b, at, 2, 0, 2, 0) >= 0;
            c.line[2] = c.line[2] && exact_second(b, at, 0, 1, 0, 1) >= 0;
            c.weak = c.weak && d1 * d2 + d2 * d3 + d3 * d1 >= 0;
        }
    c.weak = c.weak && c.line[0] && c.line[1] && c.line[2];
    for (int x = 0; x < 3; x++) {
        bool up = true, down = true;
        for (int i = n - 1; i >= 0; i--)
            for (int j = n - 1 - i; j >= 0; j--) {
                int from[3] = { i, j, n - 1 - i - j }, to[3] = { i, j, n - 1 - i - j };
                from[(x + 1) % 3]++;
                to[(x + 2) % 3]++;
                up   = up && exact_net(b, to) >= exact_net(b, from);
                down = down && exact_net(b, to) <= exact_net(b, from);
            }
        c.trend[x] = up && down ? 0 : up ? 1 : down ? -1 : 9;
    }
    return c;
}

#endif
