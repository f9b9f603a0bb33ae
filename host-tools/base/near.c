/* host-tools/base/near.c
 * SPDX-License-Identifier: MIT
 */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/near.h"

#define LONGEST 40          /* letters of a word; others are not compared */

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

/* Wagner and Fischer, with swapped neighbours: row i has the distances of i letters of a. */
static size_t distance_of(const char *a, size_t m, const char *b, size_t n)
{
    size_t row[LONGEST + 1][LONGEST + 1];

    for (size_t i = 0; i <= m; i++)
        for (size_t j = 0; j <= n; j++) {
            if (i == 0 || j == 0) {
                row[i][j] = i + j;
                continue;
            }
            row[i][j] = least(row[i - 1][j - 1] + (a[i - 1] != b[j - 1]),
                              1 + least(row[i - 1][j], row[i][j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[i][j] = least(row[i][j], row[i - 2][j - 2] + 1);
        }
    return row[m][n];
}

void near_try(near_words *n, const char *candidate)
{
    const size_t size = strlen(candidate);

    if (n->length == 0 || n->length > LONGEST || size > LONGEST)
        return;
    char word[LONGEST + 1];
    snprintf(word, sizeof word, "%.*s", (int)n->length, n->word);
    const bool part       = n->length >= 3 && strstr(candidate, word) != NULL;
    const size_t distance = part ? 1 : distance_of(word, n->length, candidate, size);
    if (distance > (n->length + 2) / 3)
        return;
    size_t at = NEAR_MOST;
    while (at > 0 && (n->found[at - 1] == NULL || n->distance[at - 1] > distance))
        at--;
    for (size_t k = NEAR_MOST - 1; k > at; k--) {
        n->found[k]    = n->found[k - 1];
        n->distance[k] = n->distance[k - 1];
    }
    if (at < NEAR_MOST) {
        n->found[at]    = candidate;
        n->distance[at] = distance;
    }
}

char *near_text(const near_words *n, const char *before, char out[160])
{
    size_t used = 0;

    out[0] = '\0';
    for (size_t k = 0; k < NEAR_MOST && n->found[k] != NULL; k++) {
        const bool last = k + 1 == NEAR_MOST || n->found[k + 1] == NULL;
        used += (size_t)snprintf(out + used, 160 - used, "%s%s%s",
                                 k == 0 ? ": did you mean "
                                 : last ? " or "
                                        : ", ",
                                 before, n->found[k]);
    }
    if (used > 0 && used < 158)
        strcpy(out + used, "?");
    return out;
}
