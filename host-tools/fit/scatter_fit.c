/* host-tools/fit/scatter_fit.c
 * SPDX-License-Identifier: MIT
 *
 * Least squares with fixed parameters, then parameters for a fixed surface: each step lowers the
 * sum of squares (J. Hoschek, Intrinsic parametrization for approximation, CAGD 5, 1988). The
 * nearest place is found by Gauss and Newton's method, halved where it does not come nearer.
 *
 * A net that meets the points tells nothing of the surface between them. So it is judged by points
 * that it has not seen: FOLDS times a share of the points is left out, a net is fitted to the
 * others, and measured at those (cross-validation: M. Stone, JRSS B 36, 1974). A net that follows
 * the noise, or that the points hardly determine, predicts badly. The root of the mean square must
 * be within PREDICTED tolerances. There is at most one control point for two points. And the
 * surface, seen at LOOKS places along each span, stays in the box of the points along the rectangle
 * and the plane's normal, but for BEYOND of its diagonal and SLACK tolerances: corners that have no
 * points are not told by others. Where the surface stays in the box there, it is a guess all the
 * same. Of n points thrown over the rectangle none is within BLANK / sqrt(n) of its sides from a
 * corner once in 140 corners; farther, the caller is told the place.
 */
#include "fit/scatter_fit.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"         /* LOFT_OK */

#include "base/least.h"         /* least_squares */
#include "base/space.h"         /* space_distance */
#include "base/tool.h"          /* tool_grow */

#define ROUNDS  8
#define STEPS   4               /* to the nearest place, in a round */
#define HALVES  6
#define SHARE   1e-5L           /* of the first column: a shorter one has no points of its own */
#define FOLDS   4
#define PREDICTED 2
#define SLACK   4
#define LOOKS   4
#define BEYOND  0.02
#define BLANK   2.5
#define BLANK_LEAST 0.08        /* of the sides */
#define BLANK_LOOKS 20
#define TURN_PAYS 0.2
#define TURNS   90              /* that are tried for the rectangle */

typedef double point[ENGINE_AXES];


// The plane, and the rectangle in it
// ----------------------------------

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double unit(double a[3])
{
    const double length = sqrt(dot(a, a));

    for (int i = 0; i < 3; i++)
        a[i] = length > 0 ? a[i] / length : 0;
    return length;
}

/* The plane through the mean across which the points reach least: A = sum of x x^T; powers of its
 * adjugate turn any vector to that of the smallest eigenvalue. False if they lie on a line. */
static bool find_normal(const scatter_fit *f, const point mean, double out[3])
{
    double a[3][3] = { { 0 } }, adjugate[3][3], scale = 0;

    for (size_t k = 0; k < f->count; k++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                a[i][j] += (f->p[k][i] - mean[i]) * (f->p[k][j] - mean[j]);
    for (int i = 0; i < 3; i++)
        cross(a[(i + 1) % 3], a[(i + 2) % 3], adjugate[i]);
    for (int i = 0; i < 3; i++)
        scale += adjugate[i][i];
    const double size = a[0][0] + a[1][1] + a[2][2];
    if (!(scale > 1e-12 * size * size))
        return false;
    for (int round = 0; round < 40; round++) {      /* the 2^40th power */
        double next[3][3], trace = 0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                next[i][j] = 0;
                for (int k = 0; k < 3; k++)
                    next[i][j] += adjugate[i][k] * adjugate[k][j] / scale / scale;
            }
        for (int i = 0; i < 3; i++)
            trace += next[i][i];
        memcpy(adjugate, next, sizeof next);
        scale = trace;
    }
    int longest = 0;
    for (int i = 1; i < 3; i++)
        longest = adjugate[i][i] > adjugate[longest][longest] ? i : longest;
    memcpy(out, adjugate[longest], 3 * sizeof *out);
    return unit(out) > 0;
}

/* The directions of the rectangle: along the axes where no turn is smaller by TURN_PAYS. A round
 * cloud has no direction of its own, and turned corners leave its box. */
