/* host-tools/figures/figures.h -- figures of the five texts as rows of a table
 * SPDX-License-Identifier: MIT
 *
 *     figures.c           the list
 *     figures_curve.c     polynomials, curves of interpolation
 *     figures_spline.c    Bezier curves, conics, NURBS
 *     figures_surface.c   triangles, tensor products, surfaces of curves
 *     figures_sided.c     patches with n sides, coordinates
 *     figures_gb.c        generalized Bezier patches, a hole that is filled
 *     cmd_figures.c       runs the rows: files, pictures, proofs, the page
 *
 * A row holds data and lines of the command itself, so that a reader can repeat each of them.
 */
#ifndef LOFT_HOST_FIGURES_H
#define LOFT_HOST_FIGURES_H

#include <stddef.h>

#define FIGURE_PROOFS 6

/* A number or a text that a line of `loft` prints, and what it must be. */
typedef struct {
    const char *says;
    const char *run;        /* {0} is the input, {1} .. are what `make` made                      */
    const char *pick;       /* what is before the number; "eval:5": the largest of column 5 in rows
                             * with `eval`; "#meet": the number of rows with `meet`; "@2:3": row 2,
                             * column 3                                                           */
    double want;
    double lsb, off;        /* the bound: LSB of a number of this size, and what is added to them */
    double floats;          /* instead of `off` in f32 and f64, if not 0 */
    const char *text;       /* instead of a number: this is in the output, lines joined with `;` */
} figure_proof;

/* A proof of many figures, with its bounds in q16 and in floats. */
#define FIGURE_ERROR(q16, other)                                                                   \
    { .says = "error against the definition, in LSB", .run = "compare {0}", .pick = "eval:5",      \
      .off = (q16), .floats = (other) }

typedef struct {
    const char *name, *text, *section, *title;
    const char *input;      /* in .loft */
    const char *also;       /* one more input, {9}; or NULL */
    const char *make;       /* lines of `loft`, `;` between them: the files {1}, {2} ..; or NULL */
    const char *plot;       /* options of `loft plot` and the file; {01} is both in one */
    const char *type;       /* of the picture: "svg", "png" */
    figure_proof proof[FIGURE_PROOFS];
} figure;

/* Figure i, in the order of the texts; NULL behind the last one. */
const figure *figure_number(size_t i);

extern const figure figures_curve[], figures_spline[], figures_surface[], figures_sided[],
    figures_gb[];
extern const size_t figures_curves, figures_splines, figures_surfaces, figures_sideds, figures_gbs;

#endif
