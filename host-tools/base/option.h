/* host-tools/base/option.h -- tables of options: what a call takes, as data that outlives the run
 * SPDX-License-Identifier: MIT
 *
 * A table is `static const` and ends with { 0 }. It holds offsets into a struct, so it can be read
 * without running anything: the command line, JSON, help, man pages and completions are made of it.
 *
 *     typedef struct { const char *file; double tol; } flatten_options;
 *
 *     static const option rows[] = {
 *         { "tol", OPTION_NUMBER(flatten_options, tol), .least = 1e-6, .most = 1000, .unit = "mm",
 *           .standard = "0.01", .help = "largest distance of a chord from its curve" },
 *         { "file", OPTION_WORD(flatten_options, file), .value = "FILE", .standard = "-" },
 *         { 0 }
 *     };
 */
#ifndef LOFT_OPTION_H
#define LOFT_OPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum option_kind {
    OPTION_END,
    OPTION_IS_FLAG,
    OPTION_IS_NUMBER,
    OPTION_IS_MAYBE,            /* a number that may be omitted: 0 then */
    OPTION_IS_INTEGER,
    OPTION_IS_TEXT,
    OPTION_IS_FILE,
    OPTION_IS_FOLDER,
    OPTION_IS_CHOICE,           /* the index of a word of `choices` */
    OPTION_IS_LIST,
    OPTION_IS_PARSED,
    OPTION_IS_WORD,             /* no option, but a word after the options */
    OPTION_IS_WORDS,            /* all others */
    OPTION_IS_GROUP,            /* the table of a struct within the struct */
    OPTION_IS_HEADING,          /* of the rows below it, in the help */
    OPTION_IS_EXCLUDES,
    OPTION_IS_NEEDS
};

/* A list of numbers: "0,0.5,1", or the option repeated. */
#define OPTION_LIST_MAX 256
typedef struct {
    double value[OPTION_LIST_MAX];
    size_t count;
} option_list;

typedef struct {
    const char *const *word;
    size_t count;
} option_words;

typedef struct option_row option;    /* <getopt.h> has a struct of the shorter name */
struct option_row {
    const char *name;           /* without the dashes */
    enum option_kind kind;
    size_t offset;
    double least, most;         /* of numbers; of WORDS: how many */
    const char *unit;           /* "mm/s": may be written 20, 20mm/s or 1200mm/min */
    const char *value;          /* its name in the help; NULL: the choices, or the unit */
    const char *choices;        /* "host|chip"; of TEXT and WORD too */
    const char *standard;       /* the default, as a user would write it; NULL: none */
    double unset;               /* a number, or the index of a CHOICE, without a default */
    const char *counts;         /* how many numbers a LIST has: "1|2"; "2n": pairs; NULL: any */
    bool (*parse)(const char *text, void *out);     /* PARSED; false: see `remedy` */
    const char *remedy;         /* what to give instead, if that is more than the row says */
    const option *group;
    const char *when, *what;    /* of rules */
    const char *help;           /* one line, without the default if that is its end */
};

/* Kind and offset of a row; a member of another type does not compile. */
#define OPTION_MEMBER(s, m, type) (offsetof(s, m) + 0 * sizeof(&((s *)0)->m == (type *)0))
#define OPTION_FLAG(s, m)    OPTION_IS_FLAG, OPTION_MEMBER(s, m, bool)
#define OPTION_NUMBER(s, m)  OPTION_IS_NUMBER, OPTION_MEMBER(s, m, double)
#define OPTION_MAYBE(s, m)   OPTION_IS_MAYBE, OPTION_MEMBER(s, m, double)
#define OPTION_INTEGER(s, m) OPTION_IS_INTEGER, OPTION_MEMBER(s, m, unsigned)
#define OPTION_TEXT(s, m)    OPTION_IS_TEXT, OPTION_MEMBER(s, m, const char *)
#define OPTION_FILE(s, m)    OPTION_IS_FILE, OPTION_MEMBER(s, m, const char *)
#define OPTION_FOLDER(s, m)  OPTION_IS_FOLDER, OPTION_MEMBER(s, m, const char *)
#define OPTION_LIST(s, m)    OPTION_IS_LIST, OPTION_MEMBER(s, m, option_list)
#define OPTION_WORD(s, m)    OPTION_IS_WORD, OPTION_MEMBER(s, m, const char *)
#define OPTION_WORDS(s, m)   OPTION_IS_WORDS, OPTION_MEMBER(s, m, option_words)
#define OPTION_CHOICE(s, m) /* an int or an enum */                                                \
    OPTION_IS_CHOICE, offsetof(s, m) + 0 * sizeof(char[sizeof(((s *)0)->m) == sizeof(int) ? 1 : -1])
