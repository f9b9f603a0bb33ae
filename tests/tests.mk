# tests/tests.mk -- the tests of the library, of readers and pictures, of vectors, of whole jobs
# SPDX-License-Identifier: MIT

# with sanitizers, -Og compiles in half the time of -O1, and runs at most a third longer
TESTED    = -Og -g1 $(CPPFLAGS) $(CFLAGS)
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer

# --- the library: build/test/<num>/<module>, one sanitized program per module and number type -----
TEST_SRC := $(sort $(wildcard tests/lib/*/test_*.c tests/lib/*/*/test_*.c))
TESTS    := $(sort $(patsubst test_%.c,%,$(notdir $(TEST_SRC))))
# tests of motion link libloft alone, but a machine that is given patches
SURFACES_TESTS := $(patsubst test_%.c,%,$(notdir \
                      $(filter $(foreach r,$(SURFACES_ROOMS),tests/lib/$(r)/%),$(TEST_SRC)))) \
                  wire_fuzz
vpath test_%.c $(sort $(dir $(TEST_SRC)))

# the solver of harmonic coordinates, with which tests make tables: on the host, in long double
SOLVER_SRC := $(sort $(wildcard host-tools/engine/harmonic*.c host-tools/base/least*.c)) \
              host-tools/base/memory.c
SOLVER_OBJ := $(patsubst %.c,build/solver/%.o,$(SOLVER_SRC))
build/solver/%.o: %.c
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(BUILT) $(STD) $(DEPS) -Ihost-tools -c $< -o $@
-include $(SOLVER_OBJ:.o=.d)
SOLVED := harmonic

define tested
build/test/$(1)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(TESTED) $$(STD) $$(DEPS) $$(SANITIZE) $$(call num_flag,$(1)) \
	    -c $$< -o $$@
build/test/$(1)/libloft.a: $(patsubst %.c,build/test/$(1)/%.o,$(LOFT_SRC))
build/test/$(1)/libloft-surfaces.a: $(patsubst %.c,build/test/$(1)/%.o,$(SURFACES_SRC))
$(call libs,build/test/$(1)):
	$$(SAY) "  AR  $$@"
	$$(Q)rm -f $$@; $$(AR) rcs $$@ $$^
build/test/$(1)/%: test_%.c build/test/$(1)/libloft.a
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(TESTED) $$(STD) $$(DEPS) -MF $$@.d -MT $$@ \
	    $$(SANITIZE) $$(call num_flag,$(1)) $$< $$(linked) -lm -o $$@
$(SURFACES_TESTS:%=build/test/$(1)/%): build/test/$(1)/libloft-surfaces.a
build/test/$(1)/$(SOLVED): INCLUDE += -Ihost-tools
build/test/$(1)/flash_log: INCLUDE += -Iports
build/test/$(1)/$(SOLVED): $(SOLVER_OBJ)
-include $(patsubst %.c,build/test/$(1)/%.d,$(LIB_SRC)) $(patsubst %,build/test/$(1)/%.d,$(TESTS))
endef
$(foreach n,$(NUMS),$(eval $(call tested,$(n))))

# Those that take long: all seeds as the library is built for use, a share of them sanitized. The
# longest first, so that no core waits at the end.
TESTS_LONG := plan any intersect waypoints planner
TEST_SHARE := $(if $(ALL),1,8)
# A push sanitizes q16 and f64; f32 has the code of f64 and is run as the library is built for use.
SANITIZED  := $(if $(ALL),$(NUMS),q16 f64)
build/plain/%: private OPTIMISED = -Og
$(foreach n,$(NUMS),$(TESTS_LONG:%=build/plain/$(n)/%)): private OPTIMISED = -O2
define plain
build/plain/$(1)/%: test_%.c build/$(1)x$(AXES)/libloft.a
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(BUILT) $$(STD) $$(DEPS) -MF $$@.d -MT $$@ \
	    $$(call num_flag,$(1)) $$< $$(linked) -lm -o $$@
