/* host-tools/make/engine_thin.c -- B-splines without the knots that they do not need, and with
 * more; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "curve/knot_removal.h"     /* loft_bspline_remove */

#include "base/tool.h"              /* tool_grow */
#include "make/engine_parts.h"

/* A curve, and what it becomes without one knot: the last tried, the best. Points, with weights or
 * without. */
typedef struct {
    bool weighted;
    loft_vec *p[3];
    loft_weighted *w[3];
    loft_real *k[3];
    unsigned points, degree;
} thinning;

static void swap_sides(thinning *x, int a, int b)
{
    loft_vec *const p = x->p[a];
    loft_weighted *const w = x->w[a];
    loft_real *const k = x->k[a];

    x->p[a] = x->p[b];
    x->w[a] = x->w[b];
    x->k[a] = x->k[b];
    x->p[b] = p;
    x->w[b] = w;
    x->k[b] = k;
}

static int without_knot(thinning *x, unsigned knot, loft_acc *distance)
{
    loft_bspline b;
    loft_nurbs n;
    int status = x->weighted ? loft_nurbs_init(&n, x->w[0], x->points, x->k[0], x->degree)
                             : loft_bspline_init(&b, x->p[0], x->points, x->k[0], x->degree);

    if (status == LOFT_OK)
        status = x->weighted ? loft_nurbs_remove(&n, knot, x->w[1], x->k[1], distance)
                             : loft_bspline_remove(&b, knot, x->p[1], x->k[1], distance);
    return status;
}

/* Remove the knot that moves the curve least, if by no more than `left`; *far is how much. */
static bool remove_least(thinning *x, double left, double *far)
{
    bool found = false;

    for (unsigned knot = x->degree + 1; knot < x->points; knot++) {
        loft_acc distance;
        if (without_knot(x, knot, &distance) != LOFT_OK ||
            double_of_acc(distance) > (found ? *far : left))
            continue;
        *far = double_of_acc(distance);
        found = true;
        swap_sides(x, 1, 2);
    }
    if (found) {
        swap_sides(x, 0, 2);
        x->points--;
    }
    return found;
}

static void write_spline(const decide_input *in, const thinning *x, double far)
{
    const print_options options = { in->e, in->curves->solid };
    const unsigned knots = x->points + x->degree + 1;

    printf("%s %u\n", x->weighted ? "nurbs" : "bspline", x->degree);
    for (unsigned k = 0; k < x->points; k++) {
        double point[ENGINE_AXES];
        point_of(x->weighted ? x->w[0][k].p : x->p[0][k], point);
        print_words(&options, point);
        if (x->weighted) {
            fputs(" : ", stdout);
            print_number(in->e, double_of(x->w[0][k].w));
        }
        putchar('\n');
    }
    for (unsigned k = 0; k < knots; k++)
        print_knot(in->e, "knots", double_of(x->k[0][k]), k, knots);
    if (far >= 0)
        printf("# within %s\n", text_of(far));
}

static int read_spline(const curve *c, thinning *x)
{
    for (unsigned i = 0; i < c->count; i++) {
        if (!vec_of(c->point[i].p, &x->p[0][i]) ||
            (x->weighted && !real_of(c->point[i].w, &x->w[0][i].w)))
            return LOFT_ERR_RANGE;
        x->w[0][i].p = x->p[0][i];
    }
    for (unsigned i = 0; i < c->knot_count; i++)
        if (!real_of(c->knot[i], &x->k[0][i]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* A curve with room for so many more points. */
static int open_spline(const decide_input *in, const curve *c, unsigned more, thinning *x)
{
    *x = (thinning){ .weighted = curve_is_rational(c), .points = c->count, .degree = c->degree };
    if (!curve_has_knots(c))
        return decide_refuse(in, "a curve is no `bspline` and no `nurbs`: give curves with knots");
    if (c->knot_count != c->count + c->degree + 1)
        return decide_refuse(in, "a B-spline has no knots: give as many as points + degree + 1");
    for (int i = 0; i < 3; i++) {
        x->p[i] = tool_grow(NULL, (c->count + more) * sizeof *x->p[i]);
        x->w[i] = tool_grow(NULL, (c->count + more) * sizeof *x->w[i]);
        x->k[i] = tool_grow(NULL, (c->knot_count + more) * sizeof *x->k[i]);
    }
    return read_spline(c, x);
}

static void close_spline(thinning *x)
{
    for (int i = 0; i < 3; i++) {
        free(x->p[i]);
        free(x->w[i]);
        free(x->k[i]);
    }
}

/* Knots go one by one, as long as the sum of their distances is within the tolerance. */
static int thin_curve(const decide_input *in, const curve *c)
{
    double sum = 0, far = 0;
    thinning x;
    const int status = open_spline(in, c, 0, &x);

    while (status == LOFT_OK && remove_least(&x, in->of->value[0] - sum, &far))
        sum += far;
    if (status == LOFT_OK)
        write_spline(in, &x, sum);
    close_spline(&x);
    return status;
}

int ENGINE_OF(make_thin)(const decide_input *in)
{
    int status = in->of->value[0] >= 0 ? LOFT_OK
                                       : decide_refuse(in, "give a tolerance of 0 or more");

    for (size_t c = 0; c < in->curves->count && status == LOFT_OK; c++)
        status = thin_curve(in, &in->curves->curve[c]);
    return status;
}

static int insert_knot(const decide_input *in, thinning *x, double at)
{
    loft_bspline b;
    loft_nurbs n;
    loft_real u;
    int status = !real_of(at, &u) ? LOFT_ERR_RANGE
                 : x->weighted    ? (int)loft_nurbs_init(&n, x->w[0], x->points, x->k[0], x->degree)
                               : (int)loft_bspline_init(&b, x->p[0], x->points, x->k[0], x->degree);

    if (status == LOFT_OK)
        status = x->weighted ? loft_nurbs_insert(&n, u, x->w[0], x->k[0])
                             : loft_bspline_insert(&b, u, x->p[0], x->k[0]);
    if (status == LOFT_ERR_ARG)
        return decide_refuse(in, "a knot beyond the curve, or there as often as the degree and one "
                                 "more: give others");
    x->points += status == LOFT_OK;
    return status;
}

/* The same curves with more knots. */
int ENGINE_OF(make_insert)(const decide_input *in)
{
    int status = LOFT_OK;

    for (size_t c = 0; c < in->curves->count && status == LOFT_OK; c++) {
        thinning x;
        status = open_spline(in, &in->curves->curve[c], (unsigned)in->of->count, &x);
        for (size_t k = 0; k < in->of->count && status == LOFT_OK; k++)
            status = insert_knot(in, &x, in->of->value[k]);
        if (status == LOFT_OK)
            write_spline(in, &x, -1);
        close_spline(&x);
    }
    return status;
}
