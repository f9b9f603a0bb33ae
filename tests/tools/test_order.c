/* tests/tools/test_order.c -- doubles are dropped, touching ends joined, and no curve is lost
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "arrange/order.h"
#include "tools/drawn.h"

double tool_clock(void) { return 0; }

static const double zero[2] = { 0, 0 };

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

static void add_line(drawing *d, double x0, double y0, double x1, double y1, bool fresh)
{
    double p[4][2];

    for (int k = 0; k < 4; k++) {
        p[k][0] = x0 + (x1 - x0) * k / 3;
        p[k][1] = y0 + (y1 - y0) * k / 3;
    }
    p[3][0] = x1;
    p[3][1] = y1;
    drawing_add(d, p, fresh, (unsigned)d->count + 1);
}

static int apply(drawing *d, const order_options *o)
{
    hear();
    return order_apply(&heard, o, d, zero, false, "f");
}

static const order_options best = { .how = "best", .effort = 0.01, .join = 0.005 };

static size_t paths_of(const drawing *d)
{
    return d->count == 0 ? 0 : (size_t)d->curve[d->count - 1].path + 1;
}

/* The way between the paths. */
static double travel_of(const drawing *d)
{
    double at[2] = { 0, 0 }, sum = 0;

    for (size_t i = 0; i < d->count; i++) {
        sum += hypot(d->curve[i].p[0][0] - at[0], d->curve[i].p[0][1] - at[1]);
        memcpy(at, d->curve[i].p[3], sizeof at);
    }
    return sum;
}

static bool same_curve(const drawing_curve *a, const drawing_curve *b)
{
    bool forth = true, back = true;

    for (int k = 0; k < 4; k++) {
        forth = forth && memcmp(a->p[k], b->p[k], sizeof a->p[k]) == 0 && a->z[k] == b->z[k];
        back  = back && memcmp(a->p[k], b->p[3 - k], sizeof a->p[k]) == 0 && a->z[k] == b->z[3 - k];
    }
    return (forth || back) && a->line == b->line && a->feed == b->feed;
}

/* Random paths of curves in space: each curve is drawn once, forth or back; those of a path stay
 * together; the way does not grow. */
static void every_curve_is_drawn_once(arb *a)
{
    drawing d = { .width = 9, .height = 8 }, was = { 0 };

    for (unsigned i = 1 + arb_below(a, 60); i > 0; i--) {
        double p[4][3];
        for (unsigned k = 0, count = 1 + arb_below(a, 4); k < count; k++) {
            for (int j = 0; j < 12; j++)
                if (k == 0 || j > 2)
                    p[j / 3][j % 3] = 100 * random_unit(a);
            if (k + 1 == count && arb_below(a, 3) == 0 && k > 0)       /* closed */
                memcpy(p[3],
                       (double[3]){ d.curve[d.count - k].p[0][0], d.curve[d.count - k].p[0][1],
                                    d.curve[d.count - k].z[0] },
                       sizeof p[3]);
            drawing_add_space(&d, p, (double)k, k == 0, (unsigned)d.count + 1);
            memcpy(p[0], p[3], sizeof p[0]);
        }
    }
    for (size_t i = 0; i < d.count; i++)
        drawing_add_like(&was, &d.curve[i], i == 0 || d.curve[i].path != d.curve[i - 1].path);
    CHECK(apply(&d, &best) == 0 && d.count == was.count && d.width == 9 && d.height == 8);
    CHECK(paths_of(&d) == paths_of(&was) && travel_of(&d) <= travel_of(&was) + 1e-9);
    for (size_t i = 0; i < d.count && d.count == was.count; i++) {
        CHECK(same_curve(&d.curve[i], &was.curve[d.curve[i].line - 1]));
        for (size_t j = 0; j < i; j++)
            CHECK(d.curve[i].line != d.curve[j].line);
        if (i > 0 && d.curve[i].path == d.curve[i - 1].path)
            CHECK(memcmp(d.curve[i].p[0], d.curve[i - 1].p[3], sizeof d.curve[i].p[0]) == 0 &&
                  was.curve[d.curve[i].line - 1].path == was.curve[d.curve[i - 1].line - 1].path);
    }
    drawing_free(&was);
    drawing_free(&d);
}

/* The sides of a square, in any order and direction: one closed path, from the nearest corner. */
static void touching_ends_become_one_path(arb *a)
{
    static const double corner[5][2] = {
        { 30, 30 }, { 50, 30 }, { 50, 50 }, { 30, 50 }, { 30, 30 }
    };
    drawing d = { 0 };
    unsigned side[4] = { 0, 1, 2, 3 };

    for (unsigned k = 3; k > 0; k--) {
        const unsigned j = arb_below(a, k + 1), was = side[k];
        side[k] = side[j];
        side[j] = was;
    }
    for (int k = 0; k < 4; k++) {
        const double *p = corner[side[k]], *q = corner[side[k] + 1];
        const bool back = arb_below(a, 2) == 1;
        add_line(&d, back ? q[0] : p[0], back ? q[1] : p[1], back ? p[0] : q[0], back ? p[1] : q[1],
                 true);
    }
    CHECK(apply(&d, &best) == 0 && d.count == 4 && paths_of(&d) == 1);
    CHECK_NEAR(travel_of(&d), hypot(30, 30), 1e-9);
    CHECK_NEAR(d.curve[3].p[3][0], 30, 0);
    drawing_free(&d);
}

/* A gap within --join is bridged by a line, a larger one is not; ends at other heights are not
 * joined; where four ends meet, the straight ones are. */
