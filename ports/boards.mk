# ports/boards.mk -- how the firmware of a 32-bit board is built; each port.mk names its boards
# SPDX-License-Identifier: MIT

MACHINE_SRC  = $(wildcard $(patsubst %,lib/%/*.c,num geom kinematics path motion wire machine))
# what patches take of other rooms
PATCHES_SRC  = lib/toolpath/patches.c lib/toolpath/lines.c lib/toolpath/lines_check.c \
               lib/surface/tensor/grid.c lib/surface/tensor/tensor.c lib/curve/bezier.c \
               lib/basis/bernstein.c
FIRMWARE_SRC = ports/firmware.c ports/bare/memory.c $(MACHINE_SRC) $(PATCHES_SRC)
FIRMWARE_FLAGS = -std=c99 -O2 -ffreestanding -ffunction-sections -fdata-sections \
                 $(WARN) $(DEPS) -Ilib -Iports $(call num_flag,q16)
FIRMWARES :=

## Build the firmware of every board, print its flash and RAM   or one: make firmware-stm32f405
.PHONY: firmware
firmware:
	+@$(PARALLEL) firmware-atmega328p $(addprefix firmware-,$(FIRMWARES))

## Write it to a board   PORT=/dev/ttyUSB0 (an Uno), or BOARD=stm32f405|rp2040|rp2350|nrf51|..
.PHONY: flash
flash: BOARD ?= $(if $(PORT),atmega328p)
flash:
	@case "$(BOARD)" in \
	atmega328p|atmega328p-fast|stm32f405|stm32f405-fast|stm32f103|stm32f103-fast|stm32g0|stm32g0-fast|\
	rp2040|rp2040-fast|rp2350|rp2350-fast|nrf51) \
	    $(MAKE) --no-print-directory flash-$(BOARD) ;; \
	*) echo "name the board or its port: make flash PORT=/dev/ttyUSB0 (an ATmega328P)," \
	        "make flash BOARD=stm32f405 or BOARD=nrf51"; exit 1 ;; esac


# firmware BOARD, compiler and flags of the core, tool prefix, sources, script of the linker
define firmware
build/firmware/$(1)/%.o: %.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$(2) $$(FIRMWARE_FLAGS) -c $$< -o $$@
build/firmware/$(1)/start.o: $(filter %.S,$(4))
	@mkdir -p $$(@D)
	$$(Q)$(2) -c $$< -o $$@
build/firmware/$(1)/loft.ld: $(5)
	@mkdir -p $$(@D)
	$$(Q)$(2) -E -P -x c $$< -o $$@
build/firmware/$(1)/loft.elf: \
        $$(patsubst %.c,build/firmware/$(1)/%.o,$$(FIRMWARE_SRC) $(filter %.c,$(4))) \
        $(if $(filter %.S,$(4)),build/firmware/$(1)/start.o) build/firmware/$(1)/loft.ld
	$$(SAY) "  LD  $$@"
	$$(Q)$(2) -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments \
	    -T build/firmware/$(1)/loft.ld $$(filter %.o,$$^) -lgcc -o $$@
.PHONY: firmware-$(1)
firmware-$(1): build/firmware/$(1)/loft.elf
	@$(3)-size $$< | awk 'NR == 2 { \
	    printf "%s: %d bytes of flash, %d of RAM without the stack\n", \
	        "$(1)", $$$$1 + $$$$2, $$$$2 + $$$$3 }'
-include $$(patsubst %.c,build/firmware/$(1)/%.d,$$(LIB_SRC) $$(FIRMWARE_SRC) $(filter %.c,$(4)))
FIRMWARES += $(1)
endef
