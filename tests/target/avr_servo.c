/* tests/target/avr_servo.c
 * SPDX-License-Identifier: MIT
 */
#include "avr_servo.h"

#include <string.h>

#define TCCR2A 0xB0
#define TCCR2B 0xB1
#define OCR2A  0xB3
#define BY_32  3                /* of TCCR2B */
#define CLEARS 2                /* of the two high bits of TCCR2A */
#define SETS   3

void avr_servo_init(struct avr_servo *s, avr_t *avr)
{
    static const uint16_t own[] = { TCCR2A, TCCR2B, OCR2A };

    *s = (struct avr_servo){ .avr = avr };
    for (avr_io_t *io = avr->io_port; io; io = io->next)
        if (strcmp(io->kind, "timer") == 0 && ((avr_timer_t *)io)->name == '2')
            s->timer = (avr_timer_t *)io;
    for (unsigned i = 0; i < sizeof own / sizeof own[0]; i++)
        avr->io[AVR_DATA_TO_IO(own[i])].w.c = NULL;
}

static void match(struct avr_servo *s, uint64_t cycle, FILE *record)
{
    const unsigned does = s->avr->data[TCCR2A] >> 6;

    if (does == SETS && s->rose == 0)
        s->rose = cycle;
    if (does == CLEARS && s->rose != 0) {
        if (record)
            fprintf(record, "# servo = %.2f us, from slot %llu\n", (double)(cycle - s->rose) / 16,
                    (unsigned long long)s->rose);
        s->rose = 0;
    }
    avr_raise_interrupt(s->avr, &s->timer->comp[AVR_TIMER_COMPA].interrupt);
}

void avr_servo_run(struct avr_servo *s, FILE *record)
{
    const uint8_t *data = s->avr->data;
    const uint64_t now  = s->avr->cycle / 32;

    if (s->counted == now)
        return;
    if (data[TCCR2B] == BY_32 && (data[TCCR2A] & 3) == 0)
        for (uint64_t k = s->counted + 1; k <= now; k++)
            if ((uint8_t)k == data[OCR2A])
                match(s, k * 32, record);
    s->counted = now;
}
