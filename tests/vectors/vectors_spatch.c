/* tests/vectors/vectors_spatch.c -- readers of S-patches: nets, points, other forms
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "support/exact_polygon.h"          /* exact_meanvalue */
#include "support/polygons.h"               /* polygon_of, coordinates */
#include "polygon/spatch.h"

#define POINTS 12000

/* The patch of a case; the arrays stay where they are, one patch at a time. */
typedef struct {
    loft_spatch s;
    polygon domain;
    char which;
    unsigned n, d;
} patch;

static loft_vec point[POINTS];
static loft_real weight[POINTS];

static unsigned rank_of(row *r, const char *text, unsigned n, unsigned sum)
{
    int l[LOFT_SIDES_MAX + 1];
    uint8_t index[LOFT_SIDES_MAX];
    unsigned total = 0;

    if (wholes(text, l, LOFT_SIDES_MAX + 1) != n)
        row_complain(r, "no index of %u parts at '%.30s'", n, text);
    for (unsigned i = 0; i < n && !r->complaint[0]; i++) {
        index[i] = (uint8_t)l[i];
        total += (unsigned)l[i];
    }
    if (r->complaint[0] || total != sum) {
        row_complain(r, "the parts of '%.30s' do not sum to %u", text, sum);
        return 0;
    }
    return loft_multiindex_rank(index, n);
}

static const char *domain_of(const sheet *s, const char *id)
{
    unsigned k = 0;

    while (k < s->rows && strcmp(s->field[k][0], id) != 0)
        k++;
    return k < s->rows ? s->field[k][4] : "";
}

static bool patch_of(row *r, const char *id, bool with_domain, patch *p)
{
    const sheet *s = sheet_of(r, "spatch_net");
    unsigned found = 0;
    bool rational = false;

    p->n = p->d = 0;
    if (with_domain && !polygon_of(r, domain_of(s, id), &p->domain))
        return false;
    const long double inexact = r->inexact;
    r->largest = 0;
    for (unsigned k = 0; k < s->rows; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        p->n = (unsigned)decimal(r, f[1]);
        p->d = (unsigned)decimal(r, f[2]);
        p->which = f[3][0];
        rational = strcmp(f[5], "1") == 0;
        const unsigned rank = rank_of(r, f[6], p->n, p->d);
        if (rank >= POINTS || p->n > LOFT_SIDES_MAX)
            return false;
        const long double largest = r->largest;
        weight[rank] = decimal_real(r, f[7]);
        r->largest = largest;
        for (int i = 0; i < 3; i++)
            point[rank].axis[i] = decimal_real(r, f[8 + i]);
        found++;
    }
    r->inexact = fmaxl(r->inexact, inexact);
    if (!found || found != loft_multiindex_count(p->n, p->d))
        row_complain(r, "the net of %s has %u points", id, found);
    else if (loft_spatch_init(&p->s, point, rational ? weight : NULL, p->n, p->d) != LOFT_OK)
        row_complain(r, "the patch %s was refused", id);
    return !r->complaint[0];
}

/* Every index has a place of its own, and a corner of the patch is its point. */
static void spatch_net(row *r)
{
    patch p;
    loft_sci phi[LOFT_SIDES_MAX];
    int l[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } };

    if (!patch_of(r, row_text(r, "case"), true, &p))
        return;
    wholes(row_text(r, "lambda"), l, LOFT_SIDES_MAX);
    for (unsigned i = 0; i < p.n; i++)
        if ((unsigned)l[i] == p.d) {
            loft_domain_vertex(&p.domain.d, i, phi);
            expect_point(r, loft_spatch_eval(&p.s, phi, &v), v,
                         (law){ .lsb = 0, .gain = 1, .roundings = 0 });
        }
}

/* The bound in spatch.h, and what mean values lose outside: (1 + |phi|) K 2^-56 or 2^-47 each,
 * times depth M / sum |phi|. */
