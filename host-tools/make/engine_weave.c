/* host-tools/make/engine_weave.c -- surfaces of several curves: swept, through networks, through
 * grids of points; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "surface/tensor/ferguson.h"            /* loft_bicubic_from_grid */
#include "surface/tensor/gordon.h"              /* loft_gordon */
#include "surface/tensor/skin.h"                /* loft_skin */
#include "surface/tensor/sweep.h"               /* loft_sweep_sections */

#include "make/engine_pieces.h"                /* visit_curve, piece_list */
#include "make/engine_weave.h"


// Sweeping
// --------

/* All pieces, polynomial ones. */
static int hold_polynomials(const decide_input *in, piece_list *all)
{
    int status;

    all->count = 0;
    status = visit_pieces(in, hold_piece, all);
    for (size_t i = 0; i < all->count && status == LOFT_OK; i++)
        if (all->piece[i].rational || all->piece[i].b.degree < 1) {
            snprintf(in->why, DECIDE_WHY,
                     "a curve with weights, or of degree 0: give polynomials, as `natural`");
            status = LOFT_ERR_ARG;
        }
    return status;
}

/* The first piece from `from` on that does not start where the one before ends. */
static size_t gap_after(const piece_list *all, size_t from)
{
    size_t i = from + 1;

    while (i < all->count &&
           loft_vec_equal(all->piece[i - 1].p[all->piece[i - 1].b.degree], all->piece[i].p[0]))
        i++;
    return i;
}

/* The direction of the section's x at the start: given, or z, or x where the path goes along z. */
static int up_of(const decide_input *in, const loft_bezier *start, loft_vec *up)
{
    loft_vec along;
    const int status = loft_bezier_deriv(start, 1, 0, &along);
    double given[ENGINE_AXES] = { 0, 0, 1 };

    if (status == LOFT_OK && fabs(double_of(along.axis[0])) + fabs(double_of(along.axis[1])) <
                                 1e-3 * fabs(double_of(along.axis[2])))
        given[0] = 1, given[2] = 0;
    for (unsigned i = 0; i < 3 && in->of->count == 4; i++)
        given[i] = in->of->value[i + 1];
    return vec_of(given, up) ? status : LOFT_ERR_RANGE;
}

static int sweep_piece(const decide_input *in, const arc_piece *section, const loft_bezier path[],
                       unsigned pieces, uint32_t stations, loft_vec up)
{
    static loft_vec placed[HELD * MOST];
    static loft_real v[HELD];
    static loft_spline_knot memory[HELD * MOST];
    const unsigned degree = section->b.degree;
    loft_vec net[MOST * MOST];
    loft_skin s;
    int status = loft_sweep_sections(path, pieces, stations, up, section->p, degree, placed);

    for (uint32_t k = 0; k < stations; k++)
        v[k] = loft_real_from_int((int32_t)k);
    if (status == LOFT_SINGULAR)
        snprintf(in->why, DECIDE_WHY,
                 "the path has a cusp, turns back, or starts along the direction: give another one "
                 "as --of STATIONS,X,Y,Z, or more stations");
    if (status == LOFT_OK)
        status = loft_skin_init(&s, placed, degree, stations, v, LOFT_ENDS_NOT_A_KNOT, memory);
    for (uint32_t j = 0; j + 1 < stations && status == LOFT_OK; j++) {
        status = loft_tensor_from_skin(&s, j, net);
        if (status == LOFT_OK)
            write_tensor(in, degree, 3, net);
    }
    return status;
}

int ENGINE_OF(make_sweep)(const decide_input *in)
{
    static piece_list all;
    static loft_bezier path[HELD];
    const double stations = in->of->value[0];
    loft_vec up;

    if ((in->of->count != 1 && in->of->count != 4) || stations < 2 || stations > HELD ||
        stations != floor(stations)) {
        snprintf(in->why, DECIDE_WHY, "give 2 to %d stations, and a direction or none", HELD);
        return LOFT_ERR_ARG;
    }
    int status = hold_polynomials(in, &all);
    const size_t first = gap_after(&all, 0);
    if (status == LOFT_OK && (first >= all.count || gap_after(&all, first) < all.count)) {
        snprintf(in->why, DECIDE_WHY,
                 "give two paths: the section, and then its way, which starts elsewhere than the "
                 "section ends and has no gap");
        return LOFT_ERR_ARG;
    }
    for (size_t i = first; i < all.count; i++)
        path[i - first] = all.piece[i].b;
    if (status == LOFT_OK)
        status = up_of(in, &path[0], &up);
    for (size_t i = 0; i < first && status == LOFT_OK; i++)
        status = sweep_piece(in, &all.piece[i], path, (unsigned)(all.count - first),
                             (uint32_t)stations, up);
    return status;
}


