/* tests/target/arm_core.h -- a Cortex-M of a microcontroller in libunicorn: instructions,
 * exceptions by priority, SysTick and sleep
 * SPDX-License-Identifier: MIT
 *
 * Unicorn runs instructions; what is around the core is here, as the ARMv7-M manual says (B1.5
 * exceptions, B3.2 registers). An instruction lasts one cycle, and an interrupt is taken between
 * two basic blocks. So numbers of instructions are exact, and times are as good as that.
 */
#ifndef TARGET_ARM_CORE_H
#define TARGET_ARM_CORE_H

#include <stdbool.h>
#include <stdint.h>
#include <unicorn/unicorn.h>

#define ARM_IRQS  96
#define ARM_NEST  8
#define ARM_NEVER UINT64_MAX

struct arm_memory {
    uint32_t flash, flash_size, ram, ram_size;
    uint32_t image;                     /* the program runs in RAM, and is a copy of flash from this
                                         * address; or 0 */
    bool kept;                          /* 0x080C0000.. is flash that the chip writes, 256 KB */
};

struct arm_frame {
    uint64_t fp[8];
    uint32_t fpscr;
    int priority;                       /* of the code that was interrupted */
    unsigned exception;                 /* that runs */
};

struct arm_core {
    uc_engine *uc;
    struct arm_memory memory;
    unsigned stored;                    /* bytes of the write that runs */
    uint8_t *flash_bytes, *ram_bytes;
    uint8_t *counts[2];                 /* instructions of the block at a half word; of RAM */
    uint32_t vectors;                   /* address of the table */
    uint64_t now, due;                  /* cycles */
    uint32_t stopped_at;                /* the block or instruction that is next; or 0 */
    uint64_t ran, ran_in[16 + ARM_IRQS];    /* instructions; of each exception, 0: the main loop */
    uint64_t taken[16 + ARM_IRQS];
    bool pending[16 + ARM_IRQS], enabled[ARM_IRQS], asleep, failed, fpu;
    uint8_t priority[16 + ARM_IRQS];
    struct arm_frame nest[ARM_NEST];
    int depth;
    uint32_t tick_csr, tick_reload;
    uint64_t tick_at;                   /* the next one */
    uint32_t hold_irq;                  /* an exception that is not taken until */
    uint64_t hold_until;

    /* CALLBACKS of the chip: registers; all that happens up to `now`; when something will. */
    uint32_t (*read)(void *chip, uint32_t address);
    void     (*write)(void *chip, uint32_t address, uint32_t value);
    void     (*advance)(void *chip, uint64_t now);
    uint64_t (*next)(void *chip);
    void *chip;
};

/* Load the firmware, an ELF file or blocks of UF2, and reset. Returns 0, or an exit code after one
 * line on standard error. */
int arm_core_start(struct arm_core *c, const char *file, int model, bool fpu);

/* Begin at `pc` with that stack. */
void arm_core_jump(struct arm_core *c, uint32_t pc, uint32_t sp);

/* Run until that cycle. Returns false if the firmware has failed. */
bool arm_core_run(struct arm_core *c, uint64_t until);

/* Interrupt `irq` asks. */
void arm_core_raise(struct arm_core *c, unsigned irq);

/* A word of RAM, as DMA reads it. */
uint32_t arm_core_word(const struct arm_core *c, uint32_t address);

#endif
