/* host-tools/gcode/gcode_flow.c -- subroutines, branches and loops of G-code: O-words, M98, M99
 * SPDX-License-Identifier: MIT
 *
 * LinuxCNC's documentation: G-code, O Codes. Lines before the first O-word are run as they come.
 * From there on the text is kept, and run when it is complete: a loop goes back, and a subroutine
 * may stand behind its call, or in a file of its name beside the program. All lines with an O-word
 * are listed once, each with the next one of its label. So a jump never reads the text.
 *
 * Calls and blocks lie on stacks of fixed size, and the lines that are run are counted.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"     /* memory_grow */
#include "base/source.h"     /* source_read */
#include "gcode/gcode_number.h"
#include "gcode/gcode_state.h"

#define CALLS   10              /* in each other, as in LinuxCNC */
#define BLOCKS  256
#define LOCALS  30              /* #1 .. #30 */
#define UNITS   64              /* files that are called */
#define LINES   100000000u      /* that are run */
#define QUIET   1000000u        /* without an event */
#define TEXT    (256u << 20)    /* bytes behind the first O-word, or of a file */

enum word {
    ENDSUB,
    ENDIF,
    ENDWHILE,
    ENDREPEAT,
    ELSEIF,
    ELSE,
    SUB,
    CALL,
    DO,
    WHILE,
    IF,
    REPEAT,
    BREAK,
    CONTINUE,
    RETURN,
    NAME,               /* nothing behind the label: a program, or a subroutine for M98 */
    WORDS
};

static const char *const words[WORDS] = { "ENDSUB", "ENDIF",  "ENDWHILE", "ENDREPEAT",
                                          "ELSEIF", "ELSE",   "SUB",      "CALL",
                                          "DO",     "WHILE",  "IF",       "REPEAT",
                                          "BREAK",  "CONTINUE", "RETURN", "" };

/* A line with an O-word. */
typedef struct {
    size_t at, behind;          /* in the text: its start, and that of the next line */
    uint64_t label;             /* a hash */
    unsigned line;
    unsigned next;              /* the next line of this label, from 1; 0: there is none */
    enum word word;
} steer;

/* The text that is run: the rest of the program, or a file. */
typedef struct {
    char *file;                 /* NULL: the program's own */
    char *text;
    size_t size;
    unsigned first;             /* the number of its first line */
    steer *steer;
    unsigned count, room;
} unit;

typedef struct {
    unsigned unit, line;
    size_t at;
    unsigned next;              /* the first O-word here or behind */
} place;

typedef struct {
    place back, begin;
    bool plain;                 /* by M98: #1 to #30 stay those of the caller */
    double times;               /* of M98 */
    double saved[LOCALS];
    unsigned blocks;            /* below its own */
} call;

typedef struct {
    uint64_t label;
    enum word word;             /* IF, WHILE, DO, REPEAT */
    place begin;                /* its line */
    double left;                /* of REPEAT */
} block;

struct gcode_flow {
    unit unit[UNITS];
    unsigned units;
    size_t room;                /* of the text of unit 0 */
    place at;
    call call[CALLS];
    unsigned calls;
    block block[BLOCKS];
    unsigned blocks;
    unsigned lines;
};


// Reading
// -------

typedef struct {
    uint64_t label;
    enum word word;             /* WORDS: another one */
    char text[GCODE_NAME_MAX];  /* the label */
    bool computed;
} o_word;

static uint64_t hash(const char *text)
{
    uint64_t h = 14695981039346656037u;         /* FNV-1a */

    for (; *text != '\0'; text++)
        h = (h ^ (unsigned char)*text) * 1099511628211u;
    return h;
}

static void read_digits_of(gcode_scanner *s, char *out, size_t room)
{
    size_t n = 0;

    for (char c = gcode_peek(s); c >= '0' && c <= '9'; c = gcode_peek(s)) {
        if (n + 1 < room && (n > 0 || c != '0'))
            out[n++] = c;
        s->at++;
    }
    if (n == 0)
        out[n++] = '0';
    out[n] = '\0';
}

