/* host-tools/gcode/gcode_number.h -- numbers of G-code: written out, parameters, expressions
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_READ_GCODE_NUMBER_H
#define LOFT_READ_GCODE_NUMBER_H

#include "gcode/gcode_block.h"

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
} gcode_scanner;

/* Tell what is wrong with the line, once. */
void gcode_scan_fail(gcode_scanner *s, const char *name, const char *what, const char *remedy);

/* The next character that is not blank, as a capital; 0 at the end. */
char gcode_peek(gcode_scanner *s);

/* Take a character, or a word of capital letters, if it comes next. */
bool gcode_take(gcode_scanner *s, char c);
bool gcode_take_word(gcode_scanner *s, const char *word);

/* A number: written out, with a sign, in brackets, of a parameter or of a function. */
double gcode_read_value(gcode_scanner *s);

/* What follows #: the number of a parameter, or -1 and its name. */
int gcode_read_parameter(gcode_scanner *s, char name[GCODE_NAME_MAX]);
gcode_named *gcode_find_named(const gcode_block *b, const char *name);

/* <name>, with its brackets: the label of an O-word. */
void gcode_read_label(gcode_scanner *s, char out[GCODE_NAME_MAX]);

/* gcode_named.c: parameters that are not set, but tell how the program stands. */
bool   gcode_live_name(const struct gcode_program *g, const char *name, double *out);
double gcode_live_number(const struct gcode_program *g, int number);

#endif
