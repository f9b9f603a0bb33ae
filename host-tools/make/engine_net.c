/* host-tools/make/engine_net.c -- questions about surfaces with nets; compiled once per number
 * type
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "surface/area.h"           /* loft_net_area, loft_net_cone_volume */
#include "surface/net_nearest.h"    /* loft_net_nearest */
#include "surface/net_ray.h"        /* loft_net_ray */
#include "surface/volume.h"         /* loft_net_volume */

#include "engine/engine_sheet.h"    /* engine_nets */
#include "engine/surface.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"    /* numbers_of, print_vec */

/* What the nets of a surface are asked; `number` is its place in the file. */
typedef struct {
    const decide_input *in;
    size_t number;
    loft_vec point, direction;
    loft_net_near near;
    double at[2];
    bool found, proved;
    loft_ray_hit hit[64];
    double hit_at[64][2];
    unsigned hits;
    bool more;
    loft_real tol;
    double area, volume, moment[3];
    size_t nets, all_nets;      /* of this surface, and of all of them */
} net_question;

static int ask_nets(net_question *q, engine_net_visit *visit)
{
    const surface *s = &q->in->surfaces->surface[q->number];
    engine_surface *held;
    int status = ENGINE_OF(engine_surfaces).open(s, &held);

    if (status != LOFT_OK)
        return status;
    status = ENGINE_OF(engine_nets)(held, visit, q);
    ENGINE_OF(engine_surfaces).close(held);
    if (status == LOFT_ERR_ARG && *q->in->why == '\0')
        decide_refuse_kind(q->in, q->number, s);
    return status;
}

static int count_only(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;

    (void)net;
    (void)part;
    q->nets++;
    return LOFT_OK;
}

/* A question that cannot be asked is refused before any other is computed, which may take long; a
 * row is printed at once. */
static int ask_each(net_question *q, engine_net_visit *visit, void (*tell)(const net_question *q))
{
    int status = LOFT_OK;

    for (q->number = 0; q->number < q->in->surfaces->count && status == LOFT_OK; q->number++)
        status = ask_nets(q, count_only);
    q->all_nets = q->nets;
    for (q->number = 0; q->number < q->in->surfaces->count && status == LOFT_OK; q->number++) {
        q->found = false;
        q->proved = true;
        q->hits = 0;
        q->more = false;
        q->area = 0;
        q->nets = 0;
        status = ask_nets(q, count_only);
        if (status == LOFT_OK)
            status = ask_nets(q, visit);
        if (status == LOFT_OK)
            tell(q);
        fflush(stdout);
    }
    return status;
}

static int nearest_of(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;
    loft_net_near near;
    const int status = loft_net_nearest(net, q->point, LOFT_REAL(0.0001), &near);

    if (status < 0)
        return status;
    q->proved = q->proved && status == LOFT_OK;
    if (q->found && !(near.distance < q->near.distance))
        return LOFT_OK;
    q->found = true;
    q->near = near;
    engine_net_place(part, double_of_unit(near.u), double_of_unit(near.v), q->at);
    return LOFT_OK;
}

static void tell_nearest(const net_question *q)
{
    printf("%zu u %s v %s distance %s%s at ", q->number, text_of(q->at[0]), text_of(q->at[1]),
           text_of(double_of_acc(q->near.distance)), q->proved ? "" : " (not proved)");
    print_vec(q->in, q->near.point);
}

int ENGINE_OF(answer_nearest)(const decide_input *in)
{
    net_question q = { .in = in };
    loft_real x[3];
    const int status = in->of->count == 3 ? numbers_of(in, x, 3) : LOFT_ERR_ARG;

    for (int axis = 0; axis < 3 && status == LOFT_OK; axis++)
        q.point.axis[axis] = x[axis];
    return status ? status : ask_each(&q, nearest_of, tell_nearest);
}

