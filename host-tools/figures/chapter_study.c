/* host-tools/figures/chapter_study.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figures/chapter.h"
#include "base/memory.h"             /* memory_grow */

#define RAYS    72          /* from the middle */
#define STEPS   (s->rough ? 25 : 120)   /* of a ray, closer together toward the middle */
#define HEIGHTS 5
#define SHIFTS  5

static const double heights[HEIGHTS] = { 0.2, 0.25, 0.4, 0.15, 0.05 },
                    shifts[SHIFTS] = { 0, 1.4, 4.4, -0.6, -1.6 };

// Rows
// ----

typedef struct {
    const chapter_pentagon *p;
    engine_chapter *patch[CHAPTER_KINDS];
    const engine_chapters *e;
    double middle[2];
    bool rough;                 /* as in engine_chapters */
    double few;                 /* the error of a sample with fewer than 18000 points, as a multiple
                                 * of the error with 18000 */
    chapter_sink *sink;
    void *context;
} study;

static void give_row(const study *s, double off, const double value[], unsigned count,
                     const char *figure, const char *kind, const char *format, ...)
    __attribute__((format(printf, 7, 8)));

static void give_row(const study *s, double off, const double value[], unsigned count,
                     const char *figure, const char *kind, const char *format, ...)
{
    chapter_row r = { .off = off,
                      .count = count,
                      .sampled = strcmp(figure, "4-6..4-11") != 0 &&
                                 strstr(format, "at the centre") == NULL };
    char quantity[180];
    va_list arguments;

    if (r.sampled)
        r.off *= s->few;
    va_start(arguments, format);
    vsnprintf(quantity, sizeof quantity, format, arguments);
    va_end(arguments);
    snprintf(r.key, sizeof r.key, "%s;%s;%s;%s", figure, s->p->name, quantity, kind);
    memcpy(r.value, value, count * sizeof *value);
    s->sink(s->context, &r);
}

/* Sines of whole turns are 1e-16, which does not suit exact decisions. */
static double tidy(double x) { return fabs(x) < 1e-15 ? 0 : x; }

static void eval_point(const study *s, unsigned kind, double x, double y, bool bent,
                       chapter_point *out)
{
    if (s->e->at(s->patch[kind], tidy(x), tidy(y), bent, out) != 0)
        *out = (chapter_point){ .bent = false };
}

/* The place at fraction rho of the way from the middle to a point of the boundary. */
static void eval_on_ray(const study *s, unsigned kind, const double to[2], double rho, bool bent,
                        chapter_point *out)
{
    eval_point(s, kind, s->middle[0] + rho * (to[0] - s->middle[0]),
               s->middle[1] + rho * (to[1] - s->middle[1]), bent, out);
}


// The sample: the middles of equal triangles
// ------------------------------------------

typedef struct {
    double weight, rho, b0[CHAPTER_KINDS], gauss[CHAPTER_KINDS][HEIGHTS];
} place;

typedef struct {
    place *place;
    size_t count;
    double area;
} sample;

static void take_point(const study *s, sample *all, bool bent, double weight, double rho, double x,
                       double y)
{
    place *q = &all->place[all->count++];

    *q = (place){ .weight = weight, .rho = rho };
    all->area += weight;
    for (unsigned k = 0; k < CHAPTER_KINDS; k++) {
        chapter_point p;
        eval_point(s, k, x, y, bent, &p);
        q->b0[k] = p.b0.f;
        for (int h = 0; h < HEIGHTS; h++)
            q->gauss[k][h] = p.bent ? chapter_gauss(&p, heights[h]) : 0;
    }
}

static void take_points(const study *s, bool bent, unsigned fine, sample *all)
{
    *all = (sample){ .place = memory_grow(NULL,
                                          CHAPTER_SIDES * (size_t)fine * fine * sizeof(place)) };
    for (unsigned i = 0; i < CHAPTER_SIDES; i++) {
        const double *a = s->p->v[i], *b = s->p->v[(i + 1) % CHAPTER_SIDES], *c = s->middle;
        const double area = ((a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])) / 2 /
                            fine / fine;
        for (unsigned row = 0; row < fine; row++)
            for (unsigned k = 0; k < 2 * row + 1; k++) {
                const double rho = (row + (k % 2 ? 1.0 / 3 : 2.0 / 3)) / fine,
                             share = (k / 2 + (k % 2 ? 2.0 / 3 : 1.0 / 3)) / fine;
                take_point(s, all, bent, area, rho,
                           c[0] + rho * (a[0] - c[0]) + share * (b[0] - a[0]),
                           c[1] + rho * (a[1] - c[1]) + share * (b[1] - a[1]));
            }
    }
}