static void read_label(gcode_scanner *s, o_word *out, bool runs)
{
    const char c = gcode_peek(s);

    out->text[0]  = '\0';
    out->computed = c == '#' || c == '[';
    if (c == '<')
        gcode_read_label(s, out->text);
    else if (c >= '0' && c <= '9')
        read_digits_of(s, out->text, sizeof out->text);
    else if (out->computed && runs)
        snprintf(out->text, sizeof out->text, "%.0f", gcode_read_value(s));
    else
        gcode_scan_fail(s, "gcode.label-missing", "O without a label",
                        "write as O100 sub, or O<name> sub");
    out->label = hash(out->text);
}

/* Up to and with O, behind / and N. */
static bool take_o(gcode_scanner *s)
{
    char digits[16];

    (void)gcode_take(s, '/');
    if (gcode_take(s, 'N'))
        read_digits_of(s, digits, sizeof digits);
    return gcode_take(s, 'O');
}

/* `runs`: a label may be computed, and errors are reported. */
static void read_o_word(gcode_scanner *s, o_word *out, bool runs)
{
    int n = 0;

    read_label(s, out, runs);
    while (n < NAME && !gcode_take_word(s, words[n]))
        n++;
    const char c = gcode_peek(s);
    out->word = n < NAME || c == '\0' || c == ';' || c == '(' ? (enum word)n : WORDS;
}

bool gcode_flow_steers(gcode_program *g, const char *text, size_t length)
{
    gcode_block quiet = { .file = NULL };
    gcode_scanner s   = { .b = &quiet, .at = text, .end = text + length };
    o_word o;

    if (g->printer || (g->b.skip && gcode_peek(&s) == '/') || !take_o(&s))
        return false;
    s.code = -1;                /* nothing is reported here */
    read_o_word(&s, &o, false);
    return o.word != NAME || o.text[0] == '<' || o.text[0] == '\0';
}


// Units
// -----

static void add_steer(unit *u, const steer *new)
{
    if (u->count == u->room) {
        u->room  = u->room ? 2 * u->room : 64;
        u->steer = memory_grow(u->steer, u->room * sizeof *u->steer);
    }
    u->steer[u->count++] = *new;
}

/* From the last line to the first: a table of the labels gives the next one. */
static void join_labels(unit *u)
{
    unsigned size = 16;

    while (size < 2 * u->count)
        size *= 2;
    unsigned *last = memory_grow(NULL, size * sizeof *last);
    memset(last, 0, size * sizeof *last);
    for (unsigned n = u->count; n > 0; n--) {
        steer *s    = &u->steer[n - 1];
        unsigned at = (unsigned)(s->label >> 32) & (size - 1);
        while (last[at] != 0 && u->steer[last[at] - 1].label != s->label)
            at = (at + 1) & (size - 1);
        s->next = last[at];
        if (s->word != CALL && s->word != BREAK && s->word != CONTINUE && s->word != RETURN)
            last[at] = n;
    }
    free(last);
}

static void list_steers(gcode_program *g, unit *u)
{
    unsigned line = u->first;

    for (size_t at = 0; at < u->size; line++) {
        const char *text = u->text + at, *end = gcode_line_end(text, u->text + u->size);
        gcode_block none = { .file = NULL };
        gcode_scanner s  = { .b = &none, .at = text, .end = end };
        const size_t behind = (size_t)(gcode_next_line(end, u->text + u->size) - u->text);
        if (!(g->b.skip && gcode_peek(&s) == '/') && take_o(&s)) {
            o_word o;
            s.code = -1;
            read_o_word(&s, &o, false);
            add_steer(u, &(steer){ .at = at,
                                   .behind = behind,
                                   .label = o.computed ? 0 : o.label,
                                   .line = line,
                                   .word = o.computed ? CALL : o.word });
        }
        at = behind;
    }
    join_labels(u);
}

static unit *unit_at(const gcode_program *g) { return &g->flow->unit[g->flow->at.unit]; }

void gcode_flow_open(gcode_program *g, unsigned line)
{
    g->flow = memory_grow(NULL, sizeof *g->flow);
    memset(g->flow, 0, sizeof *g->flow);
    g->flow->units = 1;
    g->flow->unit[0].first = line;
}

