/* tests/vectors/vectors.h -- what a reader of a CSV with exact results is written with
 * SPDX-License-Identifier: MIT
 *
 * A system is one row of a table: its name as the first line of the CSV gives it, the columns it
 * reads, a function that is called for each row, and its bound in words. The function takes its
 * inputs by column name, calls the library, and hands over each answer with the law that bounds its
 * error:
 *
 *     static void bernstein1d(row *r)
 *     {
 *         const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
 *         loft_acc w[LOFT_DEGREE_MAX + 1];
 *         loft_bernstein_weights(n, row_unit(r, "t_q16"), w);
 *         answer a = { 0 };
 *         for (unsigned k = 0; k <= n; k++)
 *             answer_wide(&a, w[k]);
 *         row_expect(r, "basis", &a, (law) { .lsb = n / 65536.0L, .roundings = 3 * n });
 *     }
 *
 * A column that cannot be read gives zeros and a complaint, so no function needs an error path.
 * Whether a result beyond the range was reported is decided over the whole row.
 */
#ifndef LOFT_TESTS_VECTORS_H
#define LOFT_TESTS_VECTORS_H

#include "support/exact.h"  /* exact_of, exact_acc, ulp, growth_sum */
#include "geom/vec.h"       /* loft_vec */

#define ROW_COLUMNS 32
#define LIST_MAX    65536   /* numbers in one field */

typedef struct {
    char *name[ROW_COLUMNS], *field[ROW_COLUMNS];
    unsigned columns;
    char complaint[200];            /* why the row cannot be read or is wrong; empty when neither */
    bool refused, beyond, edge;     /* an overflow was reported; an expected value is out of range,
                                     * is within one LSB of its end: then either answer is right */
    long double largest, inexact;   /* of the coordinates: the largest, the most that reading
                                     * rounded one */
    long double error, bound;       /* in LSB, of the value that comes closest to its bound */
    const char *folder;             /* where the CSV is, and others that it refers to */
} row;

typedef struct {
    const char *name, *columns;
    void (*function)(row *r);
    const char *bound;
} vector_system;

/* The tables, each ended by a row without a name. */
extern const vector_system vectors_curve[], vectors_measure[], vectors_shape[], vectors_rational[],
    vectors_bspline[], vectors_join[], vectors_spline[], vectors_sign[], vectors_coons[],
    vectors_tensor[], vectors_polygon[], vectors_harmonic[], vectors_deficit[], vectors_chapter[],
    vectors_spatch[], vectors_npatch[], vectors_gb[], vectors_triangle[], vectors_triangle_curved[],
    vectors_tetra[], vectors_motion[], vectors_ends[], vectors_weighted[], vectors_decide[],
    vectors_meet[], vectors_woven[], vectors_fit[], vectors_along[], vectors_across[],
    vectors_made[], vectors_sides[];

/* Inputs */

const char *row_text(row *r, const char *column);
/* the next number of such a text, which goes on behind it; INFINITY where there is none */
long double row_next(const char **text);
/* a whole number, 0..most */
unsigned  row_count(row *r, const char *column, unsigned most);
bool      row_is(row *r, const char *column, const char *word);
loft_unit row_unit(row *r, const char *column);         /* a parameter as a raw Q16.16 */
loft_unit row_unit_q30(row *r, const char *column);     /* as a raw Q2.30, rounded once */
loft_real row_real(row *r, const char *column);
void      row_reals(row *r, const char *column, unsigned count, loft_real out[]);
/* how many numbers or points stand there */
unsigned  row_length(row *r, const char *column, unsigned most);
/* d <= LOFT_AXES */
void      row_points(row *r, const char *column, unsigned count, unsigned d, loft_vec out[]);


/* Answers */

typedef struct {
    unsigned count;
    bool refused, wide;
    long double value[LIST_MAX];
} answer;

answer *answer_new(void);                               /* an empty one, valid for this row */
/* LOFT_ERR_RANGE: there is no value */
void    answer_status(row *r, answer *a, enum loft_status status);
void    answer_real(answer *a, loft_real x);
void    answer_unit(answer *a, loft_unit t);
void    answer_acc(answer *a, loft_acc x);              /* rounded to a coordinate; may not fit */
void    answer_wide(answer *a, loft_acc x);                     /* as it is */
void    answer_vec(answer *a, loft_vec v, unsigned d);

/* A bound: in q16 `lsb`. In floats the sum of the weights (`gain`, at least 1) times what reading
 * rounded and `roundings` ulp of double, of the largest coordinate, and 1/2 ulp of the result. */
typedef struct {
    long double lsb, gain, roundings;
} law;

void row_expect(row *r, const char *column, const answer *a, law l);
void row_expect_word(row *r, const char *column, const char *word);
void row_expect_flag(row *r, const char *column, bool flag);
/* both in LSB */
void row_within(row *r, const char *what, long double error, long double bound);
void row_complain(row *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
