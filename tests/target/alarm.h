/* tests/target/alarm.h -- the interrupt of alarm.c on a Cortex-M: the vector of SysTick
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_ALARM_H
#define LOFT_TARGET_ALARM_H

void alarm_interrupt(void);
void alarm_stop(void);

#endif
