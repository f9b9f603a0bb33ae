/* host-tools/engine/engine.h -- the library behind a double interface; engine.c is compiled once
 * per number type
 * SPDX-License-Identifier: MIT
 *
 * All three number types live in one program: names.h keeps their symbols apart.
 */
#ifndef LOFT_ENGINE_H
#define LOFT_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/option.h"    /* OPTION_PARSED */

#define ENGINE_AXES 3

struct curve;               /* curve.h */
struct piece;               /* piece.h */
struct surface;             /* surface.h */

/* A span as it is sent and drawn: Bezier points in time, raw Q16.16 mm, in steps of ENGINE_LSB. */
#define ENGINE_LSB (1 / 65536.0)
typedef struct {
    int32_t  p[4][ENGINE_AXES];
    uint16_t ticks;
} engine_span;

/* A move of the toolpath: a cubic in mm with its feed in mm/s. */
typedef struct {
    double p[4][ENGINE_AXES];
    double feed;
} engine_move;

typedef struct {
    double max_speed[ENGINE_AXES], max_accel[ENGINE_AXES];      /* mm/s, mm/s^2 */
    double max_jerk[ENGINE_AXES];                               /* mm/s^3, or 0 */
    double corner, tol;                                         /* mm           */
    double exact;                                               /* as in lib/path/limits.h, and */
    unsigned one_sided;         /* of a plan of one straight line: all axes */
    unsigned tick_hz;
} engine_limits;

typedef void engine_point_sink(void *context, const double point[ENGINE_AXES]);
typedef void engine_cubic_sink(void *context, double p[4][ENGINE_AXES]);
/* Give move number n; the same one each time. */
typedef void engine_move_source(void *context, size_t n, engine_move *out);

/* A curve of any kind, in the representation of the library. */
typedef struct engine_curve engine_curve;

/* Functions return enum loft_status (0 = OK, negative = error, LOFT_SINGULAR = no result). Points
 * are in mm. */
typedef struct {
    /* Prepare the curve; `c` must outlive it. After an error there is nothing to close. */
    int (*open)(const struct curve *c, engine_curve **out);
    void (*close)(engine_curve *c);
    /* The point at t of the curve's own parameter; outside its range only if curve_extends. */
    int (*eval)(engine_curve *c, double t, double out[ENGINE_AXES]);
    /* The number of Bezier pieces, and piece i. */
    unsigned (*pieces)(const engine_curve *c);
    int (*piece)(engine_curve *c, unsigned i, struct piece *out);
} engine_curves;

/* The shape of a piece. */
typedef struct {
    const char *type;           /* of a cubic in the plane of x and y: "serpentine" ..; NULL: not a
                                 * cubic */
    unsigned inflections;       /* strictly within 0..1 */
    bool cusp, loop;
    double inflection[2], cusp_at, loop_at[2];
    bool tight;                 /* the box bounds the curve tightly; otherwise it bounds the control
                                 * points */
    double box[2][ENGINE_AXES];
} engine_shape;

/* A curve near a place: derivatives; curvature, with a sign in the plane, if it does not stop
 * there; Frenet's frame and the torsion, if it turns there. */
typedef struct {
    double d[3][ENGINE_AXES], curvature, frame[3][ENGINE_AXES], torsion;
    bool derived, stops, straight;          /* derived: the derivatives fit the number type */
} engine_bend;

/* Pieces as engine_curves gives them: their numbers are exact in the number type. */
typedef struct {
    /* n points at equal steps, by forward differences where the library walks (up to degree 5). The
     * start is not repeated. */
    int (*walk)(const struct piece *p, uint32_t n, engine_point_sink *sink, void *context);
    int (*shape)(const struct piece *p, engine_shape *out);
    /* At t in 0..1 of the piece, in a parameter that is `span` times as long. */
    int (*bend)(const struct piece *p, double t, double span, bool plane, engine_bend *out);
    /* A chain of cubics within tol of the piece; neighbours share ends and directions. */
    int (*cubics)(const struct piece *p, double tol, engine_cubic_sink *sink, void *context);
} engine_pieces;

/* The nearest point of a piece: t in 0..1. */
typedef struct {
    double t, point[ENGINE_AXES], distance;
} engine_near;

/* Where two pieces meet: begin, closest place, end; 0..1 on each. */
typedef struct {
    double s[3], t[3], point[ENGINE_AXES], distance;
    bool overlap;
} engine_meeting;

#define ENGINE_MEETINGS 96      /* more than the meetings of two curves of degree 9: 81 */

