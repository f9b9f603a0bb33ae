/* host-tools/gcode/gcode_number.c
 * SPDX-License-Identifier: MIT
 *
 * The grammar is that of NIST RS274/NGC version 3, section 3.3.2.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/gcode_number.h"

#define DEPTH    32         /* of expressions in expressions */
#define DIGITS   60         /* of a number */
#define PI       3.14159265358979323846
#define DEGREES  (180 / PI)
#define CODE_TOL 1e-4       /* of a number that must be whole */

void gcode_scan_fail(gcode_scanner *s, const char *name, const char *what, const char *remedy)
{
    if (s->code == 0)
        s->code = gcode_wrong(s->b, name, what, remedy);
}

static char upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

char gcode_peek(gcode_scanner *s)
{
    while (s->at < s->end && (*s->at == ' ' || *s->at == '\t' || *s->at == '\r'))
        s->at++;
    return s->at < s->end ? upper(*s->at) : '\0';
}

bool gcode_take(gcode_scanner *s, char c)
{
    const bool there = gcode_peek(s) == c;

    s->at += there;
    return there;
}

bool gcode_take_word(gcode_scanner *s, const char *word)
{
    const char *back = s->at;

    for (; *word != '\0'; word++)
        if (!gcode_take(s, *word)) {
            s->at = back;
            return false;
        }
    return true;
}


// Numbers
// -------

static const double powers[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15 };

/* Blanks count nowhere, but end the numbers of a printer: M117 100 is a text. */
static char next_digit(gcode_scanner *s)
{
    return !s->b->printer ? gcode_peek(s) : s->at < s->end ? *s->at : '\0';
}

/* Digits with at most one point. Up to 15 digits are an exact integer over an exact power of ten,
 * so the quotient is rounded once. */
static double read_digits(gcode_scanner *s)
{
    char text[DIGITS + 4];
    unsigned length = 0, digits = 0, behind = 0;
    uint64_t whole = 0;
    bool point = false;

    for (char c = gcode_peek(s); (c >= '0' && c <= '9') || (c == '.' && !point);
         c = next_digit(s)) {
        if (length == DIGITS) {
            gcode_scan_fail(s, "gcode.number-long", "a number of more than 60 digits",
                            "write fewer");
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
        gcode_scan_fail(s, "gcode.number-missing", "a number is missing",
                        "write one after each letter");
        return 0;
    }
    if (digits <= 15)
        return (double)whole / powers[behind];
    text[length] = '\0';
    return strtod(text, NULL);
}

static double read_expression(gcode_scanner *s);

static bool read_name(gcode_scanner *s, char out[GCODE_NAME_MAX])
{
    size_t n = 0;

    while (gcode_peek(s) != '>' && gcode_peek(s) != '\0' && n < GCODE_NAME_MAX - 1) {
        out[n++] = gcode_peek(s);
        s->at++;
    }
    out[n] = '\0';
    return gcode_take(s, '>') && n > 0;
}

gcode_named *gcode_find_named(const gcode_block *b, const char *name)
{
    const unsigned depth = *name == '_' ? 0 : b->at->depth;

    for (unsigned i = 0; i < b->at->count; i++)
        if (b->at->named[i].depth == depth && strcmp(b->at->named[i].name, name) == 0)
            return &b->at->named[i];
    return NULL;
}

void gcode_read_label(gcode_scanner *s, char out[GCODE_NAME_MAX])
{
    char name[GCODE_NAME_MAX];

    if (!gcode_take(s, '<') || !read_name(s, name) || strlen(name) > GCODE_NAME_MAX - 3)
        gcode_scan_fail(s, "gcode.label-name", "O<: a name is missing, or too long",
                        "write O<name>");
    else
        snprintf(out, GCODE_NAME_MAX, "<%.*s>", GCODE_NAME_MAX - 3, name);
}

/* What follows #: the number of a parameter, or -1 and its name. */
int gcode_read_parameter(gcode_scanner *s, char name[GCODE_NAME_MAX])
{
    if (gcode_take(s, '<')) {
        if (!read_name(s, name))
            gcode_scan_fail(s, "gcode.parameter-name", "#<: a name is missing, or too long",
                            "write #<name>");
        return -1;
    }
    const double n = gcode_read_value(s), whole = floor(n + 0.5);
    if (s->code == 0 && (!(fabs(n - whole) <= CODE_TOL) || whole < 1 || whole >= GCODE_NUMBERED)) {
        gcode_scan_fail(s, "gcode.parameter-number", "#: no such parameter",
                        "give a whole number from 1 to 5602");
        return 1;
    }
    return s->code == 0 ? (int)whole : 1;
}

static double parameter_value(gcode_scanner *s)
{
    char name[GCODE_NAME_MAX] = "", what[GCODE_NAME_MAX + 32];
    const int n = gcode_read_parameter(s, name);

    double live = 0;

    if (n >= 0 || s->code != 0)
        return n >= 0 ? gcode_live_number(s->b->of, n) : 0;
    const gcode_named *found = gcode_find_named(s->b, name);
    if (found == NULL && gcode_live_name(s->b->of, name, &live))
        return live;
    if (found == NULL) {
        snprintf(what, sizeof what, "#<%s> has no value", name);
        gcode_scan_fail(s, "gcode.parameter-unset", what, "set it first");
    }
    return found ? found->value : 0;
}

/* EXISTS[#<name>], EXISTS[#5]: the numbers up to 5602 are there. */
static double read_exists(gcode_scanner *s)
{
    char name[GCODE_NAME_MAX] = "";
    bool there = false, good = gcode_take(s, '[') && gcode_take(s, '#');

    if (good && gcode_peek(s) == '<') {
        (void)gcode_read_parameter(s, name);
        double live;
        there = gcode_find_named(s->b, name) != NULL || gcode_live_name(s->b->of, name, &live);
    } else if (good) {
        const double n = gcode_read_value(s);
        there = n >= 1 - CODE_TOL && n < GCODE_NUMBERED - CODE_TOL;
    }
    if (!good || !gcode_take(s, ']'))
        gcode_scan_fail(s, "gcode.exists", "EXISTS without [#<name>]", "write EXISTS[#<name>]");
    return there ? 1 : 0;
}

enum function { ABS, ACOS, ASIN, ATAN, COS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT, TAN, FUNCTIONS };

static double apply_function(gcode_scanner *s, enum function f, double x)
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
        if (!gcode_take(s, '/') || !gcode_take(s, '['))
            gcode_scan_fail(s, "gcode.atan", "ATAN without its second number", "write ATAN[y]/[x]");
        return s->code == 0 ? atan2(x, read_expression(s)) * DEGREES : 0;
    case FUNCTIONS: break;
    }
    return 0;
}

