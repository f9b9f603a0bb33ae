/* host-tools/base/host.c
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdlib.h>

#include "base/host.h"
#include "base/say.h"

#define OFTEN 0.1               /* s between two calls of `progress` */

void host_close(host *h)
{
    free(h->input.text);
    h->input.text = NULL;
    h->input.size = 0;
}

/* `m` has all but the words. Without memory for long ones, only their beginning is passed on. */
static void tell(const host *h, host_message *m, const char *what, va_list values)
{
    char few[512], *text = few;
    va_list again;

    if (h->message == NULL)
        return;
    va_copy(again, values);
    const int length = vsnprintf(few, sizeof few, what, values);
    if (length >= (int)sizeof few && (text = malloc((size_t)length + 1)) != NULL)
        (void)vsnprintf(text, (size_t)length + 1, what, again);
    va_end(again);
    m->what = text != NULL ? text : few;
    h->message(h->context, m);
    if (text != few)
        free(text);
}

int host_error(host *h, int code, const char *name, host_place at, const char *remedy,
               const char *what, ...)
{
    host_message m = { .code = code, .name = name, .at = at, .remedy = remedy };
    va_list values;

    h->errors++;
    va_start(values, what);
    tell(h, &m, what, values);
    va_end(values);
    return code;
}

void host_warn(host *h, const char *name, host_place at, const char *remedy, const char *what, ...)
{
    host_message m = { .code = EX_OK, .name = name, .at = at, .remedy = remedy };
    va_list values;

    h->warnings++;
    va_start(values, what);
    tell(h, &m, what, values);
    va_end(values);
}

const char *host_words(char out[HOST_WORDS], const char *format, ...)
{
    va_list values;

    va_start(values, format);
    (void)vsnprintf(out, HOST_WORDS, format, values);
    va_end(values);
    return out;
}

int host_code(const host *h, unsigned warnings, int code)
{
    return code == 0 && h->strict && h->warnings > warnings ? EX_DATAERR : code;
}

bool host_goes_on(host *h, const host_progress *p)
{
    if (h->progress == NULL)
        return true;
    if (h->now != NULL) {
        const double now = h->now(h->context);
        if (h->shows && now - h->shown < OFTEN)
            return true;
        h->shown = now;
    }
    h->shows = true;
    return h->progress(h->context, p);
}

void host_has_done(host *h)
{
    const host_progress p = { .doing = NULL };

    if (h->shows)
        (void)h->progress(h->context, &p);
    h->shows = false;
}


// Sinks
// -----

void host_put_line(FILE *out, const host_message *m, const char *before, const char *behind)
{
    const char *file = m->at.file, *remedy = m->remedy;

    (void)say(out, "%s", before);
    if (file != NULL)
        (void)say(out, "%s:", file);
    if (file != NULL && m->at.line > 0)
        (void)say(out, "%u:", m->at.line);
    (void)say(out, "%s%s%s%s%s\n", file != NULL ? " " : "", m->what, remedy != NULL ? ": " : "",
              remedy != NULL ? remedy : "", behind);
}

static void put_pair(FILE *out, const char *key, const char *text)
{
    fprintf(out, ",\"%s\":", key);
    if (text != NULL)
        say_quoted(out, text);
    else
        fputs("null", out);
}

void host_put_json(FILE *out, const host_message *m)
{
    fprintf(out, "{\"code\":%d", m->code);
    put_pair(out, "name", m->name);
    put_pair(out, "file", m->at.file);
    fprintf(out, ",\"line\":%u", m->at.line);
    put_pair(out, "what", m->what);
    put_pair(out, "remedy", m->remedy);
    fputc('}', out);
}