// Networks
// --------

#define LINES   (2 * LOFT_GORDON_MAX)
#define MEETS   0.001           /* mm: as near two curves meet */
#define WITHIN  0.0001          /* mm: so near a cubic is to a curve with weights */

/* A curve of the network: its pieces, and where it meets the others: node[i] pieces before it. */
typedef struct {
    piece_list list;
    unsigned node[LOFT_GORDON_MAX];
    unsigned meets;
} net_line;

static loft_vec node_point(const net_line *l, size_t k)
{
    const arc_piece *a = &l->list.piece[k ? k - 1 : 0];

    return k ? a->p[a->b.degree] : a->p[0];
}

/* A curve with weights as n cubics of equal parts, or LOFT_MORE if they are not near enough. */
static int hermite_pieces(const loft_rational *r, unsigned n, piece_list *all)
{
    double off = 0;

    for (unsigned k = 0; k < n; k++) {
        arc_piece a = { .rational = false };
        const loft_unit at[2] = { loft_unit_of(k, n), loft_unit_of(k + 1, n) };
        for (int end = 0; end < 2; end++) {
            loft_vec d;
            const int status = loft_rational_deriv(r, at[end], &d);
            if (status != LOFT_OK)
                return status;
            a.p[3 * end] = loft_rational_eval(r, at[end]);
            for (int i = 0; i < LOFT_AXES; i++)
                if (!real_of(double_of(a.p[3 * end].axis[i]) +
                                 (end ? -1 : 1) * double_of(d.axis[i]) / (3.0 * n),
                             &a.p[1 + end].axis[i]))
                    return LOFT_ERR_RANGE;
        }
        int status = loft_bezier_init(&a.b, a.p, 3);
        for (unsigned x = 1; x < 8 && status == LOFT_OK; x++) {
            const loft_vec on = loft_rational_eval(r, loft_unit_of(8 * k + x, 8 * n));
            off = fmax(off, double_of_acc(
                                loft_vec_distance(on, loft_bezier_eval(&a.b, loft_unit_of(x, 8)))));
        }
        if (status == LOFT_OK)
            status = hold_piece(all, &a, 0);
        if (status != LOFT_OK)
            return status;
    }
    return off <= WITHIN ? LOFT_OK : LOFT_MORE;
}

static int hold_line_piece(void *context, const arc_piece *a, size_t number)
{
    piece_list *all = context;
    const size_t before = all->count;
    loft_rational r;
    int status = LOFT_MORE;

    if (!a->rational)
        return hold_piece(all, a, number);
    if (loft_rational_init(&r, a->w, a->b.degree) != LOFT_OK)
        return LOFT_ERR_RANGE;
    for (unsigned n = 1; n <= 32 && status == LOFT_MORE; n *= 2) {
        all->count = before;
        status = hermite_pieces(&r, n, all);
    }
    return status == LOFT_MORE ? LOFT_ERR_RANGE : status;
}

/* Where line l meets line o, at joints of both. */
static bool find_meeting(const net_line *l, const net_line *o, unsigned *node)
{
    for (unsigned k = 0; k <= l->list.count; k++)
        for (unsigned j = 0; j <= o->list.count; j++)
            if (double_of_acc(loft_vec_distance(node_point(l, k), node_point(&o[0], j))) <= MEETS) {
                *node = k;
                return true;
            }
    return false;
}

/* A line meets all lines of the other family in their order, the first at its start. */
static int find_meetings(const decide_input *in, net_line *l, unsigned number,
                         const net_line other[], unsigned count, unsigned first)
{
    l->meets = count;
    for (unsigned i = 0; i < count; i++) {
        if (!find_meeting(l, &other[i], &l->node[i])) {
            snprintf(in->why, DECIDE_WHY,
                     "curves %u and %u do not meet at joints of both: let both have a point there, "
                     "within 0.001 mm",
                     number + 1, first + i + 1);
            return LOFT_ERR_ARG;
        }
        if (i > 0 && l->node[i] <= l->node[i - 1]) {
            snprintf(
                in->why, DECIDE_WHY,
                "curve %u meets curve %u before curve %u: turn it with `loft make reverse`, or "
                "sort the curves",
                number + 1, first + i + 1, first + i);
            return LOFT_ERR_ARG;
        }
    }
    if (l->node[0] > 0 || l->node[count - 1] < l->list.count) {
        snprintf(in->why, DECIDE_WHY,
                 "curve %u goes on beyond the others: let it end where it meets the last one",
                 number + 1);
        return LOFT_ERR_ARG;
    }
    return LOFT_OK;
}