#define OPTION_PARSED(s, m)  OPTION_IS_PARSED, offsetof(s, m)
#define OPTION_GROUP(s, m, rows) { #m, OPTION_IS_GROUP, offsetof(s, m), .group = rows }

/* What the rows below it are for, up to the next one: "the page" */
#define OPTION_HEADING(text) { NULL, OPTION_IS_HEADING, .help = text }

/* Rules. A condition is one or more terms with `|` between, each one or more with `&` between:
 * `name` is true if the option was given, and `name=value` if it has that value, by default too.
 * "" is true.
 *
 *     OPTION_EXCLUDES("record", "trim|trim-uv", "it draws whole surfaces")
 *     OPTION_NEEDS("", "port|dry-run", "name the machine's port, or plan with --dry-run")
 */
#define OPTION_EXCLUDES(one, other, why)                                                           \
    { NULL, OPTION_IS_EXCLUDES, .when = one, .what = other, .help = why }
#define OPTION_NEEDS(one, other, why)                                                              \
    { NULL, OPTION_IS_NEEDS, .when = one, .what = other, .help = why }

/* No words after the options; `why` is the remedy. */
#define OPTION_NO_WORDS(why) { "words", OPTION_IS_WORDS, 0, .most = 0, .remedy = why }

/* All rows of a table and its groups, in order, with offsets in the whole struct. */
#define OPTIONS_MOST 128
typedef struct {
    const option *row;
    size_t offset;
} option_at;
size_t option_all(const option rows[], option_at all[OPTIONS_MOST]);

bool option_is_named(const option *o);      /* --name, neither a word nor a rule */
bool option_is_word(const option *o);

/* The name of its value: "MM"; "" of a FLAG. */
const char *option_value(const option *o, char out[80]);

/* The help with the default behind it, "(0.01)", unless it says it itself. */
const char *option_help(const option *o, char out[400]);

/* The options of a table, or its rules, as objects of JSON with commas between: all that they say.
 */
void option_put_json(FILE *out, const option rows[], bool rules);

/* `, "name": "text"`, or nothing without a text. */
void option_put_member(FILE *out, const char *name, const char *text);

/* What is wrong with what was given. The names are stable: option.unknown, .value (none is given),
 * .range (a number), .choice, .count, .form (of a PARSED), .excludes, .needs, .words, .json. */
typedef struct {
    const char *name;
    char text[1200];            /* "--tol 0: give a number from 1e-06 to 1000" */
} option_fault;

#define OPTIONS_HELP (-1)       /* --help or --help=FORM was given: text has FORM */

/* Read argv[1..] into the zeroed struct *o, in which texts stay those of argv; words are moved to
 * the end of argv. argv[0] is the command, for errors. Returns 0, OPTIONS_HELP or EX_USAGE. */
int options_read(const option rows[], int argc, char **argv, void *o, option_fault *f);

/* The same from a JSON object, {"tol": 0.02, "scale": [1, 2], "crop": true, "file": "a.svg"}; null
 * is as if it were not there. Changes the text; text and words have to stay: *o points to them. */
#define OPTION_JSON_WORDS 256
int options_read_json(const option rows[], char *text, const char *word[OPTION_JSON_WORDS], void *o,
                      option_fault *f);

/* For option_line.c and option_json.c: begin with defaults, give one option its text (NULL: a FLAG,
 * or a MAYBE without number), and end with the rules. */
typedef struct {
    option_at all[OPTIONS_MOST];
    bool given[OPTIONS_MOST];
    size_t count;
    void *o;
    const char *self;           /* the command, or NULL */
    option_fault *f;
} option_reading;
int option_begin(option_reading *r, const option rows[], void *o, option_fault *f);
int option_take(option_reading *r, size_t row, const char *text);
int option_take_words(option_reading *r, const char *const *word, size_t count);
int option_unknown(option_reading *r, const char *word);
int option_end(option_reading *r);
int option_wrong(option_reading *r, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
const char *option_see(const option_reading *r, char out[80]);      /* ": see `loft NAME --help`" */

/* The row of a name, or `count`. */
size_t option_row_named(const option_reading *r, const char *name, size_t length);

/* Read the number at the start of `text`, and find its end. Returns false if there is none, or if
 * it is out of bounds. */
bool option_number_at(const char *text, double least, double most, double *out, char **end);

#define OPTION_SHOWN 300        /* letters of a word of the user, in a fault */

#endif
