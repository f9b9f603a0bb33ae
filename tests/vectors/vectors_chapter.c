/* tests/vectors/vectors_chapter.c -- readers of the numbers of `loft study gb`: over the area, at
 * points, along contours
 * SPDX-License-Identifier: MIT
 *
 * The pentagons and nets are those of host-tools/figures/chapter.h, made of numbers that
 * coordinates of 32 bits do not hold. In f32 and q16 the bounds allow for what that moves.
 */
#include <string.h>

#include "support/polygons.h"   /* decimal, sheet_of */
#include "figures/chapter.h"
#include "names.h"              /* LOFT_TAG */

#define ENGINE_(tag) engine_chapters_ ## tag
#define ENGINE__(tag) ENGINE_(tag)
#define ENGINE ENGINE__(LOFT_TAG)

#define KEPT 8

static struct {
    chapter_pentagon p;
    char name[64];
    engine_chapter *patch[CHAPTER_KINDS];
} kept[KEPT];
static unsigned kept_so_far;

/* Those of polygons.csv go before: P2_irregular is pent_P2 there. The regular one is exact only
 * here. */
static bool look_up(row *r, const char *name, chapter_pentagon *out)
{
    const sheet *s = sheet_of(r, "polygons");
    char other[64];
    unsigned found = 0;

    snprintf(other, sizeof other, "pent_%.*s", (int)strcspn(name, "_"), name);
    for (unsigned k = 0; k < s->rows && strcmp(name, chapter_pentagons[0].name) != 0; k++)
        if (strcmp(s->field[k][0], name) == 0 || strcmp(s->field[k][0], other) == 0) {
            const unsigned i = (unsigned)decimal(r, s->field[k][3]) - 1;
            if (i < CHAPTER_SIDES) {
                out->v[i][0] = (double)decimal(r, s->field[k][4]);
                out->v[i][1] = (double)decimal(r, s->field[k][5]);
                found++;
            }
        }
    for (unsigned k = 0; k < 3 && found == 0; k++)
        if (strcmp(name, chapter_pentagons[k].name) == 0) {
            *out = chapter_pentagons[k];
            found = CHAPTER_SIDES;
        }
    if (found != CHAPTER_SIDES)
        row_complain(r, "no pentagon %s", name);
    return found == CHAPTER_SIDES;
}

static engine_chapter *patch_of(row *r, const char *name, unsigned kind)
{
    unsigned k = 0;

    while (k < kept_so_far && strcmp(kept[k].name, name) != 0)
        k++;
    if (k == KEPT || (k == kept_so_far && !look_up(r, name, &kept[k].p)))
        return NULL;
    if (k == kept_so_far)
        snprintf(kept[kept_so_far++].name, sizeof kept[k].name, "%s", name);
    if (kept[k].patch[kind] == NULL &&
        ENGINE.open((const double(*)[2])kept[k].p.v, kind, &kept[k].patch[kind]) != LOFT_OK)
        row_complain(r, "the patch was refused");
    return kept[k].patch[kind];
}

static void expect_near(row *r, const char *what, double got, long double want, long double off)
{
    if (!(fabsl(got - want) <= off))
        row_complain(r, "%s: %.15g, not %.15Lg, may be off by %.3Lg", what, got, want, off);
    row_within(r, what, fabsl(got - want) * 65536, off * 65536);
}

/* How far a number moves with the vertices and the net, which rounding moves by 2^-17, or by 2^-25
 * in floats. */
static long double moved(long double by) { return by * BY_NUM(0x1p-17L, 0x1p-25L, 0); }

static void ch4_points(row *r)
{
    static const char *const letter[CHAPTER_KINDS] = { "W", "M", "H" };
    const double x = (double)decimal(r, row_text(r, "x")), y = (double)decimal(r, row_text(r, "y"));
    char column[8];
    chapter_point p;

    for (unsigned kind = 0; kind < CHAPTER_KINDS; kind++) {
        const engine_chapter *patch = patch_of(r, row_text(r, "polygon"), kind);
        if (patch == NULL)
            return;
        if (ENGINE.at(patch, x, y, true, &p) != LOFT_OK || !p.bent) {
            row_complain(r, "no point by %s", letter[kind]);
            return;
        }
        snprintf(column, sizeof column, "B0_%s", letter[kind]);
        expect_near(r, column, p.b0.f, decimal(r, row_text(r, column)), 1e-12L + moved(8));
        snprintf(column, sizeof column, "Z_%s", letter[kind]);
        expect_near(r, column, p.p[2].f, decimal(r, row_text(r, column)),
                    1e-12L + moved(16) + BY_NUM(0, 0x1p-23L, 0));
        snprintf(column, sizeof column, "K_%s", letter[kind]);
        const long double gauss = decimal(r, row_text(r, column));
        expect_near(r, column, chapter_gauss(&p, 0.2), gauss,
                    (1e-9L + moved(400)) * fmaxl(1, 10 * gauss * gauss));
    }
}

