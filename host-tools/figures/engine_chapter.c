/* host-tools/figures/engine_chapter.c -- the patch of chapter.h through the library; compiled once
 * per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "polygon/gb.h"                 /* loft_gb */
#include "polygon/meanvalue.h"          /* loft_meanvalue_eval */
#include "polygon/wachspress.h"         /* loft_wachspress_eval */
#include "surface/deficit.h"            /* loft_deficit_eval */

#include "figures/chapter.h"
#include "base/memory.h"                /* memory_grow */
#include "engine/engine_harmonic.h"    /* engine_harmonic_solve */
#include "engine/engine_num.h"         /* vec_of, double_of_acc */

#define DEGREE 5
#define LAYERS 3
#define POINTS 46

struct engine_chapter {
    loft_spot v[CHAPTER_SIDES];
    loft_domain domain;
    loft_vec p[POINTS], bump[POINTS];   /* bump: height 1 at V0, else 0: a patch whose height is the
                                         * weight of V0 */
    loft_gb patch, weight;
    unsigned kind;
    engine_harmonic *harmonic;
};

static int place_points(engine_chapter *e, const double v[CHAPTER_SIDES][2])
{
    const double zero[ENGINE_AXES] = { 0 }, one[ENGINE_AXES] = { 0, 0, 1 };
    double c[ENGINE_AXES] = { 0, 0, CHAPTER_V0 }, point[ENGINE_AXES];
    bool fits = true;

    for (unsigned i = 0; i < CHAPTER_SIDES; i++)
        for (unsigned k = 0; k < LAYERS; k++)
            for (unsigned j = k; j + k <= DEGREE; j++) {
                chapter_net(v, i, j, k, point);
                fits = vec_of(point, &e->p[loft_gb_place(CHAPTER_SIDES, DEGREE, i, j, k)]) && fits;
            }
    chapter_middle(v, c);
    for (unsigned i = 0; i < POINTS; i++)
        fits = vec_of(i + 1 < POINTS ? zero : one, &e->bump[i]) && fits;
    return vec_of(c, &e->p[POINTS - 1]) && fits ? LOFT_OK : LOFT_ERR_RANGE;
}

static void chapter_close(engine_chapter *e)
{
    engine_harmonic_free(e->harmonic);
    free(e);
}

static int chapter_open(const double v[CHAPTER_SIDES][2], unsigned kind, engine_chapter **out)
{
    engine_chapter *e = memory_grow(NULL, sizeof *e);
    int status;

    *e = (engine_chapter){ .kind = kind };
    for (unsigned i = 0; i < CHAPTER_SIDES; i++)
        for (int k = 0; k < 2; k++)
            e->v[i].at[k] = LOFT_REAL(v[i][k]);
    status = place_points(e, v);
    if (status == LOFT_OK)
        status = loft_domain_init(&e->domain, e->v, CHAPTER_SIDES);
    if (status == LOFT_OK)
        status = loft_gb_init(&e->patch, e->p, CHAPTER_SIDES, DEGREE);
    if (status == LOFT_OK)
        status = loft_gb_init(&e->weight, e->bump, CHAPTER_SIDES, DEGREE);
    if (status == LOFT_OK && kind == 2)
        status = engine_harmonic_solve(&e->domain, &e->harmonic);
    if (status == LOFT_OK)
        *out = e;
    else
        chapter_close(e);
    return status;
}

static int coordinates(const engine_chapter *e, loft_spot p, loft_sci phi[])
{
    switch (e->kind) {
    case 0:  return loft_wachspress_eval(&e->domain, p, phi);
    case 1:  return loft_meanvalue_eval(&e->domain, p, phi);
    default: return loft_harmonic_eval(engine_harmonic_of(e->harmonic), p, phi);
    }
}

static int coordinate_jets(const engine_chapter *e, loft_spot p, loft_jet phi[])
{
    switch (e->kind) {
    case 0:  return loft_wachspress_jet(&e->domain, p, phi);
    case 1:  return loft_meanvalue_jet(&e->domain, p, phi);
    default: return loft_harmonic_jet(engine_harmonic_of(e->harmonic), p, phi);
    }
}

static double double_of_sci(loft_sci x)
{
    loft_acc wide = 0;
    return loft_sci_to_acc(x, &wide) ? double_of_acc(wide) : NAN;
}

static void jet_of(const loft_differential *l, unsigned axis, double f, chapter_jet *out)
{
    *out = (chapter_jet){ f,
                          double_of_sci(l->u[axis]),
                          double_of_sci(l->v[axis]),
                          double_of_sci(l->uu[axis]),
                          double_of_sci(l->uv[axis]),
                          double_of_sci(l->vv[axis]) };
}

static int chapter_at(const engine_chapter *e, double x, double y, bool bent, chapter_point *out)
{
    const loft_spot p = { { LOFT_REAL(x), LOFT_REAL(y) } };
    loft_sci phi[LOFT_SIDES_MAX], weight[POINTS];
    loft_jet jet[LOFT_SIDES_MAX];
    loft_differential here, bump;
    loft_vec at;
    int status = coordinates(e, p, phi);

    if (status == LOFT_OK)
        status = loft_gb_weights(CHAPTER_SIDES, DEGREE, phi, weight);
    if (status == LOFT_OK)
        status = loft_gb_eval(&e->patch, phi, &at);
    if (status != LOFT_OK)
        return status;
    *out = (chapter_point){ .bent = false };
    out->b0.f = double_of_sci(weight[POINTS - 1]);
    for (unsigned k = 0; k < 3; k++)
        out->p[k].f = double_of(at.axis[k]);
    if (!bent || coordinate_jets(e, p, jet) != LOFT_OK ||
        loft_gb_differential(&e->patch, jet, &here) != LOFT_OK ||
        loft_gb_differential(&e->weight, jet, &bump) != LOFT_OK)
        return LOFT_OK;
    out->bent = true;
    for (unsigned k = 0; k < 3; k++)
        jet_of(&here, k, out->p[k].f, &out->p[k]);
    jet_of(&bump, 2, out->b0.f, &out->b0);
    return LOFT_OK;
}

static int chapter_fan(const double vertex[3], double ring[][3], unsigned count, double *gauss)
{
    loft_vec v, r[CHAPTER_FAN];
    loft_deficit d;
    bool fits = vec_of(vertex, &v);

    for (unsigned i = 0; i < count; i++)
        fits = vec_of(ring[i], &r[i]) && fits;
    const int status = fits ? (int)loft_deficit_eval(&v, r, count, &d) : LOFT_ERR_RANGE;
    if (status == LOFT_OK)
        *gauss = double_of_sci(d.gauss);
    return status;
}

const engine_chapters ENGINE_OF(engine_chapters) = { .rough = sizeof(loft_real) < sizeof(double),
    .open  = chapter_open,
    .close = chapter_close,
    .at    = chapter_at,
                                                     .fan = chapter_fan };