static unsigned common_multiple(unsigned a, unsigned b)
{
    unsigned x = a, y = b;

    while (y != 0) {
        const unsigned rest = x % y;
        x = y;
        y = rest;
    }
    return a / x * b;
}

/* So many parts has cell i of these lines. */
static unsigned parts_of(const net_line line[], unsigned count, unsigned i)
{
    unsigned n = 1;

    for (unsigned k = 0; k < count; k++)
        n = common_multiple(n, line[k].node[i + 1] - line[k].node[i]);
    return n;
}

/* The part number `part` of n of cell i, as a Bezier curve in p. */
static int line_part(const net_line *l, unsigned i, unsigned part, unsigned n, loft_vec p[MOST],
                     loft_bezier *out)
{
    const unsigned pieces = l->node[i + 1] - l->node[i], each = n / pieces;
    const arc_piece *a = &l->list.piece[l->node[i] + part / each];
    const int status = loft_bezier_sub(&a->b, loft_unit_of(part % each, each),
                                       loft_unit_of(part % each + 1, each), p);

    return status ? status : (int)loft_bezier_init(out, p, a->b.degree);
}

/* The library asks for places where lines meet: place k of n is at k / (n - 1). */
static void line_place(const void *line, loft_unit t, loft_acc out[LOFT_AXES])
{
    const net_line *l = line;
    const double k = (double)t / (double)LOFT_UNIT(1) * (l->meets - 1);
    const loft_vec p = node_point(l, l->node[(unsigned)lround(k)]);

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = loft_to_acc(p.axis[i]);
}

typedef struct {
    net_line line[LINES];
    unsigned columns, rows;             /* lines along u come first */
    loft_side side[LINES];
    loft_unit at[2][LOFT_GORDON_MAX];
    loft_gordon_point memory[LOFT_GORDON_MAX * LOFT_GORDON_MAX];
    loft_gordon g;
    unsigned degree[2];
} network;

static int read_network(const decide_input *in, unsigned columns, network *w)
{
    const size_t count = in->curves->count;
    size_t number = 0;
    int status = LOFT_OK;

    w->columns = columns;
    w->rows = (unsigned)count - columns;
    w->degree[0] = w->degree[1] = 3;
    for (unsigned c = 0; c < count && status == LOFT_OK; c++) {
        net_line *l = &w->line[c];
        l->list.count = 0;
        status = visit_curve(in, c, hold_line_piece, &l->list, &number);
        if (status == LOFT_ERR_SPACE)
            snprintf(in->why, DECIDE_WHY, "curve %u has more than %d pieces", c + 1, HELD);
        unsigned *degree = &w->degree[c >= columns];
        for (size_t k = 0; k < l->list.count; k++)
            *degree = l->list.piece[k].b.degree > *degree ? l->list.piece[k].b.degree : *degree;
        w->side[c] = (loft_side) { line_place, l };
    }
    for (unsigned c = 0; c < count && status == LOFT_OK; c++)
        status = c < columns
                     ? find_meetings(in, &w->line[c], c, w->line + columns, w->rows, columns)
                     : find_meetings(in, &w->line[c], c, w->line, columns, 0);
    for (unsigned i = 0; i < w->rows; i++)
        w->at[0][i] = loft_unit_of(i, w->rows - 1);
    for (unsigned j = 0; j < columns; j++)
        w->at[1][j] = loft_unit_of(j, columns - 1);
    return status ? status
                  : (int)loft_gordon_init(&w->g, w->side, w->at[1], columns, w->side + columns,
                                          w->at[0], w->rows, LOFT_REAL(0.002), w->memory);
}

static loft_unit part_start(const loft_unit at[], unsigned i, unsigned part, unsigned n)
{
    return part == n ? at[i + 1] : at[i] + (loft_unit)((double)(at[i + 1] - at[i]) * part / n);
}

/* One tensor patch. part: along u, then along v. */
static int weave_part(const decide_input *in, const network *w, const unsigned cell[2],
                      const unsigned part[2], const unsigned n[2])
{
    loft_vec p[LINES][MOST], net[MOST * MOST];
    loft_bezier b[LINES];
    loft_unit from[2], to[2];
    int status = LOFT_OK;

    for (unsigned k = 0; k < w->columns + w->rows && status == LOFT_OK; k++) {
        const unsigned way = k >= w->columns;
        status = line_part(&w->line[k], cell[way], part[way], n[way], p[k], &b[k]);
    }
    for (unsigned way = 0; way < 2; way++) {
        from[way] = part_start(w->at[way], cell[way], part[way], n[way]);
        to[way] = part_start(w->at[way], cell[way], part[way] + 1, n[way]);
    }
    if (status == LOFT_OK)
        status = loft_tensor_from_gordon(&w->g, b, b + w->columns, from, to, w->degree[0],
                                         w->degree[1], net);
    if (status == LOFT_OK)
        write_tensor(in, w->degree[0], w->degree[1], net);
    return status;
}

