/* host-tools/base/text_lines.c -- reads a text line by line
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/text_lines.h"
#include "base/scan.h"       /* scan_numbers, scan_word */
#include "base/host.h"

int lines_wrong(const lines *r, const char *name, const char *what, const char *remedy)
{
    return host_error(r->host, EX_DATAERR, name, (host_place){ r->file, r->line }, remedy, "%s",
                      what);
}

bool lines_over(const lines *r) { return *r->rest == '\0' || *r->rest == '\n' || *r->rest == '#'; }

static const char *behind_mark(const char *text)
{
    return strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? text + 3 : text;
}

const char *lines_start(const char *text)
{
    text = behind_mark(text);
    for (text += strspn(text, " \t\r\n"); *text == '#'; text += strspn(text, " \t\r\n"))
        text += strcspn(text, "\n");
    return text;
}

int lines_read(lines *r, const char *text, int (*each)(void *context), void *context)
{
    int code = 0;

    for (r->line = 0, text = behind_mark(text); *text != '\0' && code == 0; text += *text == '\n') {
        r->line++;
        r->rest = text + strspn(text, " \t\r");
        if (!lines_over(r))
            code = each(context);
        text += strcspn(text, "\n");
    }
    return code;
}

bool lines_word(lines *r, const char *word)
{
    const size_t length = (size_t)scan_word(r->rest);

    if (strlen(word) != length || strncmp(r->rest, word, length) != 0)
        return false;
    r->rest += length;
    r->rest += strspn(r->rest, " \t");
    return true;
}

bool lines_colon(lines *r)
{
    const bool there = *r->rest == ':';

    r->rest += there;
    return there;
}

int lines_numbers(lines *r, double out[], int most)
{
    const int count = scan_numbers(&r->rest, out, most);

    for (int i = 0; i < count; i++) {
        if (!isfinite(out[i]))
            return -1;
        out[i] += 0.0;          /* no -0 */
    }
    return count;
}

int lines_numbers_alone(lines *r, double out[], int most)
{
    const int count = lines_numbers(r, out, most);

    return lines_over(r) ? count : -1;
}

int lines_vector(lines *r, double out[LINES_AXES])
{
    double number[LINES_AXES + 1];
    const int count = lines_numbers(r, number, LINES_AXES + 1);

    if (count < 2 || count > LINES_AXES)
        return 0;
    for (int i = 0; i < LINES_AXES; i++)
        out[i] = i < count ? number[i] : 0;
    return count;
}

bool lines_weight(lines *r, double *out)
{
    return lines_numbers(r, out, 1) == 1 && *out >= LINES_WEIGHT_LEAST && *out <= LINES_WEIGHT_MOST;
}