/* At tau the height is the level. */
static void ch4_contours(row *r)
{
    const char *letter = row_text(r, "coordinates");
    const unsigned kind = *letter == 'W' ? 0 : *letter == 'M' ? 1 : 2;
    const engine_chapter *patch = patch_of(r, chapter_pentagons[0].name, kind);
    const long double tau = decimal(r, row_text(r, "tau")), dz = decimal(r, row_text(r, "dz"));
    chapter_point p;

    if (patch == NULL)
        return;
    if (ENGINE.at(patch, (double)(tau * decimal(r, row_text(r, "dx"))),
                  (double)(tau * decimal(r, row_text(r, "dy"))), false, &p) != LOFT_OK) {
        row_complain(r, "no point");
        return;
    }
    expect_near(r, "level", chapter_height(&p, 1, (double)dz).f, decimal(r, row_text(r, "level")),
                1e-12L + moved(24 + 16 * fabsl(dz)) + BY_NUM(0, 0x1p-22L, 0));
    expect_near(r, "X", p.p[0].f, decimal(r, row_text(r, "X")),
                1e-12L + moved(8) + BY_NUM(0, 0x1p-23L, 0));
    expect_near(r, "Y", p.p[1].f, decimal(r, row_text(r, "Y")),
                1e-12L + moved(8) + BY_NUM(0, 0x1p-23L, 0));
}


// Numbers
// -------

#define ROWS 800

static chapter_row given[ROWS];
static unsigned rows_given;

static void keep(void *context, const chapter_row *r)
{
    (void)context;
    if (rows_given < ROWS)
        given[rows_given++] = *r;
}

static const chapter_row *find_row(const char *line)
{
    for (unsigned i = 0; i < 3 && (i > 0 || rows_given == 0); i++)
        if (chapter_study(&ENGINE, &chapter_pentagons[i], BY_NUM(2, 2, 30), keep, NULL) != LOFT_OK)
            return NULL;
    for (unsigned i = 0; i < rows_given; i++) {
        const size_t length = strlen(given[i].key);
        if (strncmp(line, given[i].key, length) == 0 && line[length] == ';')
            return &given[i];
    }
    return NULL;
}

/* What is made of many points is judged in f64 alone: the other two take some. The first and the
 * last of five are extremes of a sample. */
static void ch4_numbers(row *r)
{
    const char *line = row_text(r, "line");
    const chapter_row *got = find_row(line);

    if (got == NULL) {
        if (strncmp(line, "4-6;", 4) != 0 || !ENGINE.rough)
            row_complain(r, "nothing of that name: %.60s", line);
        return;
    }
    const char *at = line + strlen(got->key) + 1;
    for (unsigned i = 0; i < got->count; i++) {
        char *end;
        const long double want = strtold(at, &end);
        const bool extreme = got->count == 5 && (i == 0 || i == 4);
        if (end == at)
            row_complain(r, "number %u is missing", i);
        else if (!(got->sampled && ENGINE.rough) && !extreme)
            expect_near(r, "number", got->value[i], want, got->off * fmaxl(1, fabsl(want)));
        at = end;
    }
}

const vector_system vectors_chapter[] = {
    { "ch4_points", "polygon,x,y,B0_W,B0_M,B0_H,Z_W,Z_M,Z_H,K_W,K_M,K_H", ch4_points,
      "f64 1e-12, curvature 1e-9; f32, q16: 8, 16 and 400 times 2^-25, 2^-17, by which inputs are "
      "rounded" },
    { "ch4_contours", "coordinates,dz,level,dx,dy,tau,X,Y", ch4_contours,
      "f64 1e-12; f32, q16: 24 + 16 |dz| and 8 times 2^-25, 2^-17" },
    { "ch4_numbers", "line", ch4_numbers,
      "f64: 1e-6 at points and along rays, of samples, of 4500 points here, 4e-5 to 0.04, an "
      "estimator of a mesh 0.05; f32, q16: points and rays, 0.05" },
    { 0 }
};
