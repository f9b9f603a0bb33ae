/* tests/tools/test_option.c -- tables of options: of every command, and what is read by them from
 * the command line and from JSON
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#include "check.h"
#include "command_list.h"

/* The table of a command, as it is read. */
typedef struct {
    const command *c;
    option whole[3];
    option_at all[OPTIONS_MOST];
    size_t count;
} table;

static table table_of(const command *c)
{
    table t = { .c = c };

    command_options(c, t.whole);
    t.count = option_all(t.whole, t.all);
    return t;
}

static size_t named(const table *t, const char *name, size_t length)
{
    size_t found = 0;

    for (size_t i = 0; i < t->count; i++) {
        const char *other = t->all[i].row->name;
        found += other && strlen(other) == length && strncmp(other, name, length) == 0;
    }
    return found;
}

static bool is_of(const char *choices, const char *word, size_t length)
{
    for (;; choices++) {
        const size_t size = strcspn(choices, "|");
        if (size == length && strncmp(choices, word, size) == 0)
            return true;
        choices += size;
        if (*choices == '\0')
            return false;
    }
}

static void check_row(const table *t, const option *o)
{
    const size_t end = o->help ? strlen(o->help) : 0;
    char value[80];

    CHECK(o->name != NULL && named(t, o->name, strlen(o->name)) == 1);
    if (option_is_named(o)) {
        CHECK(end > 0 && o->help[end - 1] != '.');
        CHECK(o->kind == OPTION_IS_FLAG || option_value(o, value)[0] != '\0');
    }
    if (o->kind == OPTION_IS_NUMBER || o->kind == OPTION_IS_MAYBE || o->kind == OPTION_IS_INTEGER ||
        o->kind == OPTION_IS_LIST)
        CHECK(o->least < o->most);
    if (o->kind == OPTION_IS_CHOICE)
        CHECK(o->choices != NULL && (o->standard != NULL || o->unset < 0));
    if (o->kind == OPTION_IS_PARSED)
        CHECK(o->parse != NULL && (o->choices != NULL || o->remedy != NULL));
}

/* Every name in it exists, and every value is one of its choice. */
static void check_terms(const table *t, const char *terms)
{
    for (; *terms; terms += *terms != '\0') {
        const size_t length = strcspn(terms, "|&"), size = strcspn(terms, "=|&");
        CHECK(named(t, terms, size) == 1);
        for (size_t i = 0; i < t->count && size < length; i++) {
            const option *o = t->all[i].row;
            if (o->name == NULL || strlen(o->name) != size || strncmp(o->name, terms, size) != 0)
                continue;
            CHECK(o->kind == OPTION_IS_CHOICE || o->kind == OPTION_IS_WORD ||
                  (o->kind >= OPTION_IS_TEXT && o->kind <= OPTION_IS_FOLDER));
            CHECK(o->choices == NULL || is_of(o->choices, terms + size + 1, length - size - 1));
        }
        terms += length;
    }
}

/* Names are unique, help ends without a dot, rules name what exists, defaults are allowed. */
static void every_table_is_sound(arb *a)
{
    (void)a;
    for (size_t k = 0; k < commands_count; k++) {
        const table t = table_of(commands[k]);
        option_reading r;
        option_fault f;
        CHECK(t.count < OPTIONS_MOST);
        for (size_t i = 0; i < t.count; i++) {
            const option *o = t.all[i].row;
            if (o->kind == OPTION_IS_HEADING)
                CHECK(o->help != NULL && *o->help != '\0');
            if (o->kind != OPTION_IS_EXCLUDES && o->kind != OPTION_IS_NEEDS) {
                if (o->kind != OPTION_IS_HEADING)
                    check_row(&t, o);
                continue;
            }
            check_terms(&t, o->when);
            check_terms(&t, o->what);
            CHECK((*o->what != '\0' && *o->when != '\0') || o->help != NULL);
        }
        char *o = calloc(1, command_size(t.c));
        CHECK(option_begin(&r, t.whole, o, &f) == 0);
        free(o);
    }
}


/* More options than a screen holds are in groups. */
static void long_tables_have_headings(arb *a)
{
    (void)a;
    for (size_t k = 0; k < commands_count; k++) {
        const table t = table_of(commands[k]);
        size_t names = 0, in_group = 0, most = 0;
        bool headed = false;
        for (size_t i = 0; i < t.count; i++) {
            const option *o = t.all[i].row;
            if (o->kind == OPTION_IS_HEADING) {
                headed   = headed || names == 0;
                in_group = 0;
            }
            names += option_is_named(o);
            in_group += option_is_named(o);
            most = in_group > most ? in_group : most;
        }
        CHECK(names <= 40 || (headed && most <= 12));
    }
}


