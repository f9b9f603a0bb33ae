/* host-tools/read/record.c -- reads the pulse record and measures it against the drawing
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "geometry/nearest_piece.h"
#include "read/record.h"
#include "base/scan.h"       /* scan_number */
#include "base/host.h"
#include "base/memory.h"

#define CHORD_TOL 1e-4  /* mm between a curve and its chords */
#define AROUND    64    /* pulses before and after, for a delta */


// Reading
// -------

/* The wanted job begins, or another one. */
static void begin_job(record *r, uint32_t id)
{
    r->other = r->wanted != 0 && id != r->wanted;
    if (r->other)
        return;
    r->count = 0;
    memcpy(r->motors, r->now, sizeof r->motors);
    kinematics_ready(&r->machine.k);
    (void)kinematics_tool(&r->machine.k, r->now, r->start);
}

/* `# key = value` or `# key value`; unknown keys are skipped. steps_per_mm may be one number,
 * three, or one per axis. */
static int read_key(host *h, record *r, const char *file, unsigned number, const char *line)
{
    static const char *const maps[] = { "kinematics",  "center", "arm_length", "delta_radius",
                                        "tower_angle", "turn",   "inside" };
    const char *key = line + strspn(line, "# \t"), *at = key + scan_word(key);
    const size_t length = (size_t)(at - key);
    double v[3];
    int count = 0;

    for (size_t i = 0; i < sizeof maps / sizeof maps[0]; i++)
        if (strncmp(key + (key[0] && key[1] == '.' ? 2 : 0), maps[i], strlen(maps[i])) == 0)
            return machine_line(h, &r->machine, file, number, key);
    at += strspn(at, " \t=:");
    if (length == 3 && strncmp(key, "job", 3) == 0) {
        begin_job(r, (uint32_t)strtoul(at, NULL, 16));
        return 0;
    }
    while (count < 3 && scan_number(&at, &v[count])) {
        count++;
        scan_comma(&at);
    }
    if (count == 0)
        return 0;
    if (length == 7 && strncmp(key, "slot_hz", 7) == 0)
        r->slot_hz = v[0];
    if (length == 14 && strncmp(key, "steps_per_mm_", 13) == 0 && key[13] >= 'x' && key[13] <= 'z')
        r->steps_per_mm[key[13] - 'x'] = v[0];
    if (length == 12 && strncmp(key, "steps_per_mm", 12) == 0)
        for (int i = 0; i < 3; i++)
            r->steps_per_mm[i] = v[count == 3 ? i : 0];
    return 0;
}

/* Read whole numbers, separated by commas or blanks: slot, x, y and perhaps z. Returns false for
 * anything else. */
static bool read_pulse(record *r, const char *line)
{
    double motors[3] = { 0, 0, 0 };
    record_pulse p;
    char *end;
    int count = 0;

    p.slot = strtoull(line, &end, 10);
    for (const char *at = end; at > line; at = end) {
        at += strspn(at, ", \t;");
        const long long steps = strtoll(at, &end, 10);
        if (end == at)
            break;
        if (count < 3)
            motors[count] = (double)steps / r->steps_per_mm[count];
        count++;
    }
    end += strspn(end, ", \t\r\n");
    if (count < 2 || *end != '\0' || !kinematics_tool(&r->machine.k, motors, p.at))
        return false;
    memcpy(r->now, motors, sizeof r->now);
    if (r->other)
        return true;
    memcpy(r->motors, motors, sizeof r->motors);
    if (r->count == r->room) {
        r->room  = r->room ? 2 * r->room : 4096;
        r->pulse = memory_grow(r->pulse, r->room * sizeof *r->pulse);
    }
    r->pulse[r->count++] = p;
    return true;
}

