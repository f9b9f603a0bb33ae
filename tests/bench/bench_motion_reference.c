/* tests/bench/bench_motion_reference.c -- references for the time of lists of moves: they stop at
 * corners, or round them off
 * SPDX-License-Identifier: MIT
 * usage: reference SPEED ACCEL JERK TOL LIST..   (mm/s, mm/s^2, mm/s^3 or 0, mm)
 *
 * A corner is a joint that turns by more than 2 degrees.
 *
 * JERK 0: prints `LIST STOPS BLENDS`, both the least time by topp.h. STOPS rests at every corner,
 * and follows the path exactly. BLENDS rounds off each corner of up to 170 degrees by a cubic that
 * has the legs' tangents, within TOL both ways: on straight legs a parabola. It takes no more than
 * half of a curve.
 *
 * Else: prints `LIST STOPS`, a time for limited jerk by topp_jerk.h. It rests at every corner, and
 * where the path bends so much that a hat of 12 TOL to each side is off by more than TOL. Between
 * two of them the path is averaged over its length. The weight is a hat, as wide as TOL allows; up
 * to two times the average of what is left is added. The least time of these is taken. Straight
 * legs take the exact S-curve. So it is feasible on its grid, and not the least.
 */
#define CURVES   16384
#define PATH_MAX 400000

#include <stdlib.h>         /* atof */

#include "support/motion_paths.h"   /* even_limits, load_moves      */
#include "support/topp.h"           /* topp_grid, topp_time         */
#include "support/topp_jerk.h"      /* topp_jerk_time, scurve_time  */

#define SMOOTHED 200000
#define TURN     0.0349     /* 2 degrees                  */
#define BACK     2.967      /* 170 degrees                */
#define BEND     12         /* tolerances: half of a hat  */
#define LOOKS    64

typedef double place[LOFT_AXES];

static double tol;

/* The angle from a..b to b..c. */
static double turn_of(const place a, const place b, const place c)
{
    double along = 0, across = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int k = (i + 1) % LOFT_AXES;
        const double w = (b[i] - a[i]) * (c[k] - b[k]) - (b[k] - a[k]) * (c[i] - b[i]);
        along += (b[i] - a[i]) * (c[i] - b[i]);
        across += w * w;
    }
    return atan2(sqrt(across), along);
}

/* Between m and the move behind it. */
static double joint_turn(const loft_move *m)
{
    place a, b, c;
    cubic_at(m->curve.p, 1 - 1e-4, a);
    cubic_at(m->curve.p, 1, b);
    cubic_at(m[1].curve.p, 1e-4, c);
    return turn_of(a, b, c);
}

/* The number of moves up to the first corner. */
static unsigned moves_to_corner(const loft_move moves[], unsigned n)
{
    unsigned to = 1;
    while (to < n && joint_turn(&moves[to - 1]) < TURN)
        to++;
    return to;
}

/* --- limits of acceleration ------------------------------------------------------------------- */

static topp grid;

static double time_by_accel(const loft_move moves[], unsigned n)
{
    double time = 0;

    for (unsigned from = 0, some; from < n; from += some) {
        some = moves_to_corner(moves + from, n - from);
        topp_grid(&grid, moves + from, some, &limits,
                  (unsigned)fmin(500, (TOPP_MAX - 2.0) / some - 2));
        time += topp_time(&grid);
    }
    return time;
}

/* --- blends ----------------------------------------------------------------------------------- */

static loft_move blended[2 * CURVES];

/* The parameter at the length `gone` from the start, or the length, if gone is infinite. */
static double walk(const loft_move *m, double gone)
{
    place a, b;
    double sum = 0;

    cubic_at(m->curve.p, 0, a);
    for (int k = 1; k <= 2048; k++) {
        cubic_at(m->curve.p, k / 2048.0, b);
        const double d = distance(a, b);
        if (sum + d >= gone)
            return (k - 1 + (gone - sum) / d) / 2048;
        sum += d;
        memcpy(a, b, sizeof a);
    }
    return gone < INFINITY ? 1 : sum;
}