static double read_function(gcode_scanner *s)
{
    static const char *const names[FUNCTIONS] = { "ABS", "ACOS", "ASIN",  "ATAN", "COS",
                                                  "EXP", "FIX",  "FUP",   "LN",   "ROUND",
                                                  "SIN", "SQRT", "TAN" };

    if (gcode_take_word(s, "EXISTS"))
        return read_exists(s);
    for (int f = 0; f < FUNCTIONS; f++)
        if (gcode_take_word(s, names[f])) {
            if (!gcode_take(s, '[')) {
                gcode_scan_fail(s, "gcode.function-bracket", "a function without [",
                                "write as SIN[30]");
                return 0;
            }
            return apply_function(s, (enum function)f, read_expression(s));
        }
    return read_digits(s);
}

double gcode_read_value(gcode_scanner *s)
{
    const char c = gcode_peek(s);
    double out;

    if (c == '.' || (c >= '0' && c <= '9'))
        return read_digits(s);
    if (s->code != 0 || ++s->depth > DEPTH) {
        gcode_scan_fail(s, "gcode.expression-deep", "an expression of more than 32 levels",
                        "split it with parameters");
        return 0;
    }
    if (gcode_take(s, '-'))
        out = -gcode_read_value(s);
    else if (gcode_take(s, '+'))
        out = gcode_read_value(s);
    else if (gcode_take(s, '['))
        out = read_expression(s);
    else if (gcode_take(s, '#'))
        out = parameter_value(s);
    else
        out = read_function(s);
    s->depth--;
    if (s->code == 0 && !isfinite(out))
        gcode_scan_fail(s, "gcode.number-not-finite", "a number that is not finite",
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

static enum operator take_operator(gcode_scanner *s)
{
    int n = 0;

    while (n < NONE && !gcode_take_word(s, operators[n].name))
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
static double read_expression(gcode_scanner *s)
{
    enum operator waiting[6];
    double value[6];
    int n = 0;

    do {
        value[n] = gcode_read_value(s);
        waiting[n] = take_operator(s);
        while (n > 0 && operators[waiting[n - 1]].rank >= operators[waiting[n]].rank) {
            value[n - 1]   = apply_operator(waiting[n - 1], value[n - 1], value[n]);
            waiting[n - 1] = waiting[n];
            n--;
        }
    } while (s->code == 0 && waiting[n++] != NONE);
    if (!gcode_take(s, ']'))
        gcode_scan_fail(s, "gcode.bracket-open", "[ without ]",
                        "close the brackets, and put one operator between two numbers");
    return s->code == 0 ? value[0] : 0;
}