typedef bool question(const place *q, const void *how);

/* The share of the area with rho from `low` to `high` where the answer is yes. */
static double area_share(const sample *all, double low, double high, question *is, const void *how)
{
    double yes = 0, area = 0;

    for (size_t i = 0; i < all->count; i++) {
        const place *q = &all->place[i];
        if (q->rho < low || q->rho >= high)
            continue;
        area += q->weight;
        yes += is(q, how) ? q->weight : 0;
    }
    return yes / area;
}


// 4-3 to 4-5: the weight of V0
// ----------------------------

static bool weight_is_negative(const place *q, const void *how)
{
    return q->b0[*(const unsigned *)how] < 0;
}

/* which[0] is above which[1], and that above which[2] if there are three. */
static bool weights_in_order(const place *q, const void *how)
{
    const unsigned *which = how;
    return q->b0[which[0]] > q->b0[which[1]] &&
           (which[2] == CHAPTER_KINDS || q->b0[which[1]] > q->b0[which[2]]);
}

/* The point where the ray from the middle at an angle leaves the pentagon. */
static void leave_pentagon(const study *s, double angle, double out[2])
{
    const double d[2] = { cos(angle), sin(angle) };

    for (unsigned i = 0; i < CHAPTER_SIDES; i++) {
        const double *a = s->p->v[i], *b = s->p->v[(i + 1) % CHAPTER_SIDES],
                     e[2] = { b[0] - a[0], b[1] - a[1] },
                     f[2] = { a[0] - s->middle[0], a[1] - s->middle[1] };
        const double det = d[0] * e[1] - d[1] * e[0], t = (f[0] * e[1] - f[1] * e[0]) / det,
                     u = (f[0] * d[1] - f[1] * d[0]) / det;
        if (det > 0 && t > 0 && u >= -1e-12 && u <= 1 + 1e-12)
            for (int k = 0; k < 2; k++)
                out[k] = s->middle[k] + t * d[k];
    }
}

static double falling_rays(const study *s, unsigned kind)
{
    double falling = 0, to[2] = { 0, 0 };

    for (int ray = 0; ray < RAYS; ray++) {
        bool falls = true;
        double last = INFINITY;
        leave_pentagon(s, 2 * acos(-1) * ray / RAYS, to);
        for (int i = 0; i < STEPS && falls; i++) {
            chapter_point p;
            eval_on_ray(s, kind, to, pow((double)i / STEPS, 1.5), false, &p);
            falls = p.b0.f < last + (s->rough ? 1e-6 : 1e-12);
            last = p.b0.f;
        }
        falling += falls;
    }
    return falling / RAYS;
}

static void study_weights(const study *s, const sample *all)
{
    for (unsigned k = 0; k < CHAPTER_KINDS; k++) {
        double mean = 0, most = -INFINITY, least = INFINITY;
        chapter_point middle;
        for (size_t i = 0; i < all->count; i++) {
            mean += all->place[i].weight * all->place[i].b0[k] / all->area;
            most = fmax(most, all->place[i].b0[k]);
            least = fmin(least, all->place[i].b0[k]);
        }
        eval_point(s, k, s->middle[0], s->middle[1], false, &middle);
        const double negative = area_share(all, 0, 1, weight_is_negative, &k),
                     falling = falling_rays(s, k);
        give_row(s, s->rough ? 1e-4 : 1e-5, &mean, 1, "4-3", chapter_kinds[k],
                 "mean of B0 over the pentagon (dZ = dz*B0)");
        give_row(s, 1e-3, &most, 1, "4-3", chapter_kinds[k], "max of B0 on the sample");
        give_row(s, 1e-2, &least, 1, "4-3", chapter_kinds[k], "min of B0 on the sample");
        give_row(s, s->rough ? 1e-4 : 1e-9, &middle.b0.f, 1, "4-3", chapter_kinds[k],
                 "B0 at the centre (vertex mean)");
        give_row(s, 2e-3, &negative, 1, "4-3", chapter_kinds[k], "area fraction with B0 < 0");
        give_row(s, 0.06, &falling, 1, "4-3", chapter_kinds[k],
                 "fraction of %d centre rays on which B0 decreases monotonically outward", RAYS);
    }
}