/* The parts of m before and behind t. */
static void cut(const loft_move *m, double t, loft_move *head, loft_move *tail)
{
    const loft_move whole = *m;
    *head = *tail = whole;
    loft_cubic_split(&whole.curve, (loft_unit)t, &head->curve, &tail->curve);
}

/* The largest distance of a point of `from`, in turn of each of its curves, from chords of `to`. */
static double off_by(const loft_move from[], unsigned n, const loft_move to[], unsigned m)
{
    double most = 0;

    for (unsigned k = 0; k <= n * LOOKS; k++) {
        double least = INFINITY;
        place q, a, b;
        cubic_at(from[k < n * LOOKS ? k / LOOKS : n - 1].curve.p,
                 k < n * LOOKS ? k % LOOKS / (double)LOOKS : 1, q);
        for (unsigned j = 0; j < m * LOOKS; j++) {
            cubic_at(to[j / LOOKS].curve.p, j % LOOKS / (double)LOOKS, a);
            cubic_at(to[j / LOOKS].curve.p, (j % LOOKS + 1) / (double)LOOKS, b);
            least = fmin(least, chord_distance(q, a, b));
        }
        most = fmax(most, least);
    }
    return most;
}

/* Between both parts of a corner: the handles are two thirds of the legs' lengths d. */
static void blend_of(const loft_move leg[2], double d, loft_move *out)
{
    place end[2], near;

    *out = leg[0];
    for (int e = 0; e < 2; e++) {
        cubic_at(leg[e].curve.p, e ? 1 : 0, end[e]);
        cubic_at(leg[e].curve.p, e ? 1 - 1e-4 : 1e-4, near);
        const double l = distance(near, end[e]);
        for (int i = 0; i < LOFT_AXES; i++) {
            out->curve.p[e ? 3 : 0].axis[i] = (loft_real)end[e][i];
            out->curve.p[e ? 2 : 1].axis[i] = (loft_real)(end[e][i] +
                                                          2 * d / 3 * (near[i] - end[e][i]) / l);
        }
    }
}

/* *m is a move that ends in a corner, and next follows. Both become shorter, and the blend stands
 * behind m. `half`: of the lengths of m and next as given. Returns whether there is one. */
static bool blend_corner(loft_move *m, loft_move *next, const double half[2])
{
    const double turn = joint_turn((const loft_move[2]){ *m, *next }), length = walk(m, INFINITY);
    double d = fmin(4 * tol / (2 * sin(turn / 2)), fmin(half[0], half[1]));
    loft_move leg[2], rest[2];

    if (turn < TURN || turn > BACK || d < 1e-5)
        return false;
    for (int n = 0; n < 20; n++, d *= 0.9) {
        cut(m, walk(m, length - d), &rest[0], &leg[0]);
        cut(next, walk(next, d), &leg[1], &rest[1]);
        blend_of(leg, d, &m[1]);
        if (fmax(off_by(&m[1], 1, leg, 2), off_by(leg, 2, &m[1], 1)) <= tol) {
            *m    = rest[0];
            *next = rest[1];
            return true;
        }
    }
    return false;
}

static unsigned blend_chain(void)
{
    unsigned n = 0;
    double half[2];

    for (unsigned c = 0; c < curves; c++) {
        loft_move next = chain[c];
        half[1] = walk(&next, INFINITY) / 2;
        if (n > 0)
            n += blend_corner(&blended[n - 1], &next, half);
        blended[n++] = next;
        half[0] = half[1];
    }
    return n;
}

/* --- limits of jerk --------------------------------------------------------------------------- */

static path      track;
static topp_jerk jerked;
static unsigned  samples;
static double    whole[LOFT_AXES][SMOOTHED], given[LOFT_AXES][SMOOTHED], mean[LOFT_AXES][SMOOTHED];

/* A sample, mirrored in the ends. */
static double sample(const double v[], long i)
{
    const long last = (long)samples - 1;
    return i < 0 ? 2 * v[0] - v[-i] : i > last ? 2 * v[last] - v[2 * last - i] : v[i];
}

