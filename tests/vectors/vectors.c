/* tests/vectors/vectors.c -- hold the library against folders of exact results
 * SPDX-License-Identifier: MIT
 *
 * usage: vectors FOLDER [KNOWN]      one line per CSV: system rows max_error_lsb bound verdict
 *        vectors --list              the systems that have a reader, their columns, their bounds in
 *                                    words
 *
 * Error and bound are in LSB (2^-16 in every number type). Where the bound is a law per row, both
 * are those of the value that comes closest to its bound, so that the two can be compared in every
 * line.
 *
 * A system without a reader says so. It fails the run unless KNOWN, the project's own folder, has a
 * CSV of that name: then its reader is still to come.
 */
#define _GNU_SOURCE             /* getline, scandir */

#include <dirent.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vectors/vectors.h"

static const vector_system *const tables[] = {
    vectors_curve,   vectors_measure,  vectors_shape,    vectors_rational,        vectors_bspline,
    vectors_join,    vectors_spline,   vectors_sign,     vectors_coons,           vectors_tensor,
    vectors_polygon, vectors_harmonic, vectors_deficit,  vectors_chapter,         vectors_spatch,
    vectors_npatch,  vectors_gb,       vectors_triangle, vectors_triangle_curved, vectors_tetra,
    vectors_motion,  vectors_ends,     vectors_weighted, vectors_decide, vectors_meet,
    vectors_woven,   vectors_fit,      vectors_along, vectors_across, vectors_made,
    vectors_sides
};

#define DIGITS 1e-9L            /* LSB: what 20 significant digits leave open */

void row_complain(row *r, const char *format, ...)
{
    va_list list;

    if (r->complaint[0])
        return;
    va_start(list, format);
    vsnprintf(r->complaint, sizeof r->complaint, format, list);
    va_end(list);
}


/* Inputs */

const char *row_text(row *r, const char *column)
{
    for (unsigned k = 0; k < r->columns; k++)
        if (strcmp(r->name[k], column) == 0)
            return r->field[k];
    row_complain(r, "no column %s", column);
    return "";
}

long double row_next(const char **text)
{
    char *end;
    const long double x = strtold(*text, &end);

    if (end == *text)
        return INFINITY;
    for (*text = end; **text == ' ' || **text == ';'; )
        ++*text;
    return x;
}

/* Take a whole number off *text. */
static int64_t whole(row *r, const char *column, const char **text, int64_t least, int64_t most)
{
    char *end;

    errno = 0;
    const long long v = strtoll(*text, &end, 10);
    if (end == *text || errno || v < least || v > most) {
        row_complain(r, "column %s: no whole number in %lld..%lld at '%.20s'", column,
                     (long long)least, (long long)most, *text);
        return least > 0 ? least : 0;
    }
    *text = end;
    return v;
}

static void ends(row *r, const char *column, const char *text)
{
    if (*text)
        row_complain(r, "column %s: more than expected, '%.20s'", column, text);
}

static int64_t only_whole(row *r, const char *column, int64_t least, int64_t most)
{
    const char *text = row_text(r, column);
    const int64_t v = whole(r, column, &text, least, most);

    ends(r, column, text);
    return v;
}

unsigned row_count(row *r, const char *column, unsigned most)
{
    return (unsigned)only_whole(r, column, 0, most);
}
bool row_is(row *r, const char *column, const char *word)
{
    return strcmp(row_text(r, column), word) == 0;
}

loft_unit row_unit(row *r, const char *column)
{
    const int64_t raw = only_whole(r, column, -(1 << 23) + 1, (1 << 23) - 1);
    return (loft_unit)BY_NUM(raw * 256, (double)raw / 65536, (double)raw / 65536);
}

loft_unit row_unit_q30(row *r, const char *column)
{
    const int64_t raw = only_whole(r, column, INT32_MIN, INT32_MAX);
    return (loft_unit)BY_NUM((raw + 32) >> 6, (double)raw / 1073741824, (double)raw / 1073741824);
}

