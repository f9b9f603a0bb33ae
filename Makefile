# loft: `make help` lists what can be made. On a fresh machine: make deps demo, make deps check.
# SPDX-License-Identifier: MIT
#
# Here: the library, the command, what a fresh machine needs, and the stages of `make check`.
# The rest stands with what it builds: tests/tests.mk, tests/bench/bench.mk, tests/target/target.mk,
# ports/boards.mk and ports/*/port.mk.
NUM  ?= q16
AXES ?= 3
NUMS := q16 f32 f64

CC     ?= cc
# no built-in rules: to read 3000 files of dependencies takes 0.3 s instead of 1.6
MAKEFLAGS += -r
INCLUDE := -Ilib
# what the user gives follows what the house gives, and wins: CPPFLAGS and CFLAGS in every call of
# the compiler, LDFLAGS where it links; the same sources give the same bytes in any folder. -g1
# names functions and lines; CFLAGS=-g adds variables, and 14 % to the time
OPTIMISED = -O2
BUILT   = $(OPTIMISED) -g1 -ffile-prefix-map=$(CURDIR)=. $(CPPFLAGS) $(CFLAGS)
WARN   := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes \
          -Wundef
STD    := -std=c99 $(WARN)
DEPS   := -MMD -MP
upper     = $(subst q,Q,$(subst f,F,$(1)))
num_flag  = -DLOFT_NUM=LOFT_$(call upper,$(1)) -DLOFT_AXES=$(AXES)

# each compilation is one short line; V=1 prints the commands
Q   := $(if $(V),,@)
SAY := @$(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),:,echo)

