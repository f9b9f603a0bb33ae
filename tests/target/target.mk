# tests/target/target.mk -- the tests on emulated chips: arithmetic, calls, whole jobs, unit tests
# SPDX-License-Identifier: MIT

## Check the firmware on emulated chips: arithmetic bit for bit, whole jobs, pulses, timing
.PHONY: check-target
check-target: lib/names.h
	@MAKE="$(MAKE)" bash tests/house/check.sh $(TARGET_STAGES)

## Run arithmetic, curves and grids on an emulated ATmega328P and Cortex-M0: bit for bit
.PHONY: check-sums
check-sums: lib/names.h
	@sh tests/target/target.sh

## Compare flash and RAM of typical selections with the table of lib/COSTS.md: what grew
.PHONY: check-footprint
check-footprint: lib/names.h
	@bash tests/house/footprint.sh

## Write that table
.PHONY: footprint
footprint: lib/names.h
	@bash tests/house/footprint.sh write

## Compare the stack of each function, per chip, with lib/STACK.md and the headers: what grew
.PHONY: check-stack
check-stack: lib/names.h
	@python3 tests/house/stack.py

## Write that page, and the `stack` lines of the headers
.PHONY: stack
stack: lib/names.h
	@python3 tests/house/stack.py write

## Check the cost of the calls of lib/motion/span.h on an emulated ATmega328P, Cortex-M0 and M4
.PHONY: check-calls
check-calls: lib/names.h
	@sh tests/target/calls.sh build/calls

## Compare faster steps of walks and slots with their definitions: 10^7 random states (minutes)
.PHONY: sweep-steps
sweep-steps: lib/names.h
	@sh tests/target/steps.sh build/steps

build/target/stores.so: tests/target/stores.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -shared -fPIC $< -o $@

build/target/bad_line: tests/target/bad_line.c build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Itests $(BUILT) $(STD) $(DEPS) -MF $@.d -MT $@ \
	    -D_GNU_SOURCE $(call num_flag,q16) $(filter %.c %.a,$^) -o $@
-include build/target/bad_line.d

ARM_CHIP_SRC = $(patsubst %,tests/target/%.c,arm_chip arm_core arm_stream arm_stm32 arm_pio \
                                             arm_rp2040 arm_nrf51 chip_line avr_gate) \
               ports/host/line.c ports/host/record.c
build/target/arm_chip: $(ARM_CHIP_SRC) $(wildcard tests/target/arm_*.h tests/target/chip_*.h) \
                       build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -D_GNU_SOURCE $(INCLUDE) -Iports -Itests/target \
	    $(call num_flag,q16) $(ARM_CHIP_SRC) build/q16x3/libloft.a -lunicorn -lm -o $@

## Run boards that step by a timer and DMA in a model of both: every slot, guards, instructions
.PHONY: check-stream
check-stream: $(patsubst %,firmware-%,stm32f405 stm32f405-fast stm32f103 stm32f103-fast \
                                     stm32g0 stm32g0-fast rp2040 rp2040-fast rp2350 rp2350-fast \
                                     nrf51) \
              build/target/arm_chip build/target/rate $(TOOL_OUT)/loft
	@bash tests/target/stream.sh build/firmware $(TOOL_OUT)/loft build/target
TARGET_BESIDE += check-stream

## Run a whole job on each 32-bit board in QEMU: every pulse at the pins, also over a bad line
.PHONY: check-boards
check-boards: $(addprefix firmware-,$(FIRMWARES)) build/target/stores.so build/target/bad_line \
              build/target/arm_chip $(TOOL_OUT)/loft
	@bash tests/target/qemu.sh build/firmware $(TOOL_OUT)/loft build/target/stores.so \
	    build/target/bad_line build/target/arm_chip

include tests/target/units.mk
include tests/target/hosts.mk