static loft_real coordinate(row *r, const char *column, const char **text)
{
    const int64_t raw = whole(r, column, text, INT32_MIN, INT32_MAX);
    const loft_real x = (loft_real)BY_NUM(raw, (double)raw / 65536, (double)raw / 65536);

    r->largest = fmaxl(r->largest, fabsl(raw / 65536.0L));
    r->inexact = fmaxl(r->inexact, fabsl(raw / 65536.0L - exact_of(x)));
    return x;
}

loft_real row_real(row *r, const char *column)
{
    loft_real x;
    row_reals(r, column, 1, &x);
    return x;
}

void row_reals(row *r, const char *column, unsigned count, loft_real out[])
{
    const char *text = row_text(r, column);

    for (unsigned k = 0; k < count; k++)
        out[k] = coordinate(r, column, &text);
    ends(r, column, text);
}

/* Numbers, or points if there are semicolons. */
unsigned row_length(row *r, const char *column, unsigned most)
{
    const char *text = row_text(r, column), between = strchr(text, ';') ? ';' : ' ';
    unsigned count = *text != '\0';

    for (; *text; text++)
        count += *text == between;
    if (count > most)
        row_complain(r, "column %s: %u is more than %u", column, count, most);
    return count < most ? count : most;
}

void row_points(row *r, const char *column, unsigned count, unsigned d, loft_vec out[])
{
    const char *text = row_text(r, column);

    for (unsigned k = 0; k < count; k++) {
        out[k] = (loft_vec) { { 0 } };
        for (unsigned i = 0; i < d && i < LOFT_AXES; i++)
            out[k].axis[i] = coordinate(r, column, &text);
        if (k + 1 < count && *text++ != ';') {
            row_complain(r, "column %s: point %u does not have %u coordinates", column, k, d);
            text = "";
        }
    }
    ends(r, column, text);
}


/* Answers */

static answer scratch[16];          /* more than any row has columns of answers */
static unsigned scratch_used;

answer *answer_new(void)
{
    answer *a = &scratch[scratch_used++ % (sizeof scratch / sizeof scratch[0])];
    a->count = 0;
    a->refused = a->wide = false;
    return a;
}

void answer_status(row *r, answer *a, enum loft_status status)
{
    if (status == LOFT_ERR_RANGE)
        a->refused = true;
    else if (status != LOFT_OK)
        row_complain(r, "refused with status %d", status);
}

static void push(answer *a, long double value)
{
    if (a->count < LIST_MAX)
        a->value[a->count++] = value;
}

void answer_real(answer *a, loft_real x) { push(a, exact_of(x)); }
void answer_wide(answer *a, loft_acc x)
{
    push(a, exact_acc(x));
    a->wide = true;
}

void answer_unit(answer *a, loft_unit t) { push(a, exact_unit(t)); }

void answer_acc(answer *a, loft_acc x)
{
    if (loft_acc_valid(x))
        answer_real(a, loft_acc_round(x));
    else
        a->refused = true;
}

void answer_vec(answer *a, loft_vec v, unsigned d)
{
    for (unsigned i = 0; i < d && i < LOFT_AXES; i++)
        answer_real(a, v.axis[i]);
}

/* Outside the range of a coordinate by how much? Negative: inside. */
static long double outside(long double want)
{
    const long double half = BY_NUM(LSB / 2, 0, 0);
    const long double top = BY_NUM(32768 - LSB, FLT_MAX, DBL_MAX) + half,
                      bottom = BY_NUM(-32768, -FLT_MAX, -DBL_MAX) - half;
    return fmaxl(want - top, bottom - want);
}

static long double bound_of(const row *r, const answer *a, law l, long double want)
{
    const long double gain = fmaxl(l.gain, 1);
    const long double floats = gain * (r->inexact + l.roundings * ulp_double(r->largest)) +
                               (a->wide ? 0 : ulp(want) / 2);
    const long double by_num[2] = { l.lsb, floats * 65536 };
    return by_num[BY_NUM(0, 1, 1)] + DIGITS;
}

void row_within(row *r, const char *what, long double error, long double bound)
{
    if (!(error <= bound))
        row_complain(r, "%s: %.6Lg LSB off, bound %.6Lg", what, error, bound);
    if (!(error * r->bound <= r->error * bound)) {
        r->error = error;
        r->bound = bound;
    }
}

