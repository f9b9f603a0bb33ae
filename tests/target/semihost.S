/* tests/target/semihost.S -- semihost(operation, argument): the call to a debugger, on a Cortex-M and on RISC-V
 * SPDX-License-Identifier: MIT
 */
    .text
    .globl  semihost
    .balign 16
#ifdef __riscv
    .option norvc               /* the three instructions around ebreak are what is looked for; in one page */
semihost:
    slli    x0, x0, 0x1f
    ebreak
    srai    x0, x0, 7
    ret
#else
    .syntax unified
    .thumb_func
    .type   semihost, %function
semihost:
    bkpt    0xab
    bx      lr
#endif