$(SURFACES_TESTS:%=build/plain/$(1)/%): build/$(1)x$(AXES)/libloft-surfaces.a
build/plain/$(1)/$(SOLVED): INCLUDE += -Ihost-tools
build/plain/$(1)/flash_log: INCLUDE += -Iports
build/plain/$(1)/$(SOLVED): $(SOLVER_OBJ)
-include $(patsubst %,build/plain/$(1)/%.d,$(TESTS))
endef
$(foreach n,$(NUMS),$(eval $(call plain,$(n))))

# tested_as NUM, tests: programs of a push
tested_as = $(2:%=build/$(if $(filter $(1),$(SANITIZED)),test,plain)/$(1)/%)
TEST_EACH = $(foreach n,$(NUMS),$(TESTS_LONG:%=build/plain/$(n)/%) \
                $(if $(filter $(n),$(SANITIZED)),$(TESTS_LONG:%=build/test/$(n)/%)) \
                $(call tested_as,$(n),$(filter-out $(TESTS_LONG),$(TESTS))))

## Run all module tests in q16, f32 and f64 under ASan and UBSan (one module: make test-forward)
.PHONY: test
test: $(if $(ALL),,left-of-tests) $(TEST_EACH)
	@{ for t in $(foreach t,$(TESTS_LONG),$(foreach n,$(NUMS),build/plain/$(n)/$(t))); do \
	       echo "echo '-- $$t'; $$t"; done; \
	   for t in $(foreach t,$(TESTS_LONG),$(foreach n,$(SANITIZED),build/test/$(n)/$(t))); do \
	       echo "echo '-- $$t, a share of its seeds'; LOFT_SHARE=$(TEST_SHARE) $$t"; done; \
	   for t in $(foreach t,$(SOLVED) $(filter-out $(SOLVED) $(TESTS_LONG),$(TESTS)), \
	                $(foreach n,$(NUMS),$(call tested_as,$(n),$(t)))); do \
	       echo "echo '-- $$t'; $$t"; done; } | \
	    bash tests/house/beside.sh

.PHONY: left-of-tests
left-of-tests:
	@echo "left to make check-all: sanitizers of f32; of 8 seeds 7, sanitized, of $(TESTS_LONG);" \
	    "narrow polygons of harmonic in two number types of three"

## Run all seeds of those that take long under ASan and UBSan too: minutes
.PHONY: test-long
test-long: $(foreach n,$(NUMS),$(foreach t,$(TESTS_LONG),build/test/$(n)/$(t)))
	@for t in $(TESTS_LONG); do for n in $(NUMS); do \
	    echo "echo '-- $$t $$n'; build/test/$$n/$$t"; done; done | bash tests/house/beside.sh

# one module in all number types: make test-forward
test-%: $(foreach n,$(NUMS),build/test/$(n)/%)
	@for n in $(NUMS); do build/test/$$n/$* || exit 1; done
.PRECIOUS: $(foreach n,$(NUMS),build/test/$(n)/%)

# --- other numbers of axes: the wire in q16 with 1, 2, 4 and 6, curves with 1 ---------------------
AXES_TESTS  := codec message receiver
CURVE_TESTS := bezier rational rational_extend bspline nurbs join intersect overlap offset nearest \
               bounds
