/* host-tools/base/option_json.c -- options: from a JSON object into a struct
 * SPDX-License-Identifier: MIT
 *
 * An object of strings, numbers, true, false, null and arrays of strings and numbers (RFC 8259).
 * Texts are decoded where they are: a decoded one is never longer.
 */
#include <stdio.h>
#include <string.h>

#include "base/option.h"

enum json_kind { JSON_TEXT, JSON_NUMBER, JSON_TRUE, JSON_FALSE, JSON_NULL };

typedef struct {
    option_reading r;
    char *at;
    char next;                  /* what stood behind the last value: , ] } */
    const char **word;
} json;

static int broken(json *j, const char *what)
{
    return option_wrong(&j->r, "option.json", "%s before \"%.40s\": give an object of JSON", what,
                        j->at);
}

static void skip_blanks(json *j) { j->at += strspn(j->at, " \t\r\n"); }

static int take_character(json *j, char wanted)
{
    skip_blanks(j);
    if (*j->at != wanted)
        return broken(j, "something is missing");
    j->at++;
    return 0;
}


// Strings
// -------

static bool read_hex(const char *text, unsigned *out)
{
    *out = 0;
    for (int i = 0; i < 4; i++) {
        static const char digits[] = "0123456789abcdef0123456789ABCDEF";
        const char *digit          = text[i] ? strchr(digits, text[i]) : NULL;
        if (digit == NULL)
            return false;
        *out = *out * 16 + (unsigned)(digit - digits) % 16;
    }
    return true;
}

static char *put_utf8(char *out, unsigned c)
{
    if (c < 0x80) {
        *out++ = (char)c;
        return out;
    }
    if (c < 0x800) {
        *out++ = (char)(0xc0 | c >> 6);
    } else {
        if (c < 0x10000) {
            *out++ = (char)(0xe0 | c >> 12);
        } else {
            *out++ = (char)(0xf0 | c >> 18);
            *out++ = (char)(0x80 | (c >> 12 & 63));
        }
        *out++ = (char)(0x80 | (c >> 6 & 63));
    }
    *out++ = (char)(0x80 | (c & 63));
    return out;
}

/* Behind a backslash. A text does not contain zeros, nor halves of pairs. */
static bool unescape(char **at, char **out)
{
    static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
    const char *plain = **at ? strchr(from, **at) : NULL;
    unsigned c = 0, low;

    if (plain != NULL) {
        *(*out)++ = to[plain - from];
        (*at)++;
        return true;
    }
    if (**at != 'u' || !read_hex(*at + 1, &c) || c == 0)
        return false;
    *at += 5;
    if (c >= 0xd800 && c < 0xe000) {
        if (c >= 0xdc00 || (*at)[0] != '\\' || (*at)[1] != 'u' || !read_hex(*at + 2, &low) ||
            low < 0xdc00 || low >= 0xe000)
            return false;
        *at += 6;
        c = 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00);
    }
    *out = put_utf8(*out, c);
    return true;
}

/* From the first quote on. *end is where the text is to end. */
static int read_string(json *j, char **text, char **end)
{
    char *out = ++j->at;

    *text = out;
    while (*j->at != '"') {
        const unsigned char c = (unsigned char)*j->at;
        if (c < ' ')
            return broken(j, "a string does not end");
        j->at++;
        if (c != '\\')
            *out++ = (char)c;
        else if (!unescape(&j->at, &out))
            return broken(j, "an unknown escape");
    }
    j->at++;
    *end = out;
    return 0;
}


// Values
// ------

static int read_plain(json *j, char **text, char **end, enum json_kind *kind)
{
    static const char *const names[] = {
        [JSON_TRUE] = "true", [JSON_FALSE] = "false", [JSON_NULL] = "null"
    };
    const size_t size = strcspn(j->at, " \t\r\n,]}");

    *text = j->at;
    *end  = j->at + size;
    *kind = JSON_NUMBER;
    for (int k = JSON_TRUE; k <= JSON_NULL; k++)
        if (strlen(names[k]) == size && strncmp(j->at, names[k], size) == 0)
            *kind = (enum json_kind)k;
    if (*kind == JSON_NUMBER && (size == 0 || strspn(j->at, "0123456789+-.eE") != size))
        return broken(j, "not a value");
    j->at += size;
    return 0;
}

/* A value and the character behind it, which is needed no more. */
static int read_value(json *j, char **text, enum json_kind *kind)
{
    char *end = NULL;
    int code;

    skip_blanks(j);
    *kind = JSON_TEXT;
    code  = *j->at == '"' ? read_string(j, text, &end) : read_plain(j, text, &end, kind);
    if (code != 0)
        return code;
    skip_blanks(j);
    j->next = *j->at;
    if (j->next == '\0' || strchr(",]}", j->next) == NULL)
        return broken(j, "something is missing");
    j->at++;
    *end = '\0';
    return 0;
}