int gcode_flow_keep(gcode_program *g, const char *text, size_t size)
{
    struct gcode_flow *f = g->flow;
    unit *u = &f->unit[0];

    if (size == 0)
        return 0;
    if (size > TEXT - u->size)
        return gcode_fails(g, "gcode.flow-too-large", "more than 256 MB behind the first O-word",
                           "split the program");
    if (f->room - u->size < size) {
        f->room = 2 * (u->size + size);
        u->text = memory_grow(u->text, f->room);
    }
    memcpy(u->text + u->size, text, size);
    u->size += size;
    return 0;
}

void gcode_flow_free(gcode_program *g)
{
    for (unsigned i = 0; g->flow != NULL && i < g->flow->units; i++) {
        free(g->flow->unit[i].file);
        free(g->flow->unit[i].text);
        free(g->flow->unit[i].steer);
    }
    free(g->flow);
    g->flow = NULL;
}

/* `stem`.ngc beside the program, if there is such a file. */
static bool load_file(gcode_program *g, const char *stem, int *code)
{
    const char *slash = strrchr(g->file, '/');
    const int folder  = slash ? (int)(slash - g->file + 1) : 0;
    struct gcode_flow *f = g->flow;
    struct stat is;
    char *name = memory_grow(NULL, (size_t)folder + strlen(stem) + 5);

    sprintf(name, "%.*s%s.ngc", folder, g->file, stem);
    if (strchr(stem, '/') != NULL || *stem == '.' || stat(name, &is) != 0 || !S_ISREG(is.st_mode)) {
        free(name);
        return false;
    }
    unit *u = &f->unit[f->units];
    *code = f->units == UNITS
                ? gcode_fails(g, "gcode.files-called", "more than 63 files are called", "join some")
            : is.st_size > TEXT
                ? gcode_fails(g, "gcode.file-too-large",
                              "the file that is called has more than 256 MB", "split it")
                : 0;
    if (*code == 0)
        u->text = source_read(g->b.host, name, &u->size, code);
    if (*code != 0) {
        free(name);
        return false;
    }
    u->file  = name;
    u->first = 1;
    f->units++;
    list_steers(g, u);
    return true;
}


// Bounds
// ------

static int count_line(gcode_program *g)
{
    const unsigned most = g->most_lines ? g->most_lines : LINES;
    char what[48];

    if (++g->flow->lines > most) {
        snprintf(what, sizeof what, "more than %u lines are run", most);
        return gcode_fails(g, "gcode.lines-run", what, "look for a loop without an end");
    }
    if (++g->quiet > QUIET)
        return gcode_fails(g, "gcode.loop-endless", "a million lines are run without a motion",
                           "look for a loop without an end");
    return 0;
}

static int wrong_word(const gcode_program *g, const o_word *o, const char *name, const char *what,
                      const char *remedy)
{
    char text[2 * GCODE_NAME_MAX + 128];

    snprintf(text, sizeof text, "O%s%s%s: %s", o->text, o->word < NAME ? " " : "",
             o->word < NAME ? words[o->word] : "", what);
    return gcode_fails(g, name, text, remedy);
}


// Jumps
// -----

/* Behind an O-word, or to its line. */
static void go_behind(gcode_program *g, unsigned n)
{
    const steer *s = &unit_at(g)->steer[n];

    g->flow->at = (place){ g->flow->at.unit, s->line + 1, s->behind, n + 1 };
}

static void go_to(gcode_program *g, unsigned n)
{
    const steer *s = &unit_at(g)->steer[n];

    g->flow->at = (place){ g->flow->at.unit, s->line, s->at, n };
}

/* The next line of the label with that word behind line n; 0: none, which is reported. */
static int find_word(gcode_program *g, unsigned n, const o_word *o, enum word word, unsigned *out)
{
    const unit *u = unit_at(g);
    char what[32];
    int code = 0;

    for (unsigned at = u->steer[n].next; at != 0 && code == 0; at = u->steer[at - 1].next) {
        *out = at - 1;
        if (u->steer[at - 1].word == word)
            return 0;
        code = count_line(g);
    }
    snprintf(what, sizeof what, "it has no %s", words[word]);
    return code != 0 ? code
                     : wrong_word(g, o, "gcode.flow-no-end", what, "end it with the same label");
}


// Blocks
// ------

static unsigned base_of(const struct gcode_flow *f)
{
    return f->calls > 0 ? f->call[f->calls - 1].blocks : 0;
}

