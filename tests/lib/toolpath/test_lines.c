/* tests/lib/toolpath/test_lines.c -- properties of lib/toolpath/lines.h
 * SPDX-License-Identifier: MIT
 *
 * Against the patch, its normal and its curvature in long double.
 */
#include "support/exact.h"
#include "toolpath/lines.h"

#define COLUMNS 32
#define FINE    16

typedef struct {
    loft_vec net[16];
    loft_tensor as;
    loft_lines_way way;
} field;

/* A patch over about 30 mm that is `high` mm high, in either order of its parameters. */
static void arb_field(arb *a, int32_t high, field *f)
{
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);
    const bool turned = arb_below(a, 2) > 0;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            loft_vec *const p = &f->net[i * (n + 1) + j];
            *p = (loft_vec){ { 0 } };
            p->axis[turned] = loft_real_from_int(30 * (int32_t)i) / (loft_real)m + arb_real(a, 1);
            p->axis[!turned] = loft_real_from_int(30 * (int32_t)j) / (loft_real)n + arb_real(a, 1);
            p->axis[2] = arb_real(a, high);
        }
    CHECK(loft_tensor_init(&f->as, f->net, m, n) == LOFT_OK);
    f->way.radius = LOFT_REAL(1) + (arb_below(a, 2) ? LOFT_REAL(2) : 0);
    f->way.tol = LOFT_REAL(0.02);
    f->way.safe = LOFT_REAL(12);
    f->way.rows = (uint16_t)(1 + arb_below(a, 40));
    f->way.columns = COLUMNS;
    f->way.one_way = arb_below(a, 2) > 0;
}

/* The point, and the derivatives of order 1 and 2, at u, v. */
static void exact_at(const field *f, long double u, long double v, long double d[3][3][3])
{
    static const int choose[4][4] = { { 1 }, { 1, 1 }, { 1, 2, 1 }, { 1, 3, 3, 1 } };

    for (unsigned a = 0; a < 3; a++)
        for (unsigned b = 0; a + b < 3; b++)
            for (int k = 0; k < 3; k++) {
                long double c[4][4];
                const int m = f->as.m, n = f->as.n;
                long double sum = 0, factor = 1;
                for (int i = 0; i <= m; i++)
                    for (int j = 0; j <= n; j++)
                        c[i][j] = exact_of(f->net[i * (n + 1) + j].axis[k]);
                for (unsigned x = 0; x < a; x++, factor *= m - (int)x + 1)
                    for (int i = 0; i + 1 <= m - (int)x; i++)
                        for (int j = 0; j <= n; j++)
                            c[i][j] = c[i + 1][j] - c[i][j];
                for (unsigned y = 0; y < b; y++, factor *= n - (int)y + 1)
                    for (int i = 0; i <= m - (int)a; i++)
                        for (int j = 0; j + 1 <= n - (int)y; j++)
                            c[i][j] = c[i][j + 1] - c[i][j];
                for (int i = 0; i <= m - (int)a; i++)
                    for (int j = 0; j <= n - (int)b; j++)
                        sum += c[i][j] * choose[m - (int)a][i] * choose[n - (int)b][j] *
                               powl(u, i) * powl(1 - u, m - (int)a - i) * powl(v, j) *
                               powl(1 - v, n - (int)b - j);
                d[a][b][k] = (int)a > m || (int)b > n ? 0 : sum * factor;
            }
}

static long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The tip over u, v. Returns the curvature toward the ball, or 1e9 if the normal is not upward. */
static long double exact_tip(const field *f, long double u, long double v, long double tip[3])
{
    const long double r = exact_of(f->way.radius);
    long double d[3][3][3], n[3];

    exact_at(f, u, v, d);
    for (int k = 0; k < 3; k++)
        n[k] = d[1][0][(k + 1) % 3] * d[0][1][(k + 2) % 3] -
               d[1][0][(k + 2) % 3] * d[0][1][(k + 1) % 3];
    const long double length = sqrtl(dot(n, n)) * (n[2] < 0 ? -1 : 1);
    for (int k = 0; k < 3; k++) {
        n[k] /= length;
        tip[k] = d[0][0][k] + r * (n[k] - (k == 2));
    }
    const long double e = dot(d[1][0], d[1][0]), g = dot(d[0][1], d[0][1]),
                      h = dot(d[1][0], d[0][1]), l = dot(d[2][0], n), m = dot(d[1][1], n),
                      q = dot(d[0][2], n), area = e * g - h * h, two = e * q - 2 * h * m + g * l,
                      gauss = l * q - m * m;
    if (!(area > 0 && n[2] > 0))
        return 1e9L;
    return (two + sqrtl(fmaxl(0, two * two - 4 * area * gauss))) / (2 * area);
}

