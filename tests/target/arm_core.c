/* tests/target/arm_core.c
 * SPDX-License-Identifier: MIT
 */
#include "arm_core.h"

#include <elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#define PPB      0xE0000000u            /* the core's own registers */
#define RETURN   0x1FFF0000u            /* where a handler returns to: a page of its own */
#define THREAD   256                    /* priority of no handler */
#define PENDSV   14
#define SYSTICK  15
#define UF2_BEGIN 0x0A324655u


// Memory
// ------

uint32_t arm_core_word(const struct arm_core *c, uint32_t address)
{
    uint32_t word = 0;

    if (address - c->memory.ram <= c->memory.ram_size - 4)
        memcpy(&word, c->ram_bytes + (address - c->memory.ram), 4);
    else if (address - c->memory.flash <= c->memory.flash_size - 4)
        memcpy(&word, c->flash_bytes + (address - c->memory.flash), 4);
    return word;
}

static bool load_elf(struct arm_core *c, FILE *f)
{
    Elf32_Ehdr head;
    Elf32_Phdr part;
    bool good = fread(&head, sizeof head, 1, f) == 1 && head.e_machine == EM_ARM;

    for (unsigned k = 0; good && k < head.e_phnum; k++) {
        good = fseek(f, (long)(head.e_phoff + k * sizeof part), SEEK_SET) == 0 &&
               fread(&part, sizeof part, 1, f) == 1;
        const uint32_t at = part.p_paddr - c->memory.flash;
        if (!good || part.p_type != PT_LOAD || part.p_filesz == 0)
            continue;
        good = at < c->memory.flash_size && fseek(f, (long)part.p_offset, SEEK_SET) == 0 &&
               fread(c->flash_bytes + at, 1, part.p_filesz, f) == part.p_filesz;
    }
    return good;
}

/* Blocks of 512 bytes: two words, flags, address, size, number, count, what it is for, data, and a
 * word at the end (github.com/microsoft/uf2). */
static bool load_uf2(struct arm_core *c, FILE *f)
{
    uint32_t block[128], count = 0;

    for (; fread(block, sizeof block, 1, f) == 1; count++) {
        const uint32_t at = block[3] - c->memory.flash;
        if (block[0] != UF2_BEGIN || block[1] != 0x9E5D5157 || block[127] != 0x0AB16F30 ||
            block[5] != count || block[4] > 476 || at > c->memory.flash_size - block[4])
            return false;
        memcpy(c->flash_bytes + at, &block[8], block[4]);
    }
    return count > 0 && block[6] == count;
}

static int load_file(struct arm_core *c, const char *file)
{
    FILE *f = fopen(file, "rb");
    uint32_t word = 0;
    bool good = f && fread(&word, 4, 1, f) == 1 && fseek(f, 0, SEEK_SET) == 0;

    good = good && (word == UF2_BEGIN ? load_uf2(c, f) : load_elf(c, f));
    if (f)
        fclose(f);
    if (!good)
        fprintf(stderr, "%s: cannot be loaded\n", file);
    return good ? 0 : EX_NOINPUT;
}


// The core's registers
// --------------------

static uint64_t read_core(uc_engine *uc, uint64_t offset, unsigned size, void *context)
{
    struct arm_core *c = context;

    (void)uc;
    (void)size;
    switch (offset) {
    case 0xE010: return c->tick_csr;
    case 0xE014: return c->tick_reload;
    case 0xED20: return (uint32_t)c->priority[PENDSV] << 16 | (uint32_t)c->priority[SYSTICK] << 24;
    default: break;
    }
    if (offset - 0xE400 < ARM_IRQS) {
        uint32_t word = 0;
        for (unsigned k = 0; k < 4; k++)
            word |= (uint32_t)c->priority[16 + (offset - 0xE400) + k] << 8 * k;
        return word;
    }
    return 0;
}

