/* host-tools/plan/certify_along.c -- judges a plan while it is made
 * SPDX-License-Identifier: MIT
 *
 * A span is compared at once with the chords of the path around it. The path is compared where the
 * motion has gone on by MARGIN: a chord that is met is done with. One that is not may be met later,
 * until the motion is MARGIN behind the end of its move. Less of a path can only be farther away,
 * so nothing that is forgotten makes a distance smaller than it is.
 */
#include <math.h>
#include <string.h>

#include "plan/certify_along.h"

#define PARTS   1000        /* of the tolerance: chords are so close to curves */
#define ERROR   0.01        /* of the tolerance: distances are no farther above the true ones */
#define LONGEST 1.0         /* mm: the longest chord of the path */
#define MARGIN  0.3         /* mm: where the motion is there for certain, without corners */
#define KEPT    10.0        /* mm of both paths that are kept behind what is compared */
#define BESIDE  8           /* times the tolerance along the other path, where the nearest is */
#define MORE    64          /* moves, after which a span that is far from all is off */
#define MANY    4096        /* chords: fewer are not worth forgetting */

void certify_along_begin(certify_along *w, const engine_limits *limits, engine_move_source *source,
                         void *context, size_t count)
{
    *w = (certify_along){ .judged.connected = true,
                          .limits = *limits,
                          .source = source,
                          .context = context,
                          .count = count };
    const double fine = limits->tol / PARTS;
    const certify_search search = {
        .tol = limits->tol,
        .fine = fine,
        .reach = BESIDE * fmax(limits->tol, limits->corner),
        .step = 5 * fine * fmin(limits->tol / fmax(limits->corner, limits->tol), 1),
        .share = 1,
        .worst_share = 1
    };
    w->off = w->missed = search;
}

void certify_along_free(certify_along *w)
{
    certify_chords_free(&w->drawn);
    certify_chords_free(&w->moved);
    bends_free(&w->bends);
    *w = (certify_along){ .count = 0 };
}

/* Plans use up their tolerance: what is beyond it by no more than the error of this judgement is
 * not known to be beyond it. */
static bool holds(certify_along *w)
{
    certify_take(&w->judged.off, &w->off);
    certify_take(&w->judged.missed, &w->missed);
    certify least = w->judged;
    least.off.worst -= ERROR * least.off.tol;
    least.missed.worst -= ERROR * least.missed.tol;
    return certify_holds(&least);
}


// The path
// --------

static bool has_corners(const certify_along *w) { return w->limits.corner > w->limits.tol; }

static double margin_of(const certify_along *w)
{
    return MARGIN + 2 * fmax(w->limits.tol, w->limits.corner);
}

/* Compare two points first: they raise the worst so far, so that few parts need to be small. */
static bool compare(certify_search *s, const certify_cubic *c, double *t)
{
    const double worst = s->worst;

    certify_points(s, c);
    s->worst = fmax(worst, s->worst - 2 * s->step);
    return certify_compare(s, c, t);
}

/* The path is near a corner from one length to another. */
static void mark_corner(certify_along *w, double from, double to)
{
    certify_chords *c = &w->drawn;
    size_t k = c->chords;

    while (k > 0 && c->s[k] > from)
        k--;
    for (; k < c->chords && c->s[k] < to; k++) {
        if (certify_chords_cut(c, k, from))
            continue;
        (void)certify_chords_cut(c, k, to);
        c->share[k] = w->limits.tol / w->limits.corner;
    }
}

/* The length of the path at a place on the chords from k on. */
static double length_at(const certify_chords *c, size_t k, const double at[ENGINE_AXES])
{
    double least = HUGE_VAL, s = c->s[k];

    for (; k < c->chords; k++) {
        const double off = space_segment_distance(at, c->end[k], c->end[k + 1]);
        if (off < least) {
            least = off;
            s     = fmin(c->s[k] + space_distance(at, c->end[k]), c->s[k + 1]);
        }
    }
    return s;
}

/* Corners of the move that begins with chord `first`. */
static void find_corners(certify_along *w, size_t first, const certify_cubic *c)
{
    const double reach = CERTIFY_NEAR * w->limits.corner, begin = w->drawn.s[first];

    w->bends.count = 0;
    bends_more(&w->bends, w->next, c->p);
    if (w->near_corner > begin)
        mark_corner(w, begin, w->near_corner);
    for (size_t n = 0; n < w->bends.count; n++) {
        const bend *b   = &w->bends.bend[n];
        const double at = b->t > 0 ? length_at(&w->drawn, first, b->at) : begin;
        mark_corner(w, at - reach, at + reach);
        w->near_corner = at + reach;
    }
}

static void add_move(certify_along *w)
{
    const size_t first = w->drawn.chords;
    engine_move m;
    certify_cubic c;

    w->source(w->context, w->next, &m);
    memcpy(c.p, m.p, sizeof c.p);
    certify_chords_add(&w->drawn, w->next, &c, w->off.fine / 4, LONGEST);
    if (has_corners(w))
        find_corners(w, first, &c);
    w->next++;
    w->off.to = &w->drawn;
}

