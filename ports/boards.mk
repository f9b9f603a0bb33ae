# ports/boards.mk -- how the firmware of a 32-bit board is built; each port.mk names its boards
# SPDX-License-Identifier: MIT

FIRMWARE_SRC = ports/firmware.c ports/bare/memory.c $(wildcard $(addsuffix /*.c,lib/num lib/geom lib/motion lib/wire lib/machine))
FIRMWARE_FLAGS = -std=c99 -O2 -ffreestanding -ffunction-sections -fdata-sections -DLOFT_PLAN_FLOW=0 $(WARN) -Ilib -Iports $(call num_flag,q16)
FIRMWARES :=

# firmware BOARD, compiler and flags of the core, tool prefix, sources, script of the linker, its flags
define firmware
build/firmware/$(1)/%.o: %.c $$(LIB_HDR) $$(wildcard ports/*.h ports/*/*.h)
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$(2) $$(FIRMWARE_FLAGS) -c $$< -o $$@
build/firmware/$(1)/start.o: $(filter %.S,$(4))
	@mkdir -p $$(@D)
	$$(Q)$(2) -c $$< -o $$@
build/firmware/$(1)/loft.ld: $(5)
	@mkdir -p $$(@D)
	$$(Q)$(2) -E -P -x c $$< -o $$@
build/firmware/$(1)/loft.elf: $$(patsubst %.c,build/firmware/$(1)/%.o,$$(FIRMWARE_SRC) $(filter %.c,$(4))) $(if $(filter %.S,$(4)),build/firmware/$(1)/start.o) build/firmware/$(1)/loft.ld
	$$(SAY) "  LD  $$@"
	$$(Q)$(2) -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments -T build/firmware/$(1)/loft.ld $$(filter %.o,$$^) -lgcc -o $$@
.PHONY: firmware-$(1)
firmware-$(1): build/firmware/$(1)/loft.elf
	@$(3)-size $$< | awk 'NR == 2 { printf "%s: %d bytes of flash, %d of RAM without the stack\n", "$(1)", $$$$1 + $$$$2, $$$$2 + $$$$3 }'
FIRMWARES += $(1)
endef
