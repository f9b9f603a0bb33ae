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
TESTED   := -O1 -g1
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
num_flag  = -DLOFT_NUM=LOFT_$(shell echo $(1) | tr a-z A-Z) -DLOFT_AXES=$(AXES)

# each compilation is one short line; V=1 prints the commands
Q   := $(if $(V),,@)
SAY := @$(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),:,echo)

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
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) $$(CFLAGS) $$(STD) -ffreestanding $$(call num_flag,$(1)) -c $$< -o $$@
build/$(1)x$(AXES)/libloft.a: $(patsubst %.c,build/$(1)x$(AXES)/%.o,$(LIB_SRC))
	$$(SAY) "  AR  $$@"
	$$(Q)$$(AR) rcs $$@ $$^
endef
$(foreach n,$(NUMS),$(eval $(call library,$(n))))

## Build build/<num>x<axes>/libloft.a   NUM=q16|f32|f64  AXES=1..6
.PHONY: lib
lib: build/$(NUM)x$(AXES)/libloft.a

# --- tests: build/test/<num>/<module>, sanitized, one program per module and number type ------------
# the solver of harmonic coordinates, of which tests make tables: on the host, long double, as the tool has it
SOLVER_SRC := $(patsubst %,host-tools/%.c,harmonic harmonic_basis least)
SOLVER_OBJ := $(patsubst host-tools/%.c,build/solver/%.o,$(SOLVER_SRC))
build/solver/%.o: host-tools/%.c $(wildcard host-tools/harmonic*.h) host-tools/least.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(CFLAGS) $(STD) -c $< -o $@
SOLVED := harmonic

define tested
build/test/$(1)/lib/%.o: lib/%.c $(LIB_HDR)
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) $$(TESTED) $$(STD) $$(SANITIZE) $$(call num_flag,$(1)) -c $$< -o $$@
build/test/$(1)/libloft.a: $(patsubst %.c,build/test/$(1)/%.o,$(LIB_SRC))
	$$(SAY) "  AR  $$@"
	$$(Q)$$(AR) rcs $$@ $$^
