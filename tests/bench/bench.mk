# tests/bench/bench.mk -- measurements: curves against other libraries, patches, motion
# SPDX-License-Identifier: MIT

# --- make bench: build/bench/bench<axes>, with each of AGG, GSL and cairo that pkg-config finds ---
BENCH_LIBS := $(foreach l,gsl cairo $(if $(shell command -v $(CXX)),libagg), \
                $(shell pkg-config --exists $(l) 2>/dev/null && echo $(l)))
BENCH_FLAGS = $(if $(BENCH_LIBS),$(shell pkg-config --cflags $(BENCH_LIBS))) \
              $(if $(filter gsl,$(BENCH_LIBS)),-DBENCH_GSL) \
              $(if $(filter cairo,$(BENCH_LIBS)),-DBENCH_CAIRO)

build/bench/agg.o: tests/bench/bench_agg.cpp
	@mkdir -p $(@D)
	$(SAY) "  CXX $@"
	$(Q)$(CXX) -O2 -g $(CPPFLAGS) $(CXXFLAGS) $(BENCH_FLAGS) -c $< -o $@
build/bench/bench%: tests/bench/bench.c build/q16x%/libloft.a \
                    $(if $(filter libagg,$(BENCH_LIBS)),build/bench/agg.o)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) $(BUILT) $(STD) -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=$* \
	    $(BENCH_FLAGS) $(if $(filter libagg,$(BENCH_LIBS)),-DBENCH_AGG) $^ -o $@ \
	    $(if $(BENCH_LIBS),$(shell pkg-config --libs $(BENCH_LIBS))) \
	    $(if $(filter libagg,$(BENCH_LIBS)),-lstdc++) -lm

# --- build/bench/peers: flattening, nearest points, crossings, B-splines, in double ---------------
OCCT_DIR  := /usr/include/opencascade
OCCT_LIBS := -lTKGeomAlgo -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
CRATES    := /usr/share/cargo/registry
PEERS := $(if $(wildcard /usr/include/sisl.h),SISL) \
         $(if $(wildcard $(OCCT_DIR)/Geom2dAPI_*),OCCT) \
         $(if $(and $(wildcard $(CRATES)/kurbo-* $(CRATES)/lyon_geom-*),\
                    $(shell command -v cargo)),RUST)

build/bench/occt.o: tests/bench/bench_occt.cpp tests/bench/bench_peers.h
	@mkdir -p $(@D)
	$(SAY) "  CXX $@"
	$(Q)$(CXX) -O2 -g $(CPPFLAGS) $(CXXFLAGS) -isystem $(OCCT_DIR) -c $< -o $@
# Debian's crates, without a registry
build/bench/rust/target/release/libpeers.a: tests/bench/rust/Cargo.toml tests/bench/rust/peers.rs
	@mkdir -p build/bench/rust && cp $^ build/bench/rust
	$(SAY) "  RS  $@"
	$(Q)cd build/bench/rust && cargo build --release --offline --quiet --target-dir target \
	    --config 'source.crates-io.replace-with="debian"' \
	    --config 'source.debian.directory="$(CRATES)"'
build/bench/peers: tests/bench/bench_peers.c tests/bench/bench_peers.h build/f64x2/libloft.a \
                   $(if $(filter libagg,$(BENCH_LIBS)),build/bench/agg.o) \
                   $(if $(filter OCCT,$(PEERS)),build/bench/occt.o) \
                   $(if $(filter RUST,$(PEERS)),build/bench/rust/target/release/libpeers.a)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) $(BUILT) $(STD) -DLOFT_NUM=LOFT_F64 -DLOFT_AXES=2 \
	    $(BENCH_FLAGS) $(if $(filter libagg,$(BENCH_LIBS)),-DBENCH_AGG) \
	    $(PEERS:%=-DBENCH_%) $(filter-out %.h,$^) -o $@ $(if $(filter SISL,$(PEERS)),-lsisl) \
	    $(if $(filter OCCT,$(PEERS)),$(OCCT_LIBS)) \
	    $(if $(BENCH_LIBS),$(shell pkg-config --libs $(BENCH_LIBS))) \
	    $(if $(filter libagg,$(BENCH_LIBS))$(PEERS),-lstdc++ -ldl -lpthread) -lm

