/* host-tools/base/source.c -- reads a file, whole or in parts
 * SPDX-License-Identifier: MIT
 *
 * zlib unpacks a file that is packed with gzip (.svgz) while it is read.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/host.h"
#include "base/memory.h"     /* memory_grow */
#include "base/source.h"

/* bytes; a drawing with the largest number of curves is smaller */
#define FILE_MAX ((size_t)512 << 20)

/* What unpacks to more than this, and to so many times its size, is a trap: text that somebody
 * wrote packs to a fiftieth at best, and gzip packs nothing to less than 1/1032. */
#define TRAP_LEAST ((size_t)32 << 20)
#define TRAP_TIMES 400

#define SLICE_MAX (64u << 20)           /* bytes; requested at once */
#define PART      (256u << 10)          /* bytes of whole lines */
#define LINE_MOST (1 << 20)

static bool is_trap(gzFile stream, size_t used)
{
    const z_off_t packed = used > TRAP_LEAST && stream != NULL ? gzoffset(stream) : -1;

    return packed > 0 && used / TRAP_TIMES > (size_t)packed;
}

/* Read all of `stream`. Returns NULL on failure and sets errno (EFBIG: more than FILE_MAX; EBADMSG:
 * damaged gzip; EOVERFLOW: a trap). */
static char *slurp_stream(gzFile stream, size_t *size)
{
    size_t room = 1u << 16, used = 0;
    char *text = memory_grow(NULL, room + 1);

    for (;;) {
        const size_t left = room - used;
        const int got = gzread(stream, text + used,
                               (unsigned)(left < SLICE_MAX ? left : SLICE_MAX));
        int status;
        (void)gzerror(stream, &status);
        if (got < 0 || (got == 0 && status != Z_OK && status != Z_STREAM_END)) {
            errno = status == Z_ERRNO ? errno : EBADMSG;
            break;
        }
        used += (size_t)got;
        if (got == 0) {
            text[used] = '\0';
            *size = used;
            return text;
        }
        if (used > FILE_MAX || is_trap(stream, used)) {
            errno = used > FILE_MAX ? EFBIG : EOVERFLOW;
            break;
        }
        if (used == room)
            text = memory_grow(text, (room *= 2) + 1);
    }
    free(text);
    return NULL;
}

/* A file that is larger than it may be, packed or not, need not be read to know it. */
static bool is_too_large(int handle)
{
    struct stat is = { .st_size = 0 };

    return handle >= 0 && fstat(handle, &is) == 0 && is.st_size > (off_t)FILE_MAX;
}

/* Read everything from `handle`, and close it. */
static char *slurp(int handle, size_t *size)
{
    if (is_too_large(handle)) {
        close(handle);
        errno = EFBIG;
        return NULL;
    }
    gzFile stream = handle < 0 ? NULL : gzdopen(handle, "rb");
    char *text = stream ? slurp_stream(stream, size) : NULL;
    const int why = errno;

    if (stream != NULL)
        gzclose_r(stream);
    errno = why;
    return text;
}

static int unreadable(host *h, const char *file)
{
    const host_place at = { file, 0 };

    switch (errno) {
    case ENOENT:
        return host_error(h, EX_NOINPUT, "file.missing", at, "check the name", "no such file");
    case EISDIR:
        return host_error(h, EX_NOINPUT, "file.directory", at, "give a file", "is a directory");
    case EACCES:
        return host_error(h, EX_NOPERM, "file.no-permission", at, "check its permissions",
                          "may not be read");
    case EBADMSG:
        return host_error(h, EX_DATAERR, "file.damaged", at, "fetch or pack it again",
                          "is compressed, and damaged or cut off");
    case EOVERFLOW:
        return host_error(h, EX_DATAERR, "file.unpacks-too-large", at,
                          "unpack it, if that is right", "unpacks to more than %d times its size",
                          TRAP_TIMES);
    case EFBIG:
        return host_error(h, EX_DATAERR, "file.too-large", at, "split the file", "more than %zu MB",
                          FILE_MAX >> 20);
    default:
        return host_error(h, EX_IOERR, "file.not-read", at, NULL, "cannot be read: %s",
                          strerror(errno));
    }
}

const char *source_name(const char *file)
{
    return strcmp(file, "-") == 0 ? "standard input" : file;
}

const option source_rows[] = { { "points", OPTION_TEXT(source_given, points), .value = "POINTS",
      .help = "the control points themselves: \"0,0 1,2 3,0\"" },
                               { "file", OPTION_WORD(source_given, file), .value = "FILE",
                                 .standard = "-" },
    OPTION_EXCLUDES("points", "file", NULL),
                               { 0 } };

const char *source_given_name(const source_given *from)
{
    return from->points ? "--points" : source_name(from->file);
}

/* Standard input is read once and kept, since two readers may want it: the one for surfaces, then
 * the one for curves. */
static char *slurp_input(host *h, size_t *size)
{
    if (h->input.text == NULL)
        h->input.text = slurp(dup(STDIN_FILENO), &h->input.size);
    if (h->input.text == NULL)
        return NULL;
    *size = h->input.size;
    return memcpy(memory_grow(NULL, *size + 1), h->input.text, *size + 1);
}

char *source_read(host *h, const char *file, size_t *size, int *code)
{
    char *text = strcmp(file, "-") == 0 ? slurp_input(h, size)
                                        : slurp(open(file, O_RDONLY | O_CLOEXEC), size);

    *code = text ? 0 : unreadable(h, source_name(file));
    return text;
}


