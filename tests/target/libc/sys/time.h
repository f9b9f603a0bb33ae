/* tests/target/libc/sys/time.h -- the timer of the core, once
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_SYS_TIME_H
#define LOFT_TARGET_SYS_TIME_H

#define ITIMER_REAL 0

struct timeval {
    long tv_sec, tv_usec;
};
struct itimerval {
    struct timeval it_interval, it_value;
};

/* An interrupt after about it_value.tv_usec < 1000 microseconds: the core's clock is assumed to be
 * 25 MHz. */
void setitimer(int which, const struct itimerval *once, struct itimerval *before);

#endif