static void study_orders(const study *s, const sample *all)
{
    static const unsigned order[4][3] = {
        { 1, 2, CHAPTER_KINDS }, { 2, 0, CHAPTER_KINDS }, { 1, 0, CHAPTER_KINDS }, { 1, 2, 0 }
    };

    for (int i = 0; i < 4; i++) {
        const double part = area_share(all, 0, 1, weights_in_order, order[i]);
        give_row(s, 4e-3, &part, 1, "4-4/4-5", "-",
                 i < 3 ? "area fraction B0_%s > B0_%s" : "area fraction B0_%s > B0_%s > B0_%s",
                 chapter_kinds[order[i][0]], chapter_kinds[order[i][1]],
                 chapter_kinds[order[i][2] % CHAPTER_KINDS]);
    }
    for (int i = 0; i < 3; i++) {
        double most = 0;
        for (size_t k = 0; k < all->count; k++)
            most = fmax(most, fabs(all->place[k].b0[order[i][0]] - all->place[k].b0[order[i][1]]));
        give_row(s, 1e-3, &most, 1, "4-4/4-5", "-", "max |B0_%s - B0_%s|",
                 chapter_kinds[order[i][0]], chapter_kinds[order[i][1]]);
    }
}


// 4-6 to 4-11: ridges and valleys
// -------------------------------

static void study_ridges(const study *s, unsigned kind, bool vertex)
{
    static const double rho[3] = { 0.5, 0.75, 0.9 };
    const char *ray = vertex ? "vertex" : "midedge";
    double value[SHIFTS][3] = { { 0 } }, valley[SHIFTS] = { 0 };
    chapter_point p;

    for (unsigned i = 0; i < CHAPTER_SIDES; i++) {
        const double *a = s->p->v[i], *b = s->p->v[(i + 1) % CHAPTER_SIDES];
        const double to[2] = { vertex ? a[0] : (a[0] + b[0]) / 2,
                               vertex ? a[1] : (a[1] + b[1]) / 2 };
        for (int k = 0; k < 3; k++) {
            eval_on_ray(s, kind, to, rho[k], true, &p);
            for (int h = 0; h < SHIFTS; h++)
                value[h][k] += chapter_across(&p, shifts[h]) / CHAPTER_SIDES;
        }
        for (int k = 1; k < 40; k++) {
            eval_on_ray(s, kind, to, k / 40.0, true, &p);
            for (int h = 0; h < SHIFTS; h++)
                valley[h] += (chapter_across(&p, shifts[h]) > 0) / (39.0 * CHAPTER_SIDES);
        }
    }
    for (int h = 0; h < SHIFTS; h++) {
        give_row(s, s->rough ? 0.02 : 1e-3, &valley[h], 1, "4-6..4-11", chapter_kinds[kind],
                 "fraction of the centre-%s ray(s) with Z_tt>0 (valley), dz=%g", ray, shifts[h]);
        give_row(s, s->rough ? 0.05 : 1e-6, value[h], 3, "4-6..4-11", chapter_kinds[kind],
                 "Z_tt on the centre-%s ray at rho=0.5, 0.75, 0.9; dz=%g", ray, shifts[h]);
    }
}


// 4-12 to 4-15: curvature
// -----------------------

typedef struct {
    unsigned which;             /* MV above W, H above W, both or none */
    int height;
} comparison;

static bool curvature_is_above(const place *q, const void *how)
{
    const comparison *c = how;
    const double w = q->gauss[0][c->height];
    const bool mean = q->gauss[1][c->height] > w, harmonic = q->gauss[2][c->height] > w;

    return c->which == 0 ? mean : c->which == 1 ? harmonic : mean == harmonic;
}

