/* host-tools/make/engine_meet.c -- where surfaces and curves meet; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "surface/net_meet.h"       /* loft_net_meet */

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_sheet.h"    /* engine_nets */
#include "engine/surface.h"
#include "make/branches.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"    /* visit_pieces */

#define ROOM 32768

typedef struct {
    const decide_input *in;
    size_t first, second, piece;    /* surfaces; the piece of a curve */
    loft_real tol;
    loft_net net;                   /* of the first, or the curve */
    bool found, same;
    branches lines;                 /* of both surfaces */
    loft_net_meeting out[ROOM];
    unsigned count;
} meeting;

static int refuse(const meeting *m, size_t number, int status)
{
    const surface *s = &m->in->surfaces->surface[number];

    if (status == LOFT_ERR_ARG)
        decide_refuse_kind(m->in, number, s);
    else if (status == LOFT_ERR_RANGE)
        snprintf(m->in->why, DECIDE_WHY, "%g mm is too fine: give a larger --of",
                 m->in->of->value[0]);
    return status;
}

/* All nets of a surface. */
static int visit_surface(meeting *m, size_t number, engine_net_visit *visit)
{
    engine_surface *held;
    int status = ENGINE_OF(engine_surfaces).open(&m->in->surfaces->surface[number], &held);

    if (status == LOFT_OK)
        status = ENGINE_OF(engine_nets)(held, visit, m);
    ENGINE_OF(engine_surfaces).close(held);
    return status < 0 && *m->in->why == '\0' ? refuse(m, number, status) : status;
}

static int meet_of(meeting *m, loft_net net)
{
    const int status = loft_net_meet(m->net, net, m->tol, m->out, ROOM, &m->count);

    if (status == LOFT_MORE)
        snprintf(m->in->why, DECIDE_WHY,
                 "they overlap, touch along a line, or are so near each other that %g mm does not "
                 "tell where they meet: give another --of",
                 m->in->of->value[0]);
    m->found = m->found || m->count > 0;
    return status == LOFT_MORE ? LOFT_ERR_SPACE : status < 0 ? status : LOFT_OK;
}

/* Keep the lines of two nets. */
static void keep_lines(meeting *m)
{
    double (*p)[ENGINE_AXES] = tool_grow(NULL, (m->count + 1) * sizeof *p);

    for (unsigned k = 0, first = 0; k < m->count; k++) {
        point_of(m->out[k].point, p[k]);
        if (m->out[k].start)
            first = k;
        if (k + 1 == m->count || m->out[k + 1].start)
            branches_add(&m->lines, (const double (*)[ENGINE_AXES])(p + first), k + 1 - first,
                         m->out[k].touch);
    }
    free(p);
}

static int meet_second(void *context, loft_net net, const engine_net_part *part)
{
    meeting *m = context;

    (void)part;
    if (loft_net_same(m->net, net)) {
        m->found = m->same = true;
        return LOFT_OK;
    }
    const int status = meet_of(m, net);
    if (status == LOFT_OK)
        keep_lines(m);
    return status;
}

static int meet_first(void *context, loft_net net, const engine_net_part *part)
{
    meeting *m = context;

    (void)part;
    m->net = net;
    return visit_surface(m, m->second, meet_second);
}

static int take_tolerance(meeting *m, const decide_input *in)
{
    m->in = in;
    m->found = false;
    if (in->of->value[0] > 0 && real_of(in->of->value[0], &m->tol) && m->tol > 0)
        return LOFT_OK;
    snprintf(in->why, DECIDE_WHY, "a tolerance of 0: give one above 0");
    return LOFT_ERR_ARG;
}

static void tell_lines(const meeting *m)
{
    const print_options p = { m->in->e, true };

    if (m->same)
        printf("# surfaces %zu and %zu coincide in all points of a patch\n", m->first, m->second);
    for (size_t i = 0; i < m->lines.count; i++) {
        const branch *l = &m->lines.line[i];
        if (l->touch)
            printf("# surfaces %zu and %zu touch, or do not meet, near ", m->first, m->second);
        else if (l->count == 1)
            printf("# surfaces %zu and %zu meet in one point ", m->first, m->second);
        else
            printf("line                # surfaces %zu and %zu\n", m->first, m->second);
        for (size_t k = 0; k < l->count; k++)
            print_point((void *)&p, l->p[k]);
    }
}

static int meet_pair(meeting *m)
{
    m->lines = (branches) { .tol = m->in->of->value[0] };
    m->same = false;
    const int status = visit_surface(m, m->first, meet_first);
    if (status == LOFT_OK) {
        branches_join(&m->lines);
        tell_lines(m);
    }
    branches_free(&m->lines);
    return status;
}

/* The lines in which each two surfaces meet, over all spans of both. */
int ENGINE_OF(make_meet)(const decide_input *in)
{
    static meeting m;
    int status = take_tolerance(&m, in);

    for (m.first = 0; m.first < in->surfaces->count && status == LOFT_OK; m.first++)
        for (m.second = m.first + 1; m.second < in->surfaces->count && status == LOFT_OK;
             m.second++)
            status = meet_pair(&m);
    if (status == LOFT_OK && !m.found) {
        snprintf(in->why, DECIDE_WHY, "no two surfaces meet: give surfaces that do");
        status = LOFT_ERR_ARG;
    }
    return status;
}

static int pierce_net(void *context, loft_net net, const engine_net_part *part)
{
    meeting *m = context;
    const int status = meet_of(m, net);

    for (unsigned k = 0; k < m->count && status == LOFT_OK; k++) {
        const loft_net_meeting *o = &m->out[k];
        double at[2];
        engine_net_place(part, double_of_unit(o->at[2]), double_of_unit(o->at[3]), at);
        printf("%zu %zu t %s u %s v %s%s at ", m->piece, m->first,
               text_of(double_of_unit(o->at[0])), text_of(at[0]), text_of(at[1]),
               o->touch ? " touch" : "");
        write_solid(m->in, &o->point, 1);
    }
    return status;
}

static int pierce_piece(void *context, const arc_piece *a, size_t number)
{
    meeting *m = context;
    loft_rational r = { .p = a->w, .degree = a->b.degree };
    int status = LOFT_OK;

    m->piece = number;
    m->net = a->rational ? loft_net_from_rational(&r) : loft_net_from_bezier(&a->b);
    for (m->first = 0; m->first < m->in->surfaces->count && status == LOFT_OK; m->first++)
        status = visit_surface(m, m->first, pierce_net);
    return status;
}

/* The places where the pieces of curves meet surfaces. */
int ENGINE_OF(answer_pierce)(const decide_input *in)
{
    static meeting m;
    const int status = take_tolerance(&m, in);

    return status ? status : visit_pieces(in, pierce_piece, &m);
}