# what is made in many parts is made in parallel, also where no -j was given
JOBS     ?= $(shell nproc)
PARALLEL  = $(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

# two libraries in one tree: the second needs the first, the first does not know the second
LOFT_ROOMS     := num geom basis curve kinematics path motion wire machine
SURFACES_ROOMS := surface polygon toolpath
sources_of   = $(sort $(foreach r,$(1),$(wildcard lib/$(r)/*.c lib/$(r)/*/*.c)))
LOFT_SRC     := $(call sources_of,$(LOFT_ROOMS))
SURFACES_SRC := $(call sources_of,$(SURFACES_ROOMS))
LIB_SRC  := $(LOFT_SRC) $(SURFACES_SRC)
LIB_HDR  := $(sort $(wildcard lib/config.h lib/*/*.h lib/*/*/*.h))
LIBRARIES ?= loft loft-surfaces
# libs FOLDER: both archives there; linked: objects and archives, those of surfaces first
libs   = $(1)/libloft-surfaces.a $(1)/libloft.a
linked = $(filter %.o,$^) $(filter %/libloft-surfaces.a,$^) \
         $(filter-out %/libloft-surfaces.a,$(filter %.a,$^))

## Show this list
.PHONY: help
help:
	@awk '/^## /{h=substr($$0,4); getline; while ($$0 ~ /^\.PHONY/) getline; \
	      sub(/:.*/,""); printf "  %-14s %s\n",$$0,h}' $(MAKEFILE_LIST)

# Every external function of lib/ carries its number type. The stamp follows the headers; names.h
# changes only with their names, so that a header rebuilds no more than what includes it.
build/names.stamp: $(LIB_HDR) tests/house/names.sh
	@mkdir -p $(@D)
	@sh tests/house/names.sh > $@.$$$$ && \
	    if cmp -s $@.$$$$ lib/names.h; then rm $@.$$$$; else mv $@.$$$$ lib/names.h; fi
	@touch $@
# (+: also by make -n, which takes it as written otherwise, and announces all that includes it)
lib/names.h: build/names.stamp
	+@test -f $@

# What each function may err by is read from the headers too, when asked for: lint says when.
host-tools/MESSAGES.md: tests/house/messages.py $(wildcard host-tools/*/*.c)
	$(SAY) "  GEN $@"
	$(Q)python3 $< > $@.new && mv $@.new $@
lib/ERRORS.md: $(LIB_HDR) tests/house/errors.py tests/house/headers.py
	@python3 tests/house/errors.py > $@.new && mv $@.new $@

## Write the reference, offline: build/docs/index.html, and build/docs/man/man3
.PHONY: docs
docs:
	@python3 tests/house/reference.py build/docs && echo "build/docs/index.html"

## Check the reference: no dead link, each function with all that its header says
.PHONY: check-docs
check-docs: docs
	@python3 tests/house/check_reference.py build/docs

# --- the libraries: build/<num>x<axes>/libloft.a and libloft-surfaces.a, once per number type -----
define library
build/$(1)x$(AXES)/%.o: %.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(BUILT) $$(STD) $$(DEPS) -ffreestanding $$(call num_flag,$(1)) \
	    -c $$< -o $$@
build/$(1)x$(AXES)/libloft.a: $(patsubst %.c,build/$(1)x$(AXES)/%.o,$(LOFT_SRC))
build/$(1)x$(AXES)/libloft-surfaces.a: $(patsubst %.c,build/$(1)x$(AXES)/%.o,$(SURFACES_SRC))
$(call libs,build/$(1)x$(AXES)):
	$$(SAY) "  AR  $$@"
	$$(Q)rm -f $$@; $$(AR) rcs $$@ $$^
-include $(patsubst %.c,build/$(1)x$(AXES)/%.d,$(LIB_SRC))
endef
$(foreach n,$(NUMS),$(eval $(call library,$(n))))

## Build libloft.a, libloft-surfaces.a   NUM=q16|f32|f64 AXES=1..6 LIBRARIES="loft loft-surfaces"
.PHONY: lib
lib:
	+@$(PARALLEL) $(LIBRARIES:%=build/$(NUM)x$(AXES)/lib%.a)

# --- the command: build/loft, one program with all three number types -----------------------------
# WITHOUT="cairo geos libserialport ncurses libwebsockets": pictures, contour fills, serial ports,
# --view and `loft serve` are refused then, text has only single lines, the rest is there;
# with a TOOL_OUT of its own, or after make clean
PKG_CONFIG ?= pkg-config
TOOL_OPT  := cairo geos libserialport ncurses libwebsockets
TOOL_PKG  := libxml-2.0 zlib $(filter-out $(WITHOUT),$(TOOL_OPT)) \
             $(if $(filter cairo,$(WITHOUT)),,pangocairo) \
             $(if $(filter libwebsockets,$(WITHOUT)),,json-c)
TOOL_OUT  ?= build
# asked once, when the first file is compiled: make deps may have just installed it
TOOL_CFLAGS = $(eval TOOL_CFLAGS := $(shell $(PKG_CONFIG) --cflags $(TOOL_PKG)))$(TOOL_CFLAGS)
TOOL_INC   = -Ihost-tools -Iports $(if $(filter cairo,$(WITHOUT)),-DLOFT_WITHOUT_CAIRO) \
             $(patsubst -I%,-isystem %,$(TOOL_CFLAGS))
TOOL_STD   = $(STD) $(DEPS) -D_GNU_SOURCE $(TOOL_INC)
tool_flag  = -DLOFT_NUM=LOFT_$(call upper,$(1)) -DLOFT_AXES=3
TOOL_ONCE := host-tools/engine/engine_status.c host-tools/engine/engines.c
TOOL_ENGINE := $(filter-out $(TOOL_ONCE),$(wildcard $(patsubst %,host-tools/%/engine*.c, \
                 engine make figures)))
# what needs a library that may be left out, and what refuses in its place
TOOL_WITH_cairo            := $(wildcard $(patsubst %,host-tools/draw/%.c,plot* scene* gallery \
                                surface_* plan_plot)) \
                              host-tools/svg/svg_glyphs.c
TOOL_WITH_geos             := host-tools/arrange/region.c host-tools/arrange/pieces.c
TOOL_WITH_libserialport    := host-tools/send/transport_serial.c
TOOL_WITH_ncurses          := host-tools/cmd/screen.c
TOOL_WITHOUT_libwebsockets := host-tools/serve/without_websockets.c
TOOL_WITH_libwebsockets    := $(filter-out $(TOOL_WITHOUT_libwebsockets), \
                                $(wildcard host-tools/serve/*.c))
TOOL_WITHOUT_cairo         := host-tools/draw/without_cairo.c host-tools/svg/without_glyphs.c
TOOL_WITHOUT_geos          := host-tools/arrange/without_region.c
TOOL_WITHOUT_libserialport := host-tools/send/without_serial.c
TOOL_WITHOUT_ncurses       := host-tools/cmd/without_ncurses.c
TOOL_LEFT := $(foreach l,$(TOOL_OPT),\
                 $(TOOL_WITH$(if $(filter $(l),$(WITHOUT)),,OUT)_$(l)))
TOOL_SRC  := $(filter-out $(TOOL_ENGINE) $(TOOL_LEFT),$(sort $(wildcard host-tools/*.c \
                 host-tools/*/*.c)))