static void gaps_are_bridged_as_asked(arb *a)
{
    drawing d = { 0 };
    order_options wide = best;
    double low[4][3]  = { { 0, 0, 0 }, { 3, 0, 0 }, { 6, 0, 0 }, { 9, 0, 0 } },
           high[4][3] = { { 9, 0, 1 }, { 9, 3, 1 }, { 9, 6, 1 }, { 9, 9, 1 } };
    (void)a;
    add_line(&d, 10, 0, 20, 0, true);
    add_line(&d, 30, 0, 20.2, 0, true);
    CHECK(apply(&d, &best) == 0 && d.count == 2 && paths_of(&d) == 2);
    wide.join = 0.3;
    CHECK(apply(&d, &wide) == 0 && d.count == 3 && paths_of(&d) == 1);
    CHECK_NEAR(d.curve[1].p[3][0] - d.curve[1].p[0][0], 0.2, 1e-12);
    drawing_free(&d);

    add_line(&d, 10, 0, 10.2, 0, true);         /* its own ends: no line back */
    CHECK(apply(&d, &wide) == 0 && d.count == 1);
    drawing_free(&d);

    drawing_add_space(&d, low, 0, true, 1);
    drawing_add_space(&d, high, 0, true, 2);
    CHECK(apply(&d, &best) == 0 && paths_of(&d) == 2);
    drawing_free(&d);

    add_line(&d, 0, 10, 10, 10, true);
    add_line(&d, 10, 0, 10, 10, true);
    add_line(&d, 20, 10, 10, 10, true);
    add_line(&d, 10, 10, 10, 20, true);
    CHECK(apply(&d, &best) == 0 && d.count == 4 && paths_of(&d) == 2);
    for (size_t i = 1; i < 4; i += 2) {
        const drawing_curve *p = &d.curve[i - 1], *q = &d.curve[i];
        CHECK(fabs((p->p[3][0] - p->p[0][0]) * (q->p[3][1] - q->p[0][1]) -
                   (p->p[3][1] - p->p[0][1]) * (q->p[3][0] - q->p[0][0])) < 1e-9);
    }
    drawing_free(&d);
}

static void doubles_are_drawn_once(arb *a)
{
    drawing d = { 0 }, twice = { 0 };
    order_options keep = best;
    (void)a;
    for (int k = 0; k < 2; k++)
        for (drawing *to = &d; to != NULL; to = to == &d ? &twice : NULL) {
            add_line(to, 0, 0, 10, 0, true);
            add_line(to, 10, 0, 10, 10, false);
            add_line(to, 10, 10, 10, 0, true);          /* the same, back */
        }
    CHECK(apply(&d, &best) == 0 && d.count == 2 && paths_of(&d) == 1);
    keep.doubles = true;
    CHECK(apply(&twice, &keep) == 0 && twice.count == 6);
    drawing_free(&d);
    drawing_free(&twice);
}

/* A circle of eight arcs, closed by a corner: it begins where it is asked to. */
static void closed_paths_begin_where_asked(arb *a)
{
    order_options corner = best, there = best;
    (void)a;
    corner.seam = "corner";
    there.seam  = "70,50";
    for (int pass = 0; pass < 3; pass++) {
        drawing d = { 0 };
        for (int k = 0; k < 6; k++) {           /* an octagon less a quarter, and its corner */
            const double t = k * 0.78539816, u = (k + 1) * 0.78539816;
            double p[4][2] = { { 50 + 20 * cos(t), 50 + 20 * sin(t) } };
            const double arm = 4.0 / 3 * tan(0.78539816 / 4) * 20;
            p[1][0] = p[0][0] - arm * sin(t);
            p[1][1] = p[0][1] + arm * cos(t);
            p[3][0] = 50 + 20 * cos(u);
            p[3][1] = 50 + 20 * sin(u);
            p[2][0] = p[3][0] + arm * sin(u);
            p[2][1] = p[3][1] - arm * cos(u);
            drawing_add(&d, p, k == 0, 1);
        }
        add_line(&d, d.curve[5].p[3][0], d.curve[5].p[3][1], 70, 30, false);
        add_line(&d, 70, 30, 70, 50, false);
        CHECK(apply(&d, pass == 0 ? &best : pass == 1 ? &corner : &there) == 0 && d.count == 8);
        const double want[3][2] = { { 50 - 20 * sqrt(0.5), 50 - 20 * sqrt(0.5) },
                                    { 70, 30 },
                                    { 70, 50 } };
        CHECK_NEAR(d.curve[0].p[0][0], want[pass][0], 1e-6);
        CHECK_NEAR(d.curve[0].p[0][1], want[pass][1], 1e-6);
        drawing_free(&d);
    }
}

static void what_cannot_be_is_refused(arb *a)
{
    static const order_options file = { .how = "file" }, seam = { .how = "best", .seam = "left" };
    char word[] = "--order=wild", *line[] = { "plan", word, NULL };
    option_fault fault;
    order_options o;
    drawing d = { .program = true };
    (void)a;
    add_line(&d, 5, 5, 6, 6, true);
    add_line(&d, 1, 1, 2, 2, true);
    CHECK(options_read(order_rows, 2, line, &o, &fault) == EX_USAGE &&
          strstr(fault.text, "--order wild: give file, layer or best") != NULL);
    CHECK(apply(&d, &seam) == EX_USAGE && strstr(caught, "--seam left: give") != NULL);
    CHECK(apply(&d, &best) == EX_USAGE && strstr(caught, "is a program") != NULL);
    CHECK(apply(&d, &file) == 0 && d.curve[0].p[0][0] == 5);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(every_curve_is_drawn_once, 200);
    PROPERTY(touching_ends_become_one_path, 50);
    PROPERTY(gaps_are_bridged_as_asked, 1);
    PROPERTY(doubles_are_drawn_once, 1);
    PROPERTY(closed_paths_begin_where_asked, 1);
    PROPERTY(what_cannot_be_is_refused, 1);
    return check_failures();
}