static void find_rectangle(const scatter_fit *f, const double normal[3], double side[2][3])
{
    double base[2][3] = { { 0 } }, best = INFINITY;
    int across = 0;

    for (int i = 1; i < 3; i++)
        across = fabs(normal[i]) < fabs(normal[across]) ? i : across;
    across = fabs(normal[2]) > 0.7 ? 0 : across;
    base[0][across] = 1;
    for (int i = 0; i < 3; i++)
        base[0][i] -= normal[across] * normal[i];
    unit(base[0]);
    cross(normal, base[0], base[1]);
    for (int turn = 0; turn < TURNS; turn++) {
        const double a = turn * acos(-1) / 2 / TURNS;
        double now[2][3], area = 1;
        for (int i = 0; i < 3; i++) {
            now[0][i] = cos(a) * base[0][i] + sin(a) * base[1][i];
            now[1][i] = cos(a) * base[1][i] - sin(a) * base[0][i];
        }
        for (int axis = 0; axis < 2; axis++) {
            double low = INFINITY, high = -INFINITY;
            for (size_t k = 0; k < f->count; k++) {
                low = fmin(low, dot(f->p[k], now[axis]));
                high = fmax(high, dot(f->p[k], now[axis]));
            }
            area *= high - low;
        }
        if (turn == 0 || area < best) {
            best = turn == 0 ? (1 - TURN_PAYS) * area : area;
            memcpy(side, now, sizeof now);
        }
    }
}

static bool set_parameters(scatter_fit *f)
{
    double normal[3], side[2][3];
    point mean = { 0 };

    for (size_t k = 0; k < f->count; k++)
        for (int i = 0; i < 3; i++)
            mean[i] += f->p[k][i] / (double)f->count;
    if (!find_normal(f, mean, normal))
        return false;
    if (normal[2] < 0)
        for (int i = 0; i < 3; i++)
            normal[i] = -normal[i];
    find_rectangle(f, normal, side);
    memcpy(f->frame, side, sizeof side);
    memcpy(f->frame[2], normal, sizeof normal);
    for (int axis = 0; axis < 2; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t k = 0; k < f->count; k++) {
            f->at[k][axis] = dot(f->p[k], side[axis]);
            low = fmin(low, f->at[k][axis]);
            high = fmax(high, f->at[k][axis]);
        }
        if (!(high > low))
            return false;
        for (size_t k = 0; k < f->count; k++)
            f->at[k][axis] = (f->at[k][axis] - low) / (high - low);
    }
    return true;
}


// One net
// -------

typedef struct {
    const engine *e;
    engine_basis *basis[2];
    point *net, *place;         /* place[count] */
} room;

static engine_net_fit given(const scatter_fit *f)
{
    const engine_net_fit all = {
        f->p,     (const double(*)[2])f->at,      { f->knot[0], f->knot[1] },
        f->count, { f->points[0], f->points[1] }, { f->degree[0], f->degree[1] }
    };
    return all;
}

static int find_basis(const scatter_fit *f, room *r)
{
    const engine_net_fit all = given(f);
    int status = LOFT_OK;

    for (int axis = 0; axis < 2 && status == LOFT_OK; axis++)
        status = r->e->fit_basis(&all, axis, r->basis[axis]);
    return status;
}

/* Whatever the order of the points. */
static size_t fold_of(const double p[3])
{
    uint64_t mixed = 0, bits;

    for (int axis = 0; axis < 3; axis++) {
        memcpy(&bits, &p[axis], sizeof bits);
        mixed = ((mixed ^ bits) * 0x9e3779b97f4a7c15u) ^ (mixed >> 29);
    }
    return (size_t)(mixed >> 61) % FOLDS;
}

/* The control points for these parameters, without the points of fold `left`; how many of them no
 * point determines. */
