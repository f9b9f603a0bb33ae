/* lib/wire/action_code.c
 * SPDX-License-Identifier: MIT
 *
 * In an item, p[0][0] is the word that is sent, level + 65536 feed, and p[1][0] is the byte `what`:
 * the output, and 128 for `moving`. The other numbers of p[0] and p[1] are 0.
 */
#include "wire/action_code.h"

#include "wire/varint.h"    /* loft_varint_encode */

#define MOVING 0x80u

void loft_action_item(loft_item *item, const loft_action *action, const int32_t place[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        item->p[0][i] = item->p[1][i] = 0;
        item->p[2][i] = place[i];
    }
    item->p[0][0] = loft_word_signed((uint32_t)action->feed << 16 | action->level);
    item->p[1][0] = (int32_t)(action->output | (action->moving ? MOVING : 0));
    item->ticks   = 0;
}

loft_action loft_item_action(const volatile loft_item *item)
{
    const uint32_t word = (uint32_t)item->p[0][0];
    const uint8_t what  = (uint8_t)item->p[1][0];
    loft_action a;

    a.output = (uint8_t)(what & LOFT_OUTPUTS_MOST);
    a.moving = (what & MOVING) != 0;
    a.level  = (uint16_t)(word & 0xFFFFu);
    a.feed   = (uint16_t)(word >> 16);
    return a;
}

/* 0, which no span begins with; what; the word; where it ends, from where it begins */
uint8_t loft_action_encode(uint8_t *byte, const loft_predictor *p, const loft_item *item)
{
    uint8_t n = 2;

    byte[0] = 0;
    byte[1] = (uint8_t)item->p[1][0];
    n       = (uint8_t)(n + loft_varint_encode(byte + n, (uint32_t)item->p[0][0]));
    for (int i = 0; i < LOFT_AXES; i++)
        n = (uint8_t)(n + loft_residual_encode(byte + n, (uint32_t)item->p[2][i] - p->position[i]));
    return n;
}

const uint8_t *loft_action_decode(const uint8_t *byte, loft_predictor *p, loft_item *item)
{
    const uint8_t what = byte[1];

    byte += 2;
    const uint32_t word = loft_varint_decode(&byte);
    for (int i = 0; i < LOFT_AXES; i++) {
        p->position[i] += loft_residual_decode(&byte);
        p->change[i] = p->bend[i] = 0;
        item->p[0][i] = item->p[1][i] = 0;
        item->p[2][i] = loft_word_signed(p->position[i]);
    }
    item->p[0][0] = loft_word_signed(word);
    item->p[1][0] = what;
    item->ticks = p->ticks = 0;
    return byte;
}

uint8_t loft_action_size(const uint8_t *byte, uint8_t left)
{
    uint8_t size = 2;

    if (left < 2 || byte[0] != 0 || byte[1] & ~(MOVING | LOFT_OUTPUTS_MOST))
        return 0;
    for (uint8_t i = 0; i < 1 + LOFT_AXES; i++) {
        const uint8_t n = loft_varint_size(byte + size, (uint8_t)(left - size));
        if (n == 0)
            return 0;
        size = (uint8_t)(size + n);
    }
    return size;
}