static void curvature_fractions(const study *s, const sample *all, int h)
{
    static const struct {
        const char *name;
        double low, high;
    } part[5] = { { "whole", 0, 2 },
                  { "inner rho<0.3", 0, 0.3 },
                  { "ring 0.3..0.7", 0.3, 0.7 },
                  { "ring 0.7..0.9", 0.7, 0.9 },
                  { "outer rho>0.9", 0.9, 2 } };
    static const char *const name[3] = { "K_MV > K_W", "K_H > K_W",
                                         "sign(K_MV-K_W)=sign(K_H-K_W)" };

    for (int i = 0; i < 5; i++)
        for (unsigned which = 0; which < 3; which++) {
            const comparison c = { which, h };
            const double value = area_share(all, part[i].low, part[i].high, curvature_is_above, &c);
            give_row(s, s->rough ? 0.1 : 0.01, &value, 1, "4-13..4-15", "-",
                     "area fraction %s, %s, V0 height %g", name[which], part[i].name, heights[h]);
        }
}

/* The correlation of the curvatures for two kinds of coordinates, within rho < 0.9. Here and in the
 * quantiles all points count the same, and so do their five triangles, as in the numbers to compare
 * with. */
static double correlation(const sample *all, unsigned a, unsigned b, int h)
{
    double count = 0, mean[2] = { 0, 0 }, both = 0, square[2] = { 0, 0 };

    for (size_t i = 0; i < all->count; i++)
        if (all->place[i].rho < 0.9) {
            count += 1;
            mean[0] += all->place[i].gauss[a][h];
            mean[1] += all->place[i].gauss[b][h];
        }
    for (size_t i = 0; i < all->count; i++)
        if (all->place[i].rho < 0.9) {
            const double u = all->place[i].gauss[a][h] - mean[0] / count,
                         v = all->place[i].gauss[b][h] - mean[1] / count;
            both += u * v;
            square[0] += u * u;
            square[1] += v * v;
        }
    return both / sqrt(square[0] * square[1]);
}

static int compare_values(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The smallest value, the 5 %, 50 % and 95 % quantiles, and the largest value. */
static void study_quantiles(const study *s, const sample *all, unsigned kind, int h)
{
    static const double part[5] = { 0, 0.05, 0.5, 0.95, 1 };
    double value[5], *sorted = memory_grow(NULL, all->count * sizeof *sorted);

    for (size_t i = 0; i < all->count; i++)
        sorted[i] = all->place[i].gauss[kind][h];
    qsort(sorted, all->count, sizeof *sorted, compare_values);
    for (int k = 0; k < 5; k++)
        value[k] = sorted[(size_t)(part[k] * (double)(all->count - 1) + 0.5)];
    free(sorted);
    give_row(s, s->rough ? 0.03 : 5e-3, value, 5, "4-12..4-15", chapter_kinds[kind],
             "K on the sample: min, 5%%, median, 95%%, max; V0 height %g", heights[h]);
}

static void study_curvatures(const study *s, const sample *all, int h)
{
    for (unsigned k = 0; k < CHAPTER_KINDS; k++) {
        chapter_point middle;
        eval_point(s, k, s->middle[0], s->middle[1], true, &middle);
        const double value = chapter_gauss(&middle, heights[h]);
        give_row(s, s->rough ? 3e-3 : 1e-9, &value, 1, "4-12..4-15", chapter_kinds[k],
                 "analytic K at the centre, V0 height %g (net/8)", heights[h]);
        study_quantiles(s, all, k, h);
    }
    const double together[3] = { correlation(all, 1, 2, h), correlation(all, 1, 0, h),
                                 correlation(all, 2, 0, h) };
    curvature_fractions(s, all, h);
    give_row(s, s->rough ? 0.05 : 5e-3, together, 3, "4-13..4-15", "-",
             "correlation of K, rho<0.9, V0 height %g: (MV,H) (MV,W) (H,W)", heights[h]);
}


// 4-6: what a mesh makes of the curvature
// ---------------------------------------

/* The first triangle of the regular pentagon represents all. u runs along the side, v outward. */
static void mesh_point(const study *s, unsigned kind, double u, double v, double height, bool bent,
                       chapter_point *p, double out[3])
{
    const double *a = s->p->v[0], *b = s->p->v[1],
                 to[2] = { a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1]) };

    eval_on_ray(s, kind, to, v, bent, p);
    out[0] = p->p[0].f;
    out[1] = p->p[1].f;
    out[2] = chapter_height(p, 1.0 / 8, 8 * height - CHAPTER_V0).f;
}

