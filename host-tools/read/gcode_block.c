/* host-tools/read/gcode_block.c
 * SPDX-License-Identifier: MIT
 *
 * The grammar is that of NIST RS274/NGC version 3 (section 3.3), with the comments of LinuxCNC and
 * grbl (from ; to the end of the line) and named parameters.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"       /* tool_error, sysexits */
#include "read/gcode_block.h"

#define DEPTH    32         /* of expressions in expressions */
#define DIGITS   60         /* of a number */
#define PI       3.14159265358979323846
#define DEGREES  (180 / PI)
#define CODE_TOL 1e-4       /* of a number that must be a whole or a tenth */

/* A line in progress. */
typedef struct {
    gcode_block *b;
    const char *at, *end;
    int depth;
    int code;               /* 0, or EX_DATAERR after a message */
    struct {
        int number;         /* of the parameter, or */
        char name[GCODE_NAME_MAX];
        double value;
    } set[GCODE_SETTINGS];
    unsigned sets;
} scanner;

int gcode_wrong(const gcode_block *b, const char *what, const char *remedy)
{
    return tool_error(EX_DATAERR, "%s:%u: %s: %s", b->file, b->line, what, remedy);
}

static void fail(scanner *s, const char *what, const char *remedy)
{
    if (s->code == 0)
        s->code = gcode_wrong(s->b, what, remedy);
}

static char upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

/* The next character that is not blank, as a capital; 0 at the end. */
static char peek(scanner *s)
{
    while (s->at < s->end && (*s->at == ' ' || *s->at == '\t' || *s->at == '\r'))
        s->at++;
    return s->at < s->end ? upper(*s->at) : '\0';
}

static bool take(scanner *s, char c)
{
    const bool there = peek(s) == c;

    s->at += there;
    return there;
}

/* Take a word of capital letters if it comes next. */
static bool take_word(scanner *s, const char *word)
{
    const char *back = s->at;

    for (; *word != '\0'; word++)
        if (!take(s, *word)) {
            s->at = back;
            return false;
        }
    return true;
}


// Numbers
// -------

static const double powers[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15 };

/* Digits with at most one point. Up to 15 digits are an exact integer over an exact power of ten,
 * so the quotient is rounded once. */
static double read_digits(scanner *s)
{
    char text[DIGITS + 4];
    unsigned length = 0, digits = 0, behind = 0;
    uint64_t whole = 0;
    bool point = false;

    for (char c = peek(s); (c >= '0' && c <= '9') || (c == '.' && !point); c = peek(s)) {
        if (length == DIGITS) {
            fail(s, "a number of more than 60 digits", "write fewer");
            return 0;
        }
        text[length++] = c;
        s->at++;
        point = point || c == '.';
        if (c != '.') {
            digits++;
            behind += point;
            whole = digits <= 15 ? 10 * whole + (uint64_t)(c - '0') : 0;
        }
    }
    if (digits == 0) {
        fail(s, "a number is missing", "write one after each letter");
        return 0;
    }
    if (digits <= 15)
        return (double)whole / powers[behind];
    text[length] = '\0';
    return strtod(text, NULL);
}

static double read_value(scanner *s);
static double read_expression(scanner *s);

static bool read_name(scanner *s, char out[GCODE_NAME_MAX])
{
    size_t n = 0;

    while (peek(s) != '>' && peek(s) != '\0' && n < GCODE_NAME_MAX - 1) {
        out[n++] = peek(s);
        s->at++;
    }
    out[n] = '\0';
    return take(s, '>') && n > 0;
}

static gcode_named *find_named(const gcode_block *b, const char *name)
{
    for (unsigned i = 0; i < b->at->count; i++)
        if (strcmp(b->at->named[i].name, name) == 0)
            return &b->at->named[i];
    return NULL;
}

/* What follows #: the number of a parameter, or -1 and its name. */
static int read_parameter(scanner *s, char name[GCODE_NAME_MAX])
{
    if (take(s, '<')) {
        if (!read_name(s, name))
            fail(s, "#<: a name is missing, or too long", "write #<name>");
        return -1;
    }
    const double n = read_value(s), whole = floor(n + 0.5);
    if (s->code == 0 && (!(fabs(n - whole) <= CODE_TOL) || whole < 1 || whole >= GCODE_NUMBERED)) {
        fail(s, "#: no such parameter", "give a whole number from 1 to 5602");
        return 1;
    }
    return s->code == 0 ? (int)whole : 1;
}