/* The means of 2 half + 1 samples each. */
static void box(const double in[], double out[], long half)
{
    long double sum = (2 * half + 1) * (long double)in[0];

    for (long i = 0; i < (long)samples; i++) {
        out[i] = (double)(sum / (2 * half + 1));
        sum += (long double)sample(in, i + half + 1) - sample(in, i - half);
    }
}

static double mean_off(unsigned k)
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (mean[i][k] - given[i][k]) * (mean[i][k] - given[i][k]);
    return sqrt(sum);
}

/* The means; those of what is left are added in each further round. Returns their largest distance
 * from what is given. */
static double smooth_samples(long half, int rounds)
{
    static double left[SMOOTHED], spare[SMOOTHED];
    double most = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        for (int r = 0; r < rounds; r++) {
            for (unsigned k = 0; k < samples; k++)
                left[k] = given[i][k] - (r ? mean[i][k] : 0);
            box(left, spare, half);
            box(spare, left, half);
            for (unsigned k = 0; k < samples; k++)
                mean[i][k] = left[k] + (r ? mean[i][k] : 0);
        }
    for (unsigned k = 0; k < samples; k++)
        most = fmax(most, mean_off(k));
    return most;
}

/* Evenly by length, into `whole`. Returns their number, and the distance between two. */
static unsigned take_samples(const loft_move moves[], unsigned n, double *h)
{
    double length = 0;

    for (unsigned c = 0; c < n; c++)
        length += polygon_length(&moves[c].curve);
    path_trace(&track, moves, n, fmax(0.002, length / (PATH_MAX / 4.0)));
    const unsigned all = (unsigned)fmin(SMOOTHED,
                                        fmax(fmin(400, track.length / 1e-5), track.length / 0.002));
    *h = track.length / (all - 1.0);
    for (unsigned k = 0, j = 1; k < all; k++) {
        const double s = *h * k;
        while (j + 1 < track.count && track.end[j].s < s)
            j++;
        const double from = track.end[j - 1].s, part = (s - from) / (track.end[j].s - from);
        for (int i = 0; i < LOFT_AXES; i++) {
            const double a = track.end[j - 1].at[i], b = track.end[j].at[i];
            whole[i][k] = a + fmin(1, part) * (b - a);
        }
    }
    return all;
}

/* From `whole`, relative to the first. */
static void give_samples(unsigned from, unsigned to)
{
    samples = to - from + 1;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k < samples; k++)
            given[i][k] = whole[i][from + k] - whole[i][from];
}

static void add_node(unsigned k, double h)
{
    jerk_node *n = &jerked.node[jerked.count++];
    double top = arb_value(chain[0].feed), sum = 0;

    n->s = k * h;
    for (int i = 0; i < LOFT_AXES; i++) {
        double v[5];
        for (int j = 0; j < 5; j++)
            v[j] = sample(mean[i], (long)k + j - 2);
        n->d1[i] = (v[3] - v[1]) / (2 * h);
        n->d2[i] = (v[3] - 2 * v[2] + v[1]) / (h * h);
        n->d3[i] = (v[4] - 2 * v[3] + 2 * v[1] - v[0]) / (2 * h * h * h);
        sum += n->d1[i] * n->d1[i];
        top = fmin(top, arb_value(limits.max_speed[i]) / fmax(1e-9, fabs(n->d1[i])));
    }
    top = fmin(top, arb_value(chain[0].feed) / fmax(1e-9, sqrt(sum)));
    n->top = top * top;
}

