/* tests/tools/test_say.c -- words of others reach a terminal as text alone
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/say.h"
#include "host/duration.h"
#include "tools/drawn.h"

/* A code point, often one that a terminal obeys or that hides. */
static int32_t arb_point(arb *a)
{
    static const int32_t odd[] = { 0x1b,   0x07,   0x08,   0x0a,   0x0d,   0x7f,
                                   0x80,   0x9b,   0x9d,   0xad,   0x61c,  0x200b,
                                   0x200e, 0x2028, 0x202e, 0x2066, 0xfeff, 0xe0041 };
    static const int32_t most[] = { 0x7f, 0x7ff, 0xffff, 0x10ffff };
    int32_t c;

    if (arb_below(a, 3) == 0)
        return odd[arb_below(a, sizeof odd / sizeof *odd)];
    do
        c = 1 + (int32_t)arb_below(a, (uint32_t)most[arb_below(a, 4)]);
    while (c >= 0xd800 && c <= 0xdfff);
    return c;
}

static size_t encode(int32_t c, char out[4])
{
    const int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;

    out[0] = (char)(more == 0 ? c : (0xf80 >> more & 0xff) | c >> 6 * more);
    for (int k = 1; k <= more; k++)
        out[k] = (char)(0x80 | (c >> 6 * (more - k) & 0x3f));
    return (size_t)more + 1;
}

/* Text, of which `damage` in 8 bytes are arbitrary. */
static void arb_text(arb *a, char *text, size_t room, unsigned damage)
{
    size_t used = 0;

    while (used + 5 < room)
        if (arb_below(a, 8) < damage)
            text[used++] = (char)(1 + arb_below(a, 255));
        else
            used += encode(arb_point(a), text + used);
    text[used] = '\0';
}

/* Everything in it is a character that prints. */
static bool prints(const char *text)
{
    int32_t c;

    for (int size; *text != '\0'; text += size) {
        size = say_character(text, &c);
        if (c < 0x20 || c == 0x7f || (c >= 0x80 && c < 0xa0) || say_hides(c))
            return false;
    }
    return true;
}

static void nothing_hidden_comes_out(arb *a)
{
    char text[200], out[2500], again[2500], part[64];

    arb_text(a, text, sizeof text, arb_below(a, 9));
    say_copy(out, sizeof out, text);
    CHECK(prints(out));
    CHECK(strcmp(say_copy(again, sizeof again, out), out) == 0);
    CHECK(!prints(text) || strcmp(text, out) == 0);
    const size_t room = 1 + arb_below(a, sizeof part);
    say_copy(part, room, text);
    CHECK(strlen(part) < room && prints(part) && strncmp(part, out, strlen(part)) == 0);
}

static void printf_for_people_says_one_line(arb *a)
{
    char text[900], want[9000], got[9000];
    FILE *f = tmpfile();

    arb_text(a, text, 20 + arb_below(a, 850), arb_below(a, 9));
    CHECK(f != NULL && say(f, "%s: %d%s\n", text, 7, text) > 0);
    rewind(f);
    got[fread(got, 1, sizeof got - 1, f)] = '\0';
    fclose(f);
    say_copy(want, sizeof want, text);
    const size_t size = strlen(want);
    CHECK(strncmp(got, want, size) == 0 && strncmp(got + size, ": 7", 3) == 0);
    CHECK(strncmp(got + size + 3, want, size) == 0 && strcmp(got + 2 * size + 3, "\n") == 0);
}

static void each_character_is_told_as_it_is(arb *a)
{
    const int32_t c = arb_point(a);
    char text[5] = "", out[20], want[20];
    int32_t seen;

    const size_t size = encode(c, text);
    CHECK(say_character(text, &seen) == (int)size && seen == c);
    snprintf(want, sizeof want, c < 0x80 ? "\\x%02x" : "\\u%04x", (unsigned)c);
    CHECK(strcmp(say_copy(out, sizeof out, text), say_hides(c) ? want : text) == 0);
    CHECK(say_character("\xc0\x9b", &seen) == 1 && seen < 0);      /* longer than need be */
    CHECK(say_character("\xed\xa0\x80", &seen) == 1 && seen < 0);  /* half a pair */
    CHECK(say_character("\xf4\x90\x80\x80", &seen) == 1 && seen < 0);
}

/* Back from `12.5 s`, `3:09` and `3:09:12`. */
static double seconds_of(const char *text)
{
    double sum = 0, part;
    int used;

    for (; sscanf(text, "%lf%n", &part, &used) == 1; text += used + (text[used] == ':'))
        sum = 60 * sum + part;
    return sum;
}

static void a_duration_above_a_minute_has_minutes(arb *a)
{
    static const double edges[] = { 0, 59.4, 59.6, 59.96, 60, 3599.4, 3599.6, 3600, 11352, 1e9 };
    const double s = arb_below(a, 4) == 0 ? edges[arb_below(a, 10)]
                                          : pow(10, arb_below(a, 9000) * 1e-3);
    const int decimals = (int)arb_below(a, 4);
    char text[HOST_DURATION];
    int fields = 1;

    host_duration(text, s, decimals);
    for (const char *c = text; *c != '\0'; c++)
        fields += *c == ':';
    const double told = seconds_of(text), half = 0.5 * (fields > 1 ? 1 : pow(10, -decimals));
    CHECK(strlen(text) < HOST_DURATION && fabs(told - s) <= half * (1 + 1e-9) + 1e-9);
    CHECK(fields == (told < 60 ? 1 : told < 3600 ? 2 : 3));
    CHECK((strstr(text, " s") != NULL) == (fields == 1));
    CHECK(strcmp(host_duration(text, 11352, decimals), "3:09:12") == 0);
    CHECK(strcmp(host_duration(text, 189, decimals), "3:09") == 0);
    CHECK(strcmp(host_duration(text, a->state & 1 ? NAN : HUGE_VAL, decimals), "--:--") == 0);
}

int main(void)
{
    PROPERTY(a_duration_above_a_minute_has_minutes, 500);
    PROPERTY(nothing_hidden_comes_out, 500);
    PROPERTY(printf_for_people_says_one_line, 200);
    PROPERTY(each_character_is_told_as_it_is, 500);
    return check_failures();
}
