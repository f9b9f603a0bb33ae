/* host-tools/plan/bends.c
 * SPDX-License-Identifier: MIT
 *
 * The direction of a curve is that of its hodograph, which lies between the legs of the control
 * polygon. So a part is halved until its legs have nearly one direction, or it is so short that it
 * is a point. Then each part's first direction is compared with the last one before.
 */
#include <stdlib.h>
#include <string.h>

#include "plan/bends.h"
#include "base/space.h"          /* space_distance */
#include "base/memory.h"

#define DEPTH    40         /* halvings of a curve */
#define SHARP    0.0864     /* of two directions: 4.95 degrees */
#define SHORT    0x1p-16    /* mm */
#define STRAIGHT 0.04       /* between two legs: 2.3 degrees */

typedef struct {
    double p[4][ENGINE_AXES], from, to;
} part;

static void halve(const part *p, part *left, part *right)
{
    left->from = p->from;
    left->to = right->from = (p->from + p->to) / 2;
    right->to = p->to;
    for (int i = 0; i < ENGINE_AXES; i++) {
        double q[4] = { p->p[0][i], p->p[1][i], p->p[2][i], p->p[3][i] };
        for (int n = 0; n < 4; n++) {
            left->p[n][i]      = q[0];
            right->p[3 - n][i] = q[3 - n];
            for (int k = 0; k < 3 - n; k++)
                q[k] = (q[k] + q[k + 1]) / 2;
        }
    }
}

/* The directions of the legs; returns the length of all. */
static double legs_of(const part *p, double u[3][ENGINE_AXES])
{
    double size = 0;

    for (int k = 0; k < 3; k++) {
        const double leg = space_distance(p->p[k], p->p[k + 1]);
        for (int i = 0; i < ENGINE_AXES; i++)
            u[k][i] = leg > 0 ? (p->p[k + 1][i] - p->p[k][i]) / leg : 0;
        size += leg;
    }
    return size;
}

static void go_on(bends *b, size_t move, const part *p, double u[3][ENGINE_AXES])
{
    if (b->moves && space_distance(b->last, u[0]) > SHARP) {
        if (b->count == b->room) {
            b->room = b->room ? 2 * b->room : 64;
            b->bend = memory_grow(b->bend, b->room * sizeof *b->bend);
        }
        bend *n = &b->bend[b->count++];
        *n = (bend){ .move = move, .t = p->from };
        memcpy(n->at, p->p[0], sizeof n->at);
    }
    memcpy(b->last, u[2], sizeof b->last);
    b->moves = true;
}

void bends_more(bends *b, size_t move, const double p[4][ENGINE_AXES])
{
    part stack[DEPTH + 2];
    int parts = 1;

    stack[0] = (part){ .from = 0, .to = 1 };
    memcpy(stack[0].p, p, sizeof stack[0].p);
    while (parts > 0) {
        const part now = stack[--parts];
        double u[3][ENGINE_AXES];
        if (!(legs_of(&now, u) > SHORT))
            continue;
        if (parts < DEPTH &&
            (space_distance(u[0], u[1]) > STRAIGHT || space_distance(u[1], u[2]) > STRAIGHT)) {
            halve(&now, &stack[parts + 1], &stack[parts]);
            parts += 2;
        } else
            go_on(b, move, &now, u);
    }
}

void bends_find(bends *out, const engine_move move[], size_t count)
{
    *out = (bends){ .count = 0 };
    for (size_t n = 0; n < count; n++)
        bends_more(out, n, move[n].p);
}

void bends_free(bends *b)
{
    free(b->bend);
    *b = (bends){ .count = 0 };
}
