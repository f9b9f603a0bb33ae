# tests/target/hosts.mk -- the tests on a 32-bit x86 and, by qemu-user, on a big-endian PowerPC
# SPDX-License-Identifier: MIT
#
# The library is compiled by gcc for that processor. Tests are compiled by clang for libc/, as for
# chips (units.mk): a reference has 113 bits there, and whole numbers have 128.

HOST_SHARE ?= 1000
HOSTS      := build/hosts
HOST_UNITS := $(filter-out $(UNITS_LEFT),$(TESTS))      # as units.py says
# Linux has an abort of its own. Most tests run one seed of 1000: compiled at -O0 in a third of the
# time.
HOST_UNIT_FLAGS = $(UNIT_FLAGS) -Dabort=unit_abort

# host_set NAME, number type, processor, clang's flags of it, gcc's
define host_set
$(HOSTS)/$(1)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$(3)-linux-gnu-gcc $(5) $$(INCLUDE) -O2 $$(STD) $$(DEPS) -ffreestanding \
	    $$(call num_flag,$(2)) -c $$< -o $$@
$(HOSTS)/$(1)/test_%.o: test_%.c $(wildcard tests/target/libc/*.h) | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)clang --target=$(3)-linux-gnu $(4) $$(HOST_UNIT_FLAGS) -O0 $$(call num_flag,$(2)) \
	    $$(DEPS) -DCHECK_SHARE=$$(HOST_SHARE) -Dmain=main_$$* -c $$< -o $$@
$(HOSTS)/$(1)/libc/quadtf.o: tests/target/libc/quad.c
	@mkdir -p $$(@D)
	$$(Q)clang --target=$(3)-linux-gnu $(4) $$(HOST_UNIT_FLAGS) $$(call num_flag,$(2)) \
	    -c $$< -o $$@
$(HOSTS)/$(1)/libc/%.o: tests/target/libc/%.c $(wildcard tests/target/libc/*.h)
	@mkdir -p $$(@D)
	$$(Q)clang --target=$(3)-linux-gnu $(4) $$(QUAD_FLAGS) $$(HOST_UNIT_FLAGS) $$(call num_flag,$(2)) \
	    -c $$< -o $$@
$(HOSTS)/$(1)/units.c: $(MAKEFILE_LIST)
	@mkdir -p $$(@D)
	$$(Q){ echo '#include "units.h"'; \
	    for t in $(HOST_UNITS); do echo "int main_$$$$t(void);"; done; \
	    echo 'const struct unit units[] = {'; \
	    for t in $(HOST_UNITS); do echo "    { \"$$$$t\", main_$$$$t },"; done; \
	    echo '    { 0, 0 } };'; } > $$@
$(HOSTS)/$(1)/tests: tests/target/hosts.c $(HOSTS)/$(1)/units.c \
    $(patsubst %,$(HOSTS)/$(1)/test_%.o,$(HOST_UNITS)) \
    $(patsubst %,$(HOSTS)/$(1)/libc/%.o,quad int128 math print) \
    $(patsubst %.c,$(HOSTS)/$(1)/%.o,$(LIB_SRC))
	$$(SAY) "  LD  $$@"
	$$(Q)$(3)-linux-gnu-gcc -std=gnu99 -O1 -Itests/target -static -Wl,--no-warn-mismatch \
	    $$(filter %.c %.o,$$^) -o $$@
-include $(patsubst %,$(HOSTS)/$(1)/test_%.d,$(HOST_UNITS)) \
    $(patsubst %.c,$(HOSTS)/$(1)/%.d,$(LIB_SRC))
endef
$(eval $(call host_set,i686-q16,q16,i686,,))
# floats as the standard says them: without SSE a 32-bit x86 computes in 80 bits
$(eval $(call host_set,i686-f64,f64,i686,-msse2,-msse2 -mfpmath=sse))
$(eval $(call host_set,powerpc-q16,q16,powerpc,-Xclang -mabi=ieeelongdouble))
HOST_EACH := i686-q16 i686-f64 powerpc-q16
HOST_RUN  := $(if $(ALL),$(HOST_EACH),powerpc-q16)
HOST_LEFT := $(filter-out $(HOST_RUN),$(HOST_EACH))
HOST_ALL  := $(patsubst %,$(HOSTS)/%/tests,$(HOST_RUN))

# clang calls the functions of a quad with results that are not aligned for SSE
$(HOSTS)/i686-f64/libc/quad.o: QUAD_FLAGS := -mno-sse
# on a PowerPC clang calls the functions of a quad by other names: __addkf3, not __addtf3
$(HOSTS)/powerpc-%/libc/quad.o: $(HOSTS)/powerpc-%/libc/quadtf.o
	$(Q)powerpc-linux-gnu-nm $< | \
	    sed -n 's/.* T \(__[a-z]*\)tf\([a-z0-9]*\)$$/\1tf\2 \1kf\2/p' > $@.names
	$(Q)powerpc-linux-gnu-objcopy --redefine-syms=$@.names $< $@

## Run the tests on a big-endian PowerPC; ALL=1: on a 32-bit x86 (q16, f64) too   HOST_SHARE=1000
.PHONY: check-hosts
check-hosts: $(HOST_ALL)
	@$(if $(HOST_LEFT),echo "left to make check-all: $(HOST_LEFT)")
	@bash tests/target/hosts.sh $(patsubst %/tests,%,$(HOST_ALL))
