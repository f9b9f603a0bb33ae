# ports/riscv-virt/port.mk -- RISC-V as QEMU's board virt has it
# SPDX-License-Identifier: MIT
RISCV_GCC = riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32 -mcmodel=medany -DRAM_SIZE=256K
$(eval $(call firmware,riscv-virt,$(RISCV_GCC),riscv64-unknown-elf,$(addprefix \
    ports/,riscv-virt/start.S riscv-virt/port.c bare/no_outputs.c),ports/riscv-virt/virt.ld.in))