// Two readers
// -----------

typedef struct {
    char *o;
    int code;
    option_fault f;
    char text[4000];
    const char *word[OPTION_JSON_WORDS];
} outcome;

/* Read `--name=value` of each, or the same as JSON. */
static void read_line(const table *t, const char *line[], int count, outcome *x)
{
    char *argv[40], text[40][600];

    for (int i = 0; i < count; i++) {
        snprintf(text[i], sizeof text[i], "%s", line[i]);
        argv[i] = text[i];
    }
    argv[count] = NULL;
    x->o        = calloc(1, command_size(t->c));
    x->code     = options_read(t->whole, count, argv, x->o, &x->f);
}

static void read_object(const table *t, outcome *x)
{
    x->o    = calloc(1, command_size(t->c));
    x->code = options_read_json(t->whole, x->text, x->word, x->o, &x->f);
}

static bool same_member(const option_at *at, const char *x, const char *y)
{
    static const size_t sizes[] = { [OPTION_IS_FLAG] = sizeof(bool),
                                    [OPTION_IS_NUMBER] = sizeof(double),
                                    [OPTION_IS_MAYBE] = sizeof(double),
                                    [OPTION_IS_INTEGER] = sizeof(unsigned),
                                    [OPTION_IS_CHOICE] = sizeof(int) };
    const enum option_kind kind = at->row->kind;

    x += at->offset;
    y += at->offset;
    if (kind == OPTION_IS_LIST) {
        const option_list *a = (const void *)x, *b = (const void *)y;
        return a->count == b->count && memcmp(a->value, b->value, a->count * sizeof(double)) == 0;
    }
    if (kind > OPTION_IS_CHOICE || sizes[kind] == 0)
        return true;
    return memcmp(x, y, sizes[kind]) == 0;
}

/* A value that may be right. */
static void draw_value(arb *a, const option *o, char out[100])
{
    static const char *const words[] = { "0",   "1",    "10",  "-1",     "x",      "2.5",
                                         "1,2", "9e99", "a b", "corner", "20mm/s", "hatch" };
    const char *word = words[arb_below(a, sizeof words / sizeof *words)];

    if (o->choices != NULL && arb_below(a, 4) > 0) {
        const char *c = o->choices;
        for (uint32_t n = arb_below(a, 3); n > 0 && strchr(c, '|'); n--)
            c = strchr(c, '|') + 1;
        snprintf(out, 100, "%.*s", (int)strcspn(c, "|"), c);
    } else if (o->least < o->most && arb_below(a, 2)) {
        snprintf(out, 100, "%.9g", arb_below(a, 2) ? o->least : o->most);
    } else {
        snprintf(out, 100, "%s", o->standard && arb_below(a, 2) ? o->standard : word);
    }
}

/* A few options of a command, and sometimes words and a wrong name. */
static void both_readers_agree(arb *a)
{
    const table t = table_of(commands[arb_below(a, (uint32_t)commands_count)]);
    static char line[40][200];
    const char *argv[40] = { t.c->name };
    outcome x = { .code = 0 }, y = { .code = 0 };
    int count = 1;
    size_t n  = (size_t)snprintf(y.text, sizeof y.text, "{");

    for (uint32_t k = arb_below(a, 6); k > 0; k--) {
        const option *o = t.all[arb_below(a, (uint32_t)t.count)].row;
        char value[100];
        if (!option_is_named(o) || strcmp(o->name, "help") == 0)
            continue;
        draw_value(a, o, value);
        bool before = false;
        for (int i = 1; i < count; i++)
            before = before || strncmp(argv[i] + 2, o->name, strcspn(argv[i] + 2, "=")) == 0;
        if (before)
            continue;
        if (o->kind == OPTION_IS_FLAG)
            snprintf(line[count], sizeof line[count], "--%s", o->name);
        else
            snprintf(line[count], sizeof line[count], "--%s=%s", o->name, value);
        argv[count] = line[count];
        n += (size_t)snprintf(y.text + n, sizeof y.text - n,
                              o->kind == OPTION_IS_FLAG ? "%s\"%s\": true" : "%s\"%s\" : \"%s\"",
                              count > 1 ? " , " : "", o->name, value);
        count++;
    }
    snprintf(y.text + n, sizeof y.text - n, "}");
    read_line(&t, argv, count, &x);
    read_object(&t, &y);
    CHECK(x.code == y.code);
    CHECK(x.code == 0 || strcmp(x.f.name, y.f.name) == 0);
    for (size_t i = 0; i < t.count && x.code == 0; i++)
        CHECK(same_member(&t.all[i], x.o, y.o));
    free(x.o);
    free(y.o);
}