static long double distance(const long double a[3], const long double b[3])
{
    return hypotl(hypotl(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static void at_curve(const loft_cubic *c, long double t, long double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (1 - t) * (1 - t) * (1 - t) * exact_of(c->p[0].axis[k]) +
                 3 * t * (1 - t) * (1 - t) * exact_of(c->p[1].axis[k]) +
                 3 * t * t * (1 - t) * exact_of(c->p[2].axis[k]) +
                 t * t * t * exact_of(c->p[3].axis[k]);
}

static loft_tip row[COLUMNS + 1];
static loft_lines lines;

/* A field that can be cut with some number of columns up to COLUMNS. */
static bool begin(field *f, const loft_vec *start)
{
    bool near;

    for (f->way.columns = 1; f->way.columns < COLUMNS; f->way.columns++)
        if (loft_lines_check(&f->as, &f->way, &near) != LOFT_LINES_COARSE)
            break;
    return loft_lines_init(&lines, &f->as, &f->way, start, row, COLUMNS + 1) == LOFT_OK;
}

static const loft_vec home = { { LOFT_REAL(-5), LOFT_REAL(3), LOFT_REAL(20) } };

/* Each curve begins where the last one ended, keeps the tolerance along its line and along the
 * edge, and the way is as long as asked. */
static void curves_keep_to_the_lines(arb *a)
{
    static unsigned begun, joined;
    unsigned line = 0, place = 0, cut = 0;
    loft_vec at = home;
    loft_cubic c;
    bool cuts;
    field f;

    arb_field(a, 3, &f);
    if (begin(&f, &home)) {
        const unsigned rows = f.way.rows, columns = f.way.columns;
        const long double tol = exact_of(f.way.tol);
        begun++;
        while (loft_lines_next(&lines, &c, &cuts)) {
            long double got[3], want[3], tip[2][3];
            CHECK(loft_vec_equal(c.p[0], at));
            at = c.p[3];
            if (!cuts) {
                CHECK(c.p[0].axis[2] >= f.way.safe || c.p[3].axis[2] >= f.way.safe);
                continue;
            }
            const bool back = line & 1 && !f.way.one_way;
            const long double u = (long double)line / rows;
            exact_tip(&f, u, back, tip[0]);
            for (int k = 0; k < 3; k++)
                got[k] = exact_of(c.p[3].axis[k]);
            if (place == 0 && (c.p[0].axis[2] >= f.way.safe || (line > 0 && cut++ == 0))) {
                /* down to the line, or along the edge */
                CHECK(distance(got, tip[0]) < BY_NUM(0x5p-16L, 0x1p-16L, 1e-6L));
                if (c.p[0].axis[2] >= f.way.safe) {
                    cut = 1;
                    continue;
                }
                joined++;
                for (int k = 0; k <= 8; k++) {
                    at_curve(&c, k / 8.0L, got);
                    exact_tip(&f, u - (1 - k / 8.0L) / rows, back, want);
                    CHECK(distance(got, want) <= tol);
                }
                continue;
            }
            for (int k = 0; k <= 8; k++) {
                const long double v = (place + k / 8.0L) / columns;
                at_curve(&c, k / 8.0L, got);
                exact_tip(&f, u, back ? 1 - v : v, want);
                CHECK(distance(got, want) <= tol);
            }
            CHECK(distance(got, want) < BY_NUM(0x5p-16L, 0x1p-16L, 1e-6L));
            if (++place == columns) {
                place = cut = 0;
                line++;
            }
        }
        CHECK(line == rows + 1 && place == 0);
        CHECK(loft_vec_equal(at, home));
        CHECK(!loft_lines_next(&lines, &c, &cuts));
    }
    if (!check_sampled() && check_seed == 80)
        CHECK(begun > 30 && joined > 100);
}

/* What is refused could not be cut, or nearly: the worst of a grid shows it. What is not, can. */
static void faults_are_true(arb *a)
{
    static unsigned found[8];
    long double worst = 0, tip[3];
    bool near;
    field f;

    arb_field(a, 2 + (int32_t)arb_below(a, 30), &f);
    f.way.safe = LOFT_REAL(40);
    const enum loft_lines_fault fault = loft_lines_check(&f.as, &f.way, &near);
    for (int i = 0; i <= FINE; i++)
        for (int j = 0; j <= FINE; j++)
            worst = fmaxl(worst, exact_tip(&f, (long double)i / FINE, (long double)j / FINE, tip));
    found[fault]++;
    const long double most = worst * exact_of(f.way.radius);
    if (fault == LOFT_LINES_FINE)
        CHECK(most < 1);
    if (fault == LOFT_LINES_GOUGE)
        CHECK(most > 0.1L);
    if (!check_sampled() && check_seed == 120)
        CHECK(found[LOFT_LINES_FINE] > 50 && found[LOFT_LINES_GOUGE] > 10);
}

/* No place of the ball has a point of the patch in it. */
static void nothing_is_cut(arb *a)
{
    static long double at[33][33][3];
    long double tip[3], d[3][3][3];
    bool near;
    field f;

    arb_field(a, 4, &f);
    if (loft_lines_check(&f.as, &f.way, &near) != LOFT_LINES_FINE)
        return;
    for (int i = 0; i <= 32; i++)
        for (int j = 0; j <= 32; j++) {
            exact_at(&f, i / 32.0L, j / 32.0L, d);
            for (int k = 0; k < 3; k++)
                at[i][j][k] = d[0][0][k];
        }
    const long double r = exact_of(f.way.radius);
    for (int i = 2; i <= 30; i++)
        for (int j = 2; j <= 30; j++) {
            exact_tip(&f, i / 32.0L, j / 32.0L, tip);
            tip[2] += r;
            for (int x = 0; x <= 32; x++)
                for (int y = 0; y <= 32; y++)
                    CHECK(distance(tip, at[x][y]) >= r - 1e-9L);
        }
}

static void refuses_what_it_cannot_keep(arb *a)
{
    loft_vec net[16];
    loft_lines_way way = { LOFT_REAL(3), LOFT_REAL(0.01), LOFT_REAL(12), 10, 10, false };
    loft_tensor s;
    bool near;

    (void)a;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            net[4 * i + j] = (loft_vec){ { loft_real_from_int(10 * i),
                                           loft_real_from_int(10 * j) } };
    CHECK(loft_tensor_init(&s, net, 3, 3) == LOFT_OK);
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_FINE && near);
    CHECK(loft_lines_init(&lines, &s, &way, &home, row, 10) == LOFT_ERR_SPACE);
    way.safe = -LOFT_REAL(1);
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_LOW);
    way.safe = LOFT_REAL(12);
    net[0].axis[2] = LOFT_REAL(11);                 /* a steep corner bends more along its lines */
    way.columns = 1;
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_COARSE);
    way.columns = 64;
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_FINE);
    net[0].axis[2] = 0;
    for (int i = 0; i < 4; i++)                     /* a ridge that turns over */
        net[4 * i + 1].axis[1] = LOFT_REAL(40);
    CHECK(loft_lines_check(&s, &way, &near) != LOFT_LINES_FINE);
    for (int i = 0; i < 4; i++)                     /* a wall */
        for (int j = 0; j < 4; j++)
            net[4 * i + j] = (loft_vec){ { loft_real_from_int(10 * i), 0, loft_real_from_int(j) } };
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_OVERHANG);
    for (int k = 0; k < 16; k++)                    /* a line */
        net[k].axis[2] = 0;
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_NORMAL);
    for (int i = 0; i < 4; i++)                     /* a gutter narrower than the ball */
        for (int j = 0; j < 4; j++)
            net[4 * i + j] = (loft_vec){ { loft_real_from_int(10 * i), loft_real_from_int(2 * j),
                                           j == 0 || j == 3 ? LOFT_REAL(4) : 0 } };
    CHECK(loft_lines_check(&s, &way, &near) == LOFT_LINES_GOUGE);
    CHECK(loft_lines_init(&lines, &s, &way, &home, row, COLUMNS + 1) == LOFT_SINGULAR);
}

