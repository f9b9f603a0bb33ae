/* ports/riscv-virt/port.c -- RISC-V (rv32imac), QEMU's board `virt`: three axes
 * SPDX-License-Identifier: MIT
 *
 * It has a serial line (an NS16550 at 0x10000000) and timers, but no pins; the array `pins`
 * replaces them. A program that watches its addresses sees each pulse: pins[step + 8 * dir] is
 * written when pins are set. The slot is the timer interrupt. It requests the software interrupt,
 * which computes the tick with interrupts enabled.
 */
#include "port.h"

#define REG(address)    (*(volatile uint32_t *)(uintptr_t)(address))
#define REG8(address)   (*(volatile uint8_t *)(uintptr_t)(address))

#define LINE    0x10000000
#define CLOCK   0x00101000              /* goldfish-rtc: nanoseconds of the host's time */
#define MSIP    0x02000000
#define CMP     0x02004000              /* mtimecmp */
#define TIME    0x0200BFF8              /* mtime, 10 MHz */
#define PLIC    0x0C000000
#define CLAIM   (PLIC + 0x200004)
#define LINE_IRQ 10u
#define TIME_HZ 10000000u

#define CELLS   1024
#include "plans.h"

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(160), LOFT_RAW(1000), 20000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = 40, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 160,
    .cell = cells,
    .cells = CELLS
};
static uint32_t period;
static uint64_t due;

extern volatile uint8_t pins[64];
/* if the start cleared it, that would look like pulses */
volatile uint8_t pins[64] __attribute__((section(".noinit")));

#define CSR_SET(name, bits)                                                                        \
    __asm__ volatile(".option push\n .option arch, +zicsr\n csrs " #name ", %0\n .option pop"      \
                     :                                                                             \
                     : "r"(bits)                                                                   \
                     : "memory")
#define CSR_CLEAR(name, bits)                                                                      \
    __asm__ volatile(".option push\n .option arch, +zicsr\n csrc " #name ", %0\n .option pop"      \
                     :                                                                             \
                     : "r"(bits)                                                                   \
                     : "memory")
#define CSR_READ(name, to)                                                                         \
    __asm__ volatile(".option push\n .option arch, +zicsr\n csrr %0, " #name "\n .option pop"      \
                     : "=r"(to))
#define CSR_WRITE(name, from)                                                                      \
    __asm__ volatile(".option push\n .option arch, +zicsr\n csrw " #name ", %0\n .option pop"      \
                     :                                                                             \
                     : "r"(from)                                                                   \
                     : "memory")

#define MIE     8u                      /* of mstatus                    */
#define SOFT    (1u << 3)               /* of mie: software, timer, line */
#define TIMER   (1u << 7)
#define OUTSIDE (1u << 11)

static void set_due(void)
{
    REG(CMP + 4) = 0xFFFFFFFF;          /* no match while it is half written */
    REG(CMP) = (uint32_t)due;
    REG(CMP + 4) = (uint32_t)(due >> 32);
}

static void slot(void)
{
    due += period;
    set_due();
    loft_port_slot();
    REG(MSIP) = 1;
}

/* Slots and the line may interrupt it, but not the tick itself. */
static void tick(void)
{
    uint32_t epc, status;

    REG(MSIP) = 0;
    CSR_READ(mepc, epc);
    CSR_READ(mstatus, status);
    CSR_CLEAR(mie, SOFT);
    CSR_SET(mstatus, MIE);
    loft_port_tick();
    CSR_CLEAR(mstatus, MIE);
    CSR_SET(mie, SOFT);
    CSR_WRITE(mstatus, status);
    CSR_WRITE(mepc, epc);
}

static void line(void)
{
    const uint32_t irq = REG(CLAIM);

    while (REG8(LINE + 5) & 1)
        loft_port_byte(REG8(LINE));
    REG(CLAIM) = irq;
}

__attribute__((interrupt("machine"), aligned(4))) void trap(void);
void trap(void)
{
    uint32_t cause;

    CSR_READ(mcause, cause);
    switch (cause) {
    case 0x80000007:    slot();     break;
    case 0x80000003:    tick();     break;
    case 0x8000000B:    line();     break;
    default:
        for (;;) {
        } /* a fault: no slot comes, so no step is made */
    }
}

loft_machine_config *loft_port_init(void)
{
    config.info.boot = REG(CLOCK) ^ REG(CLOCK + 4) << 16;
    REG8(LINE + 3) = 3;                 /* 8N1                   */
    REG8(LINE + 2) = 1;                 /* queues of bytes       */
    REG8(LINE + 1) = 1;                 /* interrupt for a byte  */
    REG(PLIC + 4 * LINE_IRQ) = 1;
    REG(PLIC + 0x2000) = 1u << LINE_IRQ;
    REG(PLIC + 0x200000) = 0;
    loft_port_plans(&config);
    return &config;
}

void loft_port_start(uint32_t slot_hz)
{
    period = TIME_HZ / slot_hz;
    due = REG(TIME) + period;
    set_due();
    CSR_SET(mie, SOFT | TIMER | OUTSIDE);
    CSR_SET(mstatus, MIE);
}

void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    if (step_bits)
        pins[step_bits + 8 * dir_bits] = 1;
}

size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0 || !(REG8(LINE + 5) & 1 << 5))
        return 0;
    REG8(LINE) = *bytes;
    return 1;
}

uint16_t loft_port_inputs(void) { return 0; }

void loft_port_wait(void) { __asm__ volatile("wfi" ::: "memory"); }