static void write_core(uc_engine *uc, uint64_t offset, unsigned size, uint64_t value, void *context)
{
    struct arm_core *c = context;

    (void)uc;
    (void)size;
    if (offset == 0xE010) {
        if (value & 1 && !(c->tick_csr & 1))
            c->tick_at = c->now + c->tick_reload + 1;
        c->tick_csr = (uint32_t)value;
    } else if (offset == 0xE014) {
        c->tick_reload = (uint32_t)value;
    } else if (offset - 0xE100 < ARM_IRQS / 8) {
        for (unsigned k = 0; k < 32; k++)
            c->enabled[(offset - 0xE100) * 8 + k] |= value >> k & 1;
    } else if (offset - 0xE400 < ARM_IRQS) {
        for (unsigned k = 0; k < 4; k++)
            c->priority[16 + (offset - 0xE400) + k] = (uint8_t)(value >> 8 * k);
    } else if (offset == 0xED04) {
        c->pending[PENDSV] |= value >> 28 & 1;
    } else if (offset == 0xED08) {
        c->vectors = (uint32_t)value;
    } else if (offset == 0xED20) {
        c->priority[PENDSV] = (uint8_t)(value >> 16);
        c->priority[SYSTICK] = (uint8_t)(value >> 24);
    }
    c->due = c->now;
}

static uint64_t read_chip(struct arm_core *c, uint32_t address, unsigned size)
{
    c->advance(c->chip, c->now);
    const uint32_t word = c->read(c->chip, address & ~3u);
    return size == 4 ? word : word >> 8 * (address & 3) & (size == 2 ? 0xFFFFu : 0xFFu);
}

static void write_chip(struct arm_core *c, uint32_t address, uint32_t value, unsigned size)
{
    c->advance(c->chip, c->now);
    c->stored = size;
    c->write(c->chip, address, value);
    c->due = c->now;
}

/* Unicorn tells the offset in a region, not the region. */
#define REGION(name, base)                                                                         \
    static uint64_t read_##name(uc_engine *uc, uint64_t offset, unsigned size, void *context)      \
    {                                                                                              \
        (void)uc;                                                                                  \
        return read_chip(context, (base) + (uint32_t)offset, size);                                \
    }                                                                                              \
    static void write_##name(uc_engine *uc, uint64_t offset, unsigned size, uint64_t value,        \
                             void *context)                                                        \
    {                                                                                              \
        (void)uc;                                                                                  \
        write_chip(context, (base) + (uint32_t)offset, (uint32_t)value, size);                     \
    }

REGION(flash_port, 0x18000000u)     /* of an RP2040: its flash, */
REGION(buses, 0x40000000u)
REGION(core_port, 0xD0000000u)      /* and the pins of its cores */
REGION(kept, 0x080C0000u)           /* of an STM32F405: sectors 10 and 11 of its flash, */
REGION(about, 0x1FFF7000u)          /* and how much there is */


// Running
// -------

/* Thumb: an instruction whose first five bits are 11101, 11110 or 11111 has two half words. */
static unsigned count_instructions(const uint8_t *block, uint32_t size)
{
    unsigned count = 0;

    for (uint32_t k = 0; k < size; count++)
        k += block[k + 1] >> 3 >= 0x1D ? 4 : 2;
    return count;
}

static void on_block(uc_engine *uc, uint64_t address, uint32_t size, void *context)
{
    struct arm_core *c = context;
    const bool in_ram = (uint32_t)address - c->memory.flash >= c->memory.flash_size;
    const uint32_t at = (uint32_t)address - (in_ram ? c->memory.ram : c->memory.flash);

    if (c->now >= c->due) {
        c->stopped_at = (uint32_t)address;
        uc_emu_stop(uc);
        return;
    }
    if (in_ram && at >= c->memory.ram_size)
        return;
    uint8_t *const count = &c->counts[in_ram][at / 2];
    if (*count == 0)
        *count = (uint8_t)count_instructions((in_ram ? c->ram_bytes : c->flash_bytes) + at, size);
    const unsigned exception = c->depth ? c->nest[c->depth - 1].exception : 0;
    c->now += *count;
    c->ran += *count;
    c->ran_in[exception] += *count;
}

static void on_sleep(uc_engine *uc, uint64_t address, uint32_t size, void *context)
{
    struct arm_core *c = context;

    c->asleep = true;
    c->stopped_at = (uint32_t)(address + size);
    uc_emu_stop(uc);
}

/* Unicorn takes any function as an address of data. */
static uc_err add_hook(struct arm_core *c, int type,
                       void (*call)(uc_engine *, uint64_t, uint32_t, void *), uint64_t from,
                       uint64_t to)
{
    uc_hook hook;
    void *data;

    memcpy(&data, &call, sizeof data);
    return uc_hook_add(c->uc, &hook, type, data, c, from, to);
}

