/* host-tools/make/branches.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"              /* tool_grow */
#include "make/branches.h"

static double distance(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    double sum = 0;

    for (int k = 0; k < ENGINE_AXES; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

static double distance_from_chord(const double a[ENGINE_AXES], const double b[ENGINE_AXES],
                                  const double p[ENGINE_AXES])
{
    double along = 0, length = 0, foot[ENGINE_AXES];

    for (int k = 0; k < ENGINE_AXES; k++) {
        along += (b[k] - a[k]) * (p[k] - a[k]);
        length += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double t = length > 0 ? fmax(0, fmin(1, along / length)) : 0;
    for (int k = 0; k < ENGINE_AXES; k++)
        foot[k] = a[k] + t * (b[k] - a[k]);
    return distance(foot, p);
}

static bool is_near(const branch *l, const double p[ENGINE_AXES], double tol)
{
    if (l->count == 1)
        return distance(l->p[0], p) <= tol;
    for (size_t k = 1; k < l->count; k++)
        if (distance_from_chord(l->p[k - 1], l->p[k], p) <= tol)
            return true;
    return false;
}

static bool runs_along(const branch *l, const double (*p)[ENGINE_AXES], size_t count, double tol)
{
    size_t k = 0;

    while (k < count && is_near(l, p[k], tol))
        k++;
    return k == count;
}

void branches_add(branches *b, const double (*p)[ENGINE_AXES], size_t count, bool touch)
{
    for (size_t k = 0; k < b->count; k++)
        if (runs_along(&b->line[k], p, count, 2 * b->tol))
            return;
    if (b->count == b->room) {
        b->room = b->room ? 2 * b->room : 16;
        b->line = tool_grow(b->line, b->room * sizeof *b->line);
    }
    branch *const l = &b->line[b->count++];
    *l = (branch) { tool_grow(NULL, count * sizeof *l->p), count, touch };
    memcpy(l->p, p, count * sizeof *l->p);
}

static void reverse(branch *l)
{
    for (size_t i = 0, j = l->count - 1; i < j; i++, j--)
        for (int k = 0; k < ENGINE_AXES; k++) {
            const double x = l->p[i][k];
            l->p[i][k] = l->p[j][k];
            l->p[j][k] = x;
        }
}

static bool is_open(const branch *l)
{
    return l->count > 1 && memcmp(l->p[0], l->p[l->count - 1], sizeof *l->p) != 0;
}

/* The cosine of the turn from the end of a to the start of b. */
static double straightness(const branch *a, const branch *b)
{
    const double *const p[4] = { a->p[a->count - 2], a->p[a->count - 1], b->p[0], b->p[1] };
    double product = 0;

    for (int k = 0; k < ENGINE_AXES; k++)
        product += (p[1][k] - p[0][k]) * (p[3][k] - p[2][k]);
    const double size = distance(p[0], p[1]) * distance(p[2], p[3]);
    return size > 0 ? product / size : -1;
}

static void drop_line(branches *b, size_t k)
{
    free(b->line[k].p);
    b->line[k] = b->line[--b->count];
}

/* Append another line to the end of line i; false if none begins or ends there. */
static bool append_next(branches *b, size_t i)
{
    branch *const l = &b->line[i];
    double best = -2;
    size_t next = 0;
    bool turned = false;

    for (size_t k = 0; k < b->count; k++)
        for (int side = 0; side < 2 && k != i && is_open(&b->line[k]); side++) {
            if (distance(l->p[l->count - 1], b->line[k].p[0]) <= b->tol / 4 &&
                straightness(l, &b->line[k]) > best) {
                best = straightness(l, &b->line[k]);
                next = k;
                turned = side == 1;
            }
            reverse(&b->line[k]);
        }
    if (best < -1)
        return false;
    if (turned)
        reverse(&b->line[next]);
    l->p = tool_grow(l->p, (l->count + b->line[next].count) * sizeof *l->p);
    memcpy(l->p + l->count, b->line[next].p + 1, (b->line[next].count - 1) * sizeof *l->p);
    l->count += b->line[next].count - 1;
    drop_line(b, next);
    return true;
}

static bool close_line(branch *l, double near)
{
    if (l->count < 4 || distance(l->p[0], l->p[l->count - 1]) > near)
        return false;
    memcpy(l->p[l->count - 1], l->p[0], sizeof *l->p);
    return true;
}

/* Join one line with another; false if no two are left that go together. */
static bool join_two(branches *b)
{
    for (size_t i = 0; i < b->count; i++)
        for (int side = 0; side < 2 && is_open(&b->line[i]); side++) {
            if (close_line(&b->line[i], b->tol / 4))
                break;
            if (append_next(b, i))
                return true;
            reverse(&b->line[i]);
        }
    return false;
}

void branches_join(branches *b)
{
    while (join_two(b))
        ;
    for (size_t k = 0; k < b->count; )
        if (b->line[k].count == 1) {
            size_t other = 0;
            while (other < b->count && (other == k || b->line[other].count == 1 ||
                                        !is_near(&b->line[other], b->line[k].p[0], 2 * b->tol)))
                other++;
            if (other < b->count)
                drop_line(b, k);
            else
                k++;
        } else
            k++;
}

void branches_free(branches *b)
{
    for (size_t k = 0; k < b->count; k++)
        free(b->line[k].p);
    free(b->line);
    *b = (branches) { .tol = b->tol };
}
