/* lib/num/avr.c
 * SPDX-License-Identifier: MIT
 *
 * Arguments and results are in the registers that avr-gcc gives them: eight bytes in r18..r25, four more in r14..r17, results in
 * r18..r25 or r22..r25. r0, r18..r27, r30, r31 may be changed, r1 is 0 between functions.
 */
#include "num/num.h"    /* loft_avr_*, where they are needed */

#if defined(__AVR__)

#define TEXT_(x)   #x
#define TEXT(x)    TEXT_(x)
#define OWN(f)     ".section .text." TEXT(f) ",\"ax\",@progbits\n.type " TEXT(f) ", @function\n" TEXT(f) ":\n"
#define BEGIN(f)   ".global " TEXT(f) "\n" OWN(f)
#define END(f)     ".size " TEXT(f) ", .-" TEXT(f) "\n.text\n"

/* From the lowest byte on the columns of the product are summed in three bytes; column k + 3 becomes byte k of the result, where
 * byte k of x is not needed any more. Column 2 is kept on the stack for products that are cut two bytes lower. As x is
 * taken without its sign, a negative x has its t 2^64 too much. */
#define TERM(x, t, a, b, c)     "mul r" #x ", r" #t "\n add r" #a ", r0\n adc r" #b ", r1\n adc r" #c ", r31\n"
#define BYTE(k, a)              "mov r" #k ", r" #a "\n clr r" #a "\n"