void arm_core_jump(struct arm_core *c, uint32_t pc, uint32_t sp)
{
    uc_reg_write(c->uc, UC_ARM_REG_SP, &sp);
    uc_reg_write(c->uc, UC_ARM_REG_PC, &pc);
}

static void find_sleep(struct arm_core *c)
{
    static const uint8_t sleep[2] = { 0x30, 0xBF };
    const struct arm_memory *m = &c->memory;
    const uint32_t runs = m->image ? m->ram - (m->image - m->flash) : m->flash;

    for (uint32_t at = 0; at + 2 <= m->flash_size; at += 2)
        if (memcmp(c->flash_bytes + at, sleep, 2) == 0)
            (void)add_hook(c, UC_HOOK_CODE, on_sleep, runs + at, runs + at);
}

int arm_core_start(struct arm_core *c, const char *file, int model, bool fpu)
{
    const struct arm_memory *m = &c->memory;

    c->fpu = fpu;
    c->flash_bytes = calloc(1, m->flash_size);
    c->ram_bytes = calloc(1, m->ram_size);
    c->counts[0] = calloc(1, m->flash_size / 2);
    c->counts[1] = calloc(1, m->ram_size / 2);
    c->vectors = m->flash;
    const int code = load_file(c, file);
    if (code != 0)
        return code;
    if (uc_open(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS, &c->uc) != UC_ERR_OK ||
        uc_ctl_set_cpu_model(c->uc, model) != UC_ERR_OK ||
        uc_mem_map_ptr(c->uc, m->flash, m->flash_size, UC_PROT_READ | UC_PROT_EXEC,
                       c->flash_bytes) != UC_ERR_OK ||
        uc_mem_map_ptr(c->uc, m->ram, m->ram_size, UC_PROT_ALL, c->ram_bytes) != UC_ERR_OK ||
        uc_mem_map(c->uc, RETURN & ~0xFFFu, 0x1000, UC_PROT_READ | UC_PROT_EXEC) != UC_ERR_OK ||
        uc_mmio_map(c->uc, 0x18000000, 0x1000, read_flash_port, c, write_flash_port, c) !=
            UC_ERR_OK ||
        uc_mmio_map(c->uc, 0x40000000, 0x20000000, read_buses, c, write_buses, c) != UC_ERR_OK ||
        uc_mmio_map(c->uc, 0xD0000000, 0x1000, read_core_port, c, write_core_port, c) !=
            UC_ERR_OK ||
        uc_mmio_map(c->uc, PPB, 0x100000, read_core, c, write_core, c) != UC_ERR_OK ||
        add_hook(c, UC_HOOK_BLOCK, on_block, 1, 0) != UC_ERR_OK) {
        fprintf(stderr, "unicorn: cannot make the chip\n");
        return EX_SOFTWARE;
    }
    if (m->kept &&
        (uc_mmio_map(c->uc, 0x080C0000, 0x40000, read_kept, c, write_kept, c) != UC_ERR_OK ||
         uc_mmio_map(c->uc, 0x1FFF7000, 0x1000, read_about, c, write_about, c) != UC_ERR_OK)) {
        fprintf(stderr, "unicorn: cannot make the flash of the chip\n");
        return EX_SOFTWARE;
    }
    find_sleep(c);
    arm_core_jump(c, arm_core_word(c, m->flash + 4), arm_core_word(c, m->flash));
    return 0;
}

void arm_core_raise(struct arm_core *c, unsigned irq)
{
    c->pending[16 + irq] = true;
    c->due = c->now;
}

static int priority_now(const struct arm_core *c)
{
    return c->depth ? c->priority[c->nest[c->depth - 1].exception] : THREAD;
}

static const int frame_registers[8] = { UC_ARM_REG_R0,  UC_ARM_REG_R1, UC_ARM_REG_R2,
                                        UC_ARM_REG_R3,  UC_ARM_REG_R12, UC_ARM_REG_LR,
                                        UC_ARM_REG_PC,  UC_ARM_REG_XPSR };

