/* host-tools/engine/curve.h -- any kind of curve, as a file gives it: points with their weights,
 * parameters or derivatives
 * SPDX-License-Identifier: MIT
 *
 *     curve.c       the kinds, their parameters, the list
 *     curve_text.h  the text format .loft (LOFT.md)
 *     readers.h     any file: SVG, G-code, eight numbers per line, control points, .loft
 *     piece.h       what a curve becomes: Bezier pieces
 *     drawn.h       the pieces of drawings and pictures, of higher degrees too
 *     reference.h   its definition in long double
 *
 * A curve has its own parameter, from curve_from to curve_to: 0..1 for Bezier curves and arcs, 0..n
 * over n pieces of a spline, the given parameters for a parabola, the knots for a B-spline.
 */
#ifndef LOFT_HOST_CURVE_H
#define LOFT_HOST_CURVE_H

#include <stdbool.h>
#include <stddef.h>

#define CURVE_AXES       3
#define CURVE_DEGREE_MAX 9          /* of the library */
#define CURVE_DRAWN_MAX  32         /* of `bezier` and `rational` in drawings: drawn.h    */
#define CURVE_POINTS_MAX 4000000    /* of a curve in a file                       */
#define CURVE_HUNG_MAX   32000      /* of B-splines: LOFT_KNOTS_POINTS_MAX        */

enum curve_kind {
    CURVE_BEZIER,
    CURVE_LINE,
    CURVE_RATIONAL,
    CURVE_PARABOLA,
    CURVE_HERMITE3,
    CURVE_HERMITE5,
    CURVE_CARDINAL,
    CURVE_NATURAL,
    CURVE_CHORD,
    CURVE_BSPLINE,
    CURVE_NURBS,
    CURVE_ARC,
    CURVE_SPLINE,
    CURVE_TCB,
    CURVE_CATMULL,
    CURVE_KINDS
};

/* What completes a spline, as in curve/spline.h; the last two have a hidden point at each end. */
enum curve_ends {
    CURVE_CLOSED,
    CURVE_CLAMPED,
    CURVE_NOT_A_KNOT,
    CURVE_THROUGH,
    CURVE_SLOPE,
    CURVE_ENDS
};

/* A point and its attributes. */
typedef struct {
    double p[CURVE_AXES];       /* arc: start, centre, end                                      */
    double d[2][CURVE_AXES];    /* hermite3: the first derivative; hermite5: the second as well;
                                 * clamped: that of the ends; tcb: tension, continuity, bias    */
    double w;                   /* rational, nurbs: the weight; parabola: its parameter         */
} curve_point;

typedef struct curve {
    enum curve_kind kind;
    unsigned degree;            /* of the pieces                                                */
    double tension;             /* cardinal; catmull: the power of the chords                   */
    enum curve_ends ends;       /* spline                                                       */
    bool chord;                 /* spline: knots by the chords                                  */
    int turns;                  /* arc: > 0 left about, counterclockwise; 2: beyond a full turn */
    curve_point *point;
    unsigned count;
    double *knot;               /* bspline, nurbs: count + degree + 1 of them                   */
    unsigned knot_count;
    unsigned line;              /* its first line in the file */
} curve;

typedef struct curves {
    curve *curve;
    size_t count;
    bool solid;                 /* some point has a z */
    bool any_weights;           /* asked for: `rational` may have weights of 0 and below */
    bool drawn;                 /* asked for: degrees up to CURVE_DRAWN_MAX              */
} curves;

/* What all curves of a kind have in common: a row of curve.c. */
typedef struct {
    const char *name;
    unsigned degree;            /* of the pieces; 0: its file says it                           */
    bool rational;              /* it has weights                                               */
    bool bezier;                /* it is one Bezier curve                                       */
    bool knots;                 /* a B-spline, with or without weights                          */
    bool joins;                 /* a piece from each point to the next; otherwise it is one     */
    bool hides_ends;            /* the first and the last point only give directions            */
    bool extends;               /* it has points beyond its ends                                */
    bool slopes;                /* points have derivatives, d                                   */
    const char *remedy;         /* of LOFT_ERR_ARG; NULL: as most                               */
} curve_row;

extern const curve_row curve_kinds[CURVE_KINDS];

static inline const char *curve_name(enum curve_kind kind) { return curve_kinds[kind].name; }

/* What the library says of this curve, and the remedy (engine_status). */
const char *curve_status(const curve *c, int status);

/* It has weights; it has points beyond its ends; it is a B-spline. */
static inline bool curve_is_rational(const curve *c) { return curve_kinds[c->kind].rational; }
static inline bool curve_extends(const curve *c) { return curve_kinds[c->kind].extends; }
static inline bool curve_has_knots(const curve *c) { return curve_kinds[c->kind].knots; }

/* True if it is a Bezier curve of a degree above those of the library. */
bool curve_is_high(const curve *c);

/* Its first and its last point only give directions; it ends where it began. */
bool curve_hides_ends(const curve *c);
bool curve_is_closed(const curve *c);

/* The number of pieces that are one polynomial (or rational) each, and the start of piece i; piece
 * `pieces` is the end. */
unsigned curve_pieces(const curve *c);
double   curve_break(const curve *c, unsigned i);
double   curve_from(const curve *c);
double   curve_to(const curve *c);

/* The piece that contains t (the last one at the end), and the position of t in it: 0..1, or
 * outside 0..1 at the outer ends. */
unsigned curve_locate(const curve *c, long double t, long double *local);

/* Append a curve without points to the list, or a point to the last curve. */
curve *curves_add(curves *all, enum curve_kind kind, unsigned line);
void   curve_add_point(curve *c, const curve_point *p);
void   curve_add_knot(curve *c, double knot);
void   curves_free(curves *all);

#endif
