/* host-tools/source.c -- reading all of a file
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "source.h"
#include "tool.h"       /* tool_error, tool_grow, sysexits */

#define FILE_MAX ((size_t)512 << 20)    /* bytes; a drawing of the greatest number of curves is smaller */

/* All of `stream`; NULL on failure with errno set (EFBIG: more than FILE_MAX). */
static char *slurp(FILE *stream, size_t *size)
{
    size_t room = 1u << 16, used = 0;
    char *text = tool_grow(NULL, room + 1);

    for (;;) {
        used += fread(text + used, 1, room - used, stream);
        if (used < room)
            break;
        room *= 2;
        text = tool_grow(text, room + 1);
        if (used > FILE_MAX) {
            errno = EFBIG;
            free(text);
            return NULL;
        }
    }
    if (ferror(stream)) {
        free(text);
        return NULL;
    }
    text[used] = '\0';
    *size = used;
    return text;
}

static int unreadable(const char *file)
{
    switch (errno) {
    case ENOENT: return tool_error(EX_NOINPUT, "%s: no such file: check the name", file);
    case EISDIR: return tool_error(EX_NOINPUT, "%s: is a directory: give a file", file);
    case EACCES: return tool_error(EX_NOPERM, "%s: may not be read: check its permissions", file);
    case EFBIG:  return tool_error(EX_DATAERR, "%s: more than %zu MB: split the drawing", file, FILE_MAX >> 20);
    default:     return tool_error(EX_IOERR, "%s: cannot be read: %s", file, strerror(errno));
    }
}

const char *source_name(const char *file)
{
    return strcmp(file, "-") == 0 ? "standard input" : file;
}

/* Standard input is read once and kept, since a second reader may ask for it: is it a surface, or curves? */
static char *slurp_input(size_t *size)
{
    static char *kept;
    static size_t length;

    if (kept == NULL)
        kept = slurp(stdin, &length);
    if (kept == NULL)
        return NULL;
    *size = length;
    return memcpy(tool_grow(NULL, length + 1), kept, length + 1);
}

char *source_read(const char *file, size_t *size, int *code)
{
    const bool piped = strcmp(file, "-") == 0;
    FILE *stream = piped ? stdin : fopen(file, "rb");
    char *text = piped ? slurp_input(size) : stream ? slurp(stream, size) : NULL;

    *code = text ? 0 : unreadable(source_name(file));
    if (stream != NULL && !piped)
        fclose(stream);
    return text;
}

bool source_is_xml(const char *text)
{
    if (strncmp(text, "\xFE\xFF", 2) == 0 || strncmp(text, "\xFF\xFE", 2) == 0)
        return true;
    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    return text[strspn(text, " \t\r\n")] == '<';
}
