/* host-tools/arrange/crop.c -- cuts a drawing at the edges of a box
 * SPDX-License-Identifier: MIT
 *
 * The library intersects each curve, seen from above, with the four edges. Between two crossings a
 * curve is on one side, so the middle of a piece decides about all of it. A curve that only touches
 * an edge is not cut there.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "engine/engine.h"  /* engine_f64: where two pieces meet */
#include "engine/piece.h"
#include "arrange/page.h"

#define CUTS (4 * ENGINE_MEETINGS + 2)
#define LEAST 1e-12         /* of the parameter, between two cuts */
/* mm: a curve along an edge is on the page. A cubic that is 1/8 as far away half way between its
 * crossing and its end stays within PAGE_CUT. */
#define ALONG (PAGE_CUT / 10)

typedef struct {
    double t;
    int axis;               /* of the edge: 0: x is `at`; below 0: an end of the curve */
    double at;
} cut;

typedef struct {
    drawing *to;
    const double (*box)[2];
    const char *file;
    bool draws;             /* the piece before was kept, and ends where this one begins */
} cropping;

static void set_cubic(piece *out, const double p[4][2])
{
    *out = (piece){ .degree = 3 };
    for (int k = 0; k < 4; k++) {
        memcpy(out->p[k], p[k], sizeof p[k]);
        out->w[k] = 1;
    }
}

/* An edge of the box, long enough for the crossing not to be at its end. */
static void set_edge(piece *out, const double box[2][2], int axis, double at)
{
    const double more = 1 + (box[1][!axis] - box[0][!axis]) / 100;

    *out = (piece){ .degree = 1 };
    for (int k = 0; k < 2; k++) {
        out->p[k][axis]  = at;
        out->p[k][!axis] = k ? box[1][!axis] + more : box[0][!axis] - more;
        out->w[k]        = 1;
    }
}

static int compare_cuts(const void *a, const void *b)
{
    const cut *x = a, *y = b;
    return (x->t > y->t) - (x->t < y->t);
}

/* The ends of a curve and its crossings with the edges, sorted. Returns enum loft_status. */
static int find_cuts(const cropping *c, const double p[4][2], cut out[CUTS], size_t *count)
{
    engine_meeting meeting[ENGINE_MEETINGS];
    piece whole, edge;

    set_cubic(&whole, p);
    *count        = 0;
    out[(*count)++] = (cut){ 0, -1, 0 };
    for (int k = 0; k < 4; k++) {
        size_t found;
        const double at = c->box[k & 1][k >> 1];
        set_edge(&edge, c->box, k >> 1, at);
        const int status = engine_f64.measure->meet(&whole, &edge, PAGE_CUT / 2, meeting, &found);
        if (status != 0)
            return status;
        for (size_t i = 0; i < found; i++) {
            out[(*count)++] = (cut){ meeting[i].s[1], k >> 1, at };
            if (meeting[i].overlap) {       /* along the edge: it may leave it at either end */
                out[*count - 1].t = meeting[i].s[0];
                if (*count < CUTS - 1)
                    out[(*count)++] = (cut){ meeting[i].s[2], k >> 1, at };
            }
        }
    }
    out[(*count)++] = (cut){ 1, -1, 0 };
    qsort(out, *count, sizeof *out, compare_cuts);
    return 0;
}

static bool is_inside(const cropping *c, const double at[2])
{
    for (int i = 0; i < 2; i++)
        if (at[i] < c->box[0][i] - ALONG || at[i] > c->box[1][i] + ALONG)
            return false;
    return true;
}

/* The ends of a piece on an edge lie there exactly. */
static void keep_piece(cropping *c, const drawing_curve *of, const cut *from, const cut *to,
                       bool fresh)
{
    drawing_curve kept = *of;

    if (from->t > 0 || to->t < 1)
        drawing_cut(&kept, from->t, to->t);
    if (from->axis >= 0)
        kept.p[0][from->axis] = from->at;
    if (to->axis >= 0)
        kept.p[3][to->axis] = to->at;
    drawing_add_like(c->to, &kept, fresh || !c->draws);
}

static void crop_curve(cropping *c, const drawing_curve *of, cut cuts[CUTS], size_t count,
                       bool fresh)
{
    size_t begin = 0;
    bool inside  = false;       /* the piece from cuts[begin] */

    for (size_t k = 0, next; k + 1 < count; k = next) {
        double middle[2];
        next = k + 1;
        while (next + 1 < count && cuts[next].t - cuts[k].t < LEAST)
            next++;
        drawing_eval(of, (cuts[k].t + cuts[next].t) / 2, middle);
        const bool now = is_inside(c, middle);
        if (now && !inside)
            begin = k;
        else if (!now && inside)
            keep_piece(c, of, &cuts[begin], &cuts[k], fresh || cuts[begin].t > 0);
        if (!now)
            c->draws = false;
        inside = now;
    }
    if (inside)
        keep_piece(c, of, &cuts[begin], &cuts[count - 1], fresh || cuts[begin].t > 0);
    c->draws = inside;
}

/* Is the curve inside (1), outside (-1), or may it cross (0)? Its control points bound it. */
static int side_of(const cropping *c, const double p[4][2])
{
    bool in = true;

    for (int i = 0; i < 2; i++) {
        const double low  = fmin(fmin(p[0][i], p[1][i]), fmin(p[2][i], p[3][i])),
                     high = fmax(fmax(p[0][i], p[1][i]), fmax(p[2][i], p[3][i]));
        if (high < c->box[0][i] || low > c->box[1][i])
            return -1;
        in = in && low >= c->box[0][i] && high <= c->box[1][i];
    }
    return in;
}

int page_crop(host *h, drawing *to, const drawing *from, const double box[2][2], const char *file)
{
    static const cut whole[2] = { { 0, -1, 0 }, { 1, -1, 0 } };
    cropping c = { .to = to, .box = box, .file = file };

    for (size_t i = 0; i < from->count; i++) {
        const drawing_curve *of = &from->curve[i];
        const bool fresh = i == 0 || of->path != of[-1].path;
        const int side   = side_of(&c, of->p);
        cut cuts[CUTS];
        size_t count;
        if (side > 0)
            keep_piece(&c, of, &whole[0], &whole[1], fresh);
        if (side != 0) {
            c.draws = side > 0;
            continue;
        }
        const int status = find_cuts(&c, of->p, cuts, &count);
        if (status != 0)
            return host_error(h, EX_DATAERR, "page.not-cropped", (host_place){ file, of->line },
                              NULL, "--crop: %s", engine_status(status, NULL));
        crop_curve(&c, of, cuts, count, fresh);
    }
    return 0;
}