// Faults
// ------

typedef struct {
    bool flag, other;
    double number, speed, maybe;
    unsigned integer;
    const char *text, *file;
    int choice;
    option_list list;
    option_words words;
} sample;

static const option sample_rows[] = {
    { "flag", OPTION_FLAG(sample, flag), .help = "a" },
    { "other", OPTION_FLAG(sample, other), .help = "b" },
    { "number", OPTION_NUMBER(sample, number), .least = 0, .most = 10, .unit = "mm",
      .standard = "2", .help = "c" },
    { "speed", OPTION_NUMBER(sample, speed), .least = 1, .most = 100, .unit = "mm/s", .unset = -1,
      .help = "d" },
    { "maybe", OPTION_MAYBE(sample, maybe), .least = 1, .most = 9, .unset = -1, .value = "DEG",
      .help = "e" },
    { "integer", OPTION_INTEGER(sample, integer), .least = 1, .most = 9, .value = "N",
      .help = "f" },
    { "text", OPTION_TEXT(sample, text), .value = "TEXT", .help = "g" },
    { "choice", OPTION_CHOICE(sample, choice), .choices = "host|chip", .standard = "host",
      .help = "h" },
    { "list", OPTION_LIST(sample, list), .least = 0, .most = 9, .counts = "1|2n", .value = "X,Y,..",
      .standard = "7", .help = "i" },
    { "file", OPTION_WORD(sample, file), .value = "FILE", .standard = "-" },
    { "words", OPTION_WORDS(sample, words), .most = 2, .value = "WORD" },
    OPTION_EXCLUDES("flag", "other|choice=chip", "they differ"),
    OPTION_NEEDS("choice=chip", "text", "it has a name"),
    OPTION_EXCLUDES("other&integer", "text=b", NULL),
    { 0 }
};

static const struct {
    const char *line[5], *json, *fault;
} cases[] = {
    { { "--number=3" }, "{\"number\": 3}", NULL },
    { { "--number", "11" }, "{\"number\": 11}", "option.range" },
    { { "--number=" }, "{\"number\": \"\"}", "option.range" },
    { { "--number" }, "{\"number\": true}", "option.value" },
    { { "--speed=60mm/min" }, "{\"speed\": \"60mm/min\"}", NULL },
    { { "--speed=60kg" }, "{\"speed\": \"60kg\"}", "option.range" },
    { { "--maybe" }, "{\"maybe\": true}", NULL },
    { { "--maybe", "3" }, "{\"maybe\": 3}", NULL },
    { { "--maybe=33" }, "{\"maybe\": 33}", "option.range" },
    { { "--integer=2.5" }, "{\"integer\": 2.5}", "option.range" },
    { { "--choice=neither" }, "{\"choice\": \"neither\"}", "option.choice" },
    { { "--choice=chip" }, "{\"choice\": \"chip\"}", "option.needs" },
    { { "--choice=chip", "--text=a" }, "{\"choice\": \"chip\", \"text\": \"a\"}", NULL },
    { { "--flag", "--other" }, "{\"other\": true, \"flag\": true}", "option.excludes" },
    { { "--flag" }, "{\"other\": false, \"flag\": true}", NULL },
    { { "--flag", "--choice=chip", "--text=a" },
      "{\"choice\": \"chip\", \"flag\": true, \"text\": \"a\"}",
      "option.excludes" },
    { { "--integer=2", "--other", "--text=b" },
      "{\"text\": \"b\", \"other\": true, \"integer\": 2}",
      "option.excludes" },
    { { "--integer=2", "--other", "--text=c" },
      "{\"text\": \"c\", \"other\": true, \"integer\": 2}",
      NULL },
    { { "--integer=2", "--text=b" }, "{\"text\": \"b\", \"integer\": 2}", NULL },
    { { "--list=1,2,3" }, "{\"list\": [1, 2, 3]}", "option.count" },
    { { "--list=1,2", "--list=3,4" }, "{\"list\": [1 , 2,3,4]}", NULL },
    { { "--list=1,x" }, "{\"list\": [1, \"x\"]}", "option.range" },
    { { "--nought" }, "{\"nought\": 1}", "option.unknown" },
    { { "a", "b", "c" }, "{\"file\": \"a\", \"words\": [\"b\", \"c\"]}", NULL },
    { { "a", "b", "c", "d" },
      "{\"file\": \"a\", \"words\": [\"b\", \"c\", \"d\"]}",
      "option.words" },
    { { "-5", "--flag", "b" }, "{\"file\": \"-5\", \"words\": [\"b\"], \"flag\": true}", NULL },
    { { "--text=\xc3\xa9\"\xf0\x9f\x98\x80" }, "{\"text\": \"\\u00e9\\\"\\ud83d\\ude00\"}", NULL },
    { { NULL }, "{\"number\": null}", NULL },
    { { NULL }, "{}", NULL },
};

