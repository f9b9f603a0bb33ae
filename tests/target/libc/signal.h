/* tests/target/libc/signal.h -- an interrupt replaces an alarm
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_SIGNAL_H
#define LOFT_TARGET_SIGNAL_H

#define SIGALRM 14
#define SIG_IGN ((void (*)(int))1)

/* The timer's interrupt calls `handler`; SIG_IGN stops the timer. */
void signal(int number, void (*handler)(int));

#endif