static double parameter_value(scanner *s)
{
    char name[GCODE_NAME_MAX] = "", what[GCODE_NAME_MAX + 32];
    const int n = read_parameter(s, name);

    if (n >= 0 || s->code != 0)
        return n >= 0 ? s->b->at->number[n] : 0;
    const gcode_named *found = find_named(s->b, name);
    if (found == NULL) {
        snprintf(what, sizeof what, "#<%s> has no value", name);
        fail(s, what, "set it first");
    }
    return found ? found->value : 0;
}

/* EXISTS[#<name>] */
static double read_exists(scanner *s)
{
    char name[GCODE_NAME_MAX] = "";
    int n = -2;

    if (take(s, '[') && take(s, '#'))
        n = read_parameter(s, name);
    if (n == -2 || !take(s, ']'))
        fail(s, "EXISTS without [#<name>]", "write EXISTS[#<name>]");
    return n > 0 || find_named(s->b, name) != NULL ? 1 : 0;
}

enum function { ABS, ACOS, ASIN, ATAN, COS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT, TAN, FUNCTIONS };

static double apply_function(scanner *s, enum function f, double x)
{
    switch (f) {
    case ABS:   return fabs(x);
    case ACOS:  return acos(x) * DEGREES;
    case ASIN:  return asin(x) * DEGREES;
    case COS:   return cos(x / DEGREES);
    case EXP:   return exp(x);
    case FIX:   return floor(x);
    case FUP:   return ceil(x);
    case LN:    return log(x);
    case ROUND: return x < 0 ? -floor(0.5 - x) : floor(x + 0.5);
    case SIN:   return sin(x / DEGREES);
    case SQRT:  return sqrt(x);
    case TAN:   return tan(x / DEGREES);
    case ATAN:
        if (!take(s, '/') || !take(s, '['))
            fail(s, "ATAN without its second number", "write ATAN[y]/[x]");
        return s->code == 0 ? atan2(x, read_expression(s)) * DEGREES : 0;
    case FUNCTIONS: break;
    }
    return 0;
}

static double read_function(scanner *s)
{
    static const char *const names[FUNCTIONS] = { "ABS", "ACOS", "ASIN",  "ATAN", "COS",
                                                  "EXP", "FIX",  "FUP",   "LN",   "ROUND",
                                                  "SIN", "SQRT", "TAN" };

    if (take_word(s, "EXISTS"))
        return read_exists(s);
    for (int f = 0; f < FUNCTIONS; f++)
        if (take_word(s, names[f])) {
            if (!take(s, '[')) {
                fail(s, "a function without [", "write as SIN[30]");
                return 0;
            }
            return apply_function(s, (enum function)f, read_expression(s));
        }
    return read_digits(s);
}

/* A number: written out, with a sign, in brackets, of a parameter or of a function. */
static double read_value(scanner *s)
{
    const char c = peek(s);
    double out;

    if (c == '.' || (c >= '0' && c <= '9'))
        return read_digits(s);
    if (s->code != 0 || ++s->depth > DEPTH) {
        fail(s, "an expression of more than 32 levels", "split it with parameters");
        return 0;
    }
    if (take(s, '-'))
        out = -read_value(s);
    else if (take(s, '+'))
        out = read_value(s);
    else if (take(s, '['))
        out = read_expression(s);
    else if (take(s, '#'))
        out = parameter_value(s);
    else
        out = read_function(s);
    s->depth--;
    if (s->code == 0 && !isfinite(out))
        fail(s, "a number that is not finite",
             "look for a division by 0, or a root of less than 0");
    return s->code == 0 ? out : 0;
}