static law point_law(const patch *p, loft_spot at, const loft_sci phi[], long double largest)
{
    loft_sci area[LOFT_SIDES_MAX];
    long double own[LOFT_SIDES_MAX], sum = 0;
    unsigned index;

    for (unsigned i = 0; i < p->n; i++) {
        loft_acc x = 0;
        if (loft_sci_to_acc(phi[i], &x))
            sum += fabsl(exact_acc(x));
    }
    const long double gain = powl(sum, p->d);
    const bool outside = p->which == 'M' &&
                         loft_domain_place(&p->domain.d, at, area, &index) == LOFT_OUTSIDE;
    const long double lost =
        outside ? p->n * p->d * (1 + sum) * exact_meanvalue(p->domain.v, p->n, at, own) : 0;
    return (law){ .lsb = 0.5L + (1 + gain) / 32768 + gain * lost * largest * 0x1p-40L,
                  .gain = gain * 64,
                  .roundings = 64 + 32 * lost };
}

static void spatch_eval(row *r)
{
    static loft_sci work[POINTS];
    patch p;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } }, u = { { 0 } };

    if (!patch_of(r, row_text(r, "case"), true, &p))
        return;
    const long double largest = r->largest;
    const loft_spot at = spot_of(r);
    r->largest = largest;
    if (!coordinates(r, p.which, &p.domain, at, phi))
        return;
    const law l = point_law(&p, at, phi, largest);
    expect_point(r, loft_spatch_eval(&p.s, phi, &v), v, l);
    expect_point(r, loft_spatch_casteljau(&p.s, phi, work, &u), u, l);
}

static const law other_form = { .lsb = 0.5L + 1 / 32768.0L, .gain = 1, .roundings = 24 };

static void spatch_elevated(row *r)
{
    static loft_vec out[POINTS];
    static loft_real w[POINTS];
    patch p;

    if (!patch_of(r, row_text(r, "case"), false, &p))
        return;
    if (loft_spatch_elevate(&p.s, out, w) != LOFT_OK)
        row_complain(r, "raising was refused");
    else
        expect_point(r, LOFT_OK, out[rank_of(r, row_text(r, "lambda"), p.n, p.d + 1)], other_form);
}

static void spatch_tensor(row *r)
{
    loft_vec out[(LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1)];
    loft_real w[(LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1)];
    patch p;

    if (!patch_of(r, row_text(r, "case"), false, &p))
        return;
    const unsigned i = row_count(r, "i", p.d), j = row_count(r, "j", p.d);
    if (loft_spatch_tensor(&p.s, out, w) != LOFT_OK)
        row_complain(r, "the tensor product form was refused");
    else
        expect_point(r, LOFT_OK, out[i * (p.d + 1) + j], other_form);
}

static bool same_size(row *r, const sheet *s, unsigned k, unsigned n, unsigned d)
{
    return (unsigned)decimal(r, s->field[k][0]) == n && (unsigned)decimal(r, s->field[k][1]) == d;
}

/* The pair is an edge, once; and there are as many rows as edges. */
static void spatch_adjacency(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_SIDES_MAX), d = row_count(r, "d", LOFT_DEGREE_MAX);
    const unsigned a = rank_of(r, row_text(r, "A"), n, d), b = rank_of(r, row_text(r, "B"), n, d);
    const sheet *s = sheet_of(r, "spatch_adjacency");
    unsigned l, m, edges = 0, rows = 0, found = 0;
    loft_links w;

    if (r->complaint[0])
        return;
    for (loft_links_start(&w, n, d); loft_links_next(&w, &l, &m); edges++)
        found += (l == a && m == b) || (l == b && m == a);
    for (unsigned k = 0; k < s->rows; k++)
        rows += same_size(r, s, k, n, d);
    if (found != 1 || rows != edges)
        row_complain(r, "an edge %u times, %u edges for %u rows", found, edges, rows);
}

const vector_system vectors_spatch[] = {
    { "spatch_net", "case,n,d,which,polygon,rational,lambda,weight,X,Y,Z", spatch_net,
      "corners: exact" },
    { "spatch_eval", "case,type,x,y,X,Y,Z", spatch_eval,
      "q16 1/2 LSB + (1 + M) 2^-15 LSB; floats 64 (1 + M) ulp of double, M = (sum |phi|)^d, and "
      "outside what the coordinates lose" },
    { "spatch_elevated", "case,lambda,X,Y,Z", spatch_elevated,
      "q16 1/2 LSB + 2^-15 LSB; floats 24 ulp of double" },
    { "spatch_tensor", "case,i,j,X,Y,Z", spatch_tensor,
      "q16 1/2 LSB + 2^-15 LSB; floats 24 ulp of double" },
    { "spatch_adjacency", "n,d,A,B", spatch_adjacency, "exact" },
    { 0 }
};