/* The frame is in the memory of the firmware, the float registers are here. */
static void enter(struct arm_core *c, unsigned exception)
{
    struct arm_frame *frame = &c->nest[c->depth++];
    uint32_t sp, word[8], lr = RETURN | 1;

    frame->exception = exception;
    uc_reg_read(c->uc, UC_ARM_REG_SP, &sp);
    for (int k = 0; k < 8; k++)
        uc_reg_read(c->uc, frame_registers[k], &word[k]);
    if (c->fpu) {
        for (int k = 0; k < 8; k++)
            uc_reg_read(c->uc, UC_ARM_REG_D0 + k, &frame->fp[k]);
        uc_reg_read(c->uc, UC_ARM_REG_FPSCR, &frame->fpscr);
    }
    word[6] |= 1;
    sp -= 32;
    uc_mem_write(c->uc, sp, word, sizeof word);
    const uint32_t pc = arm_core_word(c, c->vectors + 4 * exception),
                   state = word[7] & ~0x0600FC00u;      /* not in an IT block */
    uc_reg_write(c->uc, UC_ARM_REG_XPSR, &state);
    uc_reg_write(c->uc, UC_ARM_REG_SP, &sp);
    uc_reg_write(c->uc, UC_ARM_REG_LR, &lr);
    uc_reg_write(c->uc, UC_ARM_REG_PC, &pc);
    c->pending[exception] = false;
    c->taken[exception]++;
    c->asleep = false;
}

static void leave(struct arm_core *c)
{
    struct arm_frame *frame = &c->nest[--c->depth];
    uint32_t sp, word[8];

    uc_reg_read(c->uc, UC_ARM_REG_SP, &sp);
    uc_mem_read(c->uc, sp, word, sizeof word);
    for (int k = 7; k >= 0; k--)
        uc_reg_write(c->uc, frame_registers[k], &word[k]);
    if (c->fpu) {
        for (int k = 0; k < 8; k++)
            uc_reg_write(c->uc, UC_ARM_REG_D0 + k, &frame->fp[k]);
        uc_reg_write(c->uc, UC_ARM_REG_FPSCR, &frame->fpscr);
    }
    sp += 32;
    uc_reg_write(c->uc, UC_ARM_REG_SP, &sp);
    word[6] |= 1;
    uc_reg_write(c->uc, UC_ARM_REG_PC, &word[6]);
}

/* The pending exception of highest priority, if it may interrupt; 0: none. */
static unsigned exception_due(const struct arm_core *c)
{
    unsigned best = 0;
    int priority = priority_now(c);

    for (unsigned k = PENDSV; k < 16 + ARM_IRQS; k++)
        if (c->pending[k] && (k < 16 || c->enabled[k - 16]) && c->priority[k] < priority &&
            (k != c->hold_irq || c->now >= c->hold_until)) {
            best = k;
            priority = c->priority[k];
        }
    return best;
}

static void advance(struct arm_core *c)
{
    c->advance(c->chip, c->now);
    while (c->tick_csr & 1 && c->now >= c->tick_at) {
        c->tick_at += c->tick_reload + 1;
        c->pending[SYSTICK] = true;
    }
}

static uint64_t next_event(const struct arm_core *c)
{
    uint64_t next = c->next(c->chip);

    if (c->tick_csr & 1 && c->tick_at < next)
        next = c->tick_at;
    if (c->hold_irq && c->hold_until > c->now && c->hold_until < next)
        next = c->hold_until;
    return next;
}

bool arm_core_run(struct arm_core *c, uint64_t until)
{
    while (c->now < until && !c->failed) {
        uint32_t pc;
        advance(c);
        for (unsigned k; (k = exception_due(c)) != 0;)
            enter(c, k);
        const uint64_t next = next_event(c);
        c->due = next < until ? next : until;
        c->due = c->due > c->now ? c->due : c->now + 1;     /* one block, if it may not interrupt */
        if (c->asleep) {
            c->now = c->due;
            continue;
        }
        uc_reg_read(c->uc, UC_ARM_REG_PC, &pc);
        if ((pc & ~1u) != RETURN) {
            const uc_err error = uc_emu_start(c->uc, pc | 1, RETURN, 0, 0);
            uc_reg_read(c->uc, UC_ARM_REG_PC, &pc);
            if (c->stopped_at) {            /* unicorn's own is that of a block before */
                pc = c->stopped_at | 1;
                uc_reg_write(c->uc, UC_ARM_REG_PC, &pc);
                c->stopped_at = 0;
            }
            if (error != UC_ERR_OK) {
                fprintf(stderr, "chip: %s at %#x\n", uc_strerror(error), (unsigned)pc);
                c->failed = true;
            }
        }
        if ((pc & ~1u) == RETURN && c->depth)
            leave(c);
    }
    return !c->failed;
}
