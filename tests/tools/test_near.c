/* tests/tools/test_near.c -- a slip of a letter or two leads back to the word that was meant
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/near.h"
#include "check.h"

static const char *const words[] = { "stream",  "plan",      "simulate", "monitor",
                                     "flatten", "measure",   "compare",  "harmonic",
                                     "dry-run", "from-line", "max_speed" };
#define WORDS (sizeof words / sizeof *words)

/* Drop, double, change or swap letters. */
static void slip(arb *a, char *word)
{
    const size_t size = strlen(word), at = arb_below(a, (uint32_t)size - 1);
    const char other  = (char)('a' + arb_below(a, 26)), next = word[at + 1];

    switch (arb_below(a, 4)) {
    case 0: memmove(word + at, word + at + 1, size - at); break;
    case 1: memmove(word + at + 1, word + at, size - at + 1); break;
    case 2: word[at] = other; break;
    default:
        word[at + 1] = word[at];
        word[at]     = next;
        break;
    }
}

static void a_slip_leads_back(arb *a)
{
    const char *meant = words[arb_below(a, WORDS)];
    char word[64], text[160];

    snprintf(word, sizeof word, "%s", meant);
    slip(a, word);
    near_words n = { .word = word, .length = strlen(word) };
    for (size_t k = 0; k < WORDS; k++)
        near_try(&n, words[k]);
    CHECK(strstr(near_text(&n, "--", text), meant) != NULL);
    CHECK(strlen(text) < 158 && text[strlen(text) - 1] == '?');
}

static void others_are_not_guessed(arb *a)
{
    char word[200] = "", text[160];

    memset(word, 'A' + (int)arb_below(a, 26), arb_below(a, sizeof word));
    near_words n = { .word = word, .length = strlen(word) };
    for (size_t k = 0; k < WORDS; k++)
        near_try(&n, words[k]);
    CHECK(near_text(&n, "", text)[0] == '\0');
}

int main(void)
{
    PROPERTY(a_slip_leads_back, 500);
    PROPERTY(others_are_not_guessed, 200);
    return check_failures();
}
