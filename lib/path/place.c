/* lib/path/place.c
 * SPDX-License-Identifier: MIT
 *
 * The cubic through places P, Q from P at the part z is
 *
 *     P + z (chord + (1 - z) ((1 - z) before - z after))
 *
 * where `before` and `after` are half of what the legs around it differ by from the chord. Where it
 * is nearest to a point is found along its tangent.
 */
#include "path/place.h"

#include "num/part.h"       /* loft_part, loft_doublings */

#define PART_ONE    (INT32_C(1) << 24)  /* a part */
#define ROUNDS      4                   /* towards the nearest place of a cubic */
#define NEAR        (PART_ONE / 256)


static void legs_of(const loft_position *a, const loft_position *b, loft_coord leg[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        leg[i] = loft_coord_sub(b->axis[i], a->axis[i]);
}

static loft_coord largest(const loft_coord x[])
{
    loft_coord most = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        most = loft_coord_abs(x[i]) > most ? loft_coord_abs(x[i]) : most;
    return most;
}

/* Half of what a leg differs by from the chord: of one much longer, half the chord at most, so that
 * the cubic does not turn back. At a sharp place there is none. */
static void set_turn(loft_coord leg[], const loft_coord chord[], bool sharp)
{
    const int64_t size = largest(leg), most = 2 * (int64_t)largest(chord);

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = size > most ? leg[i] * most / size : leg[i];
        leg[i] = sharp ? 0 : (loft_coord)((part - chord[i]) / 2);
    }
}

loft_path_cubic loft_path_cubic_of(const loft_path_place *const at[4])
{
    loft_path_cubic w = { .from = &at[1]->at };

    legs_of(&at[0]->at, &at[1]->at, w.before);
    legs_of(&at[1]->at, &at[2]->at, w.chord);
    legs_of(&at[2]->at, &at[3]->at, w.after);
    set_turn(w.before, w.chord, at[1]->sharp);
    set_turn(w.after, w.chord, at[2]->sharp);
    return w;
}

/* x z / 2^24, too small by less than 3; |z| <= 2^24. */
static int32_t times(int32_t x, int32_t z)
{
    return 2 * loft_part(x, z >> 9) + ((x >> 15) * (z & 511) >> 9);
}

/* (1 - z) before - z after */
static int32_t bow_at(const loft_path_cubic *w, int i, int32_t z)
{
    return times(w->before[i], PART_ONE - z) - times(w->after[i], z);
}

static void place_between(const loft_path_cubic *w, int32_t z, loft_position *out)
{
    const int32_t in = times(z, PART_ONE - z);

    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_coord_add(w->from->axis[i],
                                      times(w->chord[i], z) + times(bow_at(w, i, z), in));
}

void loft_path_between(const loft_path_place *const at[4], int32_t z, loft_position *out)
{
    const loft_path_cubic w = loft_path_cubic_of(at);
    place_between(&w, z, out);
}

/* Its derivative by z. */
static void tangent_between(const loft_path_cubic *w, int32_t z, loft_coord out[])
{
    const int32_t y = PART_ONE - z, in = times(z, y);

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = w->chord[i] + times(bow_at(w, i, z), y - z) -
                 times(w->before[i] + w->after[i], in);
}

/* By how many bits the largest is longer than that. */
static int excess(const loft_coord x[], int bits)
{
    const int n = 30 - bits - loft_doublings((uint32_t)largest(x) | 1);
    return n > 0 ? n : 0;
}

/* The part of the tangent that `off` is along it, 2^-24: with 13 bits of the one and 14 of the
 * other sums have 30, and the quotient has 14. */
static int32_t part_along(const loft_coord off[], const loft_coord tangent[])
{
    const int down = excess(tangent, 13), low = excess(off, 14);
    int32_t dot = 0, square = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t e = tangent[i] >> down;
        dot += (off[i] >> low) * e;
        square += e * e;
    }
    if (dot == 0 || square == 0)
        return 0;
    const int up = loft_doublings((uint32_t)loft_coord_abs(dot)),
              by = 15 - loft_doublings((uint32_t)square),
              shift = 24 + low - down - up - (by > 0 ? by : 0);
    const int32_t q = dot * ((int32_t)1 << up) / (square >> (by > 0 ? by : 0));
    return shift <= 0 ? q >> (shift > -31 ? -shift : 31)
           : shift < 14 && loft_coord_abs(q) < INT32_C(1) << (26 - shift)
               ? q * ((int32_t)1 << shift)
           : q > 0 ? 2 * PART_ONE
                   : -2 * PART_ONE;
}

