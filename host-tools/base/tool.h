/* host-tools/base/tool.h -- what all subcommands share: options, help, errors in one line, exit
 * codes
 * SPDX-License-Identifier: MIT
 *
 * Every error is one line on standard error: `loft: file:line: what: remedy`, with a code of
 * <sysexits.h>. A subcommand is a file cmd_<name>.c that defines one tool_command; commands.h
 * declares it, loft.c lists it in its table.
 */
#ifndef LOFT_TOOL_H
#define LOFT_TOOL_H

#include <stdbool.h>
#include <stddef.h>
#include <sysexits.h>       /* EX_USAGE, EX_DATAERR, EX_NOINPUT, EX_UNAVAILABLE, EX_PROTOCOL, .. */

#include "base/bridge.h"    /* tool_error */

typedef struct tool_command tool_command;
struct tool_command {
    const char *name;
    const char *arguments;      /* what follows the name in the usage line              */
    const char *summary;        /* half a line, for `loft --help`                       */
    const char *detail;         /* paragraphs for `loft help NAME`, ends with a newline */
    int (*run)(const tool_command *self, int argc, char **argv);    /* returns the exit code */
};

/* Read a number from `least` to `most`. On failure prints the name of the option and returns
 * false. */
bool tool_number(const char *option, const char *text, double least, double most, double *out);

/* The seconds of a monotonic clock. */
double tool_clock(void);

/* The plural ending of a word: "%zu curve%s", n, tool_s(n). */
static inline const char *tool_s(size_t n)      { return n == 1 ? "" : "s"; }


// Options
// -------

enum tool_kind {
    TOOL_END,
    TOOL_IS_SWITCH,
    TOOL_IS_NUMBER,
    TOOL_IS_COUNT,
    TOOL_IS_SPEED,
    TOOL_IS_TEXT,
    TOOL_IS_LIST,
    TOOL_IS_PARSED,
    TOOL_IS_MAYBE
};

/* A list of numbers: "0,0.5,1", or the option repeated. */
#define TOOL_LIST_MAX 256
typedef struct {
    double value[TOOL_LIST_MAX];
    size_t count;
} tool_list;

typedef struct {
    enum tool_kind kind;
    const char *name;           /* without the dashes            */
    const char *argument;       /* its name in the help          */
    void *out;
    double least, most;
    const char *help;           /* one line; names the default */
    bool (*parse)(const char *text, void *out);     /* of PARSED; prints its own error */
} tool_option;

/* Rows of a table that ends with TOOL_OPTIONS_END. Speeds are in mm/s and may be written 20, 20mm/s
 * or 1200mm/min. A MAYBE has an optional number, 0 if it is omitted. `out` points to a bool, a
 * double (numbers, speeds), an unsigned (counts), a const char *, a tool_list, or what `parse`
 * fills. */
#define TOOL_SWITCH(name, out, help) { TOOL_IS_SWITCH, name, NULL, out, 0, 0, help, NULL }
#define TOOL_NUMBER(name, argument, out, least, most, help) \
    { TOOL_IS_NUMBER, name, argument, out, least, most, help, NULL }
#define TOOL_COUNT(name, argument, out, least, most, help) \
    { TOOL_IS_COUNT, name, argument, out, least, most, help, NULL }
#define TOOL_SPEED(name, out, least, most, help) \
    { TOOL_IS_SPEED, name, "SPEED", out, least, most, help, NULL }
#define TOOL_TEXT(name, argument, out, help) { TOOL_IS_TEXT, name, argument, out, 0, 0, help, NULL }
#define TOOL_LIST(name, argument, out, least, most, help) \
    { TOOL_IS_LIST, name, argument, out, least, most, help, NULL }
#define TOOL_PARSED(name, argument, out, parse, help) \
    { TOOL_IS_PARSED, name, argument, out, 0, 0, help, parse }
#define TOOL_MAYBE(name, argument, out, least, most, help) \
    { TOOL_IS_MAYBE, name, argument, out, least, most, help, NULL }
#define TOOL_OPTIONS_END { TOOL_END, NULL, NULL, NULL, 0, 0, NULL, NULL }

#define TOOL_HELP (-1)      /* tool_options has printed the help: return EX_OK */

/* Read the options of `self` from argv[1..]. The remaining arguments are argv[*first .. argc-1].
 * Returns 0, TOOL_HELP or EX_USAGE. */
int tool_options(const tool_command *self, const tool_option options[], int argc, char **argv,
                 int *first);

/* The same for a command that takes one file. The file is "-" if none is given, or else the value
 * of --points (NULL: no such option, or not given). */
int tool_file_options(const tool_command *self, const tool_option options[], int argc, char **argv,
                      const char *const *points, const char **file);

/* The version of this program. */
extern const char tool_version[];

#endif
