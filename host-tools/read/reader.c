/* host-tools/read/reader.c
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/tool.h"      /* tool_error, sysexits */
#include "read/reader.h"

const reader *reader_of(const reader *const rows[], size_t count, const char *file,
                        const char *text, size_t size)
{
    const reader *best = NULL, *other = NULL;
    int most = READER_NOT;

    for (size_t i = 0; i < count; i++) {
        const int score = rows[i]->probe(rows[i], file, text, size);
        if (score > most) {
            most  = score;
            best  = rows[i];
            other = NULL;
        } else if (score == most && best != NULL) {
            other = rows[i];
        }
    }
    if (best == NULL || other != NULL) {
        (void)tool_error(EX_DATAERR,
                         best == NULL ? "%s: is of no kind that loft knows: give SVG, G-code, CSV "
                                        "or .loft"
                                      : "%s: could be %s, or %s as well: save it as SVG",
                         file, best ? best->name : "", other ? other->name : "");
        return NULL;
    }
    return best;
}

int reader_by_magic(const reader *r, const char *file, const char *text, size_t size)
{
    (void)file;
    return size >= r->magic_size && memcmp(text, r->magic, r->magic_size) == 0 ? READER_MAGIC
                                                                               : READER_NOT;
}