/* The innermost block of the label in this subroutine, or NULL. What is in it has ended. */
static block *find_block(gcode_program *g, uint64_t label, unsigned kinds)
{
    struct gcode_flow *f = g->flow;

    for (unsigned n = f->blocks; n > base_of(f); n--)
        if (f->block[n - 1].label == label && (kinds & 1u << f->block[n - 1].word)) {
            f->blocks = n;
            return &f->block[n - 1];
        }
    return NULL;
}

#define LOOPS (1u << WHILE | 1u << DO | 1u << REPEAT)

static int open_block(gcode_program *g, const o_word *o, enum word word, unsigned n, double left)
{
    struct gcode_flow *f = g->flow;

    if (find_block(g, o->label, 1u << word) != NULL)    /* one that was left without its end */
        f->blocks--;
    if (f->blocks == BLOCKS)
        return wrong_word(g, o, "gcode.blocks-nested", "more than 256 blocks in each other",
                          "end those before");
    const steer *s = &unit_at(g)->steer[n];
    f->block[f->blocks++] = (block){ o->label, word, { f->at.unit, s->line, s->at, n }, left };
    return 0;
}

static double read_bracket(gcode_scanner *s)
{
    if (gcode_peek(s) != '[') {
        gcode_scan_fail(s, "gcode.condition-missing", "an O-word without its condition or number",
                        "write as O1 if [#1 LT 2]");
        return 0;
    }
    return gcode_read_value(s);
}

static void end_line(gcode_scanner *s)
{
    const char c = gcode_peek(s);

    if (c != '\0' && c != ';' && c != '(')
        gcode_scan_fail(s, "gcode.label-line", "something behind the O-word",
                        "give it a line of its own");
}

static bool condition(gcode_scanner *s)
{
    const double value = read_bracket(s);

    end_line(s);
    return fabs(value) > 0;
}

/* A condition of another line, as that of elseif. */
static bool condition_at(gcode_program *g, unsigned n, int *code)
{
    const unit *u    = unit_at(g);
    const steer *at  = &u->steer[n];
    gcode_scanner s  = { .b = &g->b,
                         .at = u->text + at->at,
                         .end = gcode_line_end(u->text + at->at, u->text + u->size) };
    o_word o;

    g->b.line = at->line;
    (void)take_o(&s);
    read_o_word(&s, &o, true);
    const bool yes = condition(&s);
    *code          = s.code;
    return yes;
}

/* The first branch whose condition holds. */
static int run_if(gcode_program *g, gcode_scanner *s, const o_word *o, unsigned n)
{
    bool yes = condition(s);
    int code = s->code;

    while (code == 0 && !yes) {
        const unsigned next = unit_at(g)->steer[n].next;
        const enum word word = next ? unit_at(g)->steer[next - 1].word : IF;
        if (word != ELSEIF && word != ELSE && word != ENDIF)
            return wrong_word(g, o, "gcode.flow-no-end", "it has no ENDIF",
                              "end it with the same label");
        n = next - 1;
        if (word == ENDIF) {
            go_behind(g, n);
            return 0;
        }
        yes = word == ELSE || condition_at(g, n, &code);
        if (code == 0)
            code = count_line(g);
    }
    if (code == 0)
        code = open_block(g, o, IF, n, 0);
    go_behind(g, n);
    return code;
}

/* The branch before has ended. */
static int run_else(gcode_program *g, const o_word *o, unsigned n)
{
    if (find_block(g, o->label, 1u << IF) == NULL)
        return wrong_word(g, o, "gcode.no-if", "no IF is before it",
                          "begin it with the same label");
    g->flow->blocks--;
    const int code = o->word == ENDIF ? 0 : find_word(g, n, o, ENDIF, &n);
    go_behind(g, n);
    return code;
}

/* `while` begins a loop, or ends that of `do`. */
static int run_while(gcode_program *g, gcode_scanner *s, const o_word *o, unsigned n)
{
    const block *loop = find_block(g, o->label, LOOPS);
    const bool yes = condition(s), ends = loop != NULL && loop->word == DO;
    int code = s->code;

    if (code != 0)
        return code;
    if (ends && yes) {
        go_behind(g, loop->begin.next);
        return 0;
    }
    if (loop != NULL)
        g->flow->blocks--;
    if (yes)
        code = open_block(g, o, WHILE, n, 0);
    else if (!ends)
        code = find_word(g, n, o, ENDWHILE, &n);
    go_behind(g, n);
    return code;
}