build/test/$(1)/%: tests/test_%.c build/test/$(1)/libloft.a $(wildcard tests/*.h)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) -Itests $$(TESTED) $$(STD) $$(SANITIZE) $$(call num_flag,$(1)) $$(filter %.c %.o %.a,$$^) -lm -o $$@
build/test/$(1)/$(SOLVED): CPPFLAGS += -Ihost-tools
build/test/$(1)/$(SOLVED): $(SOLVER_OBJ)
endef
$(foreach n,$(NUMS),$(eval $(call tested,$(n))))

# one module in all number types: make test-forward
test-%: $(foreach n,$(NUMS),build/test/$(n)/%)
	@for n in $(NUMS); do build/test/$$n/$* || exit 1; done
.PRECIOUS: $(foreach n,$(NUMS),build/test/$(n)/%)

# --- exact results: one line per CSV of a folder ------------------------------------------------------
VECTORS ?= tests/vectors
define vectored
build/vectors/$(1): $(wildcard tests/vectors*.c) host-tools/engine_chapter.c host-tools/chapter.c host-tools/chapter_study.c build/test/$(1)/libloft.a $(SOLVER_OBJ) $(wildcard tests/*.h) host-tools/chapter.h
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) -Itests -Ihost-tools $$(TESTED) $$(STD) $$(SANITIZE) $$(call num_flag,$(1)) $$(filter %.c %.o %.a,$$^) -lm -o $$@
endef
$(foreach n,$(NUMS),$(eval $(call vectored,$(n))))

## Compare with exact results   VECTORS=folder of CSVs  NUM=q16|f32|f64
.PHONY: check-vectors
check-vectors: build/vectors/$(NUM)
	@build/vectors/$(NUM) $(VECTORS) tests/vectors

.PHONY: check-vectors-all
check-vectors-all: $(foreach n,$(NUMS),build/vectors/$(n))
	@{ for n in $(NUMS); do echo "echo '-- $$n'; build/vectors/$$n $(VECTORS) tests/vectors"; done; \
	   echo "sh tests/runner.sh build/vectors/q16 tests/vectors"; } | bash tests/beside.sh

# --- tests of what reads and draws: build/test/host/<module>, sanitized ------------------------------
HOST_TESTS  := $(patsubst tests/host/test_%.c,%,$(sort $(wildcard tests/host/test_*.c)))
HOST_TESTED := $(sort $(wildcard host-tools/svg*.c)) $(patsubst %,host-tools/%.c,contour csv curve curve_text drawing drawing_curves engine engine_curve engine_kinematics engine_measure engine_piece engine_sided engine_status engine_surface harmonic harmonic_basis joints kinematics least lines machine_file mesh nearest piece plot plot_frame plot_shape record reference scan sided smooth source surface surface_text toolpath)
HOST_FLAGS   = $(CPPFLAGS) $(TESTED) $(TOOL_STD) $(SANITIZE) -DLOFT_NUM=LOFT_F64 -DLOFT_AXES=3

build/test/host/obj/%.o: host-tools/%.c lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(HOST_FLAGS) -c $< -o $@
build/test/host/%: tests/host/test_%.c tests/host/drawn.h $(wildcard tests/*.h) $(patsubst host-tools/%.c,build/test/host/obj/%.o,$(HOST_TESTED)) build/test/f64/libloft.a
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(HOST_FLAGS) -Itests -Itests/host $(filter %.c %.o %.a,$^) $(shell pkg-config --libs libxml-2.0 cairo) -lm -o $@

.PRECIOUS: build/test/host/obj/%.o

## Check what the SVG reader draws and refuses, pulse records and pictures, under ASan and UBSan
.PHONY: test-host
test-host: $(patsubst %,build/test/host/%,$(HOST_TESTS))
	@for t in $(HOST_TESTS); do echo "echo '-- $$t'; build/test/host/$$t"; done | bash tests/beside.sh

# --- tools: build/loft, one program with all three number types -------------------------------------
TOOL_PKG  := libxml-2.0 cairo libserialport
TOOL_OUT  ?= build
TOOL_STD   = $(STD) -D_GNU_SOURCE -Ihost-tools -Iports -MMD -MP \
             $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(TOOL_PKG)))
tool_flag  = -DLOFT_NUM=LOFT_$(shell echo $(1) | tr a-z A-Z) -DLOFT_AXES=3
TOOL_ENGINE := $(patsubst %,host-tools/%.c,engine engine_chapter engine_curve engine_kinematics engine_measure engine_piece engine_sided engine_surface)
TOOL_SRC  := $(filter-out $(TOOL_ENGINE),$(sort $(wildcard host-tools/*.c)))
TOOL_EACH := $(TOOL_ENGINE) $(sort $(wildcard ports/host/*.c))
TOOL_LIB  ?= build/%x3/libloft.a
TOOL_LIBS := $(foreach n,$(NUMS),$(subst %,$(n),$(TOOL_LIB)))
TOOL_OBJ  := $(patsubst %.c,$(TOOL_OUT)/tools/%.o,$(TOOL_SRC)) \
             $(foreach n,$(NUMS),$(patsubst %.c,$(TOOL_OUT)/tools/$(n)/%.o,$(TOOL_EACH)))

# what exists per number type: the library (the same archive that anybody links), the engine, the simulated machine
define tooled
$(TOOL_OUT)/tools/$(1)/%.o: %.c lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) $$(CFLAGS) $$(TOOL_STD) $$(call tool_flag,$(1)) -c $$< -o $$@
endef
$(foreach n,$(NUMS),$(eval $(call tooled,$(n))))

# the rest is built once; where it talks to a machine, it does so in q16
$(TOOL_OUT)/tools/host-tools/%.o: host-tools/%.c lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(TOOL_STD) $(call tool_flag,q16) -c $< -o $@

$(TOOL_OUT)/loft: $(TOOL_OBJ) $(TOOL_LIBS)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $^ $(shell pkg-config --libs $(TOOL_PKG)) -lm -o $@

-include $(TOOL_OBJ:.o=.d) $(wildcard build/test/host/*.d build/test/host/obj/*.d)

## Build the command build/loft
.PHONY: tools
tools: $(TOOL_OUT)/loft

DRAWING ?= tests/drawings/demo.svg
## Draw it on the simulated machine: pulses, exact counts and build/demo/drawn.png   DRAWING=file.svg MACHINE=file
.PHONY: demo
demo: $(TOOL_OUT)/loft
	@host-tools/demo.sh $< "$(DRAWING)" build/demo $(MACHINE)

# --- on a fresh machine ------------------------------------------------------------------------------
HOST_PACKAGES := gcc libc6-dev make pkg-config clang libclang-rt-14-dev libxml2-dev libcairo2-dev libserialport-dev spin python3

## Install the Debian packages that demo and check need
.PHONY: deps
deps:
	@sh tests/deps.sh $(HOST_PACKAGES)

## Install what else `make bench` and `make bench-motion` compare with (AGG, GSL, SciPy)
.PHONY: deps-bench
deps-bench:
	@sh tests/deps.sh g++ libagg-dev libgsl-dev python3-scipy

## Install the cross compilers and the emulators that check-cross, check-target and size need
.PHONY: deps-target
deps-target:
	@sh tests/deps.sh gcc-arm-none-eabi gcc-avr binutils-avr avr-libc gcc-riscv64-unknown-elf simavr libsimavr-dev libelf-dev qemu-system-arm qemu-system-misc \
	    qemu-system-x86 busybox-static cpio xz-utils libgpiod-dev

## Compile lib/ for Cortex-M0+, M4, ATmega328P and rv32imac; no writable data, no libc, no slow helper in an interrupt
.PHONY: check-cross
check-cross: lib/names.h
	@sh tests/cross.sh

## Check the firmware on emulated chips: arithmetic bit for bit as here, whole jobs, pulses, timing
.PHONY: check-target
check-target: lib/names.h
	@MAKE="$(MAKE)" bash tests/check.sh $(TARGET_STAGES)

## Run arithmetic, curves and grids on an emulated ATmega328P and Cortex-M0: the same, bit for bit, as here
.PHONY: check-sums
check-sums: lib/names.h
	@sh tests/target.sh

## Check the table of lib/motion/span.h: what its calls cost at worst on an emulated ATmega328P, Cortex-M0 and M4
.PHONY: check-calls
check-calls: lib/names.h
	@sh tests/target/calls.sh build/calls

## Print text and worst stack of each module for the same cores   NUM=q16|f32|f64  AXES=1..6
.PHONY: size
size: lib/names.h
	@sh tests/size.sh $(NUM) $(AXES)

# --- firmware: each port brings its own rules, and what check-target is to run of it -------------------
# emulated clocks count instructions, so that two may run side by side
TARGET_BESIDE := check-sums check-calls bench-polygon
TARGET_STAGES  = $(subst $() $(),+,$(TARGET_BESIDE)) check-boards check-units
include ports/boards.mk $(sort $(wildcard ports/*/port.mk))
include tests/target/units.mk