## Time curves against Horner, AGG, GSL, cairo, SISL, OCCT, lyon and kurbo (make deps-bench)
.PHONY: bench
bench:
	@for axes in 2 3; do \
	    $(MAKE) -s --no-print-directory AXES=$$axes build/bench/bench$$axes && \
	    build/bench/bench$$axes || exit 1; done
	@$(MAKE) -s --no-print-directory AXES=2 build/bench/peers && build/bench/peers
	@for l in gsl cairo libagg SISL OCCT RUST; do case " $(BENCH_LIBS) $(PEERS) " in *" $$l "*) ;; \
	    *) echo "not compared: $$l is missing (make deps-bench)";; esac; done

## Count the instructions of a point of each patch with n sides on an emulated Cortex-M0 and M4
.PHONY: bench-polygon
bench-polygon: lib/names.h
	@sh tests/bench/bench_polygon.sh build/bench/polygon

# --- make bench-motion: build/bench/motion/<what>-<num> measure, bench_motion.sh prints -----------
MOTION := build/bench/motion
MOTION_WHAT := $(patsubst tests/bench/bench_motion_%.c,%,$(filter-out %_moves.c, \
                 $(sort $(wildcard tests/bench/bench_motion_*.c))))
define motioned
$(MOTION)/%-$(1): tests/bench/bench_motion_%.c build/$(1)x3/libloft.a
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(INCLUDE) -Itests $$(BUILT) $$(STD) $$(DEPS) -MF $$@.d -MT $$@ \
	    -DLOFT_NUM=LOFT_$(2) -DLOFT_AXES=3 $$(filter %.c %.a,$$^) -lm -o $$@
-include $(patsubst %,$(MOTION)/%-$(1).d,$(MOTION_WHAT))
endef
$(eval $(call motioned,q16,Q16))
$(eval $(call motioned,f64,F64))
$(MOTION)/moves: tests/bench/bench_motion_moves.c $(filter-out %/loft.o,$(TOOL_OBJ)) $(TOOL_LIBS)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) $(BUILT) $(filter-out $(DEPS),$(TOOL_STD)) \
	    $(call tool_flag,q16) $^ $(shell pkg-config --libs $(TOOL_PKG)) -lm -o $@

## Count the instructions of planning with lib/motion/plan.h on an emulated Cortex-M4 and M0
.PHONY: bench-chip
bench-chip: lib/names.h
	@bash tests/bench/bench_motion_chip.sh $(MOTION)/chip

CASES ?= 100000
## Measure the promises of motion, half an hour   ROWS="A chords lines ahead icons chip .."  CASES=
.PHONY: bench-motion
bench-motion: $(MOTION)/moves $(foreach w,$(MOTION_WHAT),$(MOTION)/$(w)-q16 $(MOTION)/$(w)-f64)
	@bash tests/bench/bench_motion.sh $(MOTION) $(CASES)

# --- drawings of Debian's packages ----------------------------------------------------------------
build/bench/order build/bench/rsvg: build/bench/%: tests/bench/bench_%.c \
        $(filter-out %/loft.o,$(TOOL_OBJ)) $(TOOL_LIBS)
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(INCLUDE) -Itests $(BUILT) $(filter-out $(DEPS),$(TOOL_STD)) \
	    $(call tool_flag,q16) $^ $(shell pkg-config --libs $(TOOL_PKG)) -lm -o $@

FILES ?= 2000
PIECE ?= 0
RSVG_FILES = $(if $(filter command,$(firstword $(origin FILES))),$(FILES),500)
## Plan 2,000 drawings of Debian's icons and clip art   FILES= PIECE=
.PHONY: bench-drawings
bench-drawings: tools
	@bash tests/bench/bench_drawings.sh $(TOOL_OUT)/loft build/bench/drawings $(FILES) 120 $(PIECE)

KNOWN ?= 60
## Travel of 20 drawings after 10 s: at most 1.05 times the best known   KNOWN=seconds for it
.PHONY: check-order
check-order: build/bench/order
	@bash tests/bench/bench_order.sh build/bench/order build/bench/drawings $(KNOWN)

## Compare 500 drawings with pictures by librsvg at 300 dpi, in pieces   FILES=500 PIECE=
.PHONY: check-rsvg
check-rsvg: build/bench/rsvg
	@bash tests/bench/bench_rsvg.sh build/bench/rsvg build/bench/drawings $(RSVG_FILES) $(PIECE)

# --- long files -----------------------------------------------------------------------------------
LINES ?= 1000000
## Read and plan 1,000,000 lines of G-code: lines per second, memory   LINES=
.PHONY: bench-long
bench-long: tools
	@bash tests/bench/bench_long.sh $(TOOL_OUT)/loft build/bench/long $(LINES)