static int run_repeat(gcode_program *g, gcode_scanner *s, const o_word *o, unsigned n)
{
    const double times = floor(read_bracket(s) + 0.5);

    end_line(s);
    int code = s->code;
    if (code == 0 && times > 0)
        code = open_block(g, o, REPEAT, n, times);
    else if (code == 0)
        code = find_word(g, n, o, ENDREPEAT, &n);
    go_behind(g, n);
    return code;
}

static int end_loop(gcode_program *g, const o_word *o, unsigned n)
{
    block *loop = find_block(g, o->label, 1u << (o->word == ENDWHILE ? WHILE : REPEAT));

    if (loop == NULL)
        return wrong_word(g, o, "gcode.no-loop", "no loop is before it",
                          "begin it with the same label");
    if (o->word == ENDWHILE) {
        go_to(g, loop->begin.next);
    } else if (--loop->left > 0) {
        go_behind(g, loop->begin.next);
    } else {
        g->flow->blocks--;
        go_behind(g, n);
    }
    return 0;
}

static int leave_loop(gcode_program *g, const o_word *o)
{
    block *loop  = find_block(g, o->label, LOOPS);
    unsigned end = 0;

    if (loop == NULL)
        return wrong_word(g, o, "gcode.no-loop-around", "no loop of this label is around it",
                          "give that of the loop");
    const int code = find_word(g, loop->begin.next, o,
                               loop->word == WHILE ? ENDWHILE
                               : loop->word == DO  ? WHILE
                                                   : ENDREPEAT,
                               &end);
    if (code != 0)
        return code;
    if (o->word == BREAK) {
        g->flow->blocks--;
        go_behind(g, end);
    } else if (loop->word == WHILE) {
        go_to(g, loop->begin.next);
    } else {
        go_to(g, end);
    }
    return 0;
}


// Subroutines
// -----------

/* A line of the label with that word, in this text, in that of the program, or another one. */
static bool find_line(gcode_program *g, uint64_t label, enum word word, place *out)
{
    struct gcode_flow *f = g->flow;

    for (unsigned i = 0; i < f->units + 1; i++) {
        const unsigned of = i == 0 ? f->at.unit : i - 1;
        const unit *u     = &f->unit[of];
        f->lines += u->count / 8;       /* which it costs */
        for (unsigned n = 0; n < u->count; n++)
            if (u->steer[n].label == label && u->steer[n].word == word) {
                *out = (place){ of, u->steer[n].line + 1, u->steer[n].behind, n + 1 };
                return true;
            }
    }
    return false;
}

/* Also in a file of its name: O<part> in part.ngc, O100 in 100.ngc or o100.ngc. */
static int find_sub(gcode_program *g, const o_word *o, enum word word, place *out)
{
    char stem[GCODE_NAME_MAX + 1], what[96];
    const size_t length = strlen(o->text);
    const bool named = o->text[0] == '<';
    int code = 0;

    if (find_line(g, o->label, word, out))
        return 0;
    snprintf(stem, sizeof stem, "%.*s", (int)(named ? length - 2 : length), o->text + named);
    for (char *at = stem; *at != '\0'; at++)
        if (*at >= 'A' && *at <= 'Z')
            *at = (char)(*at - 'A' + 'a');
    bool loaded = load_file(g, stem, &code);
    if (!loaded && code == 0 && !named) {
        snprintf(stem, sizeof stem, "o%s", o->text);
        loaded = load_file(g, stem, &code);
    }
    if (code != 0 || (loaded && find_line(g, o->label, word, out)))
        return code;
    if (find_line(g, o->label, word == SUB ? NAME : SUB, out))
        return wrong_word(g, o, "gcode.subroutine-kind",
                          word == SUB ? "it ends with M99" : "it ends with ENDSUB",
                          word == SUB ? "call it by M98 P" : "call it by O and its label");
    snprintf(what, sizeof what, "no such subroutine, and no file %.*s.ngc that holds it",
             (int)(named ? length - 2 : length), o->text + named);
    return wrong_word(g, o, "gcode.subroutine-missing", what, "give the file beside the program");
}

