/* tests/tools/test_record.c -- the nearest of many pieces, and records measured against a drawing
 * SPDX-License-Identifier: MIT
 */
#include <unistd.h>

#include "tools/drawn.h"
#include "engine/engine.h"
#include "geometry/nearest_piece.h"
#include "read/record.h"

static char file[] = "/tmp/loft-record-XXXXXX";

static double arb_mm(arb *a) { return (double)arb_raw(a, 100 << 16) / 65536; }

/* The tree finds the same distance as a linear search, whatever the hint. */
static void the_nearest_piece_is_found(arb *a)
{
    nearest n = { 0 };
    const uint32_t count = 1 + arb_below(a, arb_below(a, 2) ? 8 : 300);
    double at[2] = { arb_mm(a), arb_mm(a) };

    for (uint32_t i = 0; i < count; i++) {
        double b[2] = { at[0] + arb_mm(a) / 20, at[1] + arb_mm(a) / 20 };
        if (arb_below(a, 10) == 0)
            memcpy(b, at, sizeof b);            /* pieces without length as well */
        nearest_add(&n, at, b);
        memcpy(at, b, sizeof at);
    }
    nearest_build(&n);
    for (int k = 0; k < 20; k++) {
        const double p[2] = { arb_mm(a), arb_mm(a) };
        double best = HUGE_VAL, u, distance;
        for (uint32_t i = 0; i < count; i++) {
            const nearest_piece *q = &n.piece[i];
            const double dx = q->b[0] - q->a[0], dy = q->b[1] - q->a[1], l = dx * dx + dy * dy;
            const double t =
                l > 0 ? fmin(fmax(((p[0] - q->a[0]) * dx + (p[1] - q->a[1]) * dy) / l, 0), 1) : 0;
            best = fmin(best, hypot(q->a[0] + t * dx - p[0], q->a[1] + t * dy - p[1]));
        }
        const size_t i = nearest_find(&n, p, arb_below(a, count), &u, &distance);
        CHECK(i < count && u >= 0 && u <= 1);
        CHECK_NEAR(distance, best, 1e-9);
        CHECK_NEAR(hypot(n.piece[i].a[0] + u * (n.piece[i].b[0] - n.piece[i].a[0]) - p[0],
                         n.piece[i].a[1] + u * (n.piece[i].b[1] - n.piece[i].a[1]) - p[1]),
                   best, 1e-9);
    }
    nearest_free(&n);
}

static uint32_t wanted;     /* job */

static int read_text(record *r, const char *text)
{
    FILE *f = fopen(file, "w");

    CHECK(f != NULL && fputs(text, f) >= 0 && fclose(f) == 0);
    hear();
    *r = (record){ 0 };
    return record_read(&heard, r, file, wanted);
}

#define HEAD                                                                                       \
    "# record = pulses\n# slot_hz = 1000\n# steps_per_mm_x = 100\n# steps_per_mm_y = 200\n# "      \
    "steps_per_mm_z = 400\nslot,x,y,z\n"

static void records_are_read(arb *a)
{
    record r;
    (void)a;
    CHECK(read_text(&r, HEAD "5,0,0,400\n7,100,0,400\n9,100,0,0\n1005,150,-200,0\n1006,1") == 0 &&
          r.count == 4);
    if (r.count == 4) {
        CHECK_NEAR(r.pulse[3].at[0], 1.5, 0);
        CHECK_NEAR(r.pulse[3].at[1], -1, 0);
        CHECK_NEAR(r.pulse[0].at[2], 1, 0);
        CHECK_NEAR(record_seconds(&r), 1.001, 1e-12);
        CHECK(!record_draws(&r, 0) && !record_draws(&r, 1) && !record_draws(&r, 2) &&
              record_draws(&r, 3));
    }
    record_free(&r);
    CHECK(read_text(&r, "# steps_per_mm 100\n1,100,0\n2,100,100\n") == 0 && r.count == 2 &&
          record_draws(&r, 1));
    record_free(&r);
    CHECK(read_text(&r, "# steps_per_mm = 100 200 400\n1,100,200,400\n") == 0 && r.count == 1 &&
          r.pulse[0].at[1] < 1.5);
    record_free(&r);
    CHECK(read_text(&r, HEAD "5,0,0,400\n7,x,0,400\n") == EX_DATAERR &&
          strstr(caught, ":8: \"7,x,0,400\" is not a pulse") != NULL);
    record_free(&r);
    CHECK(read_text(&r, "1,2,3,4\n") == EX_DATAERR && strstr(caught, "no steps per mm") != NULL);
    record_free(&r);
    CHECK(read_text(&r, HEAD) == EX_DATAERR && strstr(caught, "holds no pulse") != NULL);
    record_free(&r);
    CHECK(record_read(&heard, &r, "/tmp/loft/no/such/file", 0) == EX_NOINPUT && caught_lines == 2);
    CHECK(record_read(&heard, &r, "/tmp", 0) == EX_NOINPUT);
}

/* Of three jobs, the second one twice: read the last of all, or the last run of the wanted job,
 * from its beginning. */