## Build the firmware of every board, and print what it takes of flash and RAM   or one: make firmware-stm32f405
.PHONY: firmware
firmware: firmware-atmega328p $(addprefix firmware-,$(FIRMWARES))

## Write the firmware to a board   PORT=/dev/ttyUSB0 (an ATmega328P), or BOARD=stm32f405|nrf51
.PHONY: flash
flash: BOARD ?= $(if $(PORT),atmega328p)
flash:
	@case "$(BOARD)" in atmega328p|stm32f405|nrf51) $(MAKE) --no-print-directory flash-$(BOARD) ;; \
	*) echo "name the board or its port: make flash PORT=/dev/ttyUSB0 (an ATmega328P), make flash BOARD=stm32f405 or BOARD=nrf51"; exit 1 ;; esac

build/target/stores.so: tests/target/stores.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CFLAGS) $(STD) -shared -fPIC $< -o $@

build/target/bad_line: tests/target/bad_line.c tests/line.h build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CFLAGS) $(STD) -D_GNU_SOURCE $(CPPFLAGS) -Itests $(call num_flag,q16) $(filter %.c %.a,$^) -o $@

## Run a whole job on each 32-bit board in QEMU: every pulse at the pins, over a bad line as well
.PHONY: check-boards
check-boards: $(addprefix firmware-,$(FIRMWARES)) build/target/stores.so build/target/bad_line $(TOOL_OUT)/loft
	@bash tests/target/qemu.sh build/firmware $(TOOL_OUT)/loft build/target/stores.so build/target/bad_line

# --- make bench: build/bench/bench<axes>, with each of AGG, GSL and cairo that pkg-config finds --------
BENCH_LIBS := $(foreach l,gsl cairo $(if $(shell command -v $(CXX)),libagg),$(shell pkg-config --exists $(l) 2>/dev/null && echo $(l)))
BENCH_FLAGS = $(if $(BENCH_LIBS),$(shell pkg-config --cflags $(BENCH_LIBS))) \
              $(if $(filter gsl,$(BENCH_LIBS)),-DBENCH_GSL) $(if $(filter cairo,$(BENCH_LIBS)),-DBENCH_CAIRO)

