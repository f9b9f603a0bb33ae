/* lib/num/avr.c
 * SPDX-License-Identifier: MIT
 *
 * Arguments and results are in the registers that avr-gcc assigns: eight bytes in r18..r25, four
 * more in r14..r17, results in r18..r25 or r22..r25. A function may change r0, r18..r27, r30 and
 * r31; r1 is 0 between functions.
 */
/* clang-format off */
#include "num/num.h"    /* loft_avr_*, where needed          */
#include "num/accs.h"   /* loft_accs_* */

#if defined(__AVR__)

#define TEXT_(x)   #x
#define TEXT(x)    TEXT_(x)
#define OWN_SECTION(f) \
    ".section .text." TEXT(f) ",\"ax\",@progbits\n.type " TEXT(f) ", @function\n" TEXT(f) ":\n"
#define BEGIN_FUNCTION(f)   ".global " TEXT(f) "\n" OWN_SECTION(f)
#define END_FUNCTION(f)     ".size " TEXT(f) ", .-" TEXT(f) "\n.text\n"

/* The columns of the product are summed in three bytes, from the lowest byte up. Column k + 3
 * becomes byte k of the result, which replaces byte k of x once that is no longer needed. Column 2
 * is kept on the stack for products that are truncated two bytes lower. x is taken as unsigned, so
 * for a negative x the sum is too large by t 2^64. */
#define TERM(x, t, a, b, c) \
    "mul r" #x ", r" #t "\n add r" #a ", r0\n adc r" #b ", r1\n adc r" #c ", r31\n"
#define PUSH8 \
    "push r10\n push r11\n push r12\n push r13\n push r14\n " \
    "push r15\n push r16\n push r17\n"
#define POP8   "pop r17\n pop r16\n pop r15\n pop r14\n pop r13\n pop r12\n pop r11\n pop r10\n"
#define HALVE_N "lsr r25\n ror r24\n ror r23\n ror r22\n ror r21\n ror r20\n ror r19\n ror r18\n"
#define HALVE_D "lsr r17\n ror r16\n ror r15\n ror r14\n ror r13\n ror r12\n ror r11\n ror r10\n"
#define LESS8 \
    "cp r18, r10\n cpc r19, r11\n cpc r20, r12\n cpc r21, r13\n " \
    "cpc r22, r14\n cpc r23, r15\n cpc r24, r16\n cpc r25, r17\n"
#define TAKE8  "movw r18, r10\n movw r20, r12\n movw r22, r14\n movw r24, r16\n"
/* x = x OP y for all axes, byte by byte */
#define AXES8(first, op) \
    "movw r26, r24\n movw r30, r22\n ldi r25, " TEXT(LOFT_AXES) "\n1: ldi r24, 8\n" first \
    "2: ld __tmp_reg__, X\n ld r23, Z+\n" \
    op " __tmp_reg__, r23\n st X+, __tmp_reg__\n dec r24\n brne 2b\n dec r25\n brne 1b\n ret\n"
#define BYTE(k, a)              "mov r" #k ", r" #a "\n clr r" #a "\n"

/* Byte k of a step, from Z+7: of the low half upwards, d[1] in r18..r21, d[2] in r22..r25; of the
 * high half downwards, so that each sum still finds the other number as it was. */
#define LOW0(add, k, d1) \
    "ldd r" #d1 ", Z+7+8+" #k "\n ldd __tmp_reg__, Z+7+" #k "\n " add " __tmp_reg__, r" #d1 "\n" \
    "std Z+7+" #k ", __tmp_reg__\n"
#define LOW1(add, k, d1, d2) \
    "ldd r" #d2 ", Z+7+16+" #k "\n " add " r" #d1 ", r" #d2 "\n std Z+7+8+" #k ", r" #d1 "\n"
#define LOW2(add, k, d2) \
    "ldd __tmp_reg__, Z+7+24+" #k "\n " add " r" #d2 ", __tmp_reg__\n std Z+7+16+" #k ", r" #d2 "\n"
#define HIGH2(k, d2) \
    "ldd r" #d2 ", Z+7+16+" #k "\n ldd __tmp_reg__, Z+7+24+" #k "\n adc __tmp_reg__, r" #d2 "\n" \
    "std Z+7+16+" #k ", __tmp_reg__\n"
#define HIGH1(k, d1, d2) \
    "ldd r" #d1 ", Z+7+8+" #k "\n adc r" #d2 ", r" #d1 "\n std Z+7+8+" #k ", r" #d2 "\n"
#define HIGH0(k, d1) \
    "ldd __tmp_reg__, Z+7+" #k "\n adc __tmp_reg__, r" #d1 "\n std Z+7+" #k ", __tmp_reg__\n" \
    "st X+, __tmp_reg__\n"
/* Byte k of a run: d[0] in r2..r9, d[1] in r10..r17, d[2] in r18..r25. */
#define LOAD3(k, d0, d1, d2) \
    "ldd r" #d0 ", Y+" #k "\n ldd r" #d1 ", Y+8+" #k "\n ldd r" #d2 ", Y+16+" #k "\n"
#define KEEP3(k, d0, d1, d2) \
    "std Y+" #k ", r" #d0 "\n std Y+8+" #k ", r" #d1 "\n std Y+16+" #k ", r" #d2 "\n"