// In parts
// --------

int source_open(host *h, source *s, const char *file)
{
    const bool input = strcmp(file, "-") == 0;
    const int handle = input ? dup(STDIN_FILENO) : open(file, O_RDONLY | O_CLOEXEC);
    gzFile stream    = handle < 0 ? NULL : gzdopen(handle, "rb");

    struct stat is   = { .st_size = 0 };

    *s = (source){ .file = source_name(file), .stream = stream, .host = h };
    if (stream == NULL)
        return unreadable(h, s->file);
    (void)fstat(handle, &is);
    s->large = is.st_size > (off_t)FILE_MAX;
    s->total     = (double)is.st_size;
    s->buffer    = memory_grow(NULL, PART + 1);
    s->room      = PART;
    s->buffer[0] = '\0';
    s->text      = s->buffer;
    return source_part(s);
}

int source_whole(host *h, source *s, const char *file)
{
    int code;

    *s        = (source){ .file = source_name(file), .host = h };
    s->buffer = source_read(h, file, &s->size, &code);
    s->text   = s->buffer;
    s->used   = s->size;
    return code;
}

source source_text(const char *text, size_t size)
{
    return (source){ .text = text, .size = size, .used = size };
}

void source_close(source *s)
{
    if (s->stream != NULL)
        gzclose_r(s->stream);
    if (s->host != NULL)
        host_has_done(s->host);
    free(s->buffer);
    *s = (source){ .size = 0 };
}

/* Fill the buffer. At the end the stream is closed. */
static int fill(source *s)
{
    while (s->stream != NULL && s->used < s->room) {
        const size_t left = s->room - s->used;
        const int got = gzread(s->stream, s->buffer + s->used,
                               (unsigned)(left < SLICE_MAX ? left : SLICE_MAX));
        int status;
        (void)gzerror(s->stream, &status);
        if (got < 0 || (got == 0 && status != Z_OK && status != Z_STREAM_END)) {
            errno = status == Z_ERRNO ? errno : EBADMSG;
            return unreadable(s->host, s->file);
        }
        s->used += (size_t)got;
        if (got == 0) {
            gzclose_r(s->stream);
            s->stream = NULL;
        }
    }
    s->buffer[s->used] = '\0';
    return 0;
}

static void widen(source *s)
{
    s->buffer = memory_grow(s->buffer, (s->room *= 2) + 1);
    s->text   = s->buffer;
}

/* The whole lines in the buffer; all of it at the end, and if its first part has none. */
static int cut_part(source *s, bool first)
{
    const char *last = memrchr(s->buffer, '\n', s->used);

    s->size = s->stream == NULL || last == NULL ? s->used : (size_t)(last - s->buffer) + 1;
    s->held = s->buffer[s->size];
    s->buffer[s->size] = '\0';
    if (first || strlen(s->buffer) == s->size)
        return 0;
    return host_error(s->host, EX_DATAERR, "file.not-text", (host_place){ s->file, 0 }, NULL,
                      "is not text: there is a 0 in it");
}

static unsigned long lines_of(const char *text, size_t size)
{
    unsigned long count = 0;

    for (const char *at = text, *end = text + size;
         (at = memchr(at, '\n', (size_t)(end - at))) != NULL; at++)
        count++;
    return count;
}

int source_part(source *s)
{
    const bool first = s->used == 0;
    int code         = 0;

    if (s->buffer == NULL) {        /* a text is one part */
        s->size = 0;
        return 0;
    }
    if (!first && s->stream != NULL && s->total > 0) {
        const host_progress p = { "reading", (double)gzoffset(s->stream), s->total, false };
        if (!host_goes_on(s->host, &p))
            return EX_TEMPFAIL;
    }
    s->buffer[s->size] = s->held;
    s->lines += lines_of(s->buffer, s->size);
    s->used -= s->size;
    memmove(s->buffer, s->buffer + s->size, s->used);
    code = fill(s);
    while (code == 0 && s->stream != NULL && memrchr(s->buffer, '\n', s->used) == NULL) {
        if (s->room >= LINE_MOST && !first)
            return host_error(s->host, EX_DATAERR, "file.line-too-long",
                              (host_place){ s->file, (unsigned)s->lines + 1 }, "split it",
                              "a line of more than %d MB", LINE_MOST >> 20);
        if (s->room >= LINE_MOST)
            break;
        widen(s);
        code = fill(s);
    }
    return code == 0 ? cut_part(s, first) : code;
}

int source_rest(source *s)
{
    int code = 0;

    s->buffer[s->size] = s->held;
    while (code == 0 && s->stream != NULL && s->used <= FILE_MAX && !s->large) {
        if (is_trap(s->stream, s->used)) {
            errno = EOVERFLOW;
            return unreadable(s->host, s->file);
        }
        widen(s);
        code = fill(s);
    }
    if (code == 0 && (s->used > FILE_MAX || s->large)) {
        errno = EFBIG;
        return unreadable(s->host, s->file);
    }
    s->size = s->used;
    return code;
}

bool source_is_xml(const char *text)
{
    if (strncmp(text, "\xFE\xFF", 2) == 0 || strncmp(text, "\xFF\xFE", 2) == 0)
        return true;
    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    return text[strspn(text, " \t\r\n")] == '<';
}
