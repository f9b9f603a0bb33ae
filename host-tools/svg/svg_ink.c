/* host-tools/svg/svg_ink.c -- colours, and which of them are drawn
 * SPDX-License-Identifier: MIT
 *
 * A colour that is written as numbers, or has one of the usual names, becomes #rrggbb. Any other
 * name stays as it is.
 *   see  CSS Color Module Level 4, 6.1 and 5
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/scan.h"       /* scan_number, scan_comma */
#include "read/machine_tools.h"
#include "svg/svg.h"

static const struct {
    const char *name;
    unsigned rgb;
} names[] = { { "black", 0x000000 },  { "white", 0xffffff },  { "red", 0xff0000 },
              { "lime", 0x00ff00 },   { "blue", 0x0000ff },   { "yellow", 0xffff00 },
              { "cyan", 0x00ffff },   { "aqua", 0x00ffff },   { "magenta", 0xff00ff },
              { "fuchsia", 0xff00ff }, { "gray", 0x808080 },  { "grey", 0x808080 },
              { "silver", 0xc0c0c0 }, { "maroon", 0x800000 }, { "olive", 0x808000 },
              { "green", 0x008000 },  { "purple", 0x800080 }, { "teal", 0x008080 },
              { "navy", 0x000080 },   { "orange", 0xffa500 }, { "brown", 0xa52a2a },
              { "pink", 0xffc0cb },   { "gold", 0xffd700 },   { "violet", 0xee82ee } };

static bool is_hex(const char *text, size_t *length)
{
    *length = strspn(text, "0123456789abcdefABCDEF");
    return *length == strlen(text) &&
           (*length == 3 || *length == 4 || *length == 6 || *length == 8);
}

/* rgb(1, 2, 3), also with %, commas or blanks. */
static bool read_numbers(const char *at, unsigned *rgb)
{
    *rgb = 0;
    for (int i = 0; i < 3; i++) {
        double x;
        scan_comma(&at);
        if (!scan_number(&at, &x))
            return false;
        if (*at == '%') {
            x *= 2.55;
            at++;
        }
        *rgb = *rgb << 8 | (unsigned)lround(fmin(fmax(x, 0), 255));
    }
    return true;
}

/* #rrggbb, or the text itself. */
static void plain_colour(const char *text, char out[40])
{
    size_t length;
    unsigned rgb;

    snprintf(out, 40, "%.39s", text);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcasecmp(names[i].name, text) == 0)
            snprintf(out, 40, "#%06x", names[i].rgb);
    if (text[0] == '#' && is_hex(text + 1, &length)) {
        for (size_t i = 0; i < 6; i++)
            out[1 + i] = text[1 + (length < 6 ? i / 2 : i)];
        out[7] = '\0';
    }
    const char *open = strchr(text, '(');
    if (open != NULL && strncasecmp(text, "rgb", 3) == 0 && read_numbers(open + 1, &rgb))
        snprintf(out, 40, "#%06x", rgb);
    for (char *at = out; *at != '\0'; at++)
        *at = (char)(*at >= 'A' && *at <= 'Z' ? *at + 'a' - 'A' : *at);
}

const char *svg_ink(svg_reader *r, const char *text)
{
    char plain[40];

    plain_colour(text, plain);
    return (const char *)xmlDictLookup(r->words, (const xmlChar *)plain, -1);
}

/* Keep what was seen, for the message of svg_ink_check. */
static void note_ink(svg_reader *r, const char *ink)
{
    size_t i = 0;

    while (i < SVG_INKS && r->inks[i] != NULL && r->inks[i] != ink)
        i++;
    if (i < SVG_INKS)
        r->inks[i] = ink;
}

/* Does a list of colours, with commas, have this one? */
static bool is_listed(const char *list, const char *ink)
{
    for (const char *word = list; word != NULL;) {
        const size_t length = strcspn(word, ",");
        char asked[40], plain[40];
        snprintf(asked, sizeof asked, "%.*s", (int)(length < 39 ? length : 39), word);
        plain_colour(asked, plain);
        if (strcmp(plain, ink) == 0)
            return true;
        word = word[length] == '\0' ? NULL : word + length + 1;
    }
    return false;
}

static const char *ink_of(const svg_space *space, bool stroked)
{
    const char *ink = stroked ? space->stroke_ink : space->fill_ink;

    return ink ? ink : "#000000";
}

unsigned svg_ink_tool(const svg_reader *r, const svg_space *space, bool stroked)
{
    for (unsigned i = 0; r->d->tools != NULL && i < r->d->tools->count; i++)
        if (is_listed(r->d->tools->tool[i].colours, ink_of(space, stroked)))
            return i + 1;
    return 0;
}

bool svg_ink_chosen(svg_reader *r, const svg_space *space, bool stroked)
{
    if (r->d->only == NULL)
        return true;
    note_ink(r, ink_of(space, stroked));
    const bool chosen = is_listed(r->d->only, ink_of(space, stroked));
    r->inked          = r->inked || chosen;
    return chosen;
}

bool svg_ink_check(const svg_reader *r)
{
    char all[SVG_INKS * 42] = "";

    if (r->d->only == NULL || r->inked)
        return true;
    for (size_t i = 0; i < SVG_INKS && r->inks[i] != NULL; i++)
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", i ? ", " : "", r->inks[i]);
    return svg_fail(r, "svg.no-colour", "--only %.60s: nothing has this colour: %s%s", r->d->only,
                    *all ? "give one of " : "nothing in it is painted", all);
}