static size_t solve(const scatter_fit *f, room *r, size_t left)
{
    const size_t rows = f->count, columns = (size_t)f->points[0] * f->points[1];
    long double *const a = memory_grow(NULL, (columns + 3) * rows * sizeof *a);
    long double *const x = memory_grow(NULL, 3 * columns * sizeof *x);

    memset(a, 0, columns * rows * sizeof *a);
    for (size_t k = 0; k < rows; k++) {
        const engine_basis *u = &r->basis[0][k], *v = &r->basis[1][k];
        if (fold_of(f->p[k]) == left) {     /* an equation 0 = 0 */
            for (int axis = 0; axis < 3; axis++)
                a[(columns + (size_t)axis) * rows + k] = 0;
            continue;
        }
        for (unsigned i = 0; i <= f->degree[0]; i++)
            for (unsigned j = 0; j <= f->degree[1]; j++)
                a[((u->first + i) * f->points[1] + v->first + j) * rows + k] =
                    (long double)u->value[i] * v->value[j];
        for (int axis = 0; axis < 3; axis++)
            a[(columns + (size_t)axis) * rows + k] = f->p[k][axis];
    }
    const size_t used = least_squares(a, rows, columns, 3, SHARE, x);
    for (size_t k = 0; k < columns; k++)
        for (int axis = 0; axis < 3; axis++)
            r->net[k][axis] = (double)x[(size_t)axis * columns + k];
    free(a);
    free(x);
    return columns - used;
}

/* The place of point k less the point, and its derivatives. */
static void look(const scatter_fit *f, const room *r, size_t k, double off[3], double slope[2][3])
{
    const engine_basis *u = &r->basis[0][k], *v = &r->basis[1][k];

    for (int axis = 0; axis < 3; axis++) {
        off[axis] = -f->p[k][axis];
        slope[0][axis] = slope[1][axis] = 0;
    }
    for (unsigned i = 0; i <= f->degree[0]; i++)
        for (unsigned j = 0; j <= f->degree[1]; j++) {
            const double *p = r->net[(u->first + i) * f->points[1] + v->first + j];
            for (int axis = 0; axis < 3; axis++) {
                off[axis] += u->value[i] * v->value[j] * p[axis];
                slope[0][axis] += u->slope[i] * v->value[j] * p[axis];
                slope[1][axis] += u->value[i] * v->slope[j] * p[axis];
            }
        }
}

/* The step that Gauss and Newton's method takes; along a border where it would leave. */
static void find_step(const double at[2], const double off[3], const double slope[2][3],
                      double step[2])
{
    const double a = dot(slope[0], slope[0]), b = dot(slope[0], slope[1]),
                 c = dot(slope[1], slope[1]), p = dot(slope[0], off), q = dot(slope[1], off),
                 det = a * c - b * b;

    step[0] = det > 0 ? (b * q - c * p) / det : 0;
    step[1] = det > 0 ? (b * p - a * q) / det : 0;
    for (int axis = 0; axis < 2; axis++) {
        const double to = at[axis] + step[axis];
        if ((to < 0 && !(at[axis] > 0)) || (to > 1 && !(at[axis] < 1))) {
            step[axis] = 0;
            step[1 - axis] = axis == 0 ? (c > 0 ? -q / c : 0) : (a > 0 ? -p / a : 0);
        }
    }
}

/* Move all parameters to nearer places on the surface. */
static int project(scatter_fit *f, room *r)
{
    double (*const from)[2] = tool_grow(NULL, f->count * sizeof *from),
                  (*const step)[2] = tool_grow(NULL, f->count * sizeof *step),
           *const best = tool_grow(NULL, f->count * sizeof *best);
    int status = find_basis(f, r);

    for (int round = 0; round < STEPS && status == LOFT_OK; round++) {
        for (size_t k = 0; k < f->count; k++) {
            double off[3], slope[2][3];
            look(f, r, k, off, slope);
            best[k] = dot(off, off);
            memcpy(from[k], f->at[k], sizeof from[k]);
            find_step(from[k], off, (const double(*)[3])slope, step[k]);
        }
        for (int half = 0; half <= HALVES && status == LOFT_OK; half++) {
            for (size_t k = 0; k < f->count; k++)
                for (int axis = 0; axis < 2; axis++)
                    f->at[k][axis] = fmin(fmax(from[k][axis] + step[k][axis], 0), 1);
            status = find_basis(f, r);
            for (size_t k = 0; k < f->count && status == LOFT_OK; k++) {
                double off[3], slope[2][3];
                look(f, r, k, off, slope);
                const bool nearer = dot(off, off) < best[k];
                for (int axis = 0; axis < 2; axis++)
                    step[k][axis] *= nearer ? 1 : half + 1 < HALVES ? 0.5 : 0;
            }
        }
    }
    free(from);
    free(step);
    free(best);
    return status;
}