static void of_several_jobs_one_is_read(arb *a)
{
    static const char text[] = HEAD
        "# job = 0000000a\n5,100,0,400\n# job = 0000000b\n8,200,0,400\n9,250,0,400\n# job = "
        "b\n15,300,0,400\n16,400,0,400\n"
        "# job = 0000000c\n18,500,200,400\n";
    static const struct {
        uint32_t job;
        size_t count;
        double start, end;
    } want[] = { { 0, 1, 4, 5 }, { 10, 1, 0, 1 }, { 11, 2, 2.5, 4 }, { 12, 1, 4, 5 } };
    record r;
    (void)a;

    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        wanted = want[i].job;
        CHECK(read_text(&r, text) == 0 && r.count == want[i].count);
        CHECK(r.start[0] == want[i].start && r.motors[0] == want[i].end &&
              r.pulse[r.count - 1].at[0] == want[i].end);
        record_free(&r);
    }
    wanted = 13;
    CHECK(read_text(&r, text) == EX_DATAERR && strstr(caught, "holds no pulse") != NULL);
    record_free(&r);
    wanted = 0;
}

/* A record of positions with the pen down at the points of a curve, each moved sideways by `off`;
 * the fraction `from`..`to` is left out. */
static void make_record(record *r, const drawing_curve *c, double off, double from, double to)
{
    const size_t points = 2000;

    *r = (record){ .pulse   = tool_grow(NULL, (points + 2) * sizeof(record_pulse)),
                   .machine = machine_usual(),
                   .slot_hz = 1000 };
    for (size_t i = 0; i <= points; i++) {
        const double t = (double)i / (double)points;
        double p[2], v[2];
        if (t > from && t < to)
            continue;
        drawing_eval(c, t, p);
        drawing_deriv(c, t, v);
        const double speed = hypot(v[0], v[1]);
        r->pulse[r->count].slot  = i;
        r->pulse[r->count].at[0] = p[0] - off * v[1] / speed;
        r->pulse[r->count].at[1] = p[1] + off * v[0] / speed;
        r->pulse[r->count].at[2] = 0;
        r->count++;
    }
}

/* A gently bent curve: 50..100 mm long, radii of 20 mm and more, so that a small sideways step
 * stays closest to its point. */
static drawing bent_curve(arb *a)
{
    drawing d = { 0 };
    const double x = arb_mm(a), y = arb_mm(a), up = 10.0 * arb_mm(a) / 100,
                 down = 10.0 * arb_mm(a) / 100;
    double p[4][2] = { { x, y }, { x + 25, y + up }, { x + 50, y + down }, { x + 75, y } };

    drawing_add(&d, p, true, 1);
    return d;
}

static void a_known_error_is_measured(arb *a)
{
    drawing d = bent_curve(a);
    const double off = (arb_below(a, 2) ? 1 : -1) * ldexp(1, -(int)arb_below(a, 12));
    record r;
    size_t where;

    make_record(&r, &d.curve[0], off, 2, 2);
    double (*point)[2] = tool_grow(NULL, r.count * sizeof *point);
    const double worst = record_worst_error(&d, &r, point, &where);
    CHECK_NEAR(worst, fabs(off), 1e-4);
    CHECK(where < r.count);
    for (size_t i = 1; i < r.count; i++) {      /* the points are on the curve, and as far off as
                                                 * they should be */
        CHECK_NEAR(hypot(point[i][0] - r.pulse[i].at[0], point[i][1] - r.pulse[i].at[1]), fabs(off),
                   1e-4);
        if (i % 100 == 0) {
            double best = HUGE_VAL;
            for (int k = 0; k <= 2000; k++) {
                double q[2];
                drawing_eval(&d.curve[0], k / 2000.0, q);
                best = fmin(best, hypot(q[0] - point[i][0], q[1] - point[i][1]));
            }
            CHECK(best < 0.05);
        }
    }
    CHECK_NEAR(record_worst_gap(&d, &r, NULL), fabs(off), 1e-3);
    free(point);
    record_free(&r);
    drawing_free(&d);
}

/* A gap is invisible to the path error, and the gap measure shows it: half the length of the
 * piece. */
static void what_is_left_out_shows_as_a_gap(arb *a)
{
    drawing d = { 0 };
    double p[4][2] = { { 0, 0 }, { 10, 0 }, { 20, 0 }, { 30, 0 } }, where[2];
    record r;
    (void)a;
    drawing_add(&d, p, true, 1);
    make_record(&r, &d.curve[0], 0, 0.5, 0.7);
    CHECK_NEAR(record_worst_error(&d, &r, NULL, NULL), 0, 1e-9);
    /* the pen went straight across: it was drawn */
    CHECK_NEAR(record_worst_gap(&d, &r, where), 0, 1e-9);
    for (size_t i = 0; i < r.count; i++)
        if (r.pulse[i].at[0] > 15.01)
            r.pulse[i].at[0] = 15;                                  /* half of the gap was never
                                                                     * drawn */
    CHECK_NEAR(record_worst_gap(&d, &r, where), 15, 1e-9);
    CHECK_NEAR(where[0], 30, 1e-9);
    r.count = 0;
    CHECK(isinf(record_worst_gap(&d, &r, NULL)));
    CHECK(record_worst_error(&d, &r, NULL, NULL) <= 0);
    record_free(&r);
    drawing_free(&d);
}

int main(void)
{
    if (mkstemp(file) < 0)
        return 1;
    PROPERTY(the_nearest_piece_is_found, 300);
    PROPERTY(of_several_jobs_one_is_read, 1);
    PROPERTY(records_are_read, 1);
    PROPERTY(a_known_error_is_measured, 30);
    PROPERTY(what_is_left_out_shows_as_a_gap, 1);
    remove(file);
    return check_failures();
}