static int enter(gcode_program *g, const o_word *o, const call *new)
{
    struct gcode_flow *f = g->flow;

    if (f->calls == CALLS)
        return wrong_word(g, o, "gcode.calls-nested", "more than 10 subroutines in each other",
                          "call them in turn");
    f->call[f->calls]        = *new;
    f->call[f->calls].back   = f->at;
    f->call[f->calls].blocks = f->blocks;
    f->calls++;
    f->at = new->begin;
    g->all.depth++;
    return 0;
}

static int run_call(gcode_program *g, gcode_scanner *s, const o_word *o, unsigned n)
{
    double given[LOCALS] = { 0 };
    unsigned count = 0;
    call new = { .plain = false };

    while (s->code == 0 && gcode_peek(s) == '[') {
        if (count == LOCALS)
            return wrong_word(g, o, "gcode.call-numbers", "more than 30 numbers",
                              "set parameters #31 and above before");
        given[count++] = gcode_read_value(s);
    }
    end_line(s);
    int code = s->code;
    if (code == 0)
        code = find_sub(g, o, SUB, &new.begin);
    if (code != 0)
        return code;
    go_behind(g, n);
    memcpy(new.saved, g->all.number + 1, sizeof new.saved);
    code = enter(g, o, &new);
    if (code == 0)
        memcpy(g->all.number + 1, given, sizeof given);
    return code;
}

static void leave(gcode_program *g)
{
    struct gcode_flow *f = g->flow;
    const call *c        = &f->call[--f->calls];
    unsigned kept        = 0;

    f->at     = c->back;
    f->blocks = c->blocks;
    if (!c->plain)
        memcpy(g->all.number + 1, c->saved, sizeof c->saved);
    for (unsigned i = 0; i < g->all.count; i++)         /* its own names end with it */
        if (g->all.named[i].depth < g->all.depth)
            g->all.named[kept++] = g->all.named[i];
    g->all.count = kept;
    g->all.depth--;
}

static int run_return(gcode_program *g, gcode_scanner *s, const o_word *o)
{
    const struct gcode_flow *f = g->flow;
    const bool returns         = gcode_peek(s) == '[';
    const double value         = returns ? gcode_read_value(s) : 0;

    end_line(s);
    if (s->code != 0)
        return s->code;
    if (f->calls == 0 || f->call[f->calls - 1].plain)
        return wrong_word(g, o, "gcode.subroutine-end",
                          "outside of a subroutine that was called by its O-word",
                          f->calls == 0 ? "put SUB before it" : "end this one with M99");
    g->all.value    = value;
    g->all.returned = returns;
    leave(g);
    return 0;
}

int gcode_flow_m98(gcode_program *g)
{
    const double p = gcode_value(&g->b, 'P'),
                 times = gcode_has(&g->b, 'L') ? gcode_value(&g->b, 'L') : 1;

    if (!gcode_has(&g->b, 'P') || !(p >= 0 && p <= 999999999) || p > floor(p))
        return gcode_fails(g, "gcode.call-no-number", "M98 without P, the number of the subroutine",
                           "give as M98 P100");
    if (!(times >= 0 && times <= 999999999) || times > floor(times))
        return gcode_fails(g, "gcode.call-times", "M98: L is how many times",
                           "give a whole number");
    if (g->b.gs > 0 || g->b.ms > 1 ||
        (g->b.has & ~(GCODE_BIT('N') | GCODE_BIT('P') | GCODE_BIT('L'))) != 0)
        return gcode_fails(g, "gcode.call-line", "M98 with other words than P and L",
                           "split the line");
    g->wants       = GCODE_CALLS;
    g->wants_p     = p;
    g->wants_times = times;
    return 0;
}

