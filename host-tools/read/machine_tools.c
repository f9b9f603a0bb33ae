/* host-tools/read/machine_tools.c -- reads the lines `tool.NAME.key = value` of a machine file
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"              /* scan_number */
#include "base/host.h"
#include "read/machine_tools.h"

/* A key with a number or, `size` above 0, with a text. */
typedef struct {
    const char *key, *unit;
    size_t at, size;
    double least, most;
} row;

#define AT(field)   offsetof(machine_tool, field)
#define TEXT(field) offsetof(machine_tool, field), sizeof((machine_tool *)0)->field

static const row rows[] = {
    { "colours", "", TEXT(colours), 0, 0 },
    { "layers", "", TEXT(layers), 0, 0 },
    { "pause", "", TEXT(pause), 0, 0 },
    { "feed", "mm/s", AT(feed), 0, 1 / 64.0, 16383 },
    { "pen_up", "mm", AT(pen_up), 0, -16383, 16383 },
    { "pen_down", "mm", AT(pen_down), 0, -16383, 16383 },
    { "delay", "s", AT(delay), 0, 0, 3600 },
    { "diameter", "mm", AT(diameter), 0, 0.001, 1000 },
    { "length", "mm", AT(length), 0, -1000, 1000 },
};
#define ROWS (sizeof rows / sizeof rows[0])

/* A comment begins with # between blanks, or before one: #f00 is a colour. */
static size_t text_length(const char *s)
{
    size_t end = 0;

    for (size_t i = 0; s[i] != '\0' && s[i] != '\n'; i++) {
        if (s[i] == '#' && (i == 0 || isblank((unsigned char)s[i - 1])) &&
            (s[i + 1] == ' ' || s[i + 1] == '\t'))
            break;
        if (!isspace((unsigned char)s[i]))
            end = i + 1;
    }
    return end;
}

/* Copy a list without the blanks around its commas; any other text as it is. */
static void copy_text(char *to, const char *s, size_t length, bool list)
{
    size_t n = 0;

    for (size_t i = 0; i < length; i++) {
        const bool blank = s[i] == ' ' || s[i] == '\t';
        const size_t next = i + strspn(s + i, " \t");
        if (list && blank && (n == 0 || to[n - 1] == ',' || s[next] == ','))
            continue;
        to[n++] = s[i];
    }
    to[n] = '\0';
}

static int set_text(host *h, machine_tool *t, const row *k, const char *file, unsigned line,
                    const char *s)
{
    const size_t length = text_length(s);
    char *to            = (char *)t + k->at;

    if (length == 0 || length >= k->size)
        return host_error(h, EX_DATAERR, "machine.tool-text", (host_place){ file, line },
                          HOST_REMEDY("give 1 to %zu letters", k->size - 1), "%s %s", k->key,
                          length == 0 ? "is empty" : "is too long");
    if (*to != '\0')
        return host_error(h, EX_DATAERR, "machine.tool-key-twice", (host_place){ file, line },
                          "remove one", "%s of tool %s is given already", k->key, t->name);
    copy_text(to, s, length, strcmp(k->key, "pause") != 0);
    return 0;
}

static int set_number(host *h, machine_tool *t, const row *k, const char *file, unsigned line,
                      const char *s)
{
    double value, *to = (double *)((char *)t + k->at);

    if (!scan_number(&s, &value) || !(value >= k->least && value <= k->most))
        return host_error(h, EX_DATAERR, "machine.tool-range", (host_place){ file, line },
                          HOST_REMEDY("give a number from %g to %g %s", k->least, k->most, k->unit),
                          "%s", k->key);
    s += strspn(s, " \t\r");
    if (*s != '\0' && *s != '\n' && *s != '#')
        return host_error(h, EX_DATAERR, "machine.tool-not-a-number", (host_place){ file, line },
                          HOST_REMEDY("give one in %s", k->unit), "%s is not a number", k->key);
    if (!isnan(*to) && *to != 0)
        return host_error(h, EX_DATAERR, "machine.tool-key-twice", (host_place){ file, line },
                          "remove one", "%s of tool %s is given already", k->key, t->name);
    *to = value;
    return 0;
}

static machine_tool *tool_of(machine_tools *t, const char *name, size_t length)
{
    for (unsigned i = 0; i < t->count; i++)
        if (strlen(t->tool[i].name) == length && strncmp(t->tool[i].name, name, length) == 0)
            return &t->tool[i];
    if (t->count == MACHINE_TOOLS || length == 0 || length >= sizeof t->tool[0].name)
        return NULL;
    machine_tool *fresh = &t->tool[t->count++];
    *fresh = (machine_tool){ .pen_up = NAN, .pen_down = NAN, .length = NAN };
    memcpy(fresh->name, name, length);
    return fresh;
}

int machine_tools_line(host *h, machine_tools *t, const char *file, unsigned line, const char *text)
{
    const char *name = text + strlen("tool."), *dot = name + strcspn(name, ". \t\r\n=#"),
               *key = *dot == '.' ? dot + 1 : dot;
    const size_t length = strcspn(key, " \t\r\n=#");
    const row *k        = NULL;

    for (size_t i = 0; i < ROWS; i++)
        if (strlen(rows[i].key) == length && strncmp(rows[i].key, key, length) == 0)
            k = &rows[i];
    const char *s = key + length + strspn(key + length, " \t");
    if (k == NULL || *dot != '.' || *s != '=')
        return host_error(h, EX_DATAERR, "machine.tool-line", (host_place){ file, line },
                          "write tool.NAME.KEY = .., KEY one of colours, layers, pause, feed, "
                          "pen_up, pen_down, delay, diameter, length",
                          "not a line of a tool");
    machine_tool *of = tool_of(t, name, (size_t)(dot - name));
    if (of == NULL)
        return host_error(h, EX_DATAERR, "machine.tool-name", (host_place){ file, line }, NULL,
                          "%s",
                          t->count == MACHINE_TOOLS ? "more than 32 tools: remove some"
                                                    : "the name of a tool has 1 to 23 letters");
    s++;
    s += strspn(s, " \t");
    return k->size > 0 ? set_text(h, of, k, file, line, s) : set_number(h, of, k, file, line, s);
}

const machine_tool *machine_tools_find(const machine_tools *t, const char *name)
{
    for (unsigned i = 0; i < t->count; i++)
        if (strcmp(t->tool[i].name, name) == 0)
            return &t->tool[i];
    return NULL;
}

bool machine_tool_draws_rest(const machine_tool *t)
{
    return *t->colours == '\0' && *t->layers == '\0';
}