typedef struct {
    bool c[3], g[3];            /* C0 C1 C2, G0 G1 G2                   */
    double alpha, eta;          /* 0 if G1 or G2 does not hold */
} engine_joint;

typedef void engine_offset_sink(void *context, double p[4][ENGINE_AXES], bool behind);

/* Pieces are polynomial here; lengths and distances in mm. */
typedef struct {
    int (*length)(const double p[4][ENGINE_AXES], double tol, double *out);
    int (*nearest)(const struct piece *p, const double point[ENGINE_AXES], double tol,
                   engine_near *out);
    /* LOFT_MORE if there are more than ENGINE_MEETINGS */
    int (*meet)(const struct piece *a, const struct piece *b, double tol,
                engine_meeting out[ENGINE_MEETINGS], size_t *count);
    /* pieces of one degree, 1..9 */
    int (*join)(const struct piece *a, const struct piece *b, double tol, engine_joint *out);
    int (*offset)(const double p[4][ENGINE_AXES], double distance, double tol,
                  engine_offset_sink *sink, void *context);
} engine_measures;

extern const engine_measures engine_measures_q16, engine_measures_f32, engine_measures_f64;
/* A surface of any kind, in the representation of the library. */
typedef struct engine_surface engine_surface;

/* Parts of a surface where lines of a level may be joined otherwise, or a small one be missing; u
 * and v of the first. */
typedef struct {
    unsigned parts;
    double at[2];
} engine_doubt;

/* A point of a contour; `first`: it begins a curve. */
typedef void engine_contour_sink(void *context, bool first, const double point[ENGINE_AXES]);

/* What a contour has the value of: z; the distance along a direction; the angle between it and the
 * normal, in degrees (tol is of its cosine). */
enum engine_level_of { ENGINE_LEVEL_HEIGHT, ENGINE_LEVEL_PLANE, ENGINE_LEVEL_ANGLE };
typedef struct {
    enum engine_level_of of;
    double direction[ENGINE_AXES], value;
} engine_level;

typedef struct {
    double normal[ENGINE_AXES];
    double gauss, mean;         /* 1/mm^2, 1/mm: mean > 0: bends to the normal */
    double least, most;         /* the principal curvatures */
    double direction[2][ENGINE_AXES];       /* theirs, if `directed` */
    double d[5][ENGINE_AXES];   /* by u, v, uu, uv, vv; not of a sphere */
    bool directed, derived;
} engine_look;

typedef struct {
    /* As for curves. */
    int (*open)(const struct surface *s, engine_surface **out);
    void (*close)(engine_surface *s);
    /* The point at u, v of 0..1; on a triangle u + v <= 1. A patch with n sides has its own
     * parameters. */
    int (*eval)(const engine_surface *s, double u, double v, double out[ENGINE_AXES]);
    /* The point at u, v of a kite of a patch with n sides (sided.h). Other surfaces are one
     * kite. */
    int (*kite)(const engine_surface *s, unsigned kite, double u, double v,
                double out[ENGINE_AXES]);
    /* Normal and curvatures there. If they do not exist at that place, it moves towards the middle
     * of the kite, by at most 2^-9 of the way. LOFT_SINGULAR: they do not exist there either. */
    int (*look)(const engine_surface *s, unsigned kite, double u, double v, engine_look *out);
    /* The same at u, v as eval takes them; nothing moves. */
    int (*local)(const engine_surface *s, double u, double v, engine_look *out);
    /* The lines of a level in their order, within tol in its unit. They are found on a grid of
     * n x n cells (n sides: a multiple of them around), of more where these do not show the lines
     * (engine_cells.h). */
    int (*contour)(engine_surface *s, const engine_level *level, double tol, unsigned n,
                   engine_doubt *doubt, engine_contour_sink *sink, void *context);
} engine_surfaces;

extern const engine_surfaces engine_surfaces_q16, engine_surfaces_f32, engine_surfaces_f64;
extern const engine_curves engine_curves_q16, engine_curves_f32, engine_curves_f64;
extern const engine_pieces engine_pieces_q16, engine_pieces_f32, engine_pieces_f64;

/* Points with ascending parameters, and the knots of the B-spline that curve/fit.h makes near them;
 * weight NULL: 1 each. */
typedef struct {
    const double (*p)[ENGINE_AXES], *u, *weight;
    size_t count;
    const double *knot;         /* points + degree + 1 */
    unsigned points, degree;
    bool closed;
} engine_fit;

/* A grid of points, row by row, and the knots of the surface near them: [0] along u, from row to
 * row, [1] along v. */
