/* host-tools/geometry/drawn_surface.c
 * SPDX-License-Identifier: MIT
 *
 * De Casteljau's algorithm on coordinates times the weight, and the weight. Its last rows give the
 * derivatives. With N the coordinates and W the weight, N = W P gives those of P:
 *
 *     P_u = (N_u - W_u P) / W        P_uv = (N_uv - W_u P_v - W_v P_u - W_uv P) / W
 *
 * An error of a point is below 64 roundings of the largest coordinate, without weights.
 */
#include <math.h>
#include <string.h>

#include "num/status.h"     /* enum loft_status */

#include "geometry/drawn_surface.h"

#define WIDE (SURFACE_AXES + 1)
#define MOST (SURFACE_DRAWN_MAX + 1)

/* The point, its derivatives by u, v, uu, uv and vv. */
enum { AT, BY_U, BY_V, BY_UU, BY_UV, BY_VV, JET };

typedef struct {
    double x[WIDE];
} lifted;

static lifted lift(const surface_point *p)
{
    lifted l;

    for (int i = 0; i < SURFACE_AXES; i++)
        l.x[i] = p->p[i] * p->w;
    l.x[SURFACE_AXES] = p->w;
    return l;
}

static lifted mean(double a, lifted p, double b, lifted q, double c, lifted r)
{
    lifted l;

    for (int i = 0; i < WIDE; i++)
        l.x[i] = a * p.x[i] + b * q.x[i] + c * r.x[i];
    return l;
}


// Tensor products
// ---------------

/* The point of a curve and two derivatives; c[degree + 1] is used up. */
static void curve_jet(lifted c[], unsigned degree, double t, lifted out[3])
{
    const double n = degree;
    unsigned k = degree;

    memset(out, 0, 3 * sizeof *out);
    for (; k > 0; k--) {
        if (k == 2)
            out[2] = mean(n * (n - 1), c[0], -2 * n * (n - 1), c[1], n * (n - 1), c[2]);
        if (k == 1)
            out[1] = mean(-n, c[0], n, c[1], 0, c[0]);
        for (unsigned j = 0; j < k; j++)
            c[j] = mean(1 - t, c[j], t, c[j + 1], 0, c[j]);
    }
    out[0] = c[0];
}

static void tensor_jet(const surface *s, double u, double v, lifted out[JET])
{
    lifted line[MOST], along[3][MOST], jet[3];

    for (unsigned i = 0; i <= s->m; i++) {
        for (unsigned j = 0; j <= s->n; j++)
            line[j] = lift(&s->point[i * (s->n + 1) + j]);
        curve_jet(line, s->n, v, jet);
        for (int k = 0; k < 3; k++)
            along[k][i] = jet[k];
    }
    curve_jet(along[0], s->m, u, jet);
    out[AT]    = jet[0];
    out[BY_U]  = jet[1];
    out[BY_UU] = jet[2];
    curve_jet(along[1], s->m, u, jet);
    out[BY_V]  = jet[0];
    out[BY_UV] = jet[1];
    curve_jet(along[2], s->m, u, jet);
    out[BY_VV] = jet[0];
}


// Triangles
// ---------

static void triangle_jet(const surface *s, double u, double v, lifted out[JET])
{
    const double n = s->m, w = 1 - u - v, f = n * (n - 1);
    lifted c[MOST * (MOST + 1) / 2];

    for (unsigned k = 0; k < s->count; k++)
        c[k] = lift(&s->point[k]);
    for (unsigned d = s->m; d > 0; d--) {
        if (d == 2) {
            out[BY_UU] = mean(f, c[0], -2 * f, c[1], f, c[3]);
            out[BY_UV] = mean(f, c[0], f, c[4], -f, mean(1, c[1], 1, c[2], 0, c[0]));
            out[BY_VV] = mean(f, c[0], -2 * f, c[2], f, c[5]);
        }
        if (d == 1) {
            out[BY_U] = mean(-n, c[0], n, c[1], 0, c[0]);
            out[BY_V] = mean(-n, c[0], n, c[2], 0, c[0]);
        }
        for (unsigned m = 0, p = 0; m < d; m++)
            for (unsigned k = 0; k <= m; k++, p++)
                c[p] = mean(w, c[p], u, c[p + m + 1], v, c[p + m + 2]);
    }
    out[AT] = c[0];
}


// Normals and curvatures
// ----------------------

static double dot(const double a[SURFACE_AXES], const double b[SURFACE_AXES])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void project(const lifted jet[JET], double d[JET][SURFACE_AXES])
{
    const double w = jet[AT].x[SURFACE_AXES], wu = jet[BY_U].x[SURFACE_AXES],
                 wv = jet[BY_V].x[SURFACE_AXES];

    for (int i = 0; i < SURFACE_AXES; i++) {
        const double p = jet[AT].x[i] / w, pu = (jet[BY_U].x[i] - wu * p) / w,
                     pv = (jet[BY_V].x[i] - wv * p) / w;
        d[AT][i]    = p;
        d[BY_U][i]  = pu;
        d[BY_V][i]  = pv;
        d[BY_UU][i] = (jet[BY_UU].x[i] - 2 * wu * pu - jet[BY_UU].x[SURFACE_AXES] * p) / w;
        d[BY_UV][i] = (jet[BY_UV].x[i] - wu * pv - wv * pu - jet[BY_UV].x[SURFACE_AXES] * p) / w;
        d[BY_VV][i] = (jet[BY_VV].x[i] - 2 * wv * pv - jet[BY_VV].x[SURFACE_AXES] * p) / w;
    }
}

static int look_of(double d[JET][SURFACE_AXES], engine_look *out)
{
    const double *u = d[BY_U], *v = d[BY_V], e = dot(u, u), f = dot(u, v), g = dot(v, v);
    const double area = e * g - f * f;

    if (!(area > 0x1p-40 * e * g))
        return LOFT_SINGULAR;
    for (int i = 0; i < SURFACE_AXES; i++) {
        const int j = (i + 1) % SURFACE_AXES, k = (i + 2) % SURFACE_AXES;
        out->normal[i] = (u[j] * v[k] - u[k] * v[j]) / sqrt(area);
    }
    const double l = dot(d[BY_UU], out->normal), m = dot(d[BY_UV], out->normal),
                 n = dot(d[BY_VV], out->normal);
    out->gauss = (l * n - m * m) / area;
    out->mean  = (e * n - 2 * f * m + g * l) / (2 * area);
    return LOFT_OK;
}

int drawn_surface(const surface *s, double u, double v, double point[SURFACE_AXES],
                  engine_look *out)
{
    const bool triangle = s->kind == SURFACE_TRIANGLE;
    const double middle = triangle ? 1 / 3.0 : 0.5;
    int status = LOFT_SINGULAR;

    for (int moved = 0; moved < 2 && status != LOFT_OK; moved++) {
        const double share = moved ? 0x1p-20 : 0;
        lifted jet[JET];
        double d[JET][SURFACE_AXES];
        (triangle ? triangle_jet : tensor_jet)(s, u + share * (middle - u),
                                               v + share * (middle - v), jet);
        project(jet, d);
        if (!moved)
            memcpy(point, d[AT], sizeof d[AT]);
        status = look_of(d, out);
    }
    return status;
}