// Expressions: operators by their rank, from the left
enum operator { POWER, TIMES, OVER, MOD, PLUS, MINUS, EQ, NE, GE, GT, LE, LT, AND, OR, XOR, NONE };
static const struct {
    const char *name;
    int rank;
} operators[NONE + 1] = {
    [POWER] = { "**", 5 }, [TIMES] = { "*", 4 }, [OVER] = { "/", 4 },  [MOD] = { "MOD", 4 },
    [PLUS] = { "+", 3 },   [MINUS] = { "-", 3 }, [EQ] = { "EQ", 2 },   [NE] = { "NE", 2 },
    [GE] = { "GE", 2 },    [GT] = { "GT", 2 },   [LE] = { "LE", 2 },   [LT] = { "LT", 2 },
    [AND] = { "AND", 1 },  [OR] = { "OR", 1 },   [XOR] = { "XOR", 1 }, [NONE] = { "", 0 }
};

static enum operator take_operator(scanner *s)
{
    int n = 0;

    while (n < NONE && !take_word(s, operators[n].name))
        n++;
    return (enum operator)n;
}

static double apply_operator(enum operator o, double a, double b)
{
    switch (o) {
    case POWER: return pow(a, b);
    case TIMES: return a * b;
    case OVER:  return a / b;
    case MOD:   return a - b * floor(a / b);
    case PLUS:  return a + b;
    case MINUS: return a - b;
    case EQ:    return fabs(a - b) < 1e-6;
    case NE:    return fabs(a - b) >= 1e-6;
    case GE:    return a >= b;
    case GT:    return a > b;
    case LE:    return a <= b;
    case LT:    return a < b;
    case AND:   return fabs(a) > 0 && fabs(b) > 0;
    case OR:    return fabs(a) > 0 || fabs(b) > 0;
    case XOR:   return (fabs(a) > 0) != (fabs(b) > 0);
    case NONE:  break;
    }
    return a;
}

/* Behind [: up to and with the ]. Values and operators wait on a stack until an operator of no
 * higher rank follows; ranks on the stack ascend, so six places are enough. */
static double read_expression(scanner *s)
{
    enum operator waiting[6];
    double value[6];
    int n = 0;

    do {
        value[n] = read_value(s);
        waiting[n] = take_operator(s);
        while (n > 0 && operators[waiting[n - 1]].rank >= operators[waiting[n]].rank) {
            value[n - 1]   = apply_operator(waiting[n - 1], value[n - 1], value[n]);
            waiting[n - 1] = waiting[n];
            n--;
        }
    } while (s->code == 0 && waiting[n++] != NONE);
    if (!take(s, ']'))
        fail(s, "[ without ]", "close the brackets, and put one operator between two numbers");
    return s->code == 0 ? value[0] : 0;
}


// Words
// -----

/* `(MSG,text)` is said; all other comments are left out. */
static void skip_comment(scanner *s)
{
    const char *from = s->at, *close = memchr(from, ')', (size_t)(s->end - from));

    if (close == NULL) {
        fail(s, "( without )", "close the comment");
        s->at = s->end;
        return;
    }
    if (take_word(s, "MSG,")) {
        s->b->say        = s->at;
        s->b->say_length = (size_t)(close - s->at);
    }
    s->at = close + 1;
}

static void read_setting(scanner *s)
{
    char name[GCODE_NAME_MAX] = "";
    const int n = read_parameter(s, name);

    if (!take(s, '='))
        fail(s, "# without =", "set a parameter as #5 = 2, or use it behind a letter, as X#5");
    const double value = read_value(s);
    if (s->sets == GCODE_SETTINGS)
        fail(s, "more than 16 parameters set in a line", "split the line");
    if (s->code != 0)
        return;
    s->set[s->sets].number = n;
    s->set[s->sets].value  = value;
    memcpy(s->set[s->sets].name, name, sizeof name);
    s->sets++;
}

static void apply_settings(scanner *s)
{
    for (unsigned i = 0; i < s->sets && s->code == 0; i++) {
        gcode_parameters *all = s->b->at;
        gcode_named *named    = NULL;
        if (s->set[i].number >= 0) {
            all->number[s->set[i].number] = s->set[i].value;
            continue;
        }
        named = find_named(s->b, s->set[i].name);
        if (named == NULL && all->count == GCODE_NAMED) {
            fail(s, "more than 256 named parameters", "use numbers: #1 to #5602");
            return;
        }
        if (named == NULL) {
            named = &all->named[all->count++];
            memcpy(named->name, s->set[i].name, sizeof named->name);
        }
        named->value = s->set[i].value;
    }
}