axes_src     = $(foreach r,$(1),$(sort $(wildcard lib/$(r)/*.c)))

# axes_test TEST, axes, rooms of the library
define axes_test
build/axes/$(2)/$(1): test_$(1).c $(patsubst %.c,build/axes/$(2)/%.o,$(call axes_src,$(3)))
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(TESTED) $$(STD) $$(DEPS) -MF $$@.d -MT $$@ \
	    $$(SANITIZE) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$(2) $$< $$(filter %.o,$$^) -lm -o $$@
-include build/axes/$(2)/$(1).d
AXES_EACH += build/axes/$(2)/$(1)
endef
define axes_objects
build/axes/$(1)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $$(@D)
	$$(Q)$$(CC) $$(INCLUDE) $$(TESTED) $$(STD) $$(DEPS) $$(SANITIZE) \
	    -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$(1) -c $$< -o $$@
endef
$(foreach a,1 2 4 6,$(eval $(call axes_objects,$(a))))
$(foreach a,1 2 4 6,$(foreach t,$(AXES_TESTS),$(eval $(call axes_test,$(t),$(a),wire))))
$(foreach t,$(CURVE_TESTS),$(eval $(call axes_test,$(t),1,num geom basis curve)))
-include $(patsubst %.c,build/axes/1/%.d,$(call axes_src,num geom basis curve))
-include $(foreach a,1 2 4 6,$(patsubst %.c,build/axes/$(a)/%.d,$(call axes_src,wire)))

# walks in registers of 256 bits, where this computer has them
build/axes/avx2/forward: test_forward.c $(call axes_src,num geom basis curve) | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Itests $(TESTED) -mavx2 $(STD) $(SANITIZE) \
	    -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=2 $(filter %.c,$^) -lm -o $@
AXES_EACH += $(if $(shell grep -sw avx2 /proc/cpuinfo),build/axes/avx2/forward)

## Run the wire's tests with 1, 2, 4 and 6 axes, those of curves with 1, walks with AVX2
.PHONY: test-axes
test-axes: $(AXES_EACH)
	@for t in $(AXES_EACH); do echo "echo '-- $$t'; $$t"; done | bash tests/house/beside.sh

# --- the planner with the effort of a chip: its bounds on times are wider ------------------------
CHIP_FLAGS := -DLOFT_NUM=LOFT_Q16 -DLOFT_PLAN_EFFORT=1
CHIP_TESTS := path corner tube plan planner timing any
CHIP_ROOMS := num geom basis curve kinematics path motion wire machine
CHIP_SRC   := $(foreach r,$(CHIP_ROOMS),$(sort $(wildcard lib/$(r)/*.c)))
build/effort/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(INCLUDE) $(TESTED) $(STD) $(DEPS) $(SANITIZE) $(CHIP_FLAGS) -c $< -o $@
build/effort/%: test_%.c $(patsubst %.c,build/effort/%.o,$(CHIP_SRC))
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Itests $(TESTED) $(STD) $(DEPS) -MF $@.d -MT $@ $(SANITIZE) \
	    $(CHIP_FLAGS) $< $(filter %.o,$^) -lm -o $@
-include $(patsubst %.c,build/effort/%.d,$(CHIP_SRC)) $(CHIP_TESTS:%=build/effort/%.d)

# with more axes than most boards have: way-points
ARM_SRC := $(foreach r,num geom basis curve path motion,$(sort $(wildcard lib/$(r)/*.c)))
define arm_test
build/effort/$(1)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(TESTED) $$(STD) $$(DEPS) $$(SANITIZE) $$(CHIP_FLAGS) \
	    -DLOFT_AXES=$(1) -c $$< -o $$@
build/effort/$(1)/waypoints: test_waypoints.c $(patsubst %.c,build/effort/$(1)/%.o,$(ARM_SRC))
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(TESTED) $$(STD) $$(DEPS) -MF $$@.d -MT $$@ \
	    $$(SANITIZE) $$(CHIP_FLAGS) -DLOFT_AXES=$(1) $$< $$(filter %.o,$$^) -lm -o $$@
-include $(patsubst %.c,build/effort/$(1)/%.d,$(ARM_SRC)) build/effort/$(1)/waypoints.d
CHIP_EACH += build/effort/$(1)/waypoints
endef
CHIP_EACH := $(CHIP_TESTS:%=build/effort/%)
$(foreach a,4 6,$(eval $(call arm_test,$(a))))

## Run the planner's tests with the effort of a chip, LOFT_PLAN_EFFORT 1
.PHONY: test-effort
test-effort: $(CHIP_EACH)
	@for t in $^; do echo "echo '-- $$t'; $$t"; done | bash tests/house/beside.sh

# --- exact results: one line per CSV of a folder --------------------------------------------------
VECTORS ?= tests/vectors
VECTOR_SRC := $(sort $(wildcard tests/vectors/*.c)) host-tools/figures/engine_chapter.c \
              host-tools/figures/chapter.c host-tools/figures/chapter_study.c
# f32 as the library is built for use: the readers are the same code in each number type
vector_flags = $(if $(filter-out f32,$(1)),$$(SANITIZE))
define vectored
build/vectors/$(1)-obj/%.o: %.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) -Itests -Ihost-tools $$(TESTED) $$(STD) $$(DEPS) \
	    $(call vector_flags,$(1)) $$(call num_flag,$(1)) -c $$< -o $$@
build/vectors/$(1): $(patsubst %.c,build/vectors/$(1)-obj/%.o,$(VECTOR_SRC)) $(SOLVER_OBJ) \
                    $(call libs,build/$(if $(call vector_flags,$(1)),test/$(1),$(1)x3))
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(TESTED) $(call vector_flags,$(1)) $$(linked) -lm -o $$@
-include $(patsubst %.c,build/vectors/$(1)-obj/%.d,$(VECTOR_SRC))
endef
$(foreach n,$(NUMS),$(eval $(call vectored,$(n))))

## Compare with exact results   VECTORS=folder of CSVs  NUM=q16|f32|f64
.PHONY: check-vectors
check-vectors: build/vectors/$(NUM)
	@build/vectors/$(NUM) $(VECTORS) tests/vectors

.PHONY: check-vectors-all
check-vectors-all: $(foreach n,$(NUMS),build/vectors/$(n))
	@{ for n in $(NUMS); do \
	       echo "echo '-- $$n'; build/vectors/$$n $(VECTORS) tests/vectors"; done; \
	   echo "sh tests/vectors/runner.sh build/vectors/q16 tests/vectors"; } | \
	    bash tests/house/beside.sh

# Readers that are fuzzed, and what was found, which is read again without libFuzzer.
FUZZERS := svg text gcode loft machine
CORPUS  := $(addprefix build/corpus/,$(FUZZERS))
REPLAY   = for n in $(FUZZERS); do \
               echo "sh tests/house/corpus.sh build/corpus/$$n tests/corpus/$$n.tar.gz"; done

# --- readers, plans and pictures: build/test/tools/<module>, sanitized ----------------------------
# Without base/tool.c, which has a command around it: the tests listen by support/heard.h.
TOOL_TESTS  := $(patsubst tests/tools/test_%.c,%,$(sort $(wildcard tests/tools/test_*.c)))
TOOL_TESTED := $(filter-out %/tool.c $(TOOL_LEFT),$(sort $(wildcard $(patsubst %, \
                 host-tools/%/*.c,base engine geometry read svg gcode fit arrange plan draw mill))))
TOOL_TESTED := $(filter-out host-tools/engine/engines.c,$(TOOL_TESTED))
TOOL_TESTED += $(patsubst %,host-tools/%.c,readers cmd/keys cmd/waits send/gcode_write \
                 send/facts send/near_move send/unfinished send/transport send/transport_fd \
                 send/transport_kind send/transport_tcp send/without_serial) \
               $(wildcard host-tools/send/grbl*.c)
# those that take long: a push runs a share of their seeds
TOOLS_LONG := areas export certify mill
TOOL_SHARE := $(if $(ALL),1,4)
TOOL_FLAGS   = $(INCLUDE) $(TESTED) $(TOOL_STD) $(SANITIZE) -DLOFT_NUM=LOFT_F64 -DLOFT_AXES=3
TOOL_TESTED_OBJ := $(patsubst %.c,build/test/tools/%.o,$(TOOL_TESTED))

build/test/tools/%.o: %.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)$(CC) $(TOOL_FLAGS) -c $< -o $@
build/test/tools/libtools.a: $(TOOL_TESTED_OBJ)
	$(SAY) "  AR  $@"
	$(Q)rm -f $@; $(AR) rcs $@ $^
build/test/tools/%: tests/tools/test_%.c build/test/tools/libtools.a $(call libs,build/test/f64)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(TOOL_FLAGS) -Itests -MF $@.d -MT $@ \
	    $< $(filter %.a,$^) \
	    $(shell pkg-config --libs libxml-2.0 zlib pangocairo geos) -lm -o $@
# The tables of all commands; the readers of options are sanitized.
OPTION_OBJ := $(addprefix host-tools/base/option,.o _line.o _json.o)
build/test/tools/option: tests/tools/test_option.c $(addprefix build/test/tools/,$(OPTION_OBJ)) \
        $(filter-out %/host-tools/loft.o $(addprefix %/,$(OPTION_OBJ)),$(TOOL_OBJ)) $(TOOL_LIBS)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(TOOL_FLAGS) -Itests -MF $@.d -MT $@ $(filter %.c %.o %.a,$^) \
	    $(shell $(PKG_CONFIG) --libs $(TOOL_PKG)) -lm -o $@
# Conversations with a machine in this program; they are sanitized, and have no line and no clock.
SEND_SRC := $(filter-out %/without_serial.c $(wildcard host-tools/send/transport*.c), \
              $(sort $(wildcard host-tools/send/*.c host-tools/library/*.c)))
SERVE_SRC := $(addprefix host-tools/serve/,client.c messages.c preview.c store.c)
TALK_SRC  := $(SEND_SRC) $(SERVE_SRC)
TALK_TESTS := build/test/tools/send build/test/tools/library build/test/tools/serve
$(TALK_TESTS): build/test/tools/%: tests/tools/test_%.c $(TALK_SRC:%.c=build/test/tools/%.o) \
        $(filter-out %/host-tools/loft.o %/base/clock.o $(TOOL_OUT)/tools/host-tools/send/% \
            $(TOOL_OUT)/tools/host-tools/library/% $(SERVE_SRC:%.c=$(TOOL_OUT)/tools/%.o), \
            $(TOOL_OBJ)) $(TOOL_LIBS)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(TOOL_FLAGS) -Itests -MF $@.d -MT $@ $(filter %.c %.o %.a,$^) \
	    $(shell $(PKG_CONFIG) --libs $(TOOL_PKG)) -lm -o $@
-include $(TOOL_TESTED_OBJ:.o=.d) $(TALK_SRC:%.c=build/test/tools/%.d)
-include $(patsubst %,build/test/tools/%.d,$(TOOL_TESTS))
.PRECIOUS: build/test/tools/%.o

## Test readers, plans and pictures under ASan and UBSan; what fuzzers have found
.PHONY: test-tools
test-tools: $(patsubst %,build/test/tools/%,$(TOOL_TESTS)) $(CORPUS)
	@$(if $(ALL),,echo "left to make check-all: of $(TOOL_SHARE) seeds all but one of $(TOOLS_LONG)")
	@{ for t in $(TOOLS_LONG); do \
	       echo "echo '-- $$t'; LOFT_SHARE=$(TOOL_SHARE) build/test/tools/$$t"; done; \
	   for t in $(filter-out $(TOOLS_LONG),$(TOOL_TESTS)); do \
	       echo "echo '-- $$t'; build/test/tools/$$t"; done; $(REPLAY); } | \
	    bash tests/house/beside.sh

## Paths of a mill against 10 million points of surfaces (4 minutes of processor time)
.PHONY: sweep-mill
sweep-mill: build/sweep/mill
	@for s in gb bicubic octant pn; do echo "build/sweep/mill 10000000 $$s"; done | \
	    bash tests/house/beside.sh
build/sweep/libtools.a: $(filter-out %/base/tool.o %/host-tools/loft.o,$(TOOL_OBJ))
	@mkdir -p $(@D)
	$(SAY) "  AR  $@"
	$(Q)rm -f $@; $(AR) rcs $@ $^
build/sweep/mill: tests/tools/test_mill.c build/sweep/libtools.a $(TOOL_LIBS)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Itests $(BUILT) $(TOOL_STD) $(call tool_flag,q16) \
	    $(filter %.c %.a,$^) $(shell $(PKG_CONFIG) --libs $(TOOL_PKG)) -lm -o $@

# --- G-code beside LinuxCNC's interpreter, which is large: make deps-gcode ------------------------
build/gcode/canon: tests/gcode/canon.c build/test/tools/libtools.a $(call libs,build/test/f64)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(TOOL_FLAGS) -MF $@.d -MT $@ $(filter %.c %.a,$^) \
	    $(shell pkg-config --libs libxml-2.0 zlib pangocairo) -lm -o $@

NC_FILES := $(wildcard /usr/share/linuxcnc/ncfiles)
GCODE_CASES ?= 1000
## Compare G-code with LinuxCNC's rs274, motion by motion   GCODE_CASES=programs from a seed
.PHONY: check-gcode
check-gcode: build/gcode/canon
	@{ echo "python3 tests/gcode/peer.py $< --cases $(GCODE_CASES)"; \
	   $(if $(NC_FILES),echo "python3 tests/gcode/peer.py $< $(NC_FILES)";) } | \
	    bash tests/house/beside.sh

# --- how parts fit together -----------------------------------------------------------------------
## Show that builds of different arithmetic do not link, but three number types in one program do
.PHONY: test-mixed
test-mixed: $(foreach n,$(NUMS),build/$(n)x$(AXES)/libloft.a)
	@sh tests/house/mixed.sh build

## Compile loft.h and each header alone as C++11 to C++20, and link every function with the library
.PHONY: test-cplusplus
test-cplusplus: $(foreach n,$(NUMS),$(call libs,build/$(n)x3))
	@sh tests/house/cplusplus.sh build

## Compile each form of the packages: one file as C99 and C++11, sketches, samples, modules
.PHONY: test-packages
test-packages: lib/names.h $(call libs,build/q16x3)
	@bash tests/packages/compile.sh

## Run the commands of host-tools/README.md in their order; ALL=1: also those that compute for long
.PHONY: test-tour
test-tour: build/loft
	@python3 tests/house/tour.py --run build/loft

## Compile and run the README's example
.PHONY: test-readme
test-readme: build/q16x3/libloft.a
	@sh tests/house/readme.sh build/q16x3/libloft.a build/readme

## Compile and run the programs of lib/examples in all number types, link the files of RECIPES.md
.PHONY: test-examples
test-examples: $(foreach n,$(NUMS),$(call libs,build/$(n)x3))
	@sh tests/house/examples.sh build

## Decode the examples of lib/wire/WIRE.md with a peer that was written from that page alone
.PHONY: test-peer
test-peer:
	@python3 tests/lib/wire/wire_peer.py

## Search every state of the session's model with spin: nothing twice, nothing lost, the job ends
.PHONY: test-model
test-model:
	@sh tests/model/model.sh

# --- what tests see: tests/MUTANTS.md -------------------------------------------------------------
ROOM   ?= num,geom,basis,curve,kinematics,path,motion,wire,machine,surface,polygon,toolpath
SAMPLE ?= 20
SEED   ?= 1
## Change lib/ a little: do tests see it?   ROOM=path SAMPLE=20 (0: all) SEED=1 PAGE=1
.PHONY: mutate
mutate: lib/names.h
	@python3 tests/house/mutate.py --rooms $(ROOM) --sample $(SAMPLE) --seed $(SEED) \
	    $(if $(ALL),--all) $(if $(PAGE),--page)

# --- long sweeps, not part of `make check` --------------------------------------------------------
define swept
build/sweep/$(1)/%: test_%.c $(call libs,build/$(1)x$(AXES))
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(BUILT) $$(STD) $$(call num_flag,$(1)) \
	    $$(filter %.c %.a,$$^) -lm -o $$@
endef
$(foreach n,$(NUMS),$(eval $(call swept,$(n))))

## Offset LOFT_CASES (1000000) folded cubics in each number type, in an hour of processor time
.PHONY: sweep-offset
sweep-offset: $(foreach n,$(NUMS),build/sweep/$(n)/offset)
	@for t in $^; do LOFT_CASES=$(or $(LOFT_CASES),1000000) $$t || exit 1; done

build/sweep/harmonic: tests/lib/polygon/sweep_harmonic.c $(SOLVER_OBJ) \
                      $(call libs,build/q16x$(AXES))
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Ihost-tools $(BUILT) $(STD) $(call num_flag,q16) \
	    $(filter %.c %.o %.a,$^) -lm -o $@

## Solve LOFT_CASES (1000) random polygons for harmonic coordinates, half an hour of processor time
.PHONY: sweep-harmonic
sweep-harmonic: build/sweep/harmonic
	@$<

define swept_motion
build/sweep/$(1)/motion: tests/bench/bench_motion_any.c $(2)
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $(3) $$(STD) $$(filter %.c %.a %.o,$$^) -lm -o $$@
endef
$(foreach n,$(NUMS),$(eval $(call swept_motion,$(n),build/$(n)x$(AXES)/libloft.a,$$(BUILT) \
    $(call num_flag,$(n)))))
$(eval $(call swept_motion,effort,$(CHIP_SRC:%.c=build/effort/%.o),$$(TESTED) $$(SANITIZE) \
    -DLOFT_NUM=LOFT_Q16 -DLOFT_PLAN_EFFORT=1))

FIRST ?= 1
LAST  ?= 100000
MOST  ?= 200
## Plan random chains, limits, arrivals; override, hold, starve them  FIRST=1 LAST=100000 MOST=200
.PHONY: sweep-motion
sweep-motion: $(foreach n,$(NUMS) effort,build/sweep/$(n)/motion)
	@for t in $^; do echo "echo '-- $$t'; $$t $(FIRST) $(LAST) $(MOST)"; done | \
	    bash tests/house/beside.sh

FUZZ_SECONDS ?= 60
## Fuzz the input from the line with libFuzzer for FUZZ_SECONDS (60)
.PHONY: fuzz
fuzz: lib/names.h
	@mkdir -p build/fuzz/wire
	clang $(INCLUDE) -Itests -O1 -g $(STD) -fsanitize=fuzzer,address,undefined \
	    -fno-sanitize-recover=all $(call num_flag,q16) \
	    tests/lib/wire/fuzz_wire.c $(sort $(foreach r,$(CHIP_ROOMS),$(wildcard lib/$(r)/*.c)) \
	    $(PATCHES_SRC)) lib/surface/tensor/coons.c \
	    -o build/fuzz/wire_fuzz
	build/fuzz/wire_fuzz -max_len=1200 -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 \
	    build/fuzz/wire

# What is looked for is new ways through the readers: the library below them is not counted, and
# comparisons are not (tokens come from a dictionary). So ten times as many runs fit into a second.
FUZZED = $(INCLUDE) -O1 -g $(TOOL_STD) -fsanitize=address,undefined \
         -fno-sanitize-recover=all -DLOFT_NUM=LOFT_F64 -DLOFT_AXES=3 -DDRAWING_CURVES_MAX=2000u
COUNTED = -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp
READERS := $(patsubst %,host-tools/%/%,base geometry read svg gcode)
build/fuzz/tools/%.o: %.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)clang $(FUZZED) $(if $(filter $(READERS),$<),$(COUNTED)) -c $< -o $@
FUZZED_OBJ = $(patsubst %.c,build/fuzz/tools/%.o,$(TOOL_TESTED) $(LIB_SRC))
-include $(FUZZED_OBJ:.o=.d)
build/fuzz/tools.a: $(FUZZED_OBJ)
	$(SAY) "  AR  $@"
	$(Q)rm -f $@; $(AR) rcs $@ $^

# tests/corpus/NAME.tar.gz is what earlier runs have found; NAME.dict: the words of the format.
# Freed memory is kept for 4 MB, not 256, and calls are not recorded: three times as many runs. The
# text of SVG is a target of its own, with another file in the place of svg_glyphs.c: the fonts of
# the system take four fifths of the time.
FUZZ_RUNS   ?= 0
FUZZ_LENGTH ?= 300
FUZZ_MAIN_svg     := tests/tools/fuzz_svg.c host-tools/svg/without_glyphs.c
FUZZ_MAIN_text    := tests/tools/fuzz_svg.c
FUZZ_MAIN_gcode   := tests/gcode/fuzz_gcode.c
FUZZ_MAIN_loft    := tests/tools/fuzz_loft.c
FUZZ_MAIN_machine := tests/tools/fuzz_machine.c
FUZZ_LIBS = $(shell pkg-config --libs libxml-2.0 zlib pangocairo) -lm
build/fuzz/%_fuzz: build/fuzz/tools.a
	clang $(filter-out -MMD -MP,$(FUZZED)) -Itests -fsanitize=fuzzer $(FUZZ_MAIN_$*) $< \
	    $(FUZZ_LIBS) -o $@

## Feed a reader by libFuzzer: fuzz-svg, -text, -gcode, -loft, -machine   FUZZ_SECONDS=60 FUZZ_RUNS=
.PHONY: $(addprefix fuzz-,$(FUZZERS))
$(addprefix fuzz-,$(FUZZERS)): fuzz-%: build/fuzz/%_fuzz
	@mkdir -p build/fuzz/$*
	tar -xzf tests/corpus/$*.tar.gz -C build/fuzz/$*
	LSAN_OPTIONS=suppressions=tests/tools/fuzz.supp \
	ASAN_OPTIONS=quarantine_size_mb=4:malloc_context_size=0 \
	$< -entropic=0 -max_len=$(FUZZ_LENGTH) -timeout=60 -print_final_stats=1 \
	    $(if $(filter 0,$(FUZZ_RUNS)),-max_total_time=$(FUZZ_SECONDS),-runs=$(FUZZ_RUNS)) \
	    -dict=tests/corpus/$(*:text=svg).dict -artifact_prefix=build/fuzz/$*- build/fuzz/$*

# --- what the fuzzers found, read again: without libFuzzer ----------------------------------------
build/corpus/%: tests/support/fuzz_main.c build/test/tools/libtools.a $(call libs,build/test/f64)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(TOOL_FLAGS) -Itests -MF $@.d -MT $@ $(FUZZ_MAIN_$*) $^ \
	    $(shell pkg-config --libs libxml-2.0 zlib pangocairo geos) -lm -o $@
.PHONY: test-corpus
test-corpus: $(CORPUS)
	@{ $(REPLAY); } | bash tests/house/beside.sh

# --- whole jobs -----------------------------------------------------------------------------------
## Run whole jobs: the command, sanitized, on the simulated machine   CASE=one of tests/e2e/*.sh
.PHONY: test-e2e
test-e2e: build/loft build/e2e/pty build/e2e/shim.so
	+@$(PARALLEL) -s tools TOOL_OUT=build/e2e BUILT="$(TESTED) $(SANITIZE)" \
	    TOOL_LIB="$(call libs,build/test/%)"
	@bash tests/e2e/e2e.sh build/e2e/loft build/loft build/e2e $(CASE)

## Run one whole job many times side by side, beside a load    CASE=name RUNS=20
RUNS = 20
.PHONY: stress
stress: build/loft build/e2e/pty build/e2e/shim.so
	+@$(PARALLEL) -s tools TOOL_OUT=build/e2e BUILT="$(TESTED) $(SANITIZE)" \
	    TOOL_LIB="$(call libs,build/test/%)"
	@bash tests/e2e/stress.sh $(RUNS) build/e2e/loft build/loft build/e2e $(CASE)

build/e2e/pty: tests/e2e/e2e_pty.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -D_GNU_SOURCE $< -o $@
build/e2e/shim.so: tests/e2e/e2e_shim.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -D_GNU_SOURCE -shared -fPIC $< -ldl -o $@