/* Insert, sorted by t; a hit on the border of two spans is one. */
static void keep_hit(net_question *q, const loft_ray_hit *hit, double u, double v)
{
    unsigned k = 0;

    for (k = 0; k < q->hits; k++)
        if (hit->edge && q->hit[k].edge && fabs(q->hit_at[k][0] - u) < 0x1p-20 &&
            fabs(q->hit_at[k][1] - v) < 0x1p-20)
            return;
    q->more = q->more || q->hits == 64;
    if (q->hits == 64)
        return;
    for (k = q->hits++; k > 0 && q->hit[k - 1].t > hit->t; k--) {
        q->hit[k] = q->hit[k - 1];
        q->hit_at[k][0] = q->hit_at[k - 1][0];
        q->hit_at[k][1] = q->hit_at[k - 1][1];
    }
    q->hit[k] = *hit;
    q->hit_at[k][0] = u;
    q->hit_at[k][1] = v;
}

static int hits_of(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;
    loft_ray_hit hit[64];
    unsigned count = 0;
    const int status = loft_net_ray(net, q->point, q->direction, hit, 64, &count);

    for (unsigned k = 0; k < count; k++) {
        double at[2];
        engine_net_place(part, double_of_unit(hit[k].u), double_of_unit(hit[k].v), at);
        keep_hit(q, &hit[k], at[0], at[1]);
    }
    q->more = q->more || status == LOFT_MORE;
    return status < 0 ? status : LOFT_OK;
}

static void tell_hits(const net_question *q)
{
    for (unsigned k = 0; k < q->hits; k++)
        printf("%zu t %s u %s v %s%s%s\n", q->number, text_of(double_of_acc(q->hit[k].t)),
               text_of(q->hit_at[k][0]), text_of(q->hit_at[k][1]), q->hit[k].edge ? " edge" : "",
               q->hit[k].touch ? " touch" : "");
    if (q->more)
        printf("%zu more\n", q->number);
}

int ENGINE_OF(answer_ray)(const decide_input *in)
{
    static net_question q;
    loft_real x[6];
    const int status = in->of->count == 6 ? numbers_of(in, x, 6) : LOFT_ERR_ARG;

    q.in = in;
    for (int axis = 0; axis < 3 && status == LOFT_OK; axis++) {
        q.point.axis[axis] = x[axis];
        q.direction.axis[axis] = x[axis + 3];
    }
    return status ? status : ask_each(&q, hits_of, tell_hits);
}

static loft_sci memory[LOFT_NET_MOMENT_MEMORY(LOFT_DEGREE_MAX, LOFT_DEGREE_MAX)];

static int tolerance_of(const decide_input *in, loft_real *out)
{
    *out = LOFT_REAL(0.001);
    if (in->of->count == 0 || (real_of(in->of->value[0], out) && *out > 0))
        return LOFT_OK;
    return decide_refuse(in, "not a tolerance: give --of a number above 0, or nothing for 0.001");
}

/* What was refused at a tolerance, is it refused at any? `coarse` is the status at the largest. */
static int refuse_fine(const net_question *q, int status, int coarse)
{
    if (status != LOFT_ERR_RANGE || coarse != LOFT_OK)
        return status;
    snprintf(q->in->why, DECIDE_WHY,
             "surface %zu folds, or its weights differ, by too much for this tolerance: give a "
             "larger one",
             q->number);
    return LOFT_ERR_ARG;
}

/* The part of the tolerance for each of so many nets. */
static int share_of(const net_question *q, size_t nets, loft_real *out)
{
    return tol_of(double_of(q->tol) / (double)nets, out) && *out > 0
               ? LOFT_OK
               : decide_refuse(q->in, "many nets share this tolerance: give a larger one");
}

/* The nets of a surface are within the tolerance together. */
static int area_of(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;
    loft_acc area = 0;
    loft_real tol;
    int status = share_of(q, q->nets, &tol);

    if (status == LOFT_OK)
        status = loft_net_area(net, tol, memory, &area);
    if (status == LOFT_ERR_RANGE)
        status = refuse_fine(q, status, loft_net_area(net, LOFT_REAL_MAX, memory, &area));
    (void)part;
    q->area += double_of_acc(area);
    return status;
}