static int read_lines(host *h, record *r, const char *file, FILE *stream)
{
    char line[512];

    for (unsigned number = 1; fgets(line, sizeof line, stream); number++) {
        const char *at = line + strspn(line, " \t");
        if (strchr(line, '\n') == NULL && feof(stream))
            break;                      /* still being written */
        if (*at == '#') {
            const int code = read_key(h, r, file, number, at);
            if (code != 0)
                return code;
            continue;
        }
        if (r->count == 0 && !r->other) {
            kinematics_ready(&r->machine.k);
            (void)kinematics_tool(&r->machine.k, r->now, r->start);
        }
        if (*at == '\n' || *at == '\r' || *at == '\0' ||
            (r->count == 0 && strncmp(at, "slot", 4) == 0))
            continue;
        for (int i = 0; i < 3; i++)
            if (!(r->steps_per_mm[i] > 0))
                return host_error(h, EX_DATAERR, "record.no-scale", (host_place){ file, number },
                                  "is not a pulse record of `loft simulate --record`",
                                  "no steps per mm above");
        if (!read_pulse(r, at))
            return host_error(h, EX_DATAERR, "record.not-a-pulse", (host_place){ file, number },
                              NULL, "\"%.*s\" is not a pulse: slot,x,y,z in steps is expected",
                              (int)strcspn(at, "\r\n") > 40 ? 40 : (int)strcspn(at, "\r\n"), at);
    }
    if (ferror(stream))
        return host_error(h, errno == EISDIR ? EX_NOINPUT : EX_IOERR, "file.not-read",
                          (host_place){ file, 0 }, NULL, "cannot be read: %s", strerror(errno));
    if (r->count == 0)
        return host_error(h, EX_DATAERR, "record.empty", (host_place){ file, 0 },
                          "is it the record of a finished job?", "holds no pulse");
    return 0;
}

int record_read(host *h, record *r, const char *file, uint32_t job)
{
    const bool piped = strcmp(file, "-") == 0;
    const char *name = piped ? "standard input" : file;
    FILE *stream = piped ? fdopen(dup(STDIN_FILENO), "r") : fopen(file, "r");

    if (stream == NULL)
        return host_error(h, EX_NOINPUT, "file.not-opened", (host_place){ name, 0 }, NULL,
                          "cannot be opened: %s", strerror(errno));
    r->machine = machine_usual();
    r->wanted  = job;
    const int code = read_lines(h, r, name, stream);
    fclose(stream);

    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (size_t i = 0; i < r->count; i++) {
        least    = fmin(least, r->pulse[i].at[2]);
        greatest = fmax(greatest, r->pulse[i].at[2]);
    }
    r->pen_down = greatest > least ? greatest / 2 : greatest;
    return code;
}

void record_free(record *r)
{
    free(r->pulse);
    *r = (record){ 0 };
}

static const double *place_before(const record *r, size_t i)
{
    return i > 0 ? r->pulse[i - 1].at : r->start;
}

/* Where no motor only lifts, each step moves x, y and z. There a pulse draws if the tool moves more
 * sideways than up over a few steps. */
bool record_draws(const record *r, size_t i)
{
    const bool lifts  = r->machine.k.kind->lifts;
    const size_t from = lifts ? i : i > AROUND ? i - AROUND : 0;
    const size_t to   = lifts ? i + 1 : r->count - i > AROUND ? i + AROUND : r->count;
    const double *before = place_before(r, from), *after = place_before(r, to),
                 *now = r->pulse[i].at;

    if (now[2] > r->pen_down)
        return false;
    if (!lifts)
        return hypot(after[0] - before[0], after[1] - before[1]) > fabs(after[2] - before[2]);
    return after[0] != before[0] || after[1] != before[1];
}

double record_seconds(const record *r)
{
    return r->count > 0 && r->slot_hz > 0
               ? (double)(r->pulse[r->count - 1].slot - r->pulse[0].slot + 1) / r->slot_hz
               : 0;
}


// Measuring
// ---------

/* The drawing as chords, each with its range of its curve's parameter. */
typedef struct {
    nearest chords;
    struct chord {
        const drawing_curve *curve;
        double t0, t1;
    } * of;
    size_t room;
} chords;