__asm__ (
    OWN(loft_avr_negate)
    "com r18\n com r19\n com r20\n com r21\n com r22\n com r23\n com r24\n com r25\n"
    "clr __tmp_reg__\n adc r18, __tmp_reg__\n adc r19, __tmp_reg__\n adc r20, __tmp_reg__\n adc r21, __tmp_reg__\n"
    "adc r22, __tmp_reg__\n adc r23, __tmp_reg__\n adc r24, __tmp_reg__\n adc r25, __tmp_reg__\n ret\n"
    "loft_avr_opposite: com r14\n com r15\n com r16\n com r17\n"
    "clr __tmp_reg__\n adc r14, __tmp_reg__\n adc r15, __tmp_reg__\n adc r16, __tmp_reg__\n adc r17, __tmp_reg__\n ret\n"
    END(loft_avr_negate)

    OWN(loft_avr_product)
    "sbrs r17, 7\n rjmp 1f\n"
    "call loft_avr_opposite\n call loft_avr_negate\n rcall 1f\n rjmp loft_avr_opposite\n"
    "1: bst r25, 7\n clr r26\n clr r31\n"
    TERM(18, 14, 26, 27, 30) "clr r26\n"
    TERM(18, 15, 27, 30, 26) TERM(19, 14, 27, 30, 26) "clr r27\n"
    TERM(18, 16, 30, 26, 27) TERM(19, 15, 30, 26, 27) TERM(20, 14, 30, 26, 27) "push r30\n clr r30\n"
    TERM(18, 17, 26, 27, 30) TERM(19, 16, 26, 27, 30) TERM(20, 15, 26, 27, 30) TERM(21, 14, 26, 27, 30) BYTE(18, 26)
    TERM(19, 17, 27, 30, 26) TERM(20, 16, 27, 30, 26) TERM(21, 15, 27, 30, 26) TERM(22, 14, 27, 30, 26) BYTE(19, 27)
    TERM(20, 17, 30, 26, 27) TERM(21, 16, 30, 26, 27) TERM(22, 15, 30, 26, 27) TERM(23, 14, 30, 26, 27) BYTE(20, 30)
    TERM(21, 17, 26, 27, 30) TERM(22, 16, 26, 27, 30) TERM(23, 15, 26, 27, 30) TERM(24, 14, 26, 27, 30) BYTE(21, 26)
    TERM(22, 17, 27, 30, 26) TERM(23, 16, 27, 30, 26) TERM(24, 15, 27, 30, 26) TERM(25, 14, 27, 30, 26) BYTE(22, 27)
    TERM(23, 17, 30, 26, 27) TERM(24, 16, 30, 26, 27) TERM(25, 15, 30, 26, 27) BYTE(23, 30)
    TERM(24, 17, 26, 27, 30) TERM(25, 16, 26, 27, 30) BYTE(24, 26)
    "mul r25, r17\n add r27, r0\n mov r25, r27\n"
    "brtc 2f\n sub r23, r14\n sbc r24, r15\n sbc r25, r16\n"
    "2: pop r26\n clr __zero_reg__\n ret\n"
    END(loft_avr_product)

    /* half of the last byte, which is in column 2 or 1 */
    BEGIN(loft_avr_scale)
    "ldi r30, 0x80\n clr r27\n jmp loft_avr_product\n"
    END(loft_avr_scale)

    BEGIN(loft_avr_mul)
    "ldi r27, 0x80\n clr r30\n call loft_avr_product\n"
    "mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n mov r21, r20\n mov r20, r19\n mov r19, r18\n mov r18, r26\n ret\n"
    END(loft_avr_mul)

    /* (|n| + half) / d without its rest, where half is d / 2 or, for a negative n, (d - 1) / 2. Bytes of n leave at the top and come
     * back at the bottom as those of the quotient. */
    BEGIN(loft_avr_quotient)
    "push r28\n push r29\n movw r26, r14\n movw r30, r16\n bst r25, 7\n brtc 1f\n"
    "call loft_avr_negate\n sbiw r26, 1\n sbci r30, 0\n sbci r31, 0\n"
    "1: lsr r31\n ror r30\n ror r27\n ror r26\n"
    "add r18, r26\n adc r19, r27\n adc r20, r30\n adc r21, r31\n"
    "adc r22, __zero_reg__\n adc r23, __zero_reg__\n adc r24, __zero_reg__\n adc r25, __zero_reg__\n"
    "clr r26\n clr r27\n movw r30, r26\n ldi r29, 8\n"
    "2: tst r25\n brne 3f\n"
    "rcall 9f\n dec r29\n brne 2b\n rjmp 8f\n"
    "3: ldi r28, 8\n"
    "4: lsl r25\n rol r26\n rol r27\n rol r30\n rol r31\n"
    "cp r26, r14\n cpc r27, r15\n cpc r30, r16\n cpc r31, r17\n brcs 5f\n"
    "sub r26, r14\n sbc r27, r15\n sbc r30, r16\n sbc r31, r17\n inc r25\n"
    "5: dec r28\n brne 4b\n"
    "rcall 9f\n dec r29\n brne 3b\n"
    "8: pop r29\n pop r28\n brtc 7f\n jmp loft_avr_negate\n"
    "9: mov __tmp_reg__, r25\n mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n mov r21, r20\n mov r20, r19\n mov r19, r18\n"
    "mov r18, __tmp_reg__\n"
    "7: ret\n"
    END(loft_avr_quotient)

    /* Bit by bit from the whole one on; the last rest, doubled, rounds. */
    BEGIN(loft_avr_part)
    "clr r26\n clr r27\n movw r30, r26\n ldi r23, 25\n"
    "1: lsl r26\n rol r27\n rol r30\n rol r31\n"
    "cp r18, r10\n cpc r19, r11\n cpc r20, r12\n cpc r21, r13\n cpc r22, r14\n brcs 2f\n"
    "sub r18, r10\n sbc r19, r11\n sbc r20, r12\n sbc r21, r13\n sbc r22, r14\n inc r26\n"
    "2: lsl r18\n rol r19\n rol r20\n rol r21\n rol r22\n dec r23\n brne 1b\n"
    "cp r18, r10\n cpc r19, r11\n cpc r20, r12\n cpc r21, r13\n cpc r22, r14\n brcs 3f\n"
    "subi r26, 0xff\n sbci r27, 0xff\n sbci r30, 0xff\n sbci r31, 0xff\n"
    "3: movw r22, r26\n movw r24, r30\n ret\n"
    END(loft_avr_part)

    /* Digit by digit, two bits of x a round: r12:r31:r30:r27:r26 is the rest, r17..r13 the root times 2. The root is
     * one more where the rest exceeds it. */
    BEGIN(loft_avr_root)
    "push r12\n push r13\n push r14\n push r15\n push r16\n push r17\n push r28\n push r29\n"
    "clr r12\n clr r13\n movw r14, r12\n clr r16\n clr r17\n movw r26, r14\n movw r30, r14\n ldi r29, 8\n"
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
    "mov r22, r13\n mov r23, r14\n mov r24, r15\n mov r25, r16\n"
    "adc r22, __zero_reg__\n adc r23, __zero_reg__\n adc r24, __zero_reg__\n adc r25, __zero_reg__\n"
    "pop r29\n pop r28\n pop r17\n pop r16\n pop r15\n pop r14\n pop r13\n pop r12\n ret\n"
    "9: mov r25, r24\n mov r24, r23\n mov r23, r22\n mov r22, r21\n mov r21, r20\n mov r20, r19\n mov r19, r18\n ret\n"
    END(loft_avr_root)
);

#endif