/* The fewest columns that can be proved for a patch with one high corner. */
static uint16_t columns_at(int32_t x, int32_t high)
{
    loft_lines_way way = { LOFT_REAL(4), LOFT_REAL(1 / 1024.0), LOFT_REAL(12), 10, 1, false };
    loft_vec net[16];
    loft_tensor s;
    bool near;

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            net[4 * i + j] = (loft_vec){ { loft_real_from_int(x + 10 * i),
                                           loft_real_from_int(10 * j) } };
    net[0].axis[2] = loft_real_from_int(high);
    CHECK(loft_tensor_init(&s, net, 3, 3) == LOFT_OK);
    while (loft_lines_check(&s, &way, &near) != LOFT_LINES_FINE && way.columns < 1024)
        way.columns++;
    return way.columns;
}

/* Far out f32 has fewer digits, whichever coordinate is the largest. */
static void a_patch_far_out_is_as_fine_as_its_digits(arb *a)
{
    const int32_t high = 1 + (int32_t)arb_below(a, 4), far = arb_below(a, 2) ? 990 : -1020;
    const uint16_t here = columns_at(0, high), there = columns_at(far, high);

    CHECK(here > 1 && here < 1024 && there < 1024);
    CHECK(BY_NUM(there == here, there > here, there == here));
}

int main(void)
{
    PROPERTY(a_patch_far_out_is_as_fine_as_its_digits, 2);
    PROPERTY(refuses_what_it_cannot_keep, 1);
    PROPERTY_LONG(curves_keep_to_the_lines, 80);
    PROPERTY(faults_are_true, 120);
    PROPERTY_LONG(nothing_is_cut, 6);
    return check_failures();
}
