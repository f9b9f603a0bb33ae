@ ports/rp2040/boot.S -- the first 256 bytes of the flash: sets the flash up, copies the program
@ into RAM, starts it
@ SPDX-License-Identifier: MIT
@
@ The boot ROM of an RP2040 runs these bytes in RAM if their last four are the CRC of the others,
@ which image.py puts there (RP2040 datasheet, 2.8.1.3). Flash is read by the command 03h, which any
@ chip obeys (4.10.13, SSI). That of an RP2350 has set the flash up, finds the block that says what
@ the image is, and runs it in flash from the vectors at its begin (RP2350 datasheet, 5.9.5).
    .syntax unified
    .thumb
    .section .boot, "ax"
    .global boot
    .thumb_func
#ifdef RP2350
    .word   stack_top, boot
    .word   0xFFFFDED3, 0x10210142      @ begin; one word: a program, secure, for Arm, an RP2350
    .word   0x000001FF, 0, 0xAB123579   @ last item; the next block is this one; end
boot:
#else
boot:
    ldr     r3, =0x18000000             @ SSI
    movs    r0, #0
    str     r0, [r3, #0x08]             @ SSIENR: off
    movs    r1, #4
    str     r1, [r3, #0x14]             @ BAUDR: a quarter of the core's clock
    ldr     r1, =0x001F0300
    str     r1, [r3, #0x00]             @ CTRLR0: frames of 32 bits, a command before them
    str     r0, [r3, #0x04]             @ CTRLR1: one frame
    ldr     r1, =0x03000218             @ command 03h of 8 bits, address of 24 bits
    ldr     r2, =0x180000F4
    str     r1, [r2]                    @ SPI_CTRLR0
    movs    r1, #1
    str     r1, [r3, #0x08]
#endif

    ldr     r0, =image_from
    ldr     r1, =image_begin
    ldr     r2, =image_end
    mov     r4, r1
1:  ldmia   r0!, {r3}
    stmia   r1!, {r3}
    cmp     r1, r2
    blo     1b

    ldr     r0, =0xE000ED08             @ VTOR
    str     r4, [r0]
    ldmia   r4!, {r0, r1}               @ stack, reset
    mov     sp, r0
    bx      r1
    .ltorg
