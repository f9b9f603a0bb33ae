# loft: `make help` lists what can be made. On a fresh machine: make deps demo, make deps check.
# SPDX-License-Identifier: MIT
NUM  ?= q16
AXES ?= 3
NUMS := q16 f32 f64

CC       ?= cc
CPPFLAGS += -Ilib
CFLAGS   ?= -O2 -g
WARN     := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wundef
STD      := -std=c99 $(WARN)
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
num_flag  = -DLOFT_NUM=LOFT_$(shell echo $(1) | tr a-z A-Z) -DLOFT_AXES=$(AXES)

LIB_SRC  := $(sort $(wildcard lib/*/*.c))
LIB_HDR  := $(sort lib/names.h $(wildcard lib/*.h lib/*/*.h))
TESTS    := $(patsubst tests/test_%.c,%,$(sort $(wildcard tests/test_*.c)))

## Show this list
.PHONY: help
help:
	@awk '/^## /{h=substr($$0,4); getline; while ($$0 ~ /^\.PHONY/) getline; \
	      sub(/:.*/,""); printf "  %-14s %s\n",$$0,h}' $(MAKEFILE_LIST)

# every external function of lib/ carries its number type; regenerated when a header changes
lib/names.h: $(filter-out lib/names.h,$(wildcard lib/*/*.h)) tests/names.sh
	@sh tests/names.sh > $@.new; if cmp -s $@.new $@; then rm $@.new; touch $@; else mv $@.new $@; fi

# --- the library: build/<num>x<axes>/libloft.a, once per number type --------------------------------
define library
build/$(1)x$(AXES)/%.o: %.c $(LIB_HDR)
	@mkdir -p $$(@D)
	$$(CC) $$(CPPFLAGS) $$(CFLAGS) $$(STD) -ffreestanding $$(call num_flag,$(1)) -c $$< -o $$@
build/$(1)x$(AXES)/libloft.a: $(patsubst %.c,build/$(1)x$(AXES)/%.o,$(LIB_SRC))
	$$(AR) rcs $$@ $$^
endef
$(foreach n,$(NUMS),$(eval $(call library,$(n))))

## Build build/<num>x<axes>/libloft.a   NUM=q16|f32|f64  AXES=1..6
.PHONY: lib
lib: build/$(NUM)x$(AXES)/libloft.a

# --- tests: build/test/<num>/<module>, sanitized, one program per module and number type ------------
define tested
build/test/$(1)/lib/%.o: lib/%.c $(LIB_HDR)
	@mkdir -p $$(@D)
	$$(CC) $$(CPPFLAGS) -O1 -g $$(STD) $$(SANITIZE) $$(call num_flag,$(1)) -c $$< -o $$@
build/test/$(1)/libloft.a: $(patsubst %.c,build/test/$(1)/%.o,$(LIB_SRC))
	$$(AR) rcs $$@ $$^
build/test/$(1)/%: tests/test_%.c build/test/$(1)/libloft.a $(wildcard tests/*.h)
	$$(CC) $$(CPPFLAGS) -Itests -O1 -g $$(STD) $$(SANITIZE) $$(call num_flag,$(1)) $$< build/test/$(1)/libloft.a -lm -o $$@
endef
$(foreach n,$(NUMS),$(eval $(call tested,$(n))))

# one module in all number types: make test-forward
test-%: $(foreach n,$(NUMS),build/test/$(n)/%)
	@for n in $(NUMS); do build/test/$$n/$* || exit 1; done
.PRECIOUS: $(foreach n,$(NUMS),build/test/$(n)/%)

## Remove build/
.PHONY: clean
clean:
	rm -rf build