static int needs_value(json *j, const option *o)
{
    return option_wrong(&j->r, "option.value", "--%s needs a value", o->name);
}

static int take_words(json *j, size_t row, size_t count)
{
    const option *o   = j->r.all[row].row;
    option_words *out = (option_words *)((char *)j->r.o + j->r.all[row].offset);

    if ((double)count > o->most)
        return option_wrong(&j->r, "option.words", "%s: give fewer words", o->name);
    j->r.given[row] = count > 0;
    if (count > 0)
        *out = (option_words){ j->word, count };
    return 0;
}

static int take_scalar(json *j, size_t row)
{
    const option *o = j->r.all[row].row;
    enum json_kind kind;
    char *text;
    int code = read_value(j, &text, &kind);

    if (code != 0 || kind == JSON_NULL)
        return code;
    if (o->kind == OPTION_IS_FLAG && kind != JSON_TRUE && kind != JSON_FALSE)
        return option_wrong(&j->r, "option.form", "--%s %.200s: give true or false", o->name, text);
    if (o->kind == OPTION_IS_FLAG ||
        (o->kind == OPTION_IS_MAYBE && (kind == JSON_TRUE || kind == JSON_FALSE)))
        return kind == JSON_TRUE ? option_take(&j->r, row, NULL) : 0;
    if (kind == JSON_TRUE || kind == JSON_FALSE)
        return needs_value(j, o);
    if (o->kind != OPTION_IS_WORDS)
        return option_take(&j->r, row, text);
    *j->word = text;
    return take_words(j, row, 1);
}

/* Behind the bracket: words, or the numbers of a list as one text. */
static int take_array(json *j, size_t row)
{
    const option *o = j->r.all[row].row;
    char *text, *begin = j->at, *out = j->at;
    enum json_kind kind;
    size_t words = 0;

    if (o->kind != OPTION_IS_WORDS && o->kind != OPTION_IS_LIST)
        return option_wrong(&j->r, "option.form", "--%s: give one value, no array", o->name);
    skip_blanks(j);
    for (j->next = *j->at == ']' ? *j->at++ : ','; j->next == ',';) {
        const int code = read_value(j, &text, &kind);
        if (code != 0)
            return code;
        if (kind > JSON_NUMBER)
            return needs_value(j, o);
        if (o->kind == OPTION_IS_WORDS && words < OPTION_JSON_WORDS) {
            j->word[words++] = text;
            continue;
        }
        if (o->kind == OPTION_IS_WORDS)
            return take_words(j, row, (size_t)-1);
        const size_t size = strlen(text);
        memmove(out, text, size);
        out += size;
        *out++ = ',';
    }
    if (j->next != ']')
        return broken(j, "an array does not end");
    skip_blanks(j);
    j->next = *j->at;
    j->at += j->next != '\0';
    if (o->kind == OPTION_IS_WORDS)
        return take_words(j, row, words);
    if (out == begin)
        return 0;
    out[-1] = '\0';
    return option_take(&j->r, row, begin);
}

static size_t row_of(const json *j, const char *name)
{
    for (size_t i = 0; i < j->r.count; i++) {
        const option *o = j->r.all[i].row;
        if (o->name != NULL && strcmp(o->name, name) == 0 && o->kind < OPTION_IS_GROUP)
            return i;
    }
    return j->r.count;
}

static int take_member(json *j)
{
    char *name, *end;
    int code = 0;

    skip_blanks(j);
    code = *j->at == '"' ? read_string(j, &name, &end)
                         : broken(j, "the name of an option is missing");
    if (code == 0)
        code = take_character(j, ':');
    if (code != 0)
        return code;
    *end = '\0';
    const size_t row = row_of(j, name);
    if (row == j->r.count)
        return option_unknown(&j->r, name);
    if (j->r.given[row])
        return option_wrong(&j->r, "option.json", "%.200s: is given twice: give it once", name);
    skip_blanks(j);
    if (*j->at != '[')
        return take_scalar(j, row);
    j->at++;
    return take_array(j, row);
}

int options_read_json(const option rows[], char *text, const char *word[OPTION_JSON_WORDS], void *o,
                      option_fault *f)
{
    json j   = { .at = text, .word = word };
    int code = option_begin(&j.r, rows, o, f);

    if (code == 0)
        code = take_character(&j, '{');
    skip_blanks(&j);
    for (j.next = *j.at == '}' ? *j.at++ : ','; code == 0 && j.next == ',';)
        code = take_member(&j);
    if (code != 0)
        return code;
    skip_blanks(&j);
    return j.next != '}' || *j.at != '\0' ? broken(&j, "the object does not end")
                                          : option_end(&j.r);
}
