/* tests/target/alarm.c -- signal and setitimer on the timer of each core: SysTick, or mtime
 * SPDX-License-Identifier: MIT
 */
#include "alarm.h"

#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/time.h>

#include "semihost.h"

static void (*volatile on_alarm)(int);

static void rung(void)
{
    void (*const handler)(int) = on_alarm;

    alarm_stop();
    if (handler != SIG_IGN)
        handler(SIGALRM);
}

#ifdef __riscv

#define REG(address)    (*(volatile uint32_t *)(uintptr_t)(address))
#define CMP             0x02004000      /* mtimecmp */
#define TIME            0x0200BFF8      /* mtime, 10 MHz */

void alarm_stop(void) { REG(CMP + 4) = 0xFFFFFFFF; }

/* Enable only the timer's interrupt, and not inside an interrupt, which must not be interrupted. */
static void let_interrupts_come(void)
{
    __asm__ volatile ("csrs mie, %0" : : "r" (1u << 7) : "memory");
    __asm__ volatile ("csrs mstatus, %0" : : "r" (8u) : "memory");
}

void setitimer(int which, const struct itimerval *once, struct itimerval *before)
{
    const uint32_t now = REG(TIME), high = REG(TIME + 4),
                   due = now + 10 * (uint32_t)once->it_value.tv_usec;

    (void)which;
    (void)before;
    REG(CMP + 4) = 0xFFFFFFFF;
    REG(CMP) = due;
    REG(CMP + 4) = high + (due < now);
}

__attribute__((interrupt("machine"), aligned(4))) void trap(void);
void trap(void)
{
    uint32_t cause;

    __asm__ volatile ("csrr %0, mcause" : "=r" (cause));
    if (cause == 0x80000007) {
        rung();
        return;
    }
    char where[] = "fault 00000000\n";
    for (int k = 0; k < 8; k++)
        where[6 + k] = "0123456789abcdef"[cause >> (28 - 4 * k) & 15];
    semihost_write(where);
    semihost_exit(70);
}

#else

#define SYST(offset)    (*(volatile uint32_t *)(uintptr_t)(0xE000E010u + (offset)))

void alarm_stop(void) { SYST(0) = 0; }

static void let_interrupts_come(void) {}        /* they are enabled from reset on */

void setitimer(int which, const struct itimerval *once, struct itimerval *before)
{
    (void)which;
    (void)before;
    SYST(0) = 0;
    SYST(4) = 25 * (uint32_t)once->it_value.tv_usec;
    SYST(8) = 0;
    SYST(0) = 7;
}

void alarm_interrupt(void) { rung(); }

#endif

void signal(int number, void (*handler)(int))
{
    (void)number;
    on_alarm = handler;
    alarm_stop();
    if (handler != SIG_IGN)
        let_interrupts_come();
}