TOOL_EACH := $(TOOL_ENGINE) $(sort $(wildcard ports/host/*.c))
# of the library, only what the command reaches
TOOL_REACHED := $(shell sh tests/house/tool_reach.sh)
TOOL_LIB  ?= build/tools/%/libloft.a
TOOL_LIBS  = $(foreach n,$(NUMS),$(subst %,$(n),$(TOOL_LIB)))
TOOL_OBJ  := $(patsubst %.c,$(TOOL_OUT)/tools/%.o,$(TOOL_SRC)) \
             $(foreach n,$(NUMS),$(patsubst %.c,$(TOOL_OUT)/tools/$(n)/%.o,$(TOOL_EACH))) \
             $(if $(filter libwebsockets,$(WITHOUT)),,$(TOOL_OUT)/tools/site.o)

build/tools/reached: FORCE
	+@mkdir -p $(@D)
	+@echo $(TOOL_REACHED) | cmp -s - $@ || echo $(TOOL_REACHED) > $@
.PHONY: FORCE
FORCE:

# once per number type: what is reached of the library, the engine, the simulated machine
define tooled
build/tools/$(1)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(BUILT) $$(STD) $$(DEPS) -ffreestanding $$(call tool_flag,$(1)) \
	    -c $$< -o $$@
build/tools/$(1)/libloft.a: $(TOOL_REACHED:%.c=build/tools/$(1)/%.o) build/tools/reached
	@mkdir -p $$(@D)
	$$(SAY) "  AR  $$@"
	$$(Q)rm -f $$@; $$(AR) rcs $$@ $$(filter %.o,$$^)
$(TOOL_OUT)/tools/$(1)/%.o: %.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(BUILT) $$(TOOL_STD) $$(call tool_flag,$(1)) -c $$< -o $$@
-include $(TOOL_REACHED:%.c=build/tools/$(1)/%.d)
endef
$(foreach n,$(NUMS),$(eval $(call tooled,$(n))))

# the rest is built once; where it talks to a machine, it does so in q16
$(TOOL_OUT)/tools/host-tools/%.o: host-tools/%.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(INCLUDE) $(BUILT) $(TOOL_STD) $(call tool_flag,q16) -c $< -o $@

# the page, if `make page` has built it
$(TOOL_OUT)/tools/site.c: host-tools/page/embed.sh $(wildcard build/site.built)
	@mkdir -p $(@D)
	$(SAY) "  GEN $@"
	$(Q)sh $< build/site >$@.$$$$ && mv $@.$$$$ $@
$(TOOL_OUT)/tools/site.o: $(TOOL_OUT)/tools/site.c
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(INCLUDE) $(BUILT) $(TOOL_STD) -c $< -o $@

# as fast as -O2 (plans, pictures), and compiled in two thirds of its time
$(TOOL_OUT)/loft: OPTIMISED = -O1 -finline-functions -finline-small-functions
$(TOOL_OUT)/loft: $(TOOL_OBJ) $(TOOL_LIBS)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $^ $(shell $(PKG_CONFIG) --libs $(TOOL_PKG)) -lm -o $@
-include $(TOOL_OBJ:.o=.d)

## Build the command build/loft
.PHONY: tools
tools:
	+@$(PARALLEL) $(TOOL_OUT)/loft

# --- libloft-host: the rooms below cmd/ that it calls ---------------------------------------------
# One object, of which only the functions of library/host.h can be seen: what it is made of may have
# any name. It needs the packages of HOST_PKG.
HOST_ROOMS := base engine geometry read svg gcode fit arrange plan send
HOST_PKG   := $(filter-out ncurses libwebsockets json-c,$(TOOL_PKG))
HOST_SRC   := $(filter $(foreach r,$(HOST_ROOMS),host-tools/$(r)/%) host-tools/readers.c, \
                  $(TOOL_SRC))
HOST_OBJ   := $(HOST_SRC:%.c=$(TOOL_OUT)/tools/%.o) $(foreach n,$(NUMS),$(patsubst \
                  %.c,$(TOOL_OUT)/tools/$(n)/%.o,$(filter host-tools/engine/%,$(TOOL_ENGINE))))
OBJCOPY    ?= objcopy
$(TOOL_OUT)/tools/host.a: $(HOST_OBJ)
	$(Q)rm -f $@; $(AR) rcs $@ $^
$(TOOL_OUT)/libloft-host.a: \
        $(patsubst %.c,$(TOOL_OUT)/tools/%.o,$(wildcard host-tools/library/*.c)) \
        $(TOOL_OUT)/tools/host.a $(TOOL_LIBS)
	$(SAY) "  AR  $@"
	$(Q)$(CC) -r -nostdlib $(filter %.o,$^) -Wl,--start-group $(filter %.a,$^) -Wl,--end-group \
	    -o $(TOOL_OUT)/tools/loft-host.o
	$(Q)$(OBJCOPY) --wildcard --keep-global-symbol='loft_host_*' $(TOOL_OUT)/tools/loft-host.o
	$(Q)rm -f $@; $(AR) rcs $@ $(TOOL_OUT)/tools/loft-host.o

.PHONY: print-tool-sources
print-tool-sources:
	@echo $(TOOL_SRC) $(TOOL_EACH)

DRAWING ?= tests/drawings/demo.svg
## Draw it on the simulated machine: counted pulses, drawn.png   DRAWING=file.svg MACHINE=file
.PHONY: demo
demo: tools
	@host-tools/demo.sh draw $(TOOL_OUT)/loft "$(DRAWING)" build/demo $(MACHINE)

SURFACES ?= tests/drawings/patch.loft
TOOL     ?= ball:4
STEP     ?= cusp:0.05
STOCK    ?= 40x40x20
## Mill surfaces on the simulated machine: left.png   SURFACES=file.loft TOOL= STEP= STOCK=
.PHONY: demo-mill
demo-mill: tools
	@host-tools/demo.sh mill $(TOOL_OUT)/loft "$(SURFACES)" build/demo-mill $(TOOL) $(STEP) $(STOCK)

# --- on a fresh machine ---------------------------------------------------------------------------
HOST_PACKAGES := gcc g++ libc6-dev make pkg-config clang clang-format libclang-rt-14-dev \
                 libxml2-dev zlib1g-dev libcairo2-dev libpango1.0-dev fonts-dejavu-core \
                 hershey-fonts-data libgeos-dev libserialport-dev libncurses-dev \
                 libwebsockets-dev libjson-c-dev \
                 librsvg2-bin spin python3

## Install the Debian packages that demo and check need
.PHONY: deps
deps:
	@sh tests/house/deps.sh $(HOST_PACKAGES)

## Install what else `make bench` compares with (AGG, GSL, SISL, OCCT, lyon, kurbo)
.PHONY: deps-bench
deps-bench:
	@sh tests/house/deps.sh g++ libagg-dev libgsl-dev libsisl-dev libocct-foundation-dev \
	    libocct-modeling-data-dev libocct-modeling-algorithms-dev librust-kurbo-dev \
	    librust-lyon-geom-dev $(if $(shell command -v cargo),,cargo)

## Install what `make check-gcode` compares with (LinuxCNC's rs274)
.PHONY: deps-gcode
deps-gcode:
	@sh tests/house/deps.sh linuxcnc-uspace

## Install the cross compilers and the emulators that check-cross, check-target and size need
.PHONY: deps-target
deps-target:
	@sh tests/house/deps.sh gcc-arm-none-eabi gcc-avr binutils-avr avr-libc \
	    gcc-riscv64-unknown-elf simavr libsimavr-dev libelf-dev libunicorn-dev \
	    qemu-system-arm qemu-system-misc qemu-system-x86 qemu-user \
	    gcc-i686-linux-gnu libc6-dev-i386-cross gcc-powerpc-linux-gnu libc6-dev-powerpc-cross \
	    busybox-static cpio xz-utils libgpiod-dev

# --- make check: every stage ends with `N passed, N failed`; the last line sums them --------------
CHECK_STAGES := lint test test-axes test-effort test-tools check-vectors-all \
                test-mixed+test-cplusplus+test-packages+test-readme+test-examples+check-docs \
                test-peer+test-model+test-tour test-e2e

## Check everything: rules of the house, all tests under sanitizers, vectors, README, whole jobs
.PHONY: check
check:
	@MAKE="$(MAKE)" bash tests/house/check.sh $(CHECK_STAGES)

# A push runs the same seeds each time, and of some stages a part (`left to make check-all: ..`).
# All of it runs each night, with other seeds each day; the day's first one is printed.
FIRST_SEED ?= $(shell date -u +%Y%m%d)00000
ALL_STAGES := $(CHECK_STAGES) check-cross check-target check-packages check-gcode

## Check all that there is, with seeds of the day, in hours (all of make deps*)   FIRST_SEED=
.PHONY: check-all
check-all:
	@echo "seeds from $(FIRST_SEED); again: make check-all FIRST_SEED=$(FIRST_SEED)"
	@MAKE="$(MAKE)" ALL=1 LOFT_ALL=1 LOFT_FIRST=$(FIRST_SEED) \
	    bash tests/house/check.sh $(ALL_STAGES)

## Check the rules of the house: warnings of gcc and clang, arrows, freestanding, names, docs
.PHONY: lint
lint: build/loft
	@sh tests/house/lint.sh

## Print which functions of geometry a command reaches, header by header
.PHONY: reach
reach:
	@sh tests/house/reach.sh

## Compare plans and points bit for bit with those of another commit   OLD=HEAD
.PHONY: check-same
check-same: build/loft
	@bash tests/house/same.sh $(or $(OLD),HEAD) build/loft

## Break and indent the lines of all C files as .clang-format says
.PHONY: format
format:
	$(Q)find lib host-tools ports tests -name '*.[ch]' ! -path lib/names.h \
	    -exec python3 tests/house/format.py {} +

## Compile lib/ for Cortex-M0+, M4, ATmega328P, rv32imac: no writable data, libc, slow interrupt
.PHONY: check-cross
check-cross: lib/names.h
	@sh tests/house/cross.sh

## Print text and worst stack of each module for the same cores   NUM=q16|f32|f64  AXES=1..6
.PHONY: size
size: lib/names.h
	@sh tests/house/size.sh $(NUM) $(AXES)

# check-target: each port and each test of a chip adds its stages; what measures no time runs side
# by side
TARGET_BESIDE := check-sums check-calls check-footprint check-stack bench-polygon check-hosts
TARGET_STAGES  = $(subst $() $(),+,$(TARGET_BESIDE)) check-boards check-units

include tests/tests.mk tests/bench/bench.mk
include ports/boards.mk ports/packages/packages.mk $(sort $(wildcard ports/*/port.mk))
include host-tools/page/page.mk
include tests/target/target.mk

## Remove build/
.PHONY: clean
clean:
	rm -rf build