typedef struct {
    const double (*p)[ENGINE_AXES], *at[2], *knot[2];
    unsigned count[2], points[2], degree[2];
} engine_grid_fit;

/* Points with their parameters, and a B-spline surface: its knots along u and v. */
typedef struct {
    const double (*p)[ENGINE_AXES], (*at)[2], *knot[2];
    size_t count;
    unsigned points[2], degree[2];
} engine_net_fit;

#define ENGINE_BASIS 10         /* a degree and one more */

/* The B-splines that are not 0 at a parameter, from `first` on, and their slopes. */
typedef struct {
    unsigned first;
    double value[ENGINE_BASIS], slope[ENGINE_BASIS];
} engine_basis;

/* A plan in progress: its memory does not depend on the number of moves. */
typedef struct engine_plan engine_plan;

enum engine_step { ENGINE_PLAN_BUSY, ENGINE_PLAN_SPAN, ENGINE_PLAN_DONE };

typedef struct {
    /* `count` moves; each starts where the one before ends. All are checked at once, and read again
     * when they are planned. After an error there is nothing to close. */
    int (*open)(const engine_limits *limits, engine_move_source *source, void *context,
                size_t count, engine_plan **out);
    /* Do a little work, about 1 ms. Returns enum engine_step, with or without a span; or an
     * error. */
    int (*step)(engine_plan *p, engine_span *out);
    size_t (*passed)(const engine_plan *p);         /* moves that end at or before the end of the
                                                     * last span */
    void (*close)(engine_plan *p);
} engine_plans;

extern const engine_plans engine_plans_q16, engine_plans_f32, engine_plans_f64;

typedef struct {
    const char *name;                       /* "q16" "f32" "f64"                    */
    bool fixed;                             /* the resolution is the same everywhere */
    double lsb;                             /* the resolution at a coordinate of size 1 */
    double reach;                           /* mm: plans must stay within +- this */
    int (*hold)(double x, double *out);     /* x rounded to this type */
    const engine_curves *curve;
    const engine_pieces *piece;
    const engine_measures *measure;
    /* The control points of the B-spline nearest to points. */
    int (*fit)(const engine_fit *f, double out[][ENGINE_AXES]);
    /* Those of a surface, and the largest distance of a point from its place on it. */
    int (*fit_grid)(const engine_grid_fit *f, double out[][ENGINE_AXES], double *off);
    /* The B-splines at the parameters of all points, [0] along u, `axis` of them. */
    int (*fit_basis)(const engine_net_fit *f, int axis, engine_basis out[]);
    /* The places f->at on the surface of this net. */
    int (*fit_places)(const engine_net_fit *f, const double net[][ENGINE_AXES],
                      double out[][ENGINE_AXES]);
    /* The arc of an SVG path, at most about one turn, as cubics in the plane within tol of it.
     * turns is 1 from x to y, or -1. */
    int (*ellipse)(const double from[2], const double to[2], const double radii[2], double degrees,
                   bool large, int turns, double tol, engine_cubic_sink *sink, void *context);
    const engine_surfaces *surface;
    /* The point at v, w, x of a tetrahedron. */
    int (*solid)(const struct surface *s, const double at[3], double out[ENGINE_AXES]);
    int (*flatten)(const double p[4][ENGINE_AXES], double tol, engine_point_sink *sink,
                   void *context);
    const engine_plans *plan;
    int32_t (*steps)(double mm, double steps_per_mm);   /* rounded as a machine of this type
                                                         * rounds */
} engine;

extern const engine engine_q16, engine_f32, engine_f64;

const engine *engine_find(const char *name);    /* NULL if unknown */

/* The row of --num TYPE; the member `m` is a const engine *. */
#define ENGINE_ROW(s, m, type, words)                                                              \
    { "num", OPTION_PARSED(s, m), .choices = "q16|f32|f64", .standard = type,                      \
      .parse = engine_parse, .help = words }
bool engine_parse(const char *text, void *out);

/* The smallest tolerance, or a little more, within which a piece becomes cubics. */
double engine_finest(const engine *e, const struct piece *p);

/* A status of the library as what is wrong and its remedy. `wrong` says so for LOFT_ERR_ARG, which
 * means another thing at each place; NULL: nothing that a user gives leads there. */
const char *engine_status(int status, const char *wrong);

/* What LOFT_ERR_ARG of a plan means. */
#define ENGINE_NO_MOTION "there is no motion in it: give one with visible outlines, or with motions"

#endif