/* Have the path up to where a span may end, and so far that all corners beside it are known. */
static void add_moves(certify_along *w, double way)
{
    const certify_chords *c = &w->drawn;
    const double ahead = way + margin_of(w) + CERTIFY_NEAR * w->limits.corner;

    while (w->next < w->count && (c->s == NULL || w->next <= w->passed + 1 ||
                                  c->s[c->chords] - c->s[w->off.near + 1] < ahead))
        add_move(w);
}

/* Compare the path as far as the motion has passed it: by its place, or by its moves, of which the
 * first `over` are behind it for certain. */
static void compare_drawn(certify_along *w, size_t over)
{
    const certify_chords *c = &w->drawn;
    certify_cubic curve;
    double t = 0;

    for (; w->compared < c->chords; w->compared++) {
        const size_t k     = w->compared;
        const bool certain = c->of[k] < over;
        if (!certain && !(c->s[k + 1] < c->s[w->off.near] - margin_of(w)))
            break;
        certify_search now = w->missed;
        certify_cubic_of_chord(&now, c, k, &curve);
        const bool worse = compare(&now, &curve, &t);
        if (worse && !certain && now.worst + now.step > now.tol)
            break;
        w->missed = now;
        if (worse) {
            w->judged.missed.move = c->of[k];
            certify_eval(&curve, t, w->judged.missed.at);
        }
    }
}


// The motion
// ----------

/* What lies far behind is of no use any more. */
static void forget(certify_along *w)
{
    certify_chords *c = &w->moved;
    size_t k = 0;

    if (w->moved.chords < 2 * MANY && w->drawn.chords < 2 * MANY)
        return;
    while (k < w->missed.near && c->s[k + 1] < c->s[w->missed.near] - KEPT)
        k++;
    if (k > MANY && k > c->chords / 2) {
        certify_chords_forget(c, k);
        w->missed.near -= k;
    }
    c = &w->drawn;
    const size_t needed = w->compared < w->off.near ? w->compared : w->off.near;
    for (k = 0; k < needed && c->s[k + 1] < c->s[needed] - KEPT; k++)
        ;
    if (k > MANY && k > c->chords / 2) {
        certify_chords_forget(c, k);
        w->off.near -= k;
        w->compared -= k;
    }
}

/* A path that comes back may be nearer to what was before: go on to what is now. */
static void go_on(certify_along *w, size_t over)
{
    while (w->off.near + 1 < w->drawn.chords && w->drawn.of[w->off.near] + 1 < over)
        w->off.near++;
    while (w->compared < w->drawn.chords && w->drawn.of[w->compared] >= over &&
           w->missed.near + 1 < w->moved.chords && w->moved.s[w->missed.near] < w->mark[0].s - KEPT)
        w->missed.near++;
}

/* Compare what the motion has passed, once it has gone on. */
static void pass(certify_along *w)
{
    const double s = w->moved.s[w->moved.chords];
    const size_t over = w->mark[0].passed;

    compare_drawn(w, over);
    w->sure = w->moved.of[w->missed.near];
    if (s - w->mark[1].s < margin_of(w))
        return;
    if (w->mark[1].passed > over)
        go_on(w, w->mark[1].passed);
    w->mark[0] = w->mark[1];
    w->mark[1] = (struct certify_mark){ s, w->passed };
    forget(w);
}

static void cubic_of_span(const engine_span *s, certify_cubic *out)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            out->p[k][i] = s->p[k][i] * ENGINE_LSB;
}

/* The motion may be farther along the path than its length says: it cuts corners. */
static bool compare_span(certify_along *w, const certify_cubic *c, double *t)
{
    certify_search now = w->off;
    bool worse         = compare(&now, c, t);

    for (int n = 0; n < MORE && worse && now.worst + now.step > now.tol && w->next < w->count;
         n++) {
        add_move(w);
        now   = w->off;
        worse = compare(&now, c, t);
    }
    w->off = now;
    return worse;
}

bool certify_along_span(certify_along *w, const engine_span *span, size_t passed)
{
    const double begin = (double)w->ticks / w->limits.tick_hz;
    certify_cubic c;
    double t = 0;

    w->judged.connected = w->judged.connected &&
                          (w->spans == 0 || memcmp(span->p[0], w->last, sizeof w->last) == 0);
    memcpy(w->last, span->p[3], sizeof w->last);
    certify_span(&w->judged, &w->limits, span, begin);
    cubic_of_span(span, &c);
    w->passed = passed;
    add_moves(w, certify_length(&c));
    if (compare_span(w, &c, &t)) {
        w->judged.off.seconds = begin + t * span->ticks / w->limits.tick_hz;
        certify_eval(&c, t, w->judged.off.at);
    }
    certify_chords_add(&w->moved, w->spans, &c, w->off.fine / 2, HUGE_VAL);
    w->missed.to = &w->moved;
    w->ticks += span->ticks;
    w->spans++;
    pass(w);
    return holds(w);
}

bool certify_along_end(certify_along *w)
{
    if (w->spans == 0)
        return w->count == 0;
    while (w->next < w->count)
        add_move(w);
    compare_drawn(w, w->count);
    w->sure = w->spans;
    return holds(w);
}
