/* host-tools/plan/check.c -- judges a drawing or a program against a machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "base/say.h"
#include "base/source.h"         /* source_name */
#include "base/tool.h"
#include "plan/check.h"
#include "plan/table.h"          /* table_words */

#define PLACES 8                 /* on a curve, where its direction is looked at */

/* How fast the axes allow a curve to be drawn, and which axis allows least. */
static double allowed(const machine_file *m, const drawing_curve *c, int *axis)
{
    double least = HUGE_VAL;

    for (int k = 0; k <= PLACES; k++) {
        drawing_curve up = { .path = 0 };
        double along[3], high[2];
        for (int j = 0; j < 4; j++)
            up.p[j][0] = c->z[j];
        drawing_deriv(c, (double)k / PLACES, along);
        drawing_deriv(&up, (double)k / PLACES, high);
        along[2] = high[0];
        const double all = hypot(hypot(along[0], along[1]), along[2]);
        for (int i = 0; i < 3; i++)
            if (fabs(along[i]) > 0 && m->max_speed[i] * all / fabs(along[i]) < least) {
                least = m->max_speed[i] * all / fabs(along[i]);
                *axis = i;
            }
    }
    return least;
}

typedef struct {
    size_t count;
    unsigned line;              /* of the first one */
    double is, may;             /* there */
    int axis;
} oddity;

static void note(oddity *o, unsigned line, double is, double may, int axis)
{
    if (o->count++ == 0)
        *o = (oddity){ 1, line, is, may, axis };
}

static bool goes_sideways(const drawing_curve *c)
{
    return (c->loose[0] | c->loose[1]) == 0 &&
           hypot(c->p[3][0] - c->p[0][0], c->p[3][1] - c->p[0][1]) > 1e-6;
}

void check_print(FILE *out, const machine_file *m, const char *file, const drawing *d,
                 const toolpath *path, double feed)
{
    double least = HUGE_VAL, most = 0;
    oddity fast  = { 0 }, low = { 0 };
    char words[160];

    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        const double asked     = c->feed > 0 ? c->feed : feed, z = fmin(c->z[0], c->z[3]);
        int axis               = 0;
        if (c->feed < 0) {
            if (d->program && z < -1e-6 && goes_sideways(c))
                note(&low, c->line, z, 0, 2);
            continue;
        }
        const double may = m->k.kind->direct ? allowed(m, c, &axis) : HUGE_VAL;
        least            = fmin(least, asked);
        most             = fmax(most, asked);
        if (asked > may * (1 + 1e-9))
            note(&fast, c->line, asked, may, axis);
    }
    (void)say(out, "box: %s\n", table_words(d, path, words));
    if (most > 0)
        fprintf(out, "feeds: %.6g to %.6g mm/s\n", least, most);
    if (fast.count > 0)
        (void)say(out,
                  "%s:%u: a feed of %.6g mm/s, and %c allows %.6g there: %zu curve%s %s drawn "
                  "slower\n",
                  source_name(file), fast.line, fast.is, "xyz"[fast.axis], fast.may, fast.count,
                  tool_s(fast.count), fast.count == 1 ? "is" : "are");
    if (low.count > 0)
        (void)say(out, "%s:%u: a rapid at z %.6g, below 0: %zu of them go sideways there\n",
                  source_name(file), low.line, low.is, low.count);
}