static const table sample_table = {
    .whole = { { "sample", OPTION_IS_GROUP, 0, .group = sample_rows }, { .kind = OPTION_END } }
};

static bool same_text(const char *x, const char *y)
{
    return x == NULL || y == NULL ? x == y : strcmp(x, y) == 0;
}

static bool same_sample(const sample *x, const sample *y)
{
    bool same = x->flag == y->flag && x->other == y->other && x->choice == y->choice &&
                x->integer == y->integer && same_text(x->text, y->text) &&
                same_text(x->file, y->file) && x->words.count == y->words.count;

    for (size_t i = 0; i < x->words.count && same; i++)
        same = same_text(x->words.word[i], y->words.word[i]);
    return same && memcmp(&x->number, &y->number, 3 * sizeof x->number) == 0 &&
           x->list.count == y->list.count &&
           memcmp(x->list.value, y->list.value, x->list.count * sizeof(double)) == 0;
}

/* The same faults under the same names, from the command line and from JSON. */
static void faults_have_names(arb *a)
{
    static const command self = { .name = "sample", .size = sizeof(sample) };
    table t                   = sample_table;

    (void)a;
    t.c     = &self;
    t.count = option_all(t.whole, t.all);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char *argv[7] = { "sample" }, text[5][60];
        outcome x = { .code = 0 }, y = { .code = 0 };
        int count = 1;
        for (int i = 0; i < 5 && cases[k].line[i] != NULL; i++) {
            snprintf(text[i], sizeof text[i], "%s", cases[k].line[i]);
            argv[count++] = text[i];
        }
        x.o    = calloc(1, t.c->size);
        x.code = options_read(t.whole, count, argv, x.o, &x.f);
        snprintf(y.text, sizeof y.text, "%s", cases[k].json);
        read_object(&t, &y);
        CHECK(same_text(x.f.name, cases[k].fault) && same_text(y.f.name, cases[k].fault));
        CHECK(x.code == (cases[k].fault ? EX_USAGE : 0) && y.code == x.code);
        if (cases[k].fault == NULL)
            CHECK(same_sample((const void *)x.o, (const void *)y.o));
        free(x.o);
        free(y.o);
    }
}

/* A text that is no object is refused, and read no farther than to its end. */
static void broken_json_is_refused(arb *a)
{
    static const char sound[] = "{\"text\": \"a\\u00e9\\n\", \"list\": [1,2], \"flag\": true, "
                                "\"words\": [\"x\", \"y\"], \"maybe\": null}";
    const size_t cut = arb_below(a, (uint32_t)sizeof sound - 1);
    sample o         = { .flag = false };
    const char *word[OPTION_JSON_WORDS];
    option_fault f;

    char *text = malloc(cut + 1);
    memcpy(text, sound, cut);
    text[cut] = '\0';
    CHECK(options_read_json(sample_rows, text, word, &o, &f) == EX_USAGE);
    CHECK(strcmp(f.name, "option.json") == 0 || strcmp(f.name, "option.unknown") == 0);
    free(text);
    text = malloc(sizeof sound);
    memcpy(text, sound, sizeof sound);
    text[cut] = (char)(1 + arb_below(a, 255));      /* any character: no fault of memory */
    (void)options_read_json(sample_rows, text, word, memset(&o, 0, sizeof o), &f);
    free(text);
}

int main(void)
{
    PROPERTY(every_table_is_sound, 1);
    PROPERTY(long_tables_have_headings, 1);
    PROPERTY(both_readers_agree, 3000);
    PROPERTY(faults_have_names, 1);
    PROPERTY(broken_json_is_refused, 2000);
    return check_failures();
}
