/* lib/surface/surface.c
 * SPDX-License-Identifier: MIT
 */
#include "surface/surface.h"
#include "num/angle.h"          /* LOFT_FINE_PI */
#include "num/explog.h"         /* loft_sci_from_fine */

static enum loft_status tensor_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    *out = loft_tensor_eval((const loft_tensor *)surface, u, v);
    return LOFT_OK;
}

static enum loft_status tensor_rational_at(const void *surface, loft_unit u, loft_unit v,
                                           loft_vec *out)
{
    *out = loft_tensor_rational_eval((const loft_tensor_rational *)surface, u, v);
    return LOFT_OK;
}

static enum loft_status triangle_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    const loft_bary at = { u, v };

    *out = loft_triangle_eval((const loft_triangle *)surface, at);
    return LOFT_OK;
}

static enum loft_status triangle_rational_at(const void *surface, loft_unit u, loft_unit v,
                                             loft_vec *out)
{
    const loft_bary at = { u, v };

    *out = loft_triangle_rational_eval((const loft_triangle_rational *)surface, at);
    return LOFT_OK;
}

static enum loft_status bicubic_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_bicubic_eval((const loft_bicubic *)surface, u, v, out);
}

static enum loft_status coons_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_coons_bezier_eval((const loft_coons_bezier *)surface, u, v, out);
}

static enum loft_status sphere_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_sphere_eval((const loft_sphere *)surface, loft_lerp(0, LOFT_REAL(360), v),
                            loft_lerp(0, LOFT_REAL(180), u), out);
}

static enum loft_status tensor_slopes(const void *surface, loft_unit u, loft_unit v,
                                      loft_differential *out)
{
    return loft_tensor_differential((const loft_tensor *)surface, u, v, out);
}

static enum loft_status tensor_rational_slopes(const void *surface, loft_unit u, loft_unit v,
                                               loft_differential *out)
{
    return loft_tensor_rational_differential((const loft_tensor_rational *)surface, u, v, out);
}

static enum loft_status triangle_slopes(const void *surface, loft_unit u, loft_unit v,
                                        loft_differential *out)
{
    const loft_bary at = { u, v };
    return loft_triangle_differential((const loft_triangle *)surface, loft_bary_clamp(at), out);
}

static enum loft_status triangle_rational_slopes(const void *surface, loft_unit u, loft_unit v,
                                                 loft_differential *out)
{
    const loft_bary at = { u, v };
    return loft_triangle_rational_differential((const loft_triangle_rational *)surface,
                                               loft_bary_clamp(at), out);
}

static enum loft_status bicubic_slopes(const void *surface, loft_unit u, loft_unit v,
                                       loft_differential *out)
{
    loft_vec net[16];
    loft_tensor tensor;
    enum loft_status status = loft_tensor_from_bicubic((const loft_bicubic *)surface, net);

    if (status == LOFT_OK)
        status = loft_tensor_init(&tensor, net, 3, 3);
    return status == LOFT_OK ? loft_tensor_differential(&tensor, u, v, out) : status;
}

/* By u and v, which are shares of 180 and 360 degrees. */
static enum loft_status sphere_slopes(const void *surface, loft_unit u, loft_unit v,
                                      loft_differential *out)
{
    const loft_sci pi = loft_sci_from_fine(LOFT_FINE_PI), two_pi = loft_sci_add(pi, pi);
    const enum loft_status status = loft_sphere_differential((const loft_sphere *)surface,
                                                             loft_lerp(0, LOFT_REAL(360), v),
                                                             loft_lerp(0, LOFT_REAL(180), u), out);

    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        out->u[i]  = loft_sci_mul(pi, out->u[i]);
        out->v[i]  = loft_sci_mul(two_pi, out->v[i]);
        out->uu[i] = loft_sci_mul(pi, loft_sci_mul(pi, out->uu[i]));
        out->uv[i] = loft_sci_mul(pi, loft_sci_mul(two_pi, out->uv[i]));
        out->vv[i] = loft_sci_mul(two_pi, loft_sci_mul(two_pi, out->vv[i]));
    }
    if (status == LOFT_OK) {
        out->width_u = loft_sci_mul(pi, out->width_u);
        out->width_v = loft_sci_mul(two_pi, out->width_v);
    }
    return status;
}

static enum loft_status coons_slopes(const void *surface, loft_unit u, loft_unit v,
                                     loft_differential *out)
{
    return loft_coons_bezier_differential((const loft_coons_bezier *)surface, u, v, out);
}

loft_surface loft_surface_from_tensor(const loft_tensor *s)
{
    const loft_surface made = { tensor_at, s, LOFT_SURFACE_SQUARE, tensor_slopes };
    return made;
}
loft_surface loft_surface_from_tensor_rational(const loft_tensor_rational *s)
{
    const loft_surface made = { tensor_rational_at, s, LOFT_SURFACE_SQUARE,
                                tensor_rational_slopes };
    return made;
}
loft_surface loft_surface_from_triangle(const loft_triangle *s)
{
    const loft_surface made = { triangle_at, s, LOFT_SURFACE_TRIANGLE, triangle_slopes };
    return made;
}
loft_surface loft_surface_from_triangle_rational(const loft_triangle_rational *s)
{
    const loft_surface made = { triangle_rational_at, s, LOFT_SURFACE_TRIANGLE,
                                triangle_rational_slopes };
    return made;
}
loft_surface loft_surface_from_bicubic(const loft_bicubic *s)
{
    const loft_surface made = { bicubic_at, s, LOFT_SURFACE_SQUARE, bicubic_slopes };
    return made;
}
loft_surface loft_surface_from_coons(const loft_coons_bezier *s)
{
    const loft_surface made = { coons_at, s, LOFT_SURFACE_SQUARE, coons_slopes };
    return made;
}
loft_surface loft_surface_from_sphere(const loft_sphere *s)
{
    const loft_surface made = { sphere_at, s, LOFT_SURFACE_DISK, sphere_slopes };
    return made;
}

/* Lines */

static bool domain_holds(const loft_surface *s, const loft_unit at[2])
{
    for (int i = 0; i < 2; i++)
        if (!(at[i] >= 0 && at[i] <= LOFT_UNIT(1)))
            return false;
    return s->over != LOFT_SURFACE_TRIANGLE || at[1] <= LOFT_UNIT(1) - at[0];
}

enum loft_status loft_trace_init(loft_trace *w, loft_surface surface, loft_unit u0, loft_unit v0,
                                 loft_unit u1, loft_unit v1, uint32_t n)
{
    const loft_trace start = { surface, { u0, v0 }, { u1, v1 }, n, 0 };
    loft_vec p;

    if (n < 1 || !domain_holds(&surface, start.from) || !domain_holds(&surface, start.to))
        return LOFT_ERR_ARG;
    enum loft_status status = surface.eval(surface.surface, u0, v0, &p);
    if (status == LOFT_OK)
        status = surface.eval(surface.surface, u1, v1, &p);
    if (status == LOFT_OK)
        *w = start;
    return status;
}

bool loft_trace_next(loft_trace *w, loft_vec *out)
{
    while (w->at <= w->n) {
        loft_unit at[2];
        for (int i = 0; i < 2; i++)
            at[i] = loft_unit_round(loft_acc_lerp_at(loft_unit_to_acc(w->from[i]),
                                                     loft_unit_to_acc(w->to[i]), w->at, w->n));
        w->at++;
        if (w->surface.eval(w->surface.surface, at[0], at[1], out) == LOFT_OK)
            return true;
    }
    return false;
}