static int weave_cell(const decide_input *in, const network *w, const unsigned cell[2])
{
    const unsigned n[2] = { parts_of(w->line, w->columns, cell[0]),
                            parts_of(w->line + w->columns, w->rows, cell[1]) };
    int status = LOFT_OK;

    if (n[0] > HELD || n[1] > HELD) {
        snprintf(in->why, DECIDE_WHY,
                 "the curves between two others have too different numbers of pieces: let them "
                 "have as many, or one");
        return LOFT_ERR_ARG;
    }
    for (unsigned k = 0; k < n[0] * n[1] && status == LOFT_OK; k++) {
        const unsigned part[2] = { k / n[1], k % n[1] };
        status = weave_part(in, w, cell, part, n);
    }
    return status;
}

static int weave(const decide_input *in, double columns)
{
    const size_t count = in->curves->count;
    int status;

    if (columns < 2 || columns > LOFT_GORDON_MAX || columns != floor(columns) ||
        (double)count < columns + 2 || (double)count > columns + LOFT_GORDON_MAX) {
        snprintf(in->why, DECIDE_WHY,
                 "%zu curves, %g of them along u: give 2 to %d along u, then 2 to %d along v",
                 count, columns, LOFT_GORDON_MAX, LOFT_GORDON_MAX);
        return LOFT_ERR_ARG;
    }
    network *w = tool_grow(NULL, sizeof *w);
    status = read_network(in, (unsigned)columns, w);
    for (unsigned i = 0; i + 1 < w->rows && status == LOFT_OK; i++)
        for (unsigned j = 0; j + 1 < w->columns && status == LOFT_OK; j++) {
            const unsigned cell[2] = { i, j };
            status = weave_cell(in, w, cell);
        }
    free(w);
    return status;
}

int ENGINE_OF(make_gordon)(const decide_input *in) { return weave(in, in->of->value[0]); }

int ENGINE_OF(make_coons)(const decide_input *in)
{
    if (in->curves->count == 4)
        return weave(in, 2);
    snprintf(in->why, DECIDE_WHY, "%zu curves: give four, the two along u first",
             in->curves->count);
    return LOFT_ERR_ARG;
}


// Grids of points
// ---------------

static int grid_patches(const decide_input *in, enum loft_twist twist)
{
    const unsigned rows = (unsigned)in->curves->count,
                   columns = rows ? in->curves->curve[0].count : 0;
    loft_vec *p = tool_grow(NULL, ((size_t)rows * columns + 1) * sizeof *p);
    loft_bicubic b;
    int status = LOFT_OK;

    for (unsigned i = 0; i < rows && status == LOFT_OK; i++) {
        const curve *c = &in->curves->curve[i];
        if (c->count != columns) {
            snprintf(in->why, DECIDE_WHY,
                     "curve %u has %u points, the first one %u: give a grid, one row in a curve",
                     i + 1, c->count, columns);
            status = LOFT_ERR_ARG;
        }
        for (unsigned j = 0; j < c->count && status == LOFT_OK; j++)
            status = vec_of(c->point[j].p, &p[(size_t)i * columns + j]) ? LOFT_OK : LOFT_ERR_RANGE;
    }
    if (status == LOFT_OK && (rows < 2 || columns < 2)) {
        snprintf(in->why, DECIDE_WHY, "%u rows of %u points: give 2 or more of each", rows,
                 columns);
        status = LOFT_ERR_ARG;
    }
    for (unsigned k = 0;
         rows > 1 && columns > 1 && k < (rows - 1) * (columns - 1) && status == LOFT_OK; k++) {
        status = loft_bicubic_from_grid(p, rows, columns, k / (columns - 1), k % (columns - 1),
                                        twist, &b);
        if (status == LOFT_OK) {
            printf("bicubic\n");
            write_solid(in, &b.at[0][0], 16);
        }
    }
    free(p);
    return status;
}

int ENGINE_OF(make_ferguson)(const decide_input *in) { return grid_patches(in, LOFT_TWIST_ZERO); }
int ENGINE_OF(make_adini)(const decide_input *in)    { return grid_patches(in, LOFT_TWIST_ADINI); }
int ENGINE_OF(make_bessel)(const decide_input *in)   { return grid_patches(in, LOFT_TWIST_BESSEL); }
