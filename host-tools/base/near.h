/* host-tools/base/near.h -- finds the word that was meant
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NEAR_H
#define LOFT_NEAR_H

#include <stddef.h>

#define NEAR_MOST 3             /* words that are suggested */

/* Initialize with { word, its length }. */
typedef struct {
    const char *word;
    size_t length;
    const char *found[NEAR_MOST];       /* the nearest first; NULL: no more */
    size_t distance[NEAR_MOST];
} near_words;

/* Add the candidate if it may be meant: at most a third of the letters differ, are missing, too
 * many or swapped (the distance of Damerau and Levenshtein), or the word is a part of it. */
void near_try(near_words *n, const char *candidate);

/* ": did you mean a, b or c?", or "". Returns `out`. */
char *near_text(const near_words *n, const char *before, char out[160]);

#endif