static void compare(row *r, const char *column, const answer *a, law l, unsigned k,
                    long double want)
{
    if (!a->wide && outside(want) > LSB)
        r->beyond = true;
    else if (!a->wide && outside(want) > -LSB)
        r->edge = true;
    if (a->refused || (!a->wide && outside(want) > -LSB))
        return;
    const long double bound = bound_of(r, a, l, want);
    const long double error = k < a->count ? fabsl(a->value[k] - want) * 65536 : INFINITY;

    if (!(error <= bound))
        row_complain(r,
                     "column %s, value %u: %.15Lg wanted, %.15Lg given: %.6Lg LSB off, bound %.6Lg",
                     column, k, want, k < a->count ? a->value[k] : NAN, error, bound);
    row_within(r, column, error, bound);
}

void row_expect(row *r, const char *column, const answer *a, law l)
{
    const char *text = row_text(r, column);
    unsigned k = 0;

    r->refused = r->refused || a->refused;
    for (; *text; k++) {
        char *end;
        const long double want = strtold(text, &end);
        if (end == text || !isfinite(want)) {
            row_complain(r, "column %s: no number at '%.20s'", column, text);
            return;
        }
        compare(r, column, a, l, k, want);
        for (text = end; *text == ' ' || *text == ';' || *text == ','; )
            text++;
    }
    if (!a->refused && k != a->count)
        row_complain(r, "column %s has %u values, %u were expected", column, k, a->count);
}

void row_expect_word(row *r, const char *column, const char *word)
{
    if (!row_is(r, column, word))
        row_complain(r, "column %s is %s, not %s", column, row_text(r, column), word);
}

void row_expect_flag(row *r, const char *column, bool flag)
{
    if (!row_is(r, column, flag ? "1" : "0"))
        row_complain(r, "column %s is %s, not %d", column, row_text(r, column), flag);
}


/* Files */

static const vector_system *find(const char *name)
{
    for (unsigned k = 0; k < sizeof tables / sizeof tables[0]; k++)
        for (const vector_system *s = tables[k]; s->name; s++)
            if (strcmp(s->name, name) == 0)
                return s;
    return NULL;
}

/* At most `most` fields; the last one is then the rest of the line. */
static unsigned split(char *line, char *field_of[], unsigned most)
{
    unsigned count = 0;

    for (; line && count + 1 < most; count++)
        field_of[count] = strsep(&line, ",");
    if (line)
        field_of[count++] = line;
    return count;
}

/* One more line without its end; false at the end of the file. */
static bool next_line(FILE *file, char **line, size_t *size, unsigned *number)
{
    const ssize_t length = getline(line, size, file);

    if (length < 0)
        return false;
    (*line)[strcspn(*line, "\r\n")] = '\0';
    ++*number;
    return true;
}

/* The verdict on one row: complain about what was not said while its columns were compared. */
static bool judge(row *r, const char *path, unsigned line)
{
    if (r->refused && !r->beyond && !r->edge)
        row_complain(r, "an overflow was reported, but every expected value fits");
    if (!r->refused && r->beyond)
        row_complain(r, "an expected value does not fit, and no overflow was reported");
    if (r->complaint[0])
        printf("%s:%u: %s\n", path, line, r->complaint);
    return !r->complaint[0];
}

/* The columns are named by the CSV's second line; a CSV without one has those of the table, in
 * order. */
static bool name_columns(row *names, const vector_system *s, char *second, const char *path)
{
    static char own[1024], wanted[1024];
    char *rest = wanted;

    if (!s)
        return true;
    snprintf(own, sizeof own, "%s", s->columns);
    snprintf(wanted, sizeof wanted, "%s", s->columns);
    names->columns = split(second ? second : own, names->name, ROW_COLUMNS);
    for (unsigned k = 0; k < names->columns; k++)
        names->field[k] = names->name[k];
    for (char *column; (column = strsep(&rest, ",")) != NULL; )
        row_text(names, column);
    if (names->complaint[0])
        printf("%s:2: %s\n", path, names->complaint);
    return !names->complaint[0];
}

typedef struct {
    unsigned rows, bad;
    long double error, bound;
} result;