build/bench/agg.o: tests/bench_agg.cpp
	@mkdir -p $(@D)
	$(SAY) "  CXX $@"
	$(Q)$(CXX) $(CFLAGS) $(BENCH_FLAGS) -c $< -o $@
build/bench/bench%: tests/bench.c build/q16x%/libloft.a $(if $(filter libagg,$(BENCH_LIBS)),build/bench/agg.o)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(STD) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$* $(BENCH_FLAGS) \
	    $(if $(filter libagg,$(BENCH_LIBS)),-DBENCH_AGG) $^ -o $@ \
	    $(if $(BENCH_LIBS),$(shell pkg-config --libs $(BENCH_LIBS))) $(if $(filter libagg,$(BENCH_LIBS)),-lstdc++) -lm

## Time walking a cubic against de Casteljau, Horner, AGG, GSL and cairo (make deps-bench installs them)
.PHONY: bench
bench:
	@for axes in 2 3; do $(MAKE) -s --no-print-directory AXES=$$axes build/bench/bench$$axes && build/bench/bench$$axes || exit 1; done
	@for l in gsl cairo libagg; do case " $(BENCH_LIBS) " in *" $$l "*) ;; *) echo "not compared: $$l is missing (make deps-bench)";; esac; done

## Count the instructions of a point of each patch with n sides on an emulated Cortex-M0 and M4; the same sums, bit for bit, as here
.PHONY: bench-polygon
bench-polygon: lib/names.h
	@sh tests/bench_polygon.sh build/bench/polygon