static void add_code(scanner *s, char letter, double value)
{
    const double tenths = floor(10 * value + 0.5);
    short *list         = letter == 'G' ? s->b->g : s->b->m;
    unsigned *count     = letter == 'G' ? &s->b->gs : &s->b->ms;
    char what[64];

    if (!(fabs(10 * value - tenths) <= 10 * CODE_TOL) || tenths < 0 || tenths > 9999 ||
        (letter == 'M' && fmod(tenths, 10) > 0)) {
        snprintf(what, sizeof what, "%c%.6g: no such code", letter, value);
        fail(s, what, "leave it out, or correct it");
    } else if (*count == GCODE_CODES) {
        snprintf(what, sizeof what, "more than 16 %c words in a line", letter);
        fail(s, what, "split the line");
    } else {
        list[(*count)++] = (short)tenths;
    }
}

static void read_word(scanner *s, char letter)
{
    const double value = read_value(s);
    char what[32];

    if (s->code != 0)
        return;
    if (letter == 'G' || letter == 'M') {
        add_code(s, letter, value);
        return;
    }
    if (gcode_has(s->b, letter)) {
        snprintf(what, sizeof what, "%c twice in a line", letter);
        fail(s, what, "leave one of them out");
        return;
    }
    s->b->has |= GCODE_BIT(letter);
    s->b->value[letter - 'A'] = value;
}

/* The rest of such a line is text for the printer's display, or the name of a file. */
static bool takes_text(const gcode_block *b)
{
    static const short codes[] = { 230, 280, 320, 1170, 1180, 9280 };

    for (size_t i = 0; b->printer && b->ms > 0 && i < sizeof codes / sizeof codes[0]; i++)
        if (b->m[b->ms - 1] == codes[i])
            return true;
    return false;
}

static bool at_line_end(scanner *s, char c)
{
    return c == '\0' || c == ';' || (c == '*' && s->b->printer) || takes_text(s->b);
}

/* A printer takes letters without numbers, as G28 X: they are 0. */
static bool stands_alone(scanner *s)
{
    const char c = peek(s);

    return s->b->printer && (c == '\0' || c == ';' || c == '(' || (c >= 'A' && c <= 'Z'));
}

static void add_bare(gcode_block *b, char letter)
{
    b->has |= GCODE_BIT(letter);
    b->value[letter - 'A'] = 0;
}

static void refuse_character(scanner *s, unsigned char c)
{
    char what[40];

    if (c < 32 || c > 126)
        snprintf(what, sizeof what, "a character of code %u", (unsigned)c);
    else
        snprintf(what, sizeof what, "`%c`", c);
    fail(s, what, "is this G-code? a word is a letter and a number");
}

static void read_words(scanner *s)
{
    for (char c = peek(s); s->code == 0 && !at_line_end(s, c); c = peek(s)) {
        s->at++;
        if (c == '(')
            skip_comment(s);
        else if (c == '#')
            read_setting(s);
        else if (c == 'O')
            fail(s, "O: subroutines, loops and branches are not run",
                 "write the program out in the CAM's post-processor");
        else if (c >= 'A' && c <= 'Z' && stands_alone(s))
            add_bare(s->b, c);
        else if (c >= 'A' && c <= 'Z')
            read_word(s, c);
        else
            refuse_character(s, (unsigned char)c);
    }
}

int gcode_block_read(gcode_block *b, const char *text, size_t length)
{
    scanner s = { .b = b, .at = text, .end = text + length };

    b->has = 0;
    b->gs = b->ms = 0;
    b->say = NULL;
    b->percent = false;
    if (length > GCODE_LINE_MAX)
        return gcode_wrong(b, "a line of more than 65536 characters", "is this G-code?");
    const char first = peek(&s);
    if (first == '%') {
        b->percent = true;
        return 0;
    }
    if (first == '/') {
        if (b->skip)
            return 0;
        s.at++;
    }
    read_words(&s);
    apply_settings(&s);
    return s.code;
}