static double triangle_corner(double sorted[], size_t count, double part)
{
    qsort(sorted, count, sizeof *sorted, compare_values);
    return sorted[(size_t)(part * (double)(count - 1) + 0.5)];
}

/* A quantile of a few hundred different numbers is the next number if one more falls on the other
 * side. So a difference up to 0.05 counts as equal. */
static void study_estimator(const study *s, unsigned kind, int h, unsigned n)
{
    const size_t most = (size_t)n * n;
    double *error = memory_grow(NULL, most * sizeof *error),
           *ratio = memory_grow(NULL, most * sizeof *ratio), largest = 0, vertex[3],
           ring[CHAPTER_FAN][3], mesh;
    chapter_point p, beside;
    size_t count = 0;

    for (unsigned i = 1; i < n; i++)
        for (unsigned k = 1; k < n; k++) {
            static const int step[CHAPTER_FAN][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
            mesh_point(s, kind, (double)i / n, (double)k / n, heights[h], true, &p, vertex);
            for (int m = 0; m < CHAPTER_FAN; m++)
                mesh_point(s, kind, (i + (double)step[m][0]) / n, (k + (double)step[m][1]) / n,
                           heights[h], false, &beside, ring[m]);
            if (s->e->fan(vertex, ring, CHAPTER_FAN, &mesh) != 0)
                continue;
            const double gauss = chapter_gauss(&p, heights[h]);
            error[count] = fabs(mesh - gauss);
            ratio[count++] = mesh / gauss;
            largest = fmax(largest, fabs(gauss));
        }
    const double value[4] = { triangle_corner(error, count, 0.5),
                              triangle_corner(error, count, 0.95),
                              triangle_corner(ratio, count, 0.5), largest };
    free(error);
    free(ratio);
    give_row(s, 0.05, value, 4, "4-6", chapter_kinds[kind],
             "discrete (4 neighbour fan on the (u,v) mesh, %ux%u per sector) versus analytic K, V0 "
             "height %g: "
             "median |error|, 95%% |error|, median Kd/K, max |K|",
             n, n, heights[h]);
}


// The whole
// ---------

static void study_kinds(const study *s, const sample *all, const sample *bent)
{
    study_weights(s, all);
    study_orders(s, all);
    for (unsigned k = 0; k < CHAPTER_KINDS; k++)
        for (int vertex = 1; vertex >= 0; vertex--)
            study_ridges(s, k, vertex);
    for (int h = 0; h < HEIGHTS; h++)
        study_curvatures(s, bent, h);
    for (int h = 0; h < 3 && s->p == &chapter_pentagons[0] && !s->rough; h += 2)
        for (unsigned k = 0; k < CHAPTER_KINDS; k++)
            for (unsigned n = 20; n <= 80; n += 60)
                study_estimator(s, k, h, n);
}

int chapter_study(const engine_chapters *e, const chapter_pentagon *p, unsigned fine,
                  chapter_sink *sink, void *context)
{
    study s = { .p = p,
                .e = e,
                .rough = e->rough,
                .few = fine < 30   ? INFINITY
                       : fine < 60 ? 3600.0 / fine / fine
                                   : 1,
                .sink = sink,
                .context = context };
    sample all, bent;
    int status = 0;

    chapter_middle(p->v, s.middle);
    for (unsigned k = 0; k < CHAPTER_KINDS && status == 0; k++)
        status = e->open(p->v, k, &s.patch[k]);
    if (status == 0) {
        take_points(&s, false, 2 * fine, &all);
        take_points(&s, true, fine, &bent);
        study_kinds(&s, &all, &bent);
        free(all.place);
        free(bent.place);
    }
    for (unsigned k = 0; k < CHAPTER_KINDS; k++)
        if (s.patch[k] != NULL)
            e->close(s.patch[k]);
    return status;
}