/* How far it is off its tangent at most, a part of it farther. */
static loft_coord bend_of(const loft_path_cubic *w, int32_t part)
{
    const loft_coord x = times(times(largest(w->before) + largest(w->after), part), part);
    return 4 * loft_coord_least(x, INT32_C(1) << 27);
}

/* Along its tangent, until that is near; then across it, but beyond the ends of the cubic. */
loft_coord loft_path_cubic_off(const loft_path_cubic *w, int32_t z, const loft_position *p)
{
    for (int round = 0;; round++) {
        loft_position on;
        loft_coord off[LOFT_AXES], tangent[LOFT_AXES];

        place_between(w, z, &on);
        tangent_between(w, z, tangent);
        legs_of(&on, p, off);
        const int32_t part = part_along(off, tangent), next = z + part,
                      to = next < 0          ? 0
                           : next > PART_ONE ? PART_ONE
                                             : next;
        if (round < ROUNDS && loft_coord_abs(to - z) > NEAR) {
            z = to;
            continue;
        }
        if (to != next)
            return loft_coord_length(off);
        for (int i = 0; i < LOFT_AXES; i++)
            off[i] -= times(tangent[i], part);
        return loft_coord_length(off) + bend_of(w, part);
    }
}

loft_coord loft_path_off(const loft_path_place *const at[4], int32_t z, const loft_position *p)
{
    const loft_path_cubic w = loft_path_cubic_of(at);
    return loft_path_cubic_off(&w, z, p);
}

bool loft_path_turns_back(const loft_path_place *a, const loft_path_place *b,
                          const loft_path_place *c)
{
    loft_coord before[LOFT_AXES], behind[LOFT_AXES];
    int64_t dot = 0;

    legs_of(&a->at, &b->at, before);
    legs_of(&b->at, &c->at, behind);
    for (int i = 0; i < LOFT_AXES; i++)
        dot += (int64_t)(before[i] >> 2) * (behind[i] >> 2);
    return dot < 0;
}

loft_coord loft_path_miss(const loft_path_place *const at[5], const loft_position *p)
{
    if (loft_path_turns_back(at[1], at[2], at[3]))
        return loft_position_distance(&at[2]->at, p);
    const loft_coord before = loft_path_off(at, PART_ONE, p), behind = loft_path_off(at + 1, 0, p);
    return loft_coord_least(before, behind);
}

loft_coord loft_path_miss_of(const loft_position at[5], const loft_position *p)
{
    loft_path_place place[5];
    const loft_path_place *all[5];

    for (unsigned k = 0; k < 5; k++) {
        place[k] = (loft_path_place){ .at = at[k] };
        all[k] = &place[k];
    }
    return loft_path_miss(all, p);
}

/* It is off by a 36th of the fourth difference. */
bool loft_path_missed(const loft_path_place *const at[5], loft_coord most)
{
    int64_t d4[LOFT_AXES], size = 0;
    loft_position p;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord x = at[2]->at.axis[i];
        const int64_t near = (int64_t)loft_coord_sub(at[1]->at.axis[i], x) +
                             loft_coord_sub(at[3]->at.axis[i], x),
                      far = (int64_t)loft_coord_sub(at[0]->at.axis[i], x) +
                            loft_coord_sub(at[4]->at.axis[i], x);
        d4[i] = far - 4 * near;
        size += loft_long_abs(d4[i]);
    }
    if (size < 36 * (int64_t)most)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = loft_coord_add(at[2]->at.axis[i], -(loft_coord)(d4[i] / 36));
    return loft_path_miss(at, &p) > most;
}

/* There it is off the middle of the chord by (a + 16 b - 16 d - e) / 288, with the two ways before
 * and the two behind. */
loft_coord loft_path_missed_between(const loft_path_place *const at[6])
{
    loft_coord way[5][LOFT_AXES];
    loft_position p;

    for (unsigned n = 0; n < 5; n++)
        legs_of(&at[n]->at, &at[n + 1]->at, way[n]);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t off = way[0][i] - way[4][i] + 16 * ((int64_t)way[1][i] - way[3][i]);
        p.axis[i] = loft_coord_add(at[2]->at.axis[i], way[2][i] / 2 + (loft_coord)(off / 288));
    }
    return loft_path_off(at + 1, PART_ONE / 2, &p);
}