static void set_knots(scatter_fit *f)
{
    for (int axis = 0; axis < 2; axis++) {
        const unsigned n = f->points[axis], p = f->degree[axis], spans = n - p;
        f->knot[axis] = tool_grow(f->knot[axis], (n + p + 1) * sizeof *f->knot[axis]);
        for (unsigned k = 0; k <= n + p; k++)
            f->knot[axis][k] = k <= p ? 0 : k >= n ? 1 : (k - p) / (double)spans;
    }
}

/* The net with these numbers of points, and `off` of it. LOFT_SINGULAR: some are loose. */
static int fit_once(scatter_fit *f, room *r)
{
    const size_t bytes = (size_t)f->points[0] * f->points[1] * sizeof *f->net;
    int status = LOFT_OK;

    r->net = tool_grow(r->net, bytes);
    set_knots(f);
    f->off = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        double off = 0;
        status = find_basis(f, r);
        if (status == LOFT_OK) {
            f->loose = (unsigned)solve(f, r, FOLDS);
            status = f->loose > 0 ? LOFT_SINGULAR : project(f, r);
            if (f->loose > 0 && f->off < INFINITY)
                return LOFT_OK;         /* the round before had none */
        }
        const engine_net_fit all = given(f);
        if (status == LOFT_OK)
            status = r->e->fit_places(&all, (const double(*)[ENGINE_AXES])r->net, r->place);
        for (size_t k = 0; k < f->count && status == LOFT_OK; k++)
            off = fmax(off, space_distance(r->place[k], f->p[k]));
        if (status != LOFT_OK)
            return status;
        const bool better = off < f->off, pays = off < 0.95 * f->off;
        if (better) {
            f->off = off;
            f->net = tool_grow(f->net, bytes);
            memcpy(f->net, r->net, bytes);
        }
        if (!pays)
            break;
    }
    return LOFT_OK;
}

/* Of points that a net has not seen: the root of the mean square of their distance from it. */
static double predicted_off(const scatter_fit *f, room *r)
{
    double sum = 0;

    for (size_t left = 0; left < FOLDS; left++) {
        solve(f, r, left);
        for (size_t k = 0; k < f->count; k++) {
            if (fold_of(f->p[k]) != left)
                continue;
            double off[3], slope[2][3];
            look(f, r, k, off, slope);
            sum += dot(off, off);
        }
    }
    return sqrt(sum / (double)f->count);
}

/* How far the surface leaves the box of the points, BEYOND of the diagonal apart. */
static int find_excess(const scatter_fit *f, room *r, double *out)
{
    const size_t across = LOOKS * (f->points[0] - f->degree[0]) + 1,
                 along = LOOKS * (f->points[1] - f->degree[1]) + 1;
    double (*const at)[2] = tool_grow(NULL, across * along * sizeof *at),
                  (*const place)[ENGINE_AXES] = tool_grow(NULL, across * along * sizeof *place);
    engine_net_fit all = given(f);
    double diagonal = 0;

    for (size_t k = 0; k < across * along; k++) {
        at[k][0] = (double)(k / along) / (double)(across - 1);
        at[k][1] = (double)(k % along) / (double)(along - 1);
    }
    all.at = (const double(*)[2])at;
    all.count = across * along;
    const int status = r->e->fit_places(&all, (const double(*)[ENGINE_AXES])f->net, place);
    *out = 0;
    for (int axis = 0; axis < 3 && status == LOFT_OK; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t k = 0; k < f->count; k++) {
            low = fmin(low, dot(f->p[k], f->frame[axis]));
            high = fmax(high, dot(f->p[k], f->frame[axis]));
        }
        diagonal = hypot(diagonal, high - low);
        for (size_t k = 0; k < all.count; k++) {
            const double x = dot(place[k], f->frame[axis]);
            *out = fmax(*out, fmax(low - x, x - high));
        }
    }
    *out = fmax(*out - BEYOND * diagonal, 0);
    free(at);
    free(place);
    return status;
}