/* What M98 or M99 of the line wants. */
static int obey(gcode_program *g)
{
    struct gcode_flow *f = g->flow;
    const int wants      = g->wants;
    o_word o = { .word = NAME };
    call new = { .plain = true, .times = g->wants_times };

    g->wants = 0;
    if (wants == GCODE_CALLS && !(new.times > 0))
        return 0;
    if (wants == GCODE_CALLS) {
        snprintf(o.text, sizeof o.text, "%.0f", g->wants_p);
        o.label        = hash(o.text);
        const int code = find_sub(g, &o, NAME, &new.begin);
        return code != 0 ? code : enter(g, &o, &new);
    }
    call *c = f->calls > 0 ? &f->call[f->calls - 1] : NULL;
    if (c != NULL && !c->plain)
        return gcode_fails(g, "gcode.return-kind",
                           "M99 in a subroutine that was called by its O-word",
                           "end it with ENDSUB");
    if (c != NULL)
        g->all.value = g->all.returned = 0;
    if (c == NULL)
        g->ended = true;        /* a controller would begin the program anew */
    else if (--c->times > 0)
        f->at = c->begin, f->blocks = c->blocks;
    else
        leave(g);
    return 0;
}


// Lines
// -----

static int run_steer(gcode_program *g, unsigned n)
{
    const unit *u    = unit_at(g);
    const steer *at  = &u->steer[n];
    gcode_scanner s  = { .b = &g->b,
                         .at = u->text + at->at,
                         .end = gcode_line_end(u->text + at->at, u->text + u->size) };
    o_word o;
    int code = 0;

    (void)take_o(&s);
    read_o_word(&s, &o, true);
    if (s.code == 0 && o.computed && o.word != CALL)
        return wrong_word(g, &o, "gcode.label-computed", "a label that is computed is for CALL",
                          "write its number");
    if (s.code == 0 && o.word == WORDS)
        return wrong_word(g, &o, "gcode.label-word", "an unknown word",
                          "give sub, endsub, call, return, if, elseif, "
                          "else, endif, while, endwhile, do, repeat, endrepeat, break or continue");
    if (o.word == ENDIF || o.word == ELSE || o.word == ENDWHILE || o.word == ENDREPEAT ||
        o.word == BREAK || o.word == CONTINUE || o.word == DO || o.word == SUB)
        end_line(&s);
    if (s.code != 0)
        return s.code;
    switch (o.word) {
    case IF:        return run_if(g, &s, &o, n);
    case ELSEIF:
    case ELSE:
    case ENDIF:     return run_else(g, &o, n);
    case WHILE:     return run_while(g, &s, &o, n);
    case REPEAT:    return run_repeat(g, &s, &o, n);
    case ENDWHILE:
    case ENDREPEAT: return end_loop(g, &o, n);
    case BREAK:
    case CONTINUE:  return leave_loop(g, &o);
    case CALL:      return run_call(g, &s, &o, n);
    case RETURN:
    case ENDSUB:    return run_return(g, &s, &o);
    case SUB:       code = find_word(g, n, &o, ENDSUB, &n); break;
    case DO:        code = open_block(g, &o, DO, n, 0); break;
    default:        break;
    }
    go_behind(g, n);
    return code;
}

static int run_line(gcode_program *g)
{
    place *at     = &g->flow->at;
    const unit *u = unit_at(g);
    const char *text = u->text + at->at, *end = gcode_line_end(text, u->text + u->size);

    at->at = (size_t)(gcode_next_line(end, u->text + u->size) - u->text);
    at->line++;
    const int code = gcode_line(g, text, (size_t)(end - text));
    return code == 0 && g->wants != 0 ? obey(g) : code;
}

int gcode_flow_run(gcode_program *g)
{
    struct gcode_flow *f = g->flow;
    unit *own            = &f->unit[0];
    int code;

    list_steers(g, own);
    f->at = (place){ 0, own->first, 0, 0 };
    code  = g->wants != 0 ? obey(g) : 0;
    while (code == 0 && !g->ended) {
        const unit *u = unit_at(g);
        g->b.file = u->file ? u->file : g->file;
        if (f->at.at >= u->size) {
            if (f->calls == 0)
                break;
            code = gcode_fails(g, "gcode.subroutine-open", "the text ends within a subroutine",
                               "end it with ENDSUB, or M99 after M98");
            break;
        }
        g->b.line = f->at.line;
        if (f->at.unit == 0)
            g->main_line = f->at.line;
        code = count_line(g);
        const bool steers = f->at.next < u->count && u->steer[f->at.next].at == f->at.at;
        if (code == 0)
            code = steers ? run_steer(g, f->at.next) : run_line(g);
    }
    g->b.file = g->file;
    return code;
}
