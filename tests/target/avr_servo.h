/* tests/target/avr_servo.h -- timer 2 of an emulated ATmega328P in its normal mode, and the pulses
 * that it gives on D11
 * SPDX-License-Identifier: MIT
 *
 * simavr 1.6 begins to count anew at each write to OCR2A, so the timer is counted here.
 */
#ifndef TARGET_AVR_SERVO_H
#define TARGET_AVR_SERVO_H

#include <simavr/avr_timer.h>
#include <stdio.h>

struct avr_servo {
    avr_t *avr;
    avr_timer_t *timer;
    uint64_t counted, rose;         /* counts of 32 cycles; the cycle, 0: the pin is low */
};

/* Take timer 2 from simavr. */
void avr_servo_init(struct avr_servo *s, avr_t *avr);

/* After each instruction. Writes a line for each pulse that is over, if there is a file. */
void avr_servo_run(struct avr_servo *s, FILE *record);

#endif