static void tell_area(const net_question *q)
{
    printf("%zu area %s\n", q->number, text_of(q->area));
}

int ENGINE_OF(answer_area)(const decide_input *in)
{
    net_question q = { .in = in };
    const int status = tolerance_of(in, &q.tol);

    return status ? status : ask_each(&q, area_of, tell_area);
}

/* The cone from q->point over a net, a part of the volume. Without weights it is exact: a net that
 * is that point alone gives the point to the library. */
static int volume_of(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;
    const loft_net both[2] = { { &q->point, NULL, 0, 0, false }, net };
    loft_acc volume = 0;
    loft_real tol;
    int status = share_of(q, q->all_nets, &tol);

    if (status == LOFT_OK)
        status = net.weighted ? loft_net_cone_volume(net, q->point, tol, memory, &volume)
                              : loft_net_volume(both, 2, &volume);
    if (status == LOFT_ERR_RANGE && net.weighted)
        status = refuse_fine(q, status,
                             loft_net_cone_volume(net, q->point, LOFT_REAL_MAX, memory, &volume));
    (void)part;
    q->volume += double_of_acc(volume);
    return status;
}

/* A number of any size. */
static double number_of_sci(loft_sci x)
{
    loft_acc at = 0;
    int by      = 0;

    while (by < 64 && !loft_sci_to_acc(loft_sci_mul(x, loft_sci_power2(-by)), &at))
        by += 8;
    return ldexp(double_of_acc(at), by);
}

static int moment_of(void *context, loft_net net, const engine_net_part *part)
{
    net_question *q = context;
    loft_sci moment[3];
    loft_real tol;
    int status = share_of(q, q->all_nets, &tol);

    if (status == LOFT_OK)
        status = loft_net_cone_moment(net, q->point, tol, memory, moment);
    if (status == LOFT_ERR_RANGE)
        status = refuse_fine(q, status,
                             loft_net_cone_moment(net, q->point, LOFT_REAL_MAX, memory, moment));
    (void)part;
    for (int k = 0; k < 3 && status == LOFT_OK; k++)
        q->moment[k] += number_of_sci(moment[k]);
    return status;
}

static void tell_nothing(const net_question *q) { (void)q; }

/* Where there is a volume: its moments within the tolerance times the side of a cube of it. */
static int tell_centroid(net_question *q)
{
    const double volume = fabs(q->volume), tol = double_of(q->tol) * cbrt(volume);

    if (!(volume > double_of(q->tol)))
        return LOFT_OK;
    if (!real_of(tol < 32767 ? tol : 32767, &q->tol) || !(q->tol > 0))
        q->tol = LOFT_REAL(0.001);
    const int status = ask_each(q, moment_of, tell_nothing);
    fputs(status == LOFT_OK ? "centroid" : "", stdout);
    for (int k = 0; k < 3 && status == LOFT_OK; k++)
        printf(" %s", text_of(double_of(q->point.axis[k]) + q->moment[k] / q->volume));
    fputs(status == LOFT_OK ? "\n" : "", stdout);
    return status;
}

/* Cones from one point over all nets. */
int ENGINE_OF(answer_volume)(const decide_input *in)
{
    net_question q = { .in = in };
    int status = tolerance_of(in, &q.tol);

    if (status != LOFT_OK)
        return status;
    if (in->surfaces->surface[0].count > 0 &&
        !vec_of(in->surfaces->surface[0].point[0].p, &q.point))
        return LOFT_ERR_RANGE;
    status = ask_each(&q, volume_of, tell_nothing);
    if (status == LOFT_OK)
        printf("volume %s\n", text_of(q.volume));
    return status == LOFT_OK ? tell_centroid(&q) : status;
}
