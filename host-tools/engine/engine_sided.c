/* host-tools/engine/engine_sided.c -- surfaces with n sides through the library; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "polygon/basepoint.h"      /* loft_basepoint */
#include "polygon/gb.h"             /* loft_gb */
#include "polygon/meanvalue.h"      /* loft_meanvalue_eval */
#include "polygon/partition.h"      /* loft_partition */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball */
#include "polygon/disk.h"           /* loft_disk */
#include "polygon/spatch.h"         /* loft_spatch */
#include "polygon/toric.h"          /* loft_toric */
#include "polygon/wachspress.h"     /* loft_wachspress_eval */

#include "engine/engine_harmonic.h"     /* engine_harmonic_solve */
#include "engine/engine_num.h"          /* real_of, vec_of, point_of */
#include "engine/engine_sheet.h"        /* engine_sectors */
#include "engine/engine_sided.h"
#include "engine/engine_sided_patch.h"  /* struct engine_sided */
#include "base/tool.h"                  /* tool_grow */


// Open and close
// --------------

static void sided_close(engine_sided *e)
{
    engine_harmonic_free(e->harmonic);
    free(e->p);
    free(e->w);
    free(e->c);
    free(e);
}

static int hold_point(engine_sided *e, unsigned at, const surface_point *p)
{
    return vec_of(p->p, &e->p[at]) && real_of(p->w, &e->w[at]) && real_of(p->c, &e->c[at])
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

static int hold_points(engine_sided *e)
{
    int status = LOFT_OK;

    for (unsigned i = 0; i < e->s->count && status == LOFT_OK; i++)
        status = hold_point(e, i, &e->s->point[i]);
    return status;
}

static int prepare_domain(engine_sided *e)
{
    const surface *s = e->s;
    int status = hold_points(e);

    for (unsigned i = 0; i < s->n; i++)
        for (int k = 0; k < 2; k++)
            if (!real_of(s->domain[i][k], &e->v[i].at[k]))
                return LOFT_ERR_RANGE;
    if (status == LOFT_OK)
        status = loft_domain_init(&e->domain, e->v, s->n);
    if (status == LOFT_OK && !e->domain.convex && s->coordinates == COORDINATES_WACHSPRESS)
        status = LOFT_ERR_ARG;
    if (status == LOFT_OK && s->coordinates == COORDINATES_HARMONIC)
        status = engine_harmonic_solve(&e->domain, &e->harmonic);
    return status;
}

static int prepare_spatch(engine_sided *e)
{
    const int status = prepare_domain(e);
    return status ? status
                  : (int)loft_spatch_init(&e->as.spatch, e->p, e->s->rational ? e->w : NULL,
                                          e->s->n, e->s->m);
}

static int prepare_gb(engine_sided *e)
{
    const int status = prepare_domain(e);
    const loft_vec *split = e->p + loft_gb_count(e->s->n, e->s->m);

    if (status != LOFT_OK)
        return status;
    return e->s->split ? loft_gb_init_split(&e->as.gb, e->p, split, e->s->n, e->s->m)
                       : loft_gb_init(&e->as.gb, e->p, e->s->n, e->s->m);
}

static int prepare_toric(engine_sided *e)
{
    loft_whole v[SURFACE_SIDES_MAX];
    int status = hold_points(e);

    for (unsigned i = 0; i < e->s->n; i++)
        for (int k = 0; k < 2; k++)
            v[i].at[k] = (int8_t)e->s->domain[i][k];
    if (status == LOFT_OK)
        status = loft_lattice_polygon_init(&e->lattice, v, e->s->n);
    return status ? status : (int)loft_toric_init(&e->as.toric, &e->lattice, e->p, e->c, e->w);
}

/* Points that are cut off are not listed, and not read. */
static int prepare_basepoint(engine_sided *e)
{
    const surface *s = e->s;
    const uint8_t cut[3] = { (uint8_t)s->cut[0], (uint8_t)s->cut[1], (uint8_t)s->cut[2] };
    uint8_t l[3];
    unsigned rank = 0, kept = 0;
    int status = LOFT_OK;

    loft_multiindex_first(l, 3, s->m);
    do {
        if (l[0] + cut[0] <= s->m && l[1] + cut[1] <= s->m && l[2] + cut[2] <= s->m)
            status = hold_point(e, rank, &s->point[kept++]);
        rank++;
    } while (status == LOFT_OK && loft_multiindex_next(l, 3));
    return status ? status : (int)loft_basepoint_init(&e->as.basepoint, e->p, e->w, s->m, cut);
}

static int prepare_zheng_ball(engine_sided *e)
{
    const int status = hold_points(e);
    return status ? status : (int)loft_zheng_ball_init(&e->as.zheng_ball, e->p, e->s->n, e->s->m);
}

static int prepare_patch(engine_sided *e)
{
    switch (e->s->kind) {
    case SURFACE_SPATCH:    return prepare_spatch(e);
    case SURFACE_TORIC:     return prepare_toric(e);
    case SURFACE_BASEPOINT: return prepare_basepoint(e);
    case SURFACE_GB:        return prepare_gb(e);
    default:                return prepare_zheng_ball(e);
    }
}

static int sided_open(const surface *s, engine_sided **out)
{
    engine_sided *e = tool_grow(NULL, sizeof *e);
    const size_t room = s->kind == SURFACE_BASEPOINT ? loft_multiindex_count(3, s->m) : s->count;

    *e = (engine_sided){ .s = s };
    e->p = tool_grow(NULL, room * sizeof *e->p);
    e->w = tool_grow(NULL, room * sizeof *e->w);
    e->c = tool_grow(NULL, room * sizeof *e->c);
    const int status = prepare_patch(e);
    if (status != LOFT_OK)
        sided_close(e);
    else
        *out = e;
    return status;
}


// Points
// ------

static int place_spot(const engine_sided *e, sided_place at, loft_spot *out)
{
    double x[2];

    sided_spot(e->s, at, x);
    return real_of(x[0], &out->at[0]) && real_of(x[1], &out->at[1]) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* On a side, the two coordinates that are not 0 need no point. */
static int eval_coordinates(const engine_sided *e, sided_place at, loft_sci phi[])
{
    const unsigned after = (at.k + 1) % e->s->n;
    loft_spot p;

    if (at.how == SIDED_SIDE) {
        loft_domain_vertex(&e->domain, at.k, phi);
        phi[after] = loft_sci_from_unit(LOFT_UNIT(at.u));
        phi[at.k]  = loft_sci_sub(loft_sci_one(), phi[after]);
        return LOFT_OK;
    }
    int status = place_spot(e, at, &p);
    if (status != LOFT_OK)
        return status;
    switch (e->s->coordinates) {
    case COORDINATES_MEANVALUE: status = loft_meanvalue_eval(&e->domain, p, phi); break;
    case COORDINATES_HARMONIC:
        status = loft_harmonic_eval(engine_harmonic_of(e->harmonic), p, phi);
        break;
    default: status = loft_wachspress_eval(&e->domain, p, phi); break;
    }
    if (status == LOFT_ERR_RANGE && at.how == SIDED_WITHIN) {
        loft_domain_nearest(&e->domain, p, phi);
        status = LOFT_OK;
    }
    return status;
}

static int coordinate_jets(const engine_sided *e, loft_spot p, loft_jet phi[])
{
    switch (e->s->coordinates) {
    case COORDINATES_MEANVALUE: return loft_meanvalue_jet(&e->domain, p, phi);
    case COORDINATES_HARMONIC:  return loft_harmonic_jet(engine_harmonic_of(e->harmonic), p, phi);
    default:                    return loft_wachspress_jet(&e->domain, p, phi);
    }
}

static int eval_spatch(const engine_sided *e, sided_place at, loft_vec *out)
{
    loft_sci phi[SURFACE_SIDES_MAX];
    const int status = eval_coordinates(e, at, phi);

    return status ? status : (int)loft_spatch_eval(&e->as.spatch, phi, out);
}

static int eval_gb(const engine_sided *e, sided_place at, loft_vec *out)
{
    loft_sci phi[SURFACE_SIDES_MAX];
    const int status = eval_coordinates(e, at, phi);

    return status ? status : (int)loft_gb_eval(&e->as.gb, phi, out);
}

/* A rounded point of a side may lie outside: then it moves towards the middle. */
static int eval_toric(const engine_sided *e, sided_place at, loft_vec *out)
{
    const sided_place middle = sided_middle(e->s);
    loft_spot p;
    int status = place_spot(e, at, &p);

    if (status == LOFT_OK)
        status = loft_toric_eval(&e->as.toric, p, out);
    const bool moved = at.how == SIDED_SIDE;
    for (double share = 0x1p-52; status == LOFT_ERR_RANGE && moved && share < 0x1p-8; share *= 2) {
        double x[2];
        sided_spot(e->s, at, x);
        p.at[0] = LOFT_REAL(x[0] + share * (middle.u - x[0]));
        p.at[1] = LOFT_REAL(x[1] + share * (middle.v - x[1]));
        status = loft_toric_eval(&e->as.toric, p, out);
    }
    return status;
}

static int eval_basepoint(const engine_sided *e, sided_place at, loft_vec *out)
{
    if (at.how == SIDED_CORNER)
        return loft_basepoint_corner(&e->as.basepoint, at.k, LOFT_UNIT(at.u), LOFT_UNIT(at.v), out);
    return loft_basepoint_eval(&e->as.basepoint, LOFT_UNIT(at.u), LOFT_UNIT(at.v), out);
}

/* Parameters of a corner are those of its two sides; side k counts as the first. */
static unsigned corner_side(const engine_sided *e, sided_place at)
{
    return at.how == SIDED_CORNER ? at.k + e->s->n - 1 : 0;
}

static int eval_zheng_ball(const engine_sided *e, sided_place at, loft_vec *out)
{
    const unsigned n = e->s->n, first = corner_side(e, at);
    loft_sci turned[LOFT_ZHENG_BALL_SIDES], u[LOFT_ZHENG_BALL_SIDES];
    const int status = n == 3 && at.how == SIDED_CORNER
                           ? loft_zheng_ball_lift(LOFT_UNIT(at.u), LOFT_UNIT(at.v), turned)
                           : loft_zheng_ball_params(n, LOFT_UNIT(at.u), LOFT_UNIT(at.v), turned);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < n; i++)
        u[(first + i) % n] = turned[i];
    return loft_zheng_ball_eval(&e->as.zheng_ball, u, out);
}

static int sided_eval(const engine_sided *e, sided_place at, double out[ENGINE_AXES])
{
    loft_vec p;
    int status;

    switch (e->s->kind) {
    case SURFACE_SPATCH:    status = eval_spatch(e, at, &p);    break;
    case SURFACE_TORIC:     status = eval_toric(e, at, &p);     break;
    case SURFACE_BASEPOINT: status = eval_basepoint(e, at, &p); break;
    case SURFACE_GB:        status = eval_gb(e, at, &p);        break;
    default:                status = eval_zheng_ball(e, at, &p);      break;
    }
    if (status == LOFT_OK)
        point_of(p, out);
    return status;
}


// Normals and curvatures
// ----------------------

/* As in eval_zheng_ball. */
static int differential_zheng_ball(const engine_sided *e, sided_place at, loft_differential *out)
{
    const unsigned n = e->s->n, first = corner_side(e, at);
    loft_jet turned[LOFT_ZHENG_BALL_SIDES], u[LOFT_ZHENG_BALL_SIDES];
    const loft_unit a = LOFT_UNIT(at.u), b = LOFT_UNIT(at.v);
    const bool lifted = n == 3 && at.how == SIDED_CORNER;
    const int status = lifted ? loft_zheng_ball_lift_jet(a, b, turned)
                              : loft_zheng_ball_params_jet(n, a, b, turned);

    for (unsigned i = 0; i < n && status == LOFT_OK; i++)
        u[(first + i) % n] = turned[i];
    if (status == LOFT_OK)
        loft_zheng_ball_differential(&e->as.zheng_ball, u, out);
    return status;
}

static void swap_vectors(loft_sci a[LOFT_AXES], loft_sci b[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci x = a[i];
        a[i] = b[i];
        b[i] = x;
    }
}

/* At a cut corner use the parameters there, which turn the other way round. At a corner that is not
 * cut, use the shares of the triangle's corners. */
static int differential_basepoint(const engine_sided *e, sided_place at, loft_differential *out)
{
    const loft_basepoint *b = &e->as.basepoint;
    double phi[3] = { at.u, at.v, 0 };

    if (at.how == SIDED_CORNER && b->cut[at.k] > 0) {
        const loft_unit u = LOFT_UNIT(at.u), v = LOFT_UNIT(at.v);
        const int status = loft_basepoint_corner_differential(b, at.k, u, v, out);
        swap_vectors(out->u, out->v);
        swap_vectors(out->uu, out->vv);
        return status;
    }
    if (at.how == SIDED_CORNER) {
        phi[at.k] = 1 - at.v;
        phi[(at.k + 1) % 3] = (1 - at.u) * at.v;
        phi[(at.k + 2) % 3] = at.u * at.v;
    }
    return loft_basepoint_differential(b, LOFT_UNIT(phi[0]), LOFT_UNIT(phi[1]), out);
}

/* The derivatives of a patch at a place. Over a polygon they come from the coordinates of its
 * points. */
static int differential_at(const engine_sided *e, sided_place at, loft_differential *out)
{
    loft_jet phi[SURFACE_SIDES_MAX];
    loft_spot p;

    if (e->s->kind == SURFACE_BASEPOINT)
        return differential_basepoint(e, at, out);
    if (e->s->kind == SURFACE_RING)
        return differential_zheng_ball(e, at, out);
    int status = place_spot(e, at, &p);
    if (status == LOFT_OK && e->s->kind == SURFACE_TORIC)
        return loft_toric_differential(&e->as.toric, p, out);
    if (status == LOFT_OK)
        status = coordinate_jets(e, p, phi);
    if (status == LOFT_OK)
        status = e->s->kind == SURFACE_GB ? loft_gb_differential(&e->as.gb, phi, out)
                                          : loft_spatch_differential(&e->as.spatch, phi, out);
    return status;
}

static int sided_look(const engine_sided *e, sided_place at, engine_look *out)
{
    loft_differential here;
    const int status = differential_at(e, at, &here);

    return status ? status : look_of(&here, out);
}

static int sided_disk(const engine_sided *e, loft_disk *out)
{
    loft_coordinates *const of[] = { [COORDINATES_WACHSPRESS] = loft_wachspress_eval,
                                     [COORDINATES_MEANVALUE] = loft_meanvalue_eval,
                                     [COORDINATES_HARMONIC] = NULL };
    loft_coordinates *phi = of[e->s->coordinates];
    int status = LOFT_OK;

    switch (e->s->kind) {
    case SURFACE_SPATCH: status = loft_disk_from_spatch(out, &e->as.spatch, &e->domain, phi); break;
    case SURFACE_GB: status = loft_disk_from_gb(out, &e->as.gb, &e->domain, phi); break;
    case SURFACE_TORIC: loft_disk_from_toric(out, &e->as.toric); break;
    case SURFACE_BASEPOINT: loft_disk_from_basepoint(out, &e->as.basepoint); break;
    default: loft_disk_from_zheng_ball(out, &e->as.zheng_ball); break;
    }
    if (status == LOFT_OK && e->harmonic != NULL)
        status = loft_disk_harmonic(out, engine_harmonic_of(e->harmonic));
    return status;
}

/* The bounds of a gb patch come near only over smaller parts: it has four times as many. */
static int sided_sheets(engine_sided *e, unsigned level, engine_sheet_list *out)
{
    const unsigned finer = level && e->s->kind == SURFACE_GB ? 1 : 0;
    const int status = sided_disk(e, &e->round);

    return status ? status
                  : ENGINE_OF(engine_sectors)(&e->round, e->sector, level ? level + finer : 2, out);
}

/* The first vertex at which a polygon does not turn left. */
static unsigned hollow_vertex(const loft_spot v[], unsigned n)
{
    unsigned i = 0;

    while (i < n && loft_spot_turn(&v[(i + n - 1) % n], &v[i], &v[(i + 1) % n]) > 0)
        i++;
    return i;
}

static int cut_polygon(surface *s, unsigned at[2])
{
    loft_spot v[SURFACE_SIDES_MAX];
    loft_partition cut;
    loft_domain d;

    for (at[0] = 0; at[0] < s->n; at[0]++) {
        const double *p = s->domain[at[0]];
        loft_spot *q = &v[at[0]];
        if (!real_of(p[0], &q->at[0]) || !real_of(p[1], &q->at[1]) || !loft_spot_valid(*q))
            return LOFT_ERR_RANGE;
    }
    const int status = loft_domain_init(&d, v, s->n);
    if (status == LOFT_SINGULAR)
        loft_outline_fault(v, s->n, at);
    if (status != LOFT_OK)
        return status;
    loft_partition_init(&cut, &d);
    at[0] = hollow_vertex(v, s->n);
    s->parts = cut.count;
    for (unsigned k = 0; k < cut.count; k++) {
        s->part[k].sides = cut.sides[k];
        for (unsigned i = 0; i < cut.sides[k]; i++)
            s->part[k].vertex[i] = cut.vertex[k][i];
    }
    return LOFT_OK;
}

static int sided_cut(surface *s, unsigned at[2])
{
    if (s->kind == SURFACE_SPATCH || s->kind == SURFACE_GB)
        return cut_polygon(s, at);
    s->parts = 1;
    s->part[0].sides = at[0] = s->n;
    for (unsigned i = 0; i < s->n; i++)
        s->part[0].vertex[i] = i;
    return LOFT_OK;
}

static int sided_complete(surface *s)
{
    const unsigned all = loft_gb_count(s->n, s->m);

    if (s->split || (s->count != s->n * s->m && s->count != all - 1))
        return LOFT_OK;
    loft_vec *p = tool_grow(NULL, all * sizeof *p), *net = tool_grow(NULL, all * sizeof *net);
    int status = LOFT_OK;

    for (unsigned i = 0; i < s->count && status == LOFT_OK; i++)
        status = vec_of(s->point[i].p, &p[i]) ? LOFT_OK : LOFT_ERR_RANGE;
    if (status == LOFT_OK && s->count == s->n * s->m) {
        status = loft_gb_from_boundary(p, s->n, s->m, net);
        s->count = 0;
    } else if (status == LOFT_OK) {
        status = loft_gb_middle(p, s->n, s->m, &net[all - 1]);
    }
    while (status == LOFT_OK && s->count < all) {
        surface_point q = { .w = 1, .c = 1 };
        point_of(net[s->count], q.p);
        surface_add_point(s, &q);
    }
    free(p);
    free(net);
    return status;
}

const engine_sides ENGINE_OF(engine_sides) = { .open = sided_open,
    .close    = sided_close,
    .eval     = sided_eval,
    .look     = sided_look,
    .complete = sided_complete,
    .cut      = sided_cut,
    .disk = sided_disk,
                                               .sheets = sided_sheets };