/* The place in the rectangle that is farthest from all points, if that is far. */
static bool find_blank(const scatter_fit *f, double at[2])
{
    double most = fmax(BLANK / sqrt((double)f->count), BLANK_LEAST);
    bool found  = false;

    for (int i = 0; i <= BLANK_LOOKS; i++)
        for (int j = 0; j <= BLANK_LOOKS; j++) {
            const double look[2] = { i / (double)BLANK_LOOKS, j / (double)BLANK_LOOKS };
            double least = INFINITY;
            for (size_t k = 0; k < f->count && least > most; k++)
                least = fmin(least, hypot(f->at[k][0] - look[0], f->at[k][1] - look[1]));
            if (least > most) {
                found = true;
                most  = least;
                memcpy(at, look, sizeof look);
            }
        }
    return found;
}

/* Where the points do not tell the surface, and how far from it the nearest one is. */
static int set_blank(scatter_fit *f, const engine *e)
{
    double at[1][2];
    point place[1];
    engine_net_fit all = given(f);

    f->blank = 0;
    if (!find_blank(f, at[0]))
        return LOFT_OK;
    all.at = (const double(*)[2])at;
    all.count = 1;
    const int status = e->fit_places(&all, (const double(*)[ENGINE_AXES])f->net, place);
    if (status == LOFT_OK) {
        memcpy(f->guessed, place[0], sizeof f->guessed);
        f->blank = INFINITY;
        for (size_t k = 0; k < f->count; k++)
            f->blank = fmin(f->blank, space_distance(f->p[k], place[0]));
    }
    return status;
}

/* More spans along both; false if they are too many. */
static bool refine(scatter_fit *f)
{
    unsigned to[2];

    for (int axis = 0; axis < 2; axis++) {
        const unsigned spans = f->points[axis] - f->degree[axis];
        to[axis] = spans + (spans + 1) / 2 + f->degree[axis];
    }
    if (2 * (size_t)to[0] * to[1] > f->count || to[0] * to[1] > SCATTER_CONTROLS)
        return false;
    f->points[0] = to[0];
    f->points[1] = to[1];
    return true;
}

int scatter_fit_make(scatter_fit *f, const engine *e, unsigned degree, double tol)
{
    room r = { .e = e };
    int status = LOFT_OK;

    f->at = tool_grow(NULL, f->count * sizeof *f->at);
    if (!set_parameters(f))
        return LOFT_SINGULAR;
    while (degree > 1 && 2 * (size_t)(degree + 1) * (degree + 1) > f->count)
        degree--;
    for (int axis = 0; axis < 2; axis++) {
        f->degree[axis] = degree;
        f->points[axis] = degree + 1;
        r.basis[axis] = tool_grow(NULL, f->count * sizeof *r.basis[axis]);
    }
    r.place = tool_grow(NULL, f->count * sizeof *r.place);
    f->enough = INFINITY;
    do {
        status = fit_once(f, &r);
        double excess = 0;
        if (status == LOFT_OK)
            status = find_excess(f, &r, &excess);
        if (status == LOFT_OK) {
            const double need = fmax(fmax(f->off, predicted_off(f, &r) / PREDICTED),
                                     excess / SLACK);
            if (need < f->enough) {
                f->enough = need;
                memcpy(f->best, f->points, sizeof f->best);
            }
        }
    } while (status == LOFT_OK && !(f->enough <= tol) && refine(f));
    if (status == LOFT_SINGULAR && f->enough < INFINITY)
        status = LOFT_OK;
    if (status == LOFT_OK && f->enough <= tol)
        status = set_blank(f, e);
    free(r.basis[0]);
    free(r.basis[1]);
    free(r.net);
    free(r.place);
    return status;
}

void scatter_fit_free(scatter_fit *f)
{
    free(f->at);
    free(f->knot[0]);
    free(f->knot[1]);
    free(f->net);
}
