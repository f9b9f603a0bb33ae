/* tests/target/semihost.S -- semihost(operation, argument): the call to a debugger,
 * on a Cortex-M and on RISC-V
 * SPDX-License-Identifier: MIT
 */
    .text
    .globl  semihost
    .balign 16
#ifdef __riscv
    /* the debugger looks for the three instructions around ebreak, in one page */
    .option norvc
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