# --- make bench-motion: build/bench/motion/<what>-<num> measure, tests/bench_motion.sh prints --------------------------
MOTION := build/bench/motion
MOTION_WHAT := $(patsubst tests/bench_motion_%.c,%,$(filter-out %_moves.c,$(sort $(wildcard tests/bench_motion_*.c))))
define motioned
$(MOTION)/%-$(1): tests/bench_motion_%.c build/$(1)x3/libloft.a $(wildcard tests/*.h)
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) -Itests $$(CFLAGS) $$(STD) -DLOFT_NUM=LOFT_$(2) -DLOFT_AXES=3 $$(filter %.c %.a,$$^) -lm -o $$@
endef
$(eval $(call motioned,q16,Q16))
$(eval $(call motioned,f64,F64))
$(MOTION)/moves: tests/bench_motion_moves.c $(filter-out %/loft.o,$(TOOL_OBJ)) $(TOOL_LIBS)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(filter-out -MMD -MP,$(TOOL_STD)) $(call tool_flag,q16) $^ $(shell pkg-config --libs $(TOOL_PKG)) -lm -o $@

CASES ?= 100000
## Measure what motion promises and print it beside its bounds, in half an hour   CASES=of the property run
.PHONY: bench-motion
bench-motion: $(MOTION)/moves $(foreach w,$(MOTION_WHAT),$(MOTION)/$(w)-q16 $(MOTION)/$(w)-f64)
	@bash tests/bench_motion.sh $(MOTION) $(CASES)

# --- make check: every stage ends with `N passed, N failed`; the last line sums them ------------------
CHECK_STAGES := lint test test-axes test-host check-vectors-all test-mixed+test-readme+test-peer+test-model test-e2e

## Check everything: rules of the house, all tests in all number types under sanitizers, vectors, README, whole jobs
.PHONY: check
check:
	@MAKE="$(MAKE)" bash tests/check.sh $(CHECK_STAGES)

## Check the rules of the house: warnings of gcc and clang as errors, arrows, freestanding, names, docstrings
.PHONY: lint
lint: lib/names.h
	@sh tests/lint.sh

AXES_TESTS  := codec message receiver
CURVE_TESTS := bezier rational rational_extend bspline nurbs join intersect overlap offset nearest bounds
CURVE_LIB   := $(foreach r,num geom basis curve,$(patsubst %.c,build/axes/%.o,$(wildcard lib/$(r)/*.c)))

build/axes/lib/%.o: lib/%.c $(LIB_HDR)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CPPFLAGS) $(TESTED) $(STD) $(SANITIZE) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=1 -c $< -o $@
build/axes/%1: tests/test_%.c $(CURVE_LIB) $(wildcard tests/*.h)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CPPFLAGS) -Itests $(TESTED) $(STD) $(SANITIZE) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=1 $< $(CURVE_LIB) -lm -o $@

# the wire in q16 with so many axes, curves with one
AXES_EACH := $(foreach a,1 2 4 6,$(foreach t,$(AXES_TESTS),build/axes/$(t)-$(a)))
build/axes/wire-%.a: $(wildcard lib/wire/*.c) $(LIB_HDR)
	@mkdir -p build/axes/wire-$*
	$(SAY) "  AR  $@"
	$(Q)cd build/axes/wire-$* && $(CC) -I../../../lib $(TESTED) $(STD) $(SANITIZE) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$* -c $(patsubst %,../../../%,$(wildcard lib/wire/*.c))
	$(Q)$(AR) rcs $@ build/axes/wire-$*/*.o
define axes_test
build/axes/$(1)-$(2): tests/test_$(1).c build/axes/wire-$(2).a $(wildcard tests/*.h)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(CPPFLAGS) -Itests $$(TESTED) $$(STD) $$(SANITIZE) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$(2) $$(filter %.c %.a,$$^) -o $$@
endef
$(foreach a,1 2 4 6,$(foreach t,$(AXES_TESTS),$(eval $(call axes_test,$(t),$(a)))))
.SECONDARY: $(foreach a,1 2 4 6,build/axes/wire-$(a).a)

## Run the wire's tests with 1, 2, 4 and 6 axes, those of curves with 1
.PHONY: test-axes
test-axes: $(AXES_EACH) $(patsubst %,build/axes/%1,$(CURVE_TESTS))
	@for t in $(patsubst build/axes/%,%,$^); do echo "echo '-- $$t'; build/axes/$$t"; done | bash tests/beside.sh

## Run all module tests in q16, f32 and f64 under ASan and UBSan (one module: make test-forward)
.PHONY: test
test: $(foreach n,$(NUMS),$(foreach t,$(TESTS),build/test/$(n)/$(t)))
	@for t in $(TESTS); do for n in $(NUMS); do echo "echo '-- $$t $$n'; build/test/$$n/$$t"; done; done | bash tests/beside.sh

## Show that builds that disagree do not link, and that three number types do in one program
.PHONY: test-mixed
test-mixed: $(foreach n,$(NUMS),build/$(n)x$(AXES)/libloft.a)
	@sh tests/mixed.sh build

## Decode the examples of lib/wire/WIRE.md by a peer that was written from that page alone
.PHONY: test-peer
test-peer:
	@python3 tests/wire_peer.py

## Search every state of the session's model with spin: nothing twice, nothing lost, the job ends
.PHONY: test-model
test-model:
	@sh tests/model.sh

FUZZ_SECONDS ?= 60
## Fuzz what comes from the line with libFuzzer for FUZZ_SECONDS (60)
.PHONY: fuzz
fuzz: lib/names.h
	@mkdir -p build/fuzz/wire
	clang -Ilib -O1 -g $(STD) -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $(call num_flag,q16) \
	    tests/fuzz_wire.c $(wildcard lib/wire/*.c) -o build/fuzz/wire_fuzz
	build/fuzz/wire_fuzz -max_len=1200 -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 build/fuzz/wire

## Compile and run the README's example
.PHONY: test-readme
test-readme: build/q16x3/libloft.a
	@sh tests/readme.sh build/q16x3/libloft.a build/readme

## Run whole jobs: the command, sanitized, against the simulated machine   CASE=one of tests/e2e.sh
.PHONY: test-e2e
test-e2e: build/e2e/pty build/e2e/shim.so
	@$(MAKE) -s --no-print-directory tools TOOL_OUT=build/e2e CFLAGS="$(TESTED) $(SANITIZE)" TOOL_LIB=build/test/%/libloft.a
	@bash tests/e2e.sh build/e2e/loft build/e2e $(CASE)

build/e2e/pty: tests/e2e_pty.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CFLAGS) $(STD) -D_GNU_SOURCE $< -o $@
build/e2e/shim.so: tests/e2e_shim.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(CFLAGS) $(STD) -D_GNU_SOURCE -shared -fPIC $< -ldl -o $@

## Remove build/
.PHONY: clean
clean:
	rm -rf build