/* Places are denser at both ends, and a tenth of the hat apart at most. */
static double time_of_samples(double h, int rounds)
{
    long low = 1, high = samples / 2 - 1;

    while (low < high) {
        const long middle = (low + high + 1) / 2;
        if (smooth_samples(middle, rounds) <= 0.98 * tol)
            low = middle;
        else
            high = middle - 1;
    }
    smooth_samples(low, rounds);
    const unsigned last = samples - 1,
                   most = (unsigned)fmax(
                       1, fmin(fmax((double)low / 5, samples / 3e4), samples / 300.0));
    jerked.count = 0;
    for (unsigned k = 0; k < last; ) {
        const unsigned away = k < last - k ? k : last - k, step = away / 20;
        add_node(k, h);
        k += step < 1 ? 1 : step > most ? most : step;
    }
    add_node(last, h);
    return topp_jerk_time(&jerked);
}

/* Are all samples on the chord? Gives its time. */
static bool straight_time(double *time)
{
    double speed = arb_value(chain[0].feed), accel = INFINITY, jerk = INFINITY;
    const double zero[LOFT_AXES] = { 0 };
    place end;

    for (int i = 0; i < LOFT_AXES; i++)
        end[i] = given[i][samples - 1];
    const double length = distance(end, zero);
    for (unsigned k = 0; k < samples; k++) {
        place q;
        for (int i = 0; i < LOFT_AXES; i++)
            q[i] = given[i][k];
        if (chord_distance(q, zero, end) > 1e-4)
            return false;
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        const double u = fmax(1e-9, fabs(end[i]) / length);
        speed = fmin(speed, arb_value(limits.max_speed[i]) / u);
        accel = fmin(accel, arb_value(limits.max_accel[i]) / u);
        jerk  = fmin(jerk, limits.max_jerk[i] / u);
    }
    *time = scurve_time(length, speed, accel, jerk);
    return true;
}

static double time_between(unsigned from, unsigned to, double h)
{
    double time = INFINITY;

    give_samples(from, to);
    if (samples > 8 && !straight_time(&time))
        for (int rounds = 1; rounds <= 3; rounds++)
            time = fmin(time, time_of_samples(h, rounds));
    return samples > 8 ? time : 0;
}

/* Rests where a hat of BEND tolerances to each side is too wide, most of all in the middle. */
static double time_with_bends(unsigned all, double h)
{
    static bool rest[SMOOTHED];
    double time = 0;

    give_samples(0, all - 1);
    const long half = (long)fmin(BEND * tol / h / 2, samples / 2 - 1.0);
    if (half > 0)
        smooth_samples(half, 1);
    for (unsigned k = 1, most = 0; k < all; k++) {
        const double off = half > 0 ? mean_off(k) : 0;
        most    = off > tol && (!most || off > mean_off(most)) ? k : most;
        rest[k] = false;
        if (most && off <= tol) {
            rest[most] = true;
            most       = 0;
        }
    }
    for (unsigned k = 1, from = 0; k < all; k++)
        if (rest[k] || k + 1 == all) {
            time += time_between(from, k, h);
            from = k;
        }
    return time;
}

static double time_by_jerk(void)
{
    double time = 0, h;

    for (int i = 0; i < LOFT_AXES; i++) {
        jerked.accel[i] = arb_value(limits.max_accel[i]);
        jerked.jerk[i]  = limits.max_jerk[i];
    }
    for (unsigned from = 0, some; from < curves; from += some) {
        some = moves_to_corner(chain + from, curves - from);
        const unsigned all = take_samples(chain + from, some, &h);
        time += all > 8 ? time_with_bends(all, h) : 0;
    }
    return time;
}

int main(int words, char **word)
{
    if (words < 6)
        return 64;
    tol = atof(word[4]);
    for (int n = 5; n < words; n++) {
        even_limits(atof(word[1]), atof(word[2]), atof(word[3]));
        if (!load_moves(".", word[n], 1))
            return 66;
        for (unsigned c = 0; c < curves; c++)
            chain[c].feed = real_of(atof(word[1]));
        if (atof(word[3]) > 0)
            printf("%-28s %9.4f\n", word[n], time_by_jerk());
        else {
            const double stops = time_by_accel(chain, curves);
            printf("%-28s %9.4f", word[n], stops);
            printf(" %9.4f\n", time_by_accel(blended, blend_chain()));
        }
        fflush(stdout);
    }
    return 0;
}
