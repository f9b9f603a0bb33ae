/* ports/atmega328p/slots.h -- the pins of slots, in assembly: the bytes of PORTD, and the interrupt
 * that gives them
 * SPDX-License-Identifier: MIT
 *
 * The ring is the first RING bytes of RAM, which begin a page, so an index is the low half of an
 * address. What the interrupt and the maker of slots share are three registers that one instruction
 * reaches:
 *
 *     RING_TAIL     the next slot to give: the interrupt
 *     RING_FILLED   slots in the ring: the interrupt, and the maker while interrupts are off
 *     RING_WORK     work begins when fewer are left; 0: there is none to do, or it is being done
 */
#ifndef LOFT_ATMEGA328P_SLOTS_H
#define LOFT_ATMEGA328P_SLOTS_H

#include <avr/interrupt.h>
#include <avr/io.h>

#include "machine/step.h"       /* loft_step_tick, loft_step_give */

#define STEPS       0x1C        /* of PORTD; the directions are the three bits above */
#define RX_PULL     0x01
#define RING        128
#define RING_TAIL   GPIOR1
#define RING_FILLED GPIOR2
#define RING_WORK   GPIOR0

#ifndef LOFT_INVERT
#  define LOFT_INVERT 0         /* bits of PORTD to invert */
#endif
#ifndef LOFT_PULSE
#  define LOFT_PULSE 32         /* cycles of a pulse, 16..: 2 us are enough for all drivers */
#endif


/* The linker puts it at the beginning of RAM: port.mk. */
static volatile uint8_t ring[RING] __attribute__((section(".ring,\"aw\",@nobits;"), used));


// Making
// ------

/* The slots of a tick whose pulses are carries (lib/machine/step.c), 17 cycles each. A byte is
 * shifted by five, so the directions begin as its lowest bits. The fourth shift pushes bit 4 out,
 * which the fifth brings back as the pull-up of RX. */
static inline void give_carries(loft_step_axis axis[LOFT_AXES], uint8_t *slot, uint8_t count,
                                uint8_t dir)
{
    unsigned p0 = axis[0].phase, p1 = axis[1].phase, p2 = axis[2].phase;
    uint8_t b;

    __asm__ volatile("1: mov %[b], %[k]\n"
                     "   add %A[p2], %A[r2]\n adc %B[p2], %B[r2]\n rol %[b]\n"
                     "   add %A[p1], %A[r1]\n adc %B[p1], %B[r1]\n rol %[b]\n"
                     "   add %A[p0], %A[r0]\n adc %B[p0], %B[r0]\n rol %[b]\n"
                     "   lsl %[b]\n rol %[b]\n"
#if LOFT_INVERT
                     "   eor %[b], %[invert]\n"
#endif
                     "   st %a[slot]+, %[b]\n dec %[count]\n brne 1b\n"
                     : [p0] "+&r"(p0), [p1] "+&r"(p1), [p2] "+&r"(p2), [slot] "+&e"(slot),
                       [count] "+&r"(count), [b] "=&r"(b)
                     : [r0] "r"(axis[0].rate), [r1] "r"(axis[1].rate), [r2] "r"(axis[2].rate),
                       [k] "r"((uint8_t)((dir & 7u) | 0x10u))
#if LOFT_INVERT
                           ,
                       [invert] "r"((uint8_t)LOFT_INVERT)
#endif
                     : "memory");
    axis[0].phase = p0;
    axis[1].phase = p1;
    axis[2].phase = p2;
}

/* The bytes of `count` slots of loft_step_take; `dir`: bit i is axis i. */
static inline void give_slots(loft_step_tick *taken, uint8_t *slot, uint8_t count, uint8_t dir)
{
    const uint8_t rest = (uint8_t)(dir << 5 | RX_PULL) ^ LOFT_INVERT;

    if (taken && loft_step_short(taken)) {
        give_carries(taken->axis, slot, count, dir);
        return;
    }
    if (taken)
        loft_step_give(taken, slot, count);
    for (; count; count--, slot++)
        *slot = taken ? rest ^ (uint8_t)(*slot << 2) : rest;
}


// Giving
// ------

/* Wait `cycles` with r30. */
#define WAIT(cycles)                                                                               \
    ".if " cycles " > 3\n ldi r30, (" cycles ") / 3\n 9: dec r30\n brne 9b\n"                      \
    ".rept (" cycles ") %% 3\n nop\n .endr\n"                                                      \
    ".else\n .rept " cycles "\n nop\n .endr\n .endif\n"

/* One slot. All pulses last LOFT_PULSE cycles, from one `out` to the next: what comes between them
 * is counted. If the ring is empty in mid-job, the pulses come later, and none is lost. */
static inline __attribute__((always_inline)) void give_a_slot(void)
{
    __asm__ volatile(
        "push r31\n push r24\n in r24, %[sreg]\n push r24\n push r30\n"
        "in r24, %[filled]\n subi r24, 1\n brcs 2f\n out %[filled], r24\n"
        "in r30, %[tail]\n ldi r31, hi8(%[ring])\n ld r31, Z\n out %[pins], r31\n"
        "inc r30\n andi r30, %[last]\n out %[tail], r30\n in r30, %[work]\n"
        "andi r31, %[rest]\n ori r31, %[invert]\n cp r24, r30\n brlo 1f\n" WAIT(
            "(%[pulse] - 16)") "pop r30\n pop r24\n out %[sreg], r24\n pop r24\n out %[pins], "
                               "r31\n pop r31\n reti\n"
                               "1:\n" WAIT(
                                   "(%[pulse] - 10)") "out %[pins], r31\n rjmp 3f\n"
                                                      "2: in r30, %[work]\n tst r30\n breq 4f\n"
                                                      "3: call loft_port_work_stub\n"
                                                      "4: pop r30\n pop r24\n out %[sreg], r24\n "
                                                      "pop r24\n pop r31\n reti\n"
        :
        : [sreg] "I"(_SFR_IO_ADDR(SREG)), [pins] "I"(_SFR_IO_ADDR(PORTD)),
          [filled] "I"(_SFR_IO_ADDR(RING_FILLED)), [tail] "I"(_SFR_IO_ADDR(RING_TAIL)),
          [work] "I"(_SFR_IO_ADDR(RING_WORK)), [ring] "i"(ring), [last] "M"(RING - 1),
          [rest] "M"(0xFF & ~STEPS), [invert] "M"(LOFT_INVERT & STEPS), [pulse] "n"(LOFT_PULSE)
        : "memory");
}

#endif