static void read_rows(FILE *file, unsigned number, const vector_system *s, const char *path,
                      const row *names, result *sum)
{
    char *line = NULL;
    size_t size = 0;

    while (next_line(file, &line, &size, &number)) {
        if (!*line)
            continue;
        sum->rows++;
        if (!s)
            continue;
        row r = *names;
        scratch_used = 0;
        const unsigned found = split(line, r.field, r.columns);
        if (found != r.columns)
            row_complain(&r, "%u columns of %u", found, r.columns);
        else
            s->function(&r);
        sum->bad += !judge(&r, path, number);
        if (!(r.error * sum->bound <= sum->error * r.bound)) {
            sum->error = r.error;
            sum->bound = r.bound;
        }
    }
    free(line);
}

/* A first line `# name: ..` names the system, and the second line its columns. Any other first line
 * is prose: the file is called as the system. */
static bool titled(const char *first, const char *path, char name[64])
{
    char colon = 0;

    if (sscanf(first, "# %63[A-Za-z0-9_]%c", name, &colon) == 2 && colon == ':')
        return true;
    const char *stem = strrchr(path, '/');
    snprintf(name, 64, "%.*s", (int)strcspn(stem + 1, "."), stem + 1);
    return false;
}

enum verdict { PASSED, FAILED, TO_COME };

static enum verdict report(const char *name, const vector_system *s, bool known, const result *sum)
{
    if (!s) {
        printf("%s %u - - no reader%s\n", name, sum->rows, known ? "" : ": unknown system");
        return known ? TO_COME : FAILED;
    }
    const bool good = sum->rows && !sum->bad;
    printf("%s %u %.5Lg %.5Lg %s\n", name, sum->rows, sum->error, sum->bound,
           good        ? "ok"
           : sum->rows ? "FAIL"
                       : "FAIL: no rows");
    return good ? PASSED : FAILED;
}

static bool exists(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    FILE *file = fopen(path, "r");
    if (file)
        fclose(file);
    return file != NULL;
}

static enum verdict check_file(const char *folder, const char *path, const char *known)
{
    FILE *file = fopen(path, "r");
    char *first = NULL, *second = NULL, name[64];
    size_t size = 0, size2 = 0;
    unsigned number = 0;
    enum verdict verdict = FAILED;

    if (!file || !next_line(file, &first, &size, &number) || *first != '#')
        printf("%s:1: the first line does not say what the file is ('# name: ..')\n", path);
    else if (titled(first, path, name) && !next_line(file, &second, &size2, &number))
        printf("%s:2: no column names\n", path);
    else {
        const vector_system *s = find(name);
        row names = { .error = 0, .bound = 1, .folder = folder };
        result sum = { .error = 0, .bound = 1 };

        if (name_columns(&names, s, second, path)) {
            read_rows(file, number, s, path, &names, &sum);
            verdict = report(name, s, exists(known, name), &sum);
        }
    }
    free(first);
    free(second);
    if (file)
        fclose(file);
    return verdict;
}

static int is_csv(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');
    return dot && strcmp(dot, ".csv") == 0;
}

static int list_systems(void)
{
    for (unsigned k = 0; k < sizeof tables / sizeof tables[0]; k++)
        for (const vector_system *s = tables[k]; s->name; s++)
            printf("%s (%s): %s\n", s->name, s->columns, s->bound);
    return 0;
}

int main(int argc, char **argv)
{
    struct dirent **entry;
    unsigned count[3] = { 0 };

    if (argc == 2 && strcmp(argv[1], "--list") == 0)
        return list_systems();
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: vectors FOLDER [KNOWN] | --list\n");
        return 64;
    }
    const int files = scandir(argv[1], &entry, is_csv, alphasort);
    if (files <= 0) {
        fprintf(stderr, "vectors: %s: %s\n", argv[1], files < 0 ? strerror(errno) : "no CSV file");
        return 66;
    }
    for (int k = 0; k < files; k++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", argv[1], entry[k]->d_name);
        count[check_file(argv[1], path, argc == 3 ? argv[2] : argv[1])]++;
        free(entry[k]);
    }
    free(entry);
    printf("%s: %u systems without a reader yet\n", CHECK_NUM, count[TO_COME]);
    printf("%u passed, %u failed\n", count[PASSED], count[FAILED]);
    return count[FAILED] ? 1 : 0;
}
