/* host-tools/base/say.c
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "base/say.h"

#define ESCAPED 12          /* bytes of an escaped character, at most, with its end */

/* Cc, Cf, Zl, Zp and what is no character, of Unicode 15; the joiners U+200C and U+200D, which
 * spell words and pictures, are not among them. */
static const struct {
    int32_t first, last;
} hidden[] = {
    { 0x0000, 0x001f },   { 0x007f, 0x009f },   { 0x00ad, 0x00ad },   { 0x0600, 0x0605 },
    { 0x061c, 0x061c },   { 0x06dd, 0x06dd },   { 0x070f, 0x070f },   { 0x0890, 0x0891 },
    { 0x08e2, 0x08e2 },   { 0x180e, 0x180e },   { 0x200b, 0x200b },   { 0x200e, 0x200f },
    { 0x2028, 0x202e },   { 0x2060, 0x206f },   { 0xd800, 0xdfff },   { 0xfdd0, 0xfdef },
    { 0xfeff, 0xfeff },   { 0xfff9, 0xfffb },   { 0xfffe, 0xffff },   { 0x110bd, 0x110bd },
    { 0x110cd, 0x110cd }, { 0x13430, 0x1343f }, { 0x1bca0, 0x1bca3 }, { 0x1d173, 0x1d17a },
    { 0xe0000, 0xe007f },
};

bool say_hides(int32_t c)
{
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++)
        if (c >= hidden[i].first && c <= hidden[i].last)
            return true;
    return (c & 0xfffe) == 0xfffe;      /* the last two of each plane */
}

/* Decode UTF-8 (RFC 3629). Returns how many bytes; 0: it is none, or longer than need be. */
static int decode(const unsigned char *s, int32_t *out)
{
    static const int32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const int size = s[0] < 0x80 ? 1 : s[0] < 0xc0 ? 0 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : 4;
    int32_t c      = size == 1 ? s[0] : s[0] & (0x7f >> size);

    for (int k = 1; k < size; k++) {
        if ((s[k] & 0xc0) != 0x80)
            return 0;
        c = c << 6 | (s[k] & 0x3f);
    }
    *out = c;
    return size > 0 && s[0] < 0xf8 && c >= least[size] && c <= 0x10ffff ? size : 0;
}

int say_character(const char *text, int32_t *seen)
{
    int32_t c      = -1;
    const int size = decode((const unsigned char *)text, &c);

    *seen = size > 0 ? c : -1;
    return size > 0 && !(c >= 0xd800 && c <= 0xdfff) ? size : (*seen = -1, 1);
}

/* Append a character, visible. Returns how many bytes of the text it had. */
static int put(const char *text, char out[ESCAPED])
{
    int32_t c;
    const int size = say_character(text, &c);

    if (c < 0 || c < 0x80)
        snprintf(out, ESCAPED, c < 0 || say_hides(c) ? "\\x%02x" : "%c", (unsigned char)*text);
    else if (say_hides(c))
        snprintf(out, ESCAPED, "\\u%04x", (unsigned)c);
    else
        snprintf(out, ESCAPED, "%.*s", size, text);
    return size;
}

char *say_copy(char out[], size_t room, const char *text)
{
    char one[ESCAPED];
    size_t used = 0;

    for (; *text != '\0'; used += strlen(one)) {
        text += put(text, one);
        if (used + strlen(one) >= room)
            break;
        memcpy(out + used, one, strlen(one));
    }
    if (room > 0)
        out[used] = '\0';
    return out;
}

void say_quoted(FILE *out, const char *text)
{
    int32_t c;

    putc('"', out);
    for (int size; *text != '\0'; text += size) {
        size = say_character(text, &c);
        if (c < 0)
            c = (unsigned char)*text;
        else if (!say_hides(c) && c != '"' && c != '\\') {
            fwrite(text, 1, (size_t)size, out);
            continue;
        }
        if (c > 0xffff)
            fprintf(out, "\\u%04x", (unsigned)(0xd7c0 + (c >> 10)));
        fprintf(out, "\\u%04x", (unsigned)(c > 0xffff ? 0xdc00 + (c & 0x3ff) : c));
    }
    putc('"', out);
}

int say_list(FILE *out, const char *format, va_list values)
{
    va_list again;
    char one[ESCAPED], short_text[512], *text = short_text;
    bool good = true;

    va_copy(again, values);
    const int length = vsnprintf(short_text, sizeof short_text, format, values);
    if (length >= (int)sizeof short_text) {
        text = malloc((size_t)length + 1);
        if (text != NULL)
            (void)vsnprintf(text, (size_t)length + 1, format, again);
        else
            text = short_text;          /* its beginning is better than nothing */
    }
    va_end(again);
    const size_t size = strlen(format);
    const bool line   = length > 0 && size > 0 && format[size - 1] == '\n';
    if (line && strlen(text) == (size_t)length)
        text[length - 1] = '\0';
    for (const char *at = text; length > 0 && *at != '\0';) {
        at += put(at, one);
        good = fputs(one, out) >= 0 && good;
    }
    if (line)
        good = fputc('\n', out) >= 0 && good;
    if (text != short_text)
        free(text);
    return length < 0 || !good ? -1 : length;
}

int say(FILE *out, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    const int length = say_list(out, format, values);
    va_end(values);
    return length;
}
