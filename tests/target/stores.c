/* tests/target/stores.c -- a QEMU plugin: prints each store of the guest to a range of addresses
 * SPDX-License-Identifier: MIT
 *
 *     qemu-system-riscv32 ... -plugin stores.so,lo=0x80001000,hi=0x80001040,out=FILE
 *
 * It prints a line per store: the offset in the range. QEMU's package has no header for plugins:
 * the declarations below are the used part of version 1 of its interface.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef uint32_t qemu_plugin_meminfo_t;
typedef struct qemu_info_t qemu_info_t;
typedef void on_tb(qemu_plugin_id_t id, struct qemu_plugin_tb *tb);
typedef void on_mem(unsigned vcpu, qemu_plugin_meminfo_t info, uint64_t address, void *context);

void   qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, on_tb *call);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t i);
void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *insn, on_mem *call, int registers,
                                      int access, void *context);

extern int qemu_plugin_version;
__attribute__((visibility("default"))) int qemu_plugin_version = 1;
__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t id,
                                                               const qemu_info_t *info, int argc,
                                                               char *argv[]);

static uint64_t lo, hi;
static FILE *out;

static void stored(unsigned vcpu, qemu_plugin_meminfo_t info, uint64_t address, void *context)
{
    (void)vcpu;
    (void)info;
    (void)context;
    if (address >= lo && address < hi)
        fprintf(out, "%" PRIu64 "\n", address - lo);
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); i++)
        /* stores only */
        qemu_plugin_register_vcpu_mem_cb(qemu_plugin_tb_get_insn(tb, i), stored, 0, 2, NULL);
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char *argv[])
{
    (void)info;
    for (int i = 0; i < argc; i++) {
        if (strncmp(argv[i], "lo=", 3) == 0)
            lo = strtoull(argv[i] + 3, NULL, 0);
        else if (strncmp(argv[i], "hi=", 3) == 0)
            hi = strtoull(argv[i] + 3, NULL, 0);
        else if (strncmp(argv[i], "out=", 4) == 0)
            out = fopen(argv[i] + 4, "w");
    }
    if (out == NULL || lo >= hi)
        return 1;
    setvbuf(out, NULL, _IOLBF, 0);
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
