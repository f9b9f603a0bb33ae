# tests/target/units.mk -- the tests of tests/ on emulated chips: their objects, one set per
# instruction set and number type
# SPDX-License-Identifier: MIT
#
# The library is that of the firmware, with its compiler and flags. Clang compiles the tests and the
# functions under them, which replace a C library: it has a long double of 113 bits and integers of
# 128 bits on any core (libc/quad.c, libc/int128.c). So the references are as exact as on the host.

UNIT_SHARE ?= 1000
# an integer core and one with floats; the first has room for all tests. The Cortex-M0 without
# a long product is held by check-sums, check-calls and check-boards too
UNIT_BOARDS ?= $(if $(ALL),,mps2-an385 stm32f405-f32)
UNIT_EACH   := mps2-an385 riscv-virt nrf51 stm32f405-q16 stm32f405-f32 mps2-an500 mps2-an505
UNITS      := build/units
# those that no board runs stand in NOWHERE, with their reasons
UNITS_LEFT := %_loops $(shell sed -n 's/^    "\([a-z_]*\)": ".*/\1/p' tests/target/units.py)
UNIT_TESTS := $(filter-out $(UNITS_LEFT),$(TESTS))
UNIT_BASE  := libc/quad libc/int128 libc/aeabi libc/math libc/print alarm units
UNIT_FLAGS  = -std=c99 -ffreestanding -O1 -Xclang -mlong-double-128 -Xclang -fforce-enable-int128 \
              -ffp-contract=off '-D__float128=long double' \
              -Wall -Wextra -Werror=implicit-function-declaration -Wno-unused-function \
              -Wno-sometimes-uninitialized \
              -Itests/target/libc -Itests/target -Itests -Ilib -DLOFT_AXES=3

# unit_set NAME, number type, clang's flags of the core, what it starts with
define unit_set
$(UNITS)/$(1)/test_%.o: test_%.c $(wildcard tests/target/libc/*.h) | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)clang $(3) $$(UNIT_FLAGS) -DLOFT_NUM=LOFT_$(2) $$(DEPS) -DCHECK_SHARE=$$(UNIT_SHARE) \
	    -Dmain=main_$$* -c $$< -o $$@
$(UNITS)/$(1)/%.o: tests/target/%.c \
                   $(wildcard $(addprefix tests/target/,*.h libc/*.h libc/*/*.h))
	@mkdir -p $$(@D)
	$$(Q)clang $(3) $$(UNIT_FLAGS) -DLOFT_NUM=LOFT_$(2) -c $$< -o $$@