#define RUN2(add, k, d2) "ldd __tmp_reg__, Y+24+" #k "\n " add " r" #d2 ", __tmp_reg__\n"

__asm__ (
    OWN_SECTION(loft_avr_negate)
    "com r18\n com r19\n com r20\n com r21\n com r22\n com r23\n com r24\n com r25\n"
    "clr __tmp_reg__\n adc r18, __tmp_reg__\n adc r19, __tmp_reg__\n adc r20, __tmp_reg__\n"
    "adc r21, __tmp_reg__\n"
    "adc r22, __tmp_reg__\n adc r23, __tmp_reg__\n adc r24, __tmp_reg__\n adc r25, __tmp_reg__\n"
    "ret\n"
    "loft_avr_opposite: com r14\n com r15\n com r16\n com r17\n"
    "clr __tmp_reg__\n adc r14, __tmp_reg__\n adc r15, __tmp_reg__\n adc r16, __tmp_reg__\n"
    "adc r17, __tmp_reg__\n ret\n"
    END_FUNCTION(loft_avr_negate)

    /* Halves of the numbers fit in the registers that a function may change. r1 keeps the carries
     * of d[0] and d[1] from half to half. */
    ".macro loft_avr_axis\n"
    LOW0("add", 0, 18) LOW0("adc", 1, 19) LOW0("adc", 2, 20) LOW0("adc", 3, 21) "rol r1\n"
    LOW1("add", 0, 18, 22) LOW1("adc", 1, 19, 23) LOW1("adc", 2, 20, 24) LOW1("adc", 3, 21, 25)
    "rol r1\n" LOW2("add", 0, 22) LOW2("adc", 1, 23) LOW2("adc", 2, 24) LOW2("adc", 3, 25)
    HIGH2(4, 22) HIGH2(5, 23) HIGH2(6, 24) HIGH2(7, 25) "ror r1\n"
    HIGH1(4, 18, 22) HIGH1(5, 19, 23) HIGH1(6, 20, 24) HIGH1(7, 21, 25) "ror r1\n"
    HIGH0(4, 18) HIGH0(5, 19) HIGH0(6, 20) HIGH0(7, 21)
    ".endm\n"
    BEGIN_FUNCTION(loft_avr_next3)
    "movw r30, r24\n ld r24, Z\n subi r24, 1\n brcc 2f\n"
    "ldd r18, Z+1\n ldd r19, Z+2\n ldd r20, Z+3\n"
    "sbc r18, r1\n sbc r19, r1\n sbc r20, r1\n brcc 1f\n ldi r24, 0\n ret\n"
    "1: std Z+1, r18\n std Z+2, r19\n std Z+3, r20\n"
    "2: st Z, r24\n movw r26, r22\n"
    ".rept " TEXT(LOFT_AXES) " - 1\n loft_avr_axis\n adiw r30, 48\n .endr\n loft_avr_axis\n"
    "clr __zero_reg__\n ldi r24, 1\n ret\n"
    END_FUNCTION(loft_avr_next3)

    /* r1 is `bytes`, X what is left */
    BEGIN_FUNCTION(loft_avr_run3)
    "push r2\n push r3\n push r4\n push r5\n push r6\n push r7\n push r8\n push r9\n" PUSH8
    "push r28\n push r29\n"
    "movw r28, r24\n movw r30, r22\n movw r26, r20\n mov r1, r18\n"
    LOAD3(0, 2, 10, 18) LOAD3(1, 3, 11, 19) LOAD3(2, 4, 12, 20) LOAD3(3, 5, 13, 21)
    LOAD3(4, 6, 14, 22) LOAD3(5, 7, 15, 23) LOAD3(6, 8, 16, 24) LOAD3(7, 9, 17, 25)
    "1: add r2, r10\n adc r3, r11\n adc r4, r12\n adc r5, r13\n"
    "adc r6, r14\n adc r7, r15\n adc r8, r16\n adc r9, r17\n"
    "st Z, r6\n std Z+1, r7\n std Z+2, r8\n std Z+3, r9\n"
    "add r10, r18\n adc r11, r19\n adc r12, r20\n adc r13, r21\n"
    "adc r14, r22\n adc r15, r23\n adc r16, r24\n adc r17, r25\n"
    RUN2("add", 0, 18) RUN2("adc", 1, 19) RUN2("adc", 2, 20) RUN2("adc", 3, 21)
    RUN2("adc", 4, 22) RUN2("adc", 5, 23) RUN2("adc", 6, 24) RUN2("adc", 7, 25)
    "add r30, r1\n brcc 2f\n inc r31\n 2: sbiw r26, 1\n brne 1b\n"
    KEEP3(0, 2, 10, 18) KEEP3(1, 3, 11, 19) KEEP3(2, 4, 12, 20) KEEP3(3, 5, 13, 21)
    KEEP3(4, 6, 14, 22) KEEP3(5, 7, 15, 23) KEEP3(6, 8, 16, 24) KEEP3(7, 9, 17, 25)
    "clr __zero_reg__\n pop r29\n pop r28\n" POP8
    "pop r9\n pop r8\n pop r7\n pop r6\n pop r5\n pop r4\n pop r3\n pop r2\n ret\n"
    END_FUNCTION(loft_avr_run3)

    BEGIN_FUNCTION(loft_acc_abs)
    "sbrs r25, 7\n ret\n jmp loft_avr_negate\n"
    END_FUNCTION(loft_acc_abs)

    BEGIN_FUNCTION(loft_acc_min)
    LESS8 "brlt 1f\n" TAKE8 "1: ret\n"
    END_FUNCTION(loft_acc_min)

    BEGIN_FUNCTION(loft_acc_max)
    LESS8 "brge 1f\n" TAKE8 "1: ret\n"
    END_FUNCTION(loft_acc_max)

    BEGIN_FUNCTION(loft_accs_add)
    AXES8("clc\n", "adc")
    END_FUNCTION(loft_accs_add)

    BEGIN_FUNCTION(loft_accs_sub)
    AXES8("clc\n", "sbc")
    END_FUNCTION(loft_accs_sub)

    BEGIN_FUNCTION(loft_accs_triple)
    "movw r26, r24\n ldi r25, " TEXT(LOFT_AXES) "\n ldi r23, 3\n"
    "1: ldi r24, 8\n clr r22\n"
    "2: ld r20, X\n mul r20, r23\n add r0, r22\n clr r22\n adc r22, r1\n st X+, r0\n dec r24\n"
    "brne 2b\n dec r25\n brne 1b\n clr __zero_reg__\n ret\n"
    END_FUNCTION(loft_accs_triple)

    BEGIN_FUNCTION(loft_accs_copy)
    AXES8("", "mov")
    END_FUNCTION(loft_accs_copy)

    BEGIN_FUNCTION(loft_to_acc)
    "movw r20, r22\n movw r22, r24\n clr r18\n clr r19\n mov r24, r23\n lsl r24\n sbc r24, r24\n"
    "mov r25, r24\n ret\n"
    END_FUNCTION(loft_to_acc)

    BEGIN_FUNCTION(loft_unit_to_acc)
    "clr r18\n mov r19, r22\n mov r20, r23\n mov r21, r24\n mov r22, r25\n mov r23, r25\n"
    "lsl r23\n sbc r23, r23\n mov r24, r23\n mov r25, r23\n ret\n"
    END_FUNCTION(loft_unit_to_acc)

    BEGIN_FUNCTION(loft_acc_round)
    "lsl r19\n adc r20, __zero_reg__\n adc r21, __zero_reg__\n adc r22, __zero_reg__\n"
    "adc r23, __zero_reg__\n movw r24, r22\n movw r22, r20\n ret\n"
    END_FUNCTION(loft_acc_round)

    BEGIN_FUNCTION(loft_unit_round)
    "lsl r18\n adc r19, __zero_reg__\n adc r20, __zero_reg__\n adc r21, __zero_reg__\n"
    "adc r22, __zero_reg__\n"
    "mov r25, r22\n mov r24, r21\n mov r23, r20\n mov r22, r19\n ret\n"
    END_FUNCTION(loft_unit_round)

    BEGIN_FUNCTION(loft_avr_bits)
    "ldi r26, 64\n"
    "1: tst r25\n brne 2f\n mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n"
    "mov r21, r20\n mov r20, r19\n mov r19, r18\n clr r18\n"
    "subi r26, 8\n brne 1b\n rjmp 3f\n"
    "2: lsl r25\n brcs 3f\n dec r26\n rjmp 2b\n"
    "3: mov r24, r26\n ret\n"
    END_FUNCTION(loft_avr_bits)

    BEGIN_FUNCTION(loft_avr_shift)
    "tst r16\n breq 4f\n brmi 2f\n mov r26, r16\n"
    "1: " HALVE_N "dec r26\n brne 1b\n"
    "adc r18, __zero_reg__\n adc r19, __zero_reg__\n adc r20, __zero_reg__\n"
    "adc r21, __zero_reg__\n"
    "adc r22, __zero_reg__\n adc r23, __zero_reg__\n adc r24, __zero_reg__\n"
    "adc r25, __zero_reg__\n ret\n"
    "2: mov r26, r16\n"
    "3: lsl r18\n rol r19\n rol r20\n rol r21\n rol r22\n rol r23\n rol r24\n rol r25\n inc r26\n"
    "brne 3b\n"
    "4: ret\n"
    END_FUNCTION(loft_avr_shift)

    /* The product of the magnitudes, as below, with the sign of both. Columns 0 to 2 are kept on
     * the stack, column 3 in place of byte 0 of b. */
    BEGIN_FUNCTION(loft_prod)
    "mov r26, r25\n eor r26, r21\n bst r26, 7\n"
    "sbrs r25, 7\n rjmp 1f\n com r25\n com r24\n com r23\n neg r22\n sbci r23, 0xff\n"
    "sbci r24, 0xff\n sbci r25, 0xff\n"
    "1: sbrs r21, 7\n rjmp 2f\n com r21\n com r20\n com r19\n neg r18\n sbci r19, 0xff\n"
    "sbci r20, 0xff\n sbci r21, 0xff\n"
    "2: clr r27\n clr r30\n clr r31\n mul r18, r22\n push r0\n mov r26, r1\n"
    TERM(18, 23, 26, 27, 30) TERM(19, 22, 26, 27, 30) "push r26\n clr r26\n"
    TERM(18, 24, 27, 30, 26) TERM(19, 23, 27, 30, 26) TERM(20, 22, 27, 30, 26)
    "push r27\n clr r27\n"
    TERM(18, 25, 30, 26, 27) TERM(19, 24, 30, 26, 27) TERM(20, 23, 30, 26, 27)
    TERM(21, 22, 30, 26, 27) BYTE(18, 30)
    TERM(19, 25, 26, 27, 30) TERM(20, 24, 26, 27, 30) TERM(21, 23, 26, 27, 30) BYTE(22, 26)
    TERM(20, 25, 27, 30, 26) TERM(21, 24, 27, 30, 26) "mov r23, r27\n"
    "mul r21, r25\n add r30, r0\n adc r26, r1\n mov r24, r30\n mov r25, r26\n"
    "mov r21, r18\n pop r20\n pop r19\n pop r18\n clr __zero_reg__\n"
    "brtc 3f\n jmp loft_avr_negate\n 3: ret\n"
    END_FUNCTION(loft_prod)

    /* a as unsigned: if it is negative, b is too much in the upper half (T). Column 3 rounds. */
    BEGIN_FUNCTION(loft_prod_int)
    "bst r25, 7\n clr r27\n clr r30\n clr r31\n mul r18, r22\n mov r26, r1\n"
    TERM(18, 23, 26, 27, 30) TERM(19, 22, 26, 27, 30) "clr r26\n"
    TERM(18, 24, 27, 30, 26) TERM(19, 23, 27, 30, 26) TERM(20, 22, 27, 30, 26) "clr r27\n"
    TERM(18, 25, 30, 26, 27) TERM(19, 24, 30, 26, 27) TERM(20, 23, 30, 26, 27)
    TERM(21, 22, 30, 26, 27) "lsl r30\n adc r26, r31\n adc r27, r31\n clr r30\n"
    TERM(19, 25, 26, 27, 30) TERM(20, 24, 26, 27, 30) TERM(21, 23, 26, 27, 30) BYTE(22, 26)
    TERM(20, 25, 27, 30, 26) TERM(21, 24, 27, 30, 26) "mov r23, r27\n"
    "mul r21, r25\n add r30, r0\n adc r26, r1\n mov r24, r30\n mov r25, r26\n"
    "clr __zero_reg__\n brtc 1f\n"
    "sub r22, r18\n sbc r23, r19\n sbc r24, r20\n sbc r25, r21\n 1: ret\n"
    END_FUNCTION(loft_prod_int)

    OWN_SECTION(loft_avr_product)
    "sbrs r17, 7\n rjmp 1f\n"
    "call loft_avr_opposite\n call loft_avr_negate\n rcall 1f\n rjmp loft_avr_opposite\n"
    "1: bst r25, 7\n clr r31\n mov r26, r25\n lsl r26\n sbc r26, r26\n cp r26, r25\n"
    "cpc r26, r24\n brne 3f\n tst r17\n brne 3f\n rjmp 4f\n3: clr r26\n"
    TERM(18, 14, 26, 27, 30) "clr r26\n"
    TERM(18, 15, 27, 30, 26) TERM(19, 14, 27, 30, 26) "clr r27\n"
    TERM(18, 16, 30, 26, 27) TERM(19, 15, 30, 26, 27) TERM(20, 14, 30, 26, 27)
    "push r30\n clr r30\n"
    TERM(18, 17, 26, 27, 30) TERM(19, 16, 26, 27, 30) TERM(20, 15, 26, 27, 30)
    TERM(21, 14, 26, 27, 30) BYTE(18, 26)
    TERM(19, 17, 27, 30, 26) TERM(20, 16, 27, 30, 26) TERM(21, 15, 27, 30, 26)
    TERM(22, 14, 27, 30, 26) BYTE(19, 27)
    TERM(20, 17, 30, 26, 27) TERM(21, 16, 30, 26, 27) TERM(22, 15, 30, 26, 27)
    TERM(23, 14, 30, 26, 27) BYTE(20, 30)
    TERM(21, 17, 26, 27, 30) TERM(22, 16, 26, 27, 30) TERM(23, 15, 26, 27, 30)
    TERM(24, 14, 26, 27, 30) BYTE(21, 26)
    TERM(22, 17, 27, 30, 26) TERM(23, 16, 27, 30, 26) TERM(24, 15, 27, 30, 26)
    TERM(25, 14, 27, 30, 26) BYTE(22, 27)
    TERM(23, 17, 30, 26, 27) TERM(24, 16, 30, 26, 27) TERM(25, 15, 30, 26, 27) BYTE(23, 30)
    TERM(24, 17, 26, 27, 30) TERM(25, 16, 26, 27, 30) BYTE(24, 26)
    "mul r25, r17\n add r27, r0\n mov r25, r27\n"
    "brtc 2f\n sub r23, r14\n sbc r24, r15\n sbc r25, r16\n"
    "2: pop r26\n clr __zero_reg__\n ret\n"
    /* six bytes times three, the most that usually occurs */
    "4: clr r26\n" TERM(18, 14, 26, 27, 30) "clr r26\n"
    TERM(18, 15, 27, 30, 26) TERM(19, 14, 27, 30, 26) "clr r27\n"
    TERM(18, 16, 30, 26, 27) TERM(19, 15, 30, 26, 27) TERM(20, 14, 30, 26, 27)
    "push r30\n clr r30\n"
    TERM(19, 16, 26, 27, 30) TERM(20, 15, 26, 27, 30) TERM(21, 14, 26, 27, 30) BYTE(18, 26)
    TERM(20, 16, 27, 30, 26) TERM(21, 15, 27, 30, 26) TERM(22, 14, 27, 30, 26) BYTE(19, 27)
    TERM(21, 16, 30, 26, 27) TERM(22, 15, 30, 26, 27) TERM(23, 14, 30, 26, 27) BYTE(20, 30)
    TERM(22, 16, 26, 27, 30) TERM(23, 15, 26, 27, 30) "mov r21, r26\n"
    "mul r23, r16\n add r27, r0\n adc r30, r1\n mov r22, r27\n mov r23, r30\n clr r24\n"
    "brtc 5f\n sub r21, r14\n sbc r22, r15\n sbc r23, r16\n sbc r24, r24\n"
    "5: mov r25, r24\n pop r26\n clr __zero_reg__\n ret\n"
    END_FUNCTION(loft_avr_product)

    /* half of the last byte, which is in column 2 or 1 */
    BEGIN_FUNCTION(loft_acc_scale)
    "ldi r30, 0x80\n clr r27\n jmp loft_avr_product\n"
    END_FUNCTION(loft_acc_scale)

    BEGIN_FUNCTION(loft_acc_mul)
    "ldi r27, 0x80\n clr r30\n call loft_avr_product\n"
    "mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n mov r21, r20\n mov r20, r19\n"
    "mov r19, r18\n mov r18, r26\n ret\n"
    END_FUNCTION(loft_acc_mul)

    /* b - a has 33 bits; S holds its sign */
    BEGIN_FUNCTION(loft_lerp)
    "push r22\n push r23\n push r24\n push r25\n sub r18, r22\n sbc r19, r23\n sbc r20, r24\n"
    "sbc r21, r25\n"
    "ldi r22, 0\n brge 1f\n ldi r22, 0xff\n 1: mov r23, r22\n movw r24, r22\n"
    "call " TEXT(loft_acc_scale) "\n"
    "pop r25\n pop r24\n pop r23\n pop r22\n add r22, r18\n adc r23, r19\n adc r24, r20\n"
    "adc r25, r21\n ret\n"
    END_FUNCTION(loft_lerp)

    /* (|n| + half) / d without the remainder, where half is d / 2 or, for a negative n, (d - 1) /
     * 2. Bytes of n leave at the top, and bytes of the quotient enter at the bottom. */
    BEGIN_FUNCTION(loft_avr_quotient)
    "push r28\n push r29\n movw r26, r14\n movw r30, r16\n bst r25, 7\n brtc 1f\n"
    "call loft_avr_negate\n sbiw r26, 1\n sbci r30, 0\n sbci r31, 0\n"
    "1: lsr r31\n ror r30\n ror r27\n ror r26\n"
    "add r18, r26\n adc r19, r27\n adc r20, r30\n adc r21, r31\n"
    "adc r22, __zero_reg__\n adc r23, __zero_reg__\n adc r24, __zero_reg__\n"
    "adc r25, __zero_reg__\n"
    "clr r26\n clr r27\n movw r30, r26\n ldi r29, 8\n"
    "2: tst r25\n brne 3f\n"
    "rcall 9f\n dec r29\n brne 2b\n rjmp 8f\n"
    "3: ldi r28, 8\n"
    "4: lsl r25\n rol r26\n rol r27\n rol r30\n rol r31\n brcs 6f\n"
    "cp r26, r14\n cpc r27, r15\n cpc r30, r16\n cpc r31, r17\n brcs 5f\n"
    "6: sub r26, r14\n sbc r27, r15\n sbc r30, r16\n sbc r31, r17\n inc r25\n"
    "5: dec r28\n brne 4b\n"
    "rcall 9f\n dec r29\n brne 3b\n"
    "8: pop r29\n pop r28\n brtc 7f\n jmp loft_avr_negate\n"
    "9: mov __tmp_reg__, r25\n mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n"
    "mov r21, r20\n mov r20, r19\n mov r19, r18\n"
    "mov r18, __tmp_reg__\n"
    "7: ret\n"
    END_FUNCTION(loft_avr_quotient)

    /* j 2^24 / n */
    BEGIN_FUNCTION(loft_unit_of)
    "push r14\n push r15\n push r16\n push r17\n movw r14, r18\n movw r16, r20\n"
    "clr r18\n clr r19\n clr r20\n mov r21, r22\n mov r22, r23\n mov r23, r24\n mov r24, r25\n"
    "clr r25\n"
    "call " TEXT(loft_avr_quotient) "\n movw r22, r18\n movw r24, r20\n pop r17\n pop r16\n"
    "pop r15\n pop r14\n ret\n"
    END_FUNCTION(loft_unit_of)

    BEGIN_FUNCTION(loft_acc_div)
    "movw r24, r22\n movw r22, r20\n movw r20, r18\n clr r18\n clr r19\n sbrs r17, 7\n"
    "jmp " TEXT(loft_avr_quotient) "\n"
    "call loft_avr_negate\n call loft_avr_opposite\n call " TEXT(loft_avr_quotient) "\n"
    "jmp loft_avr_opposite\n"
    END_FUNCTION(loft_acc_div)

    /* |x| and y are halved until y is below 2^38. The quotient is computed bit by bit from the
     * integer bit on; the doubled last remainder decides the rounding. */
    BEGIN_FUNCTION(loft_unit_ratio)
    "bst r25, 7\n brtc 1f\n call loft_avr_negate\n"
    "1: ldi r26, 63\n cp r26, r14\n cpc __zero_reg__, r15\n cpc __zero_reg__, r16\n"
    "cpc __zero_reg__, r17\n brcc 4f\n"
    PUSH8
    "2: " HALVE_N HALVE_D "cp r26, r14\n cpc __zero_reg__, r15\n cpc __zero_reg__, r16\n"
    "cpc __zero_reg__, r17\n brcs 2b\n"
    "rcall 4f\n" POP8 "ret\n"
    "4: clr r26\n clr r27\n movw r30, r26\n ldi r23, 25\n"
    "5: lsl r26\n rol r27\n rol r30\n rol r31\n"
    "cp r18, r10\n cpc r19, r11\n cpc r20, r12\n cpc r21, r13\n cpc r22, r14\n brcs 6f\n"
    "sub r18, r10\n sbc r19, r11\n sbc r20, r12\n sbc r21, r13\n sbc r22, r14\n inc r26\n"
    "6: lsl r18\n rol r19\n rol r20\n rol r21\n rol r22\n dec r23\n brne 5b\n"
    "cp r18, r10\n cpc r19, r11\n cpc r20, r12\n cpc r21, r13\n cpc r22, r14\n brcs 7f\n"
    "adiw r26, 1\n adc r30, __zero_reg__\n adc r31, __zero_reg__\n"
    "7: jmp loft_avr_signed\n"
    END_FUNCTION(loft_unit_ratio)

    /* r31:r30:r27:r26 with the sign in T */
    OWN_SECTION(loft_avr_signed)
    "movw r22, r26\n movw r24, r30\n brtc 1f\n"
    "com r25\n com r24\n com r23\n neg r22\n sbci r23, 0xff\n sbci r24, 0xff\n sbci r25, 0xff\n"
    "1: ret\n"
    END_FUNCTION(loft_avr_signed)

    /* |x| and y are halved until |x| is below 2^47. Then y is doubled until it is larger; each
     * doubling adds a round. One last round decides the rounding. */
    BEGIN_FUNCTION(loft_acc_quot)
    "bst r25, 7\n brtc 1f\n call loft_avr_negate\n"
    "1: " PUSH8 "rjmp 3f\n"
    "2: " HALVE_N HALVE_D
    "3: mov r26, r23\n andi r26, 0x80\n or r26, r24\n or r26, r25\n brne 2b\n"
    "ldi r26, 17\n mov __tmp_reg__, r26\n clr r26\n clr r27\n movw r30, r26\n"
    "4: " LESS8 "brcs 5f\n"
    "lsl r10\n rol r11\n rol r12\n rol r13\n rol r14\n rol r15\n rol r16\n rol r17\n"
    "inc __tmp_reg__\n rjmp 4b\n"
    "5: lsl r26\n rol r27\n rol r30\n rol r31\n"
    "lsl r18\n rol r19\n rol r20\n rol r21\n rol r22\n rol r23\n rol r24\n rol r25\n"
    "" LESS8 "brcs 6f\n"
    "sub r18, r10\n sbc r19, r11\n sbc r20, r12\n sbc r21, r13\n sbc r22, r14\n sbc r23, r15\n"
    "sbc r24, r16\n sbc r25, r17\n inc r26\n"
    "6: dec __tmp_reg__\n brne 5b\n"
    "lsr r31\n ror r30\n ror r27\n ror r26\n adc r26, __zero_reg__\n adc r27, __zero_reg__\n"
    "adc r30, __zero_reg__\n adc r31, __zero_reg__\n"
    POP8 "jmp loft_avr_signed\n"
    END_FUNCTION(loft_acc_quot)

    /* Digit by digit, two bits of x per round: r12:r31:r30:r27:r26 is the remainder, r17..r13 twice
     * the root. To nearest, the root is incremented if the remainder exceeds it. */
    BEGIN_FUNCTION(loft_root)
    "clr __tmp_reg__\n rjmp 7f\n"
    ".size " TEXT(loft_root) ", .-" TEXT(loft_root) "\n"
    ".global " TEXT(loft_root_nearest) "\n.type " TEXT(loft_root_nearest) ", @function\n"
    TEXT(loft_root_nearest) ": clr __tmp_reg__\n inc __tmp_reg__\n"
    "7: push r12\n push r13\n push r14\n push r15\n push r16\n push r17\n push r28\n push r29\n"
    "clr r12\n clr r13\n movw r14, r12\n clr r16\n clr r17\n"
    "movw r26, r14\n movw r30, r14\n ldi r29, 8\n"
    "1: tst r25\n brne 2f\n rcall 9f\n dec r29\n brne 1b\n rjmp 6f\n"
    "2: ldi r28, 4\n"
    "3: lsl r25\n rol r26\n rol r27\n rol r30\n rol r31\n rol r12\n"
    "lsl r25\n rol r26\n rol r27\n rol r30\n rol r31\n rol r12\n"
    "lsl r13\n rol r14\n rol r15\n rol r16\n rol r17\n"
    "sec\n sbc r26, r13\n sbc r27, r14\n sbc r30, r15\n sbc r31, r16\n sbc r12, r17\n brcc 4f\n"
    "sec\n adc r26, r13\n adc r27, r14\n adc r30, r15\n adc r31, r16\n adc r12, r17\n rjmp 5f\n"
    "4: set\n bld r13, 1\n"
    "5: dec r28\n brne 3b\n rcall 9f\n dec r29\n brne 2b\n"
    "6: lsr r17\n ror r16\n ror r15\n ror r14\n ror r13\n"
    "cp r13, r26\n cpc r14, r27\n cpc r15, r30\n cpc r16, r31\n cpc r17, r12\n"
    "sbrs __tmp_reg__, 0\n clc\n mov r22, r13\n mov r23, r14\n mov r24, r15\n mov r25, r16\n"
    "adc r22, __zero_reg__\n adc r23, __zero_reg__\n adc r24, __zero_reg__\n"
    "adc r25, __zero_reg__\n"
    "pop r29\n pop r28\n pop r17\n pop r16\n pop r15\n pop r14\n pop r13\n pop r12\n ret\n"
    "9: mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n mov r21, r20\n mov r20, r19\n"
    "mov r19, r18\n ret\n"
    END_FUNCTION(loft_root_nearest)

    /* Niels Moller, Torbjorn Granlund: Improved division by invariant integers (2011), algorithm 5,
     * with bytes. n is doubled until its highest bit is set (r21:r20, 2^s in r19), and x with it,
     * as its bytes are read: r14 is what a byte leaves for the one above. r15 is the reciprocal,
     * r17:r16 the rest. The first digit is 0, or the first two (r18); below x are zeros (r23). */
    BEGIN_FUNCTION(loft_avr_divide)
    "push r12\n push r13\n push r14\n push r15\n push r16\n push r17\n"
    "movw r26, r24\n add r26, r22\n adc r27, __zero_reg__\n movw r30, r26\n mov r23, r22\n"
    "ldi r18, 1\n ldi r19, 1\n tst r21\n brne 1f\n mov r21, r20\n clr r20\n inc r18\n"
    "1: tst r21\n brmi 2f\n lsl r20\n rol r21\n lsl r19\n rjmp 1b\n"
    "2: movw r16, r20\n com r16\n com r17\n ldi r24, 8\n"
    "3: lsl r15\n sec\n rol r16\n rol r17\n brcs 4f\n cp r16, r20\n cpc r17, r21\n brlo 5f\n"
    "4: sub r16, r20\n sbc r17, r21\n inc r15\n"
    "5: dec r24\n brne 3b\n clr r14\n clr r16\n clr r17\n"
    "6: clr r0\n dec r23\n brmi 7f\n ld r0, -X\n"
    "7: mul r0, r19\n or r14, r1\n mov r24, r14\n mov r14, r0\n mov r25, r16\n"
    "dec r18\n brpl 10f\n"
    "mul r15, r17\n add r0, r16\n adc r1, r17\n movw r12, r0\n"
    "mul r13, r21\n sub r25, r0\n mul r13, r20\n sub r24, r0\n sbc r25, r1\n"
    "sub r24, r20\n sbc r25, r21\n inc r13\n"
    "cp r25, r12\n brlo 8f\n dec r13\n add r24, r20\n adc r25, r21\n"
    "8: cp r24, r20\n cpc r25, r21\n brsh 11f\n"
    "9: st -Z, r13\n movw r16, r24\n dec r22\n brne 6b\n clr __zero_reg__\n"
    "pop r17\n pop r16\n pop r15\n pop r14\n pop r13\n pop r12\n ret\n"
    "10: movw r16, r24\n rjmp 6b\n"
    "11: sub r24, r20\n sbc r25, r21\n inc r13\n rjmp 9b\n"
    END_FUNCTION(loft_avr_divide)

    /* The product of |a| (r22..r18) and each byte of the inverse is added to r15..r10, whose lowest
     * byte then leaves; r23 is 0xff for a negative a. T: three times a. */
    BEGIN_FUNCTION(loft_avr_scale_wide)
    "push r8\n push r9\n" PUSH8 "movw r26, r24\n movw r30, r22\n clt\n rcall 1f\n" POP8
    "pop r9\n pop r8\n clr __zero_reg__\n ret\n"
    "loft_avr_scale_in:\n"
    "1: ld r18, X+\n ld r19, X+\n ld r20, X+\n ld r21, X+\n ld r22, X+\n sbiw r26, 9\n"
    "mov r23, r22\n lsl r23\n sbc r23, r23\n brtc 3f\n"
    "movw r10, r18\n movw r12, r20\n mov r14, r22\n"
    "2: add r18, r10\n adc r19, r11\n adc r20, r12\n adc r21, r13\n adc r22, r14\n"
    "brtc 3f\n clt\n rjmp 2b\n"
    "3: eor r18, r23\n eor r19, r23\n eor r20, r23\n eor r21, r23\n eor r22, r23\n"
    "sub r18, r23\n sbc r19, r23\n sbc r20, r23\n sbc r21, r23\n sbc r22, r23\n"
    "clr r10\n clr r11\n movw r12, r10\n movw r14, r10\n ldi r25, 12\n"
    "4: ld r24, Z+\n mul r18, r24\n movw r16, r0\n mul r20, r24\n movw r8, r0\n"
    "mul r22, r24\n add r10, r16\n adc r11, r17\n adc r12, r8\n adc r13, r9\n adc r14, r0\n"
    "adc r15, r1\n mul r19, r24\n movw r16, r0\n mul r21, r24\n clr r24\n add r11, r16\n"
    "adc r12, r17\n adc r13, r0\n adc r14, r1\n adc r15, r24\n eor r10, r23\n st X+, r10\n"
    "mov r10, r11\n mov r11, r12\n mov r12, r13\n mov r13, r14\n mov r14, r15\n clr r15\n"
    "dec r25\n brne 4b\n"
    "eor r10, r23\n st X+, r10\n eor r11, r23\n st X+, r11\n eor r12, r23\n st X+, r12\n"
    "eor r13, r23\n st X+, r13\n sbrs r23, 0\n ret\n"
    "sbiw r26, 12\n ldi r25, 12\n"
    "5: ld r24, X\n inc r24\n st X+, r24\n brne 6f\n dec r25\n brne 5b\n 6: ret\n"
    END_FUNCTION(loft_avr_scale_wide)

    /* With u = p1 - p0 (r22..r18) and v = p2 - p1, the second difference is v - u, and the third
     * one p3 - p2 - (v - u) - v. They wait where their products will be. Then, byte by byte,
     *     e1 = G1 + G2 + G3    e2 = 2 G2 + 6 G3    e3 = 6 G3
     * with their carries in r18, r19, r20. The lowest four bytes only round. */
    BEGIN_FUNCTION(loft_avr_start3)
    "push r8\n push r9\n" PUSH8 "push r28\n push r29\n push r24\n push r25\n"
    "movw r8, r20\n movw r28, r18\n movw r30, r22\n"
    "rcall 7f\n movw r18, r10\n movw r20, r12\n mov r22, r14\n adiw r26, 4\n rcall 8f\n"
    "rcall 7f\n sub r10, r18\n sbc r11, r19\n sbc r12, r20\n sbc r13, r21\n sbc r14, r22\n"
    "adiw r26, 16\n rcall 8f\n set\n"
    "1: add r18, r10\n adc r19, r11\n adc r20, r12\n adc r21, r13\n adc r22, r14\n"
    "brtc 2f\n clt\n rjmp 1b\n"
    "2: rcall 7f\n sub r10, r18\n sbc r11, r19\n sbc r12, r20\n sbc r13, r21\n"
    "sbc r14, r22\n adiw r26, 28\n rcall 8f\n"
    "movw r30, r8\n adiw r30, 24\n movw r26, r28\n adiw r26, 28\n call loft_avr_scale_in\n"
    "set\n sbiw r30, 24\n movw r26, r28\n adiw r26, 16\n call loft_avr_scale_in\n"
    "set\n sbiw r30, 24\n movw r26, r28\n adiw r26, 4\n call loft_avr_scale_in\n"
    "pop r31\n pop r30\n adiw r30, 4\n adiw r28, 4\n"
    "clr r18\n clr r19\n clr r20\n clr r21\n ldi r22, 6\n ldi r25, 4\n rcall 5f\n"
    "lsl r26\n adc r18, r21\n lsl r16\n adc r19, r21\n lsl r0\n adc r20, r21\n ldi r25, 8\n"
    "rcall 5f\n"
    "pop r29\n pop r28\n" POP8 "pop r9\n pop r8\n clr __zero_reg__\n ret\n"
    "5: ldd r24, Y+24\n ldd r23, Y+12\n ld r26, Y+\n"
    "add r26, r18\n clr r18\n adc r18, r18\n add r26, r23\n adc r18, r21\n add r26, r24\n"
    "adc r18, r21\n"
    "mul r24, r22\n movw r16, r0\n add r0, r20\n adc r1, r21\n std Z+16, r0\n mov r20, r1\n"
    "clr r27\n lsl r23\n rol r27\n add r16, r23\n adc r17, r27\n add r16, r19\n adc r17, r21\n"
    "std Z+8, r16\n mov r19, r17\n st Z+, r26\n dec r25\n brne 5b\n ret\n"
    /* r14..r10 is the next number less this one */
    "7: ldd r10, Z+4\n ldd r11, Z+5\n ldd r12, Z+6\n ldd r13, Z+7\n"
    "ld r26, Z+\n sub r10, r26\n ld r26, Z+\n sbc r11, r26\n ld r26, Z+\n sbc r12, r26\n"
    "ld r26, Z+\n sbc r13, r26\n ldi r26, 0xff\n brlt 9f\n ldi r26, 0\n 9: mov r14, r26\n"
    "movw r26, r28\n ret\n"
    "8: st X+, r10\n st X+, r11\n st X+, r12\n st X+, r13\n st X+, r14\n ret\n"
    END_FUNCTION(loft_avr_start3)
);

#endif
