/* host-tools/read/reader.c
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/host.h"
#include "read/reader.h"

const reader *reader_of(host *h, const reader *const rows[], size_t count, const char *file,
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
        const host_place at = { file, 0 };
        if (best == NULL)
            (void)host_error(h, EX_DATAERR, "file.no-kind", at, "give SVG, G-code, CSV or .loft",
                             "is of no kind that loft knows");
        else
            (void)host_error(h, EX_DATAERR, "file.two-kinds", at, "save it as SVG",
                             "could be %s, or %s as well", best->name, other->name);
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