$(UNITS)/$(1)/test_libc.o: tests/target/libc/test_libc.c $(wildcard tests/target/libc/*.h)
	@mkdir -p $$(@D)
	$$(Q)clang $(3) $$(UNIT_FLAGS) -DLOFT_NUM=LOFT_$(2) -DCHECK_SHARE=10 -Dmain=main_libc \
	    -c $$< -o $$@
-include $(patsubst %,$(UNITS)/$(1)/test_%.d,$(UNIT_TESTS))
UNIT_OBJ_$(1) = $$(patsubst %,$(UNITS)/$(1)/test_%.o,libc $$(UNIT_TESTS)) \
                $$(patsubst %,$(UNITS)/$(1)/%.o,$$(UNIT_BASE) $(4))
endef
UNIT_ARM = -fshort-enums --target=thumb
UNIT_M0  = $(UNIT_ARM)v6m-none-eabi -mcpu=cortex-m0 -DLOFT_MACHINE_PLANS=0
UNIT_RV  = --target=riscv32-unknown-elf -march=rv32imac -mabi=ilp32 -mcmodel=medany -mno-relax
$(eval $(call unit_set,v6m-q16,Q16,$(UNIT_M0),start_cortex))
$(eval $(call unit_set,v7m-q16,Q16,$(UNIT_ARM)v7m-none-eabi -mcpu=cortex-m3,start_cortex))
$(eval $(call unit_set,v7em-f32,F32,$(UNIT_ARM)v7em-none-eabihf -mcpu=cortex-m4,start_cortex))
$(eval $(call unit_set,rv32-q16,Q16,$(UNIT_RV),))

# unit_board NAME, tool prefix: the whole library as in its firmware, in an archive
define unit_board
$(UNITS)/$(1)/libloft.a: $(patsubst %.c,build/firmware/$(1)/%.o,$(LIB_SRC) ports/bare/memory.c)
	@mkdir -p $$(@D)
	$$(Q)rm -f $$@; $(2)-ar rcs $$@ $$^
endef
$(foreach b,nrf51 stm32f405 mps2-an385 mps2-an500 mps2-an505,\
    $(eval $(call unit_board,$(b),arm-none-eabi)))
$(eval $(call unit_board,riscv-virt,riscv64-unknown-elf))

# the same library in f32 for a Cortex-M4F
$(UNITS)/stm32f405-f32/%.o: %.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)arm-none-eabi-gcc -mthumb $(CORTEX_M4F) \
	    $(patsubst %LOFT_Q16,%LOFT_F32,$(FIRMWARE_FLAGS)) -c $< -o $@
-include $(patsubst %.c,$(UNITS)/stm32f405-f32/%.d,$(LIB_SRC))
$(UNITS)/stm32f405-f32/libloft.a: $(patsubst %.c,$(UNITS)/stm32f405-f32/%.o,\
                                              $(LIB_SRC) ports/bare/memory.c)
	$(Q)rm -f $@; arm-none-eabi-ar rcs $@ $^

$(UNITS)/riscv-start.o: ports/riscv-virt/start.S
	@mkdir -p $(@D)
	$(Q)$(RISCV_GCC) -c $< -o $@
$(UNITS)/riscv-semihost.o: tests/target/semihost.S
	@mkdir -p $(@D)
	$(Q)$(RISCV_GCC) -c $< -o $@
$(UNITS)/arm-semihost.o: tests/target/semihost.S
	@mkdir -p $(@D)
	$(Q)arm-none-eabi-gcc -mthumb -mcpu=cortex-m0 -c $< -o $@
$(UNITS)/quad_check: tests/target/libc/quad_check.c tests/target/libc/quad.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(LDFLAGS) -std=gnu99 $(BUILT) -Wall -Wextra $< -o $@

# What the boards of UNIT_BOARDS need: each has its library and its objects.
UNIT_NEEDS_mps2-an385    = $(UNITS)/mps2-an385/libloft.a $(UNIT_OBJ_v7m-q16)
UNIT_NEEDS_mps2-an500    = $(UNITS)/mps2-an500/libloft.a $(UNIT_OBJ_v7m-q16)
UNIT_NEEDS_mps2-an505    = $(UNITS)/mps2-an505/libloft.a $(UNIT_OBJ_v7m-q16)
UNIT_NEEDS_nrf51         = $(UNITS)/nrf51/libloft.a $(UNIT_OBJ_v6m-q16)
UNIT_NEEDS_stm32f405-q16 = $(UNITS)/stm32f405/libloft.a $(UNIT_OBJ_v7m-q16)
UNIT_NEEDS_stm32f405-f32 = $(UNITS)/stm32f405-f32/libloft.a $(UNIT_OBJ_v7em-f32)
UNIT_NEEDS_stm32f405     = $(UNIT_NEEDS_stm32f405-q16) $(UNIT_NEEDS_stm32f405-f32)
UNIT_NEEDS_riscv-virt    = $(UNITS)/riscv-virt/libloft.a $(UNIT_OBJ_rv32-q16) \
                           $(UNITS)/riscv-start.o $(UNITS)/riscv-semihost.o
UNIT_RUN  = $(or $(strip $(UNIT_BOARDS)),$(UNIT_EACH))
UNIT_MADE = $(UNITS)/arm-semihost.o $(UNITS)/quad_check \
            $(sort $(foreach b,mps2-an385 $(UNIT_RUN),$(UNIT_NEEDS_$(b))))
UNIT_LEFT = $(filter-out $(UNIT_RUN),$(UNIT_EACH))

## Run the tests on emulated Cortex-M3 and M4F (f32)   UNIT_BOARDS="nrf51 .." UNIT_SHARE=1000 seeds
.PHONY: check-units
check-units: $(UNIT_MADE)
	@$(if $(UNIT_LEFT),echo "left to make check-all: $(UNIT_LEFT)")
	@python3 tests/target/units.py $(UNITS) $(UNIT_BOARDS)

## Run them on M0, M7, M33, rv32imac and the M4F in q16 too, 9 minutes more
.PHONY: check-units-all
check-units-all:
	@$(MAKE) check-units UNIT_BOARDS=