/* A chord over a parameter range h is within h^2/8 max|P''| of its curve, and P'' is at most 6
 * times the larger second difference of the control points. */
static unsigned chord_count(const drawing_curve *c)
{
    double most = 0;

    for (int k = 0; k < 2; k++)
        most = fmax(most, hypot(c->p[k][0] - 2 * c->p[k + 1][0] + c->p[k + 2][0],
                                c->p[k][1] - 2 * c->p[k + 1][1] + c->p[k + 2][1]));
    return (unsigned)ceil(sqrt(6 * most / 8 / CHORD_TOL)) + 1;
}

static void cut_chords(chords *all, const drawing *d)
{
    *all = (chords){ .room = 0 };
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        const unsigned n = chord_count(c);
        double a[2], b[2];

        if (all->room < all->chords.count + n) {
            all->room = 2 * (all->chords.count + n);
            all->of   = memory_grow(all->of, all->room * sizeof *all->of);
        }
        memcpy(a, c->p[0], sizeof a);
        for (unsigned k = 0; k < n; k++) {
            drawing_eval(c, (k + 1.0) / n, b);
            all->of[all->chords.count] = (struct chord){ c, (double)k / n, (k + 1.0) / n };
            nearest_add(&all->chords, a, b);
            memcpy(a, b, sizeof a);
        }
    }
    nearest_build(&all->chords);
}

static void free_chords(chords *all)
{
    nearest_free(&all->chords);
    free(all->of);
}

/* From a point on the chord, find the point of the curve whose normal contains p, by Newton's
 * method on (P - p) P' = 0 with P'' left out. The chord is so short that two steps reach
 * rounding. */
static double polish_parameter(const struct chord *c, double u, const double p[2], double out[2])
{
    double t = c->t0 + u * (c->t1 - c->t0);

    for (int step = 0; step < 3; step++) {
        double at[2], v[2];
        drawing_eval(c->curve, t, at);
        drawing_deriv(c->curve, t, v);
        const double speed = v[0] * v[0] + v[1] * v[1];
        if (speed > 0)
            t -= ((at[0] - p[0]) * v[0] + (at[1] - p[1]) * v[1]) / speed;
        t = fmin(fmax(t, c->t0), c->t1);
    }
    drawing_eval(c->curve, t, out);
    return hypot(out[0] - p[0], out[1] - p[1]);
}

double record_worst_error(const drawing *d, const record *r, double (*point)[2], size_t *where)
{
    chords all;
    size_t hint = 0, worst_at = 0;
    double worst = 0;

    if (d->count == 0)
        return 0;
    cut_chords(&all, d);
    for (size_t i = 0; i < r->count; i++) {
        if (!record_draws(r, i))
            continue;
        double u, chord, at[2];
        hint = nearest_find(&all.chords, r->pulse[i].at, hint, &u, &chord);
        const double off = polish_parameter(&all.of[hint], u, r->pulse[i].at, at);
        if (point != NULL)
            memcpy(point[i], at, sizeof at);
        if (off > worst) {
            worst    = off;
            worst_at = i;
        }
    }
    if (where != NULL)
        *where = worst_at;
    free_chords(&all);
    return worst;
}

double record_worst_gap(const drawing *d, const record *r, double where[2])
{
    nearest drawn = { 0 };
    chords all;
    size_t hint = 0;
    double worst = 0;

    for (size_t i = 0; i < r->count; i++)
        if (record_draws(r, i))
            nearest_add(&drawn, place_before(r, i), r->pulse[i].at);
    if (drawn.count == 0)
        return HUGE_VAL;
    nearest_build(&drawn);
    cut_chords(&all, d);
    for (size_t i = 0; i < all.chords.count; i++) {
        double u, off;
        hint = nearest_find(&drawn, all.chords.piece[i].b, hint, &u, &off);
        if (off > worst) {
            worst = off;
            if (where != NULL)
                memcpy(where, all.chords.piece[i].b, 2 * sizeof *where);
        }
    }
    free_chords(&all);
    nearest_free(&drawn);
    return worst;
}
