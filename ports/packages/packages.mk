# ports/packages/packages.mk -- loft in every tool chain: install, uninstall, dist, check-packages
# SPDX-License-Identifier: MIT
#
# PREFIX and the folders below are those of the GNU coding standards; DESTDIR stands before them.
PREFIX     ?= /usr/local
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR    ?= $(PREFIX)/share

# Version and soname are read from loft.h. The soname is the major version; while that is 0, each
# minor version may change the interface, so it is both. The date is that of the version.
version_part = $(shell sed -n 's/^\#define LOFT_VERSION_$(1) //p' lib/loft.h)
VERSION   := $(call version_part,MAJOR).$(call version_part,MINOR).$(call version_part,PATCH)
SOVERSION := $(patsubst 0,0.$(call version_part,MINOR),$(call version_part,MAJOR))
DATE      := $(shell sed -n 's/^\#\# \[$(VERSION)\] - //p' CHANGELOG.md)

# --- shared libraries: build/<num>x<axes>/libloft-<num>.so, libloft-surfaces-<num>.so -------------
# named as what is installed
# Three axes are the usual number; a library of another carries it in its name.
INSTALLED_AS = $(1)$(if $(filter-out 3,$(AXES)),x$(AXES))
define shared
build/$(1)x$(AXES)/shared/%.o: %.c | lib/names.h
	@mkdir -p $$(@D)
	$$(SAY) "  CC  $$@"
	$$(Q)$$(CC) $$(INCLUDE) $$(BUILT) $$(STD) $$(DEPS) -ffreestanding -fPIC $$(call num_flag,$(1)) \
	    -c $$< -o $$@
build/$(1)x$(AXES)/libloft-$(INSTALLED_AS).so: \
        $(patsubst %.c,build/$(1)x$(AXES)/shared/%.o,$(LOFT_SRC))
build/$(1)x$(AXES)/libloft-surfaces-$(INSTALLED_AS).so: \
        $(patsubst %.c,build/$(1)x$(AXES)/shared/%.o,$(SURFACES_SRC)) \
        build/$(1)x$(AXES)/libloft-$(INSTALLED_AS).so
$(foreach l,loft loft-surfaces,build/$(1)x$(AXES)/lib$(l)-$(INSTALLED_AS).so): build/loft.map
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) -shared $$(LDFLAGS) $$(BUILT) $$(filter %.o,$$^) $$(filter %.so,$$^) \
	    -Wl,-soname,$$(@F).$(SOVERSION) -Wl,--version-script=build/loft.map -o $$@
-include $(patsubst %.c,build/$(1)x$(AXES)/shared/%.d,$(LIB_SRC))
endef
$(foreach n,$(NUMS),$(eval $(call shared,$(n))))
# of those that are asked for: one for each number type, or the one of the host
NUMBERED = $(filter-out loft-host,$(LIBRARIES))
HOSTED = $(if $(filter loft-host,$(LIBRARIES)),$(TOOL_OUT)/libloft-host.a)
SHARED = $(foreach n,$(NUMS),$(NUMBERED:%=build/$(n)x$(AXES)/lib%-$(call INSTALLED_AS,$(n)).so))
STATIC = $(foreach n,$(NUMS),$(NUMBERED:%=build/$(n)x$(AXES)/lib%.a))

build/loft.map: lib/loft.h
	@mkdir -p $(@D)
	@printf 'LOFT_%s { global: loft_*; local: *; };\n' $(SOVERSION) > $@

# --- install: what goes where is laid out in build/stage first ------------------------------------
STAGE = VERSION=$(VERSION) SOVERSION=$(SOVERSION) DATE=$(DATE) AXES=$(AXES) NUMS="$(NUMS)" \
        LIBRARIES="$(LIBRARIES)" LOFT_ROOMS="$(LOFT_ROOMS)" SURFACES_ROOMS="$(SURFACES_ROOMS)" \
        HOST_PKG="$(HOST_PKG)" HOST_LIBRARY="$(HOSTED)" \
        INCLUDEDIR="$(INCLUDEDIR)" LIBDIR="$(LIBDIR)" sh ports/packages/stage.sh build/stage
# copied FOLDER, where: a folder of the stage, with its links, to its place
copied = mkdir -p "$(DESTDIR)$(2)" && cp -RP build/stage/$(1)/. "$(DESTDIR)$(2)"
removed = cd build/stage/$(1) && find . ! -type d | while read -r f; do \
              rm -f "$(DESTDIR)$(2)/$$f"; done && \
          find . -depth -type d -name '*loft*' | while read -r d; do \
              rmdir "$(DESTDIR)$(2)/$$d" 2>/dev/null; done; cd ../../..

.PHONY: libraries
libraries:
	+@$(PARALLEL) $(STATIC) $(SHARED) $(HOSTED)

# lib, libraries and tools each call make: one after the other, also with -j
libraries: | $(filter lib,$(MAKECMDGOALS))
tools: | $(filter lib,$(MAKECMDGOALS)) \
         $(if $(filter libraries install uninstall,$(MAKECMDGOALS)),libraries)

# (of a command line, LIBRARIES stays as it is)
install uninstall: LIBRARIES += loft-host

## Install headers, libraries and the command   DESTDIR= PREFIX=/usr/local (LIBDIR= BINDIR= ..)
.PHONY: install
install: install-lib tools
	@$(STAGE) $(TOOL_OUT)/loft
	@$(call copied,bin,$(BINDIR)) && $(call copied,share,$(DATADIR))
	@echo "installed in $(DESTDIR)$(PREFIX): the command, man pages, completions"

## Install headers and libraries alone: loft, loft-surfaces, loft-host   LIBRARIES="loft .."
.PHONY: install-lib
install-lib: libraries lib/names.h
	@$(STAGE)
	@$(call copied,include,$(INCLUDEDIR)) && $(call copied,lib,$(LIBDIR))
	@echo "installed in $(DESTDIR)$(PREFIX): headers," \
	    "$(foreach l,$(NUMBERED),$(NUMS:%=lib$(l)-%,)) $(HOSTED:%=libloft-host,)" \
	    "pkg-config and CMake files"

## Remove what `make install` with the same DESTDIR= and PREFIX= put there
.PHONY: uninstall
uninstall: libraries tools
	@$(STAGE) $(TOOL_OUT)/loft
	@$(call removed,include,$(INCLUDEDIR)); $(call removed,lib,$(LIBDIR)); \
	 $(call removed,bin,$(BINDIR)); $(call removed,share,$(DATADIR))

# --- dist: what is given away, in build/dist ----------------------------------------------------
## Pack sources, single files, trees for other tools in build/dist   NUM= ROOMS=curve,..
.PHONY: dist
dist: lib/names.h
	@VERSION=$(VERSION) SOVERSION=$(SOVERSION) DATE=$(DATE) NUM=$(NUM) ROOMS=$(ROOMS) \
	    bash ports/packages/dist.sh build/dist
	@echo "packed in build/dist: $$(cd build/dist && ls -d *.gz *.json | paste -sd' ')"

# --- check-quick: under a minute, for those who build packages -----------------------------------
QUICK := bezier forward hermite rational measure nurbs tensor triangle span limits codec frame \
         receiver machine step kinematics
quick_runs := $(foreach n,$(NUMS),$(foreach t,$(QUICK),build/sweep/$(n)/$(t)))
.PHONY: test-quick
test-quick: $(quick_runs)
	@for t in $(quick_runs); do echo "LOFT_CASES=200 $$t"; done | bash tests/house/beside.sh

## Check the library that was built, without sanitizers, in a minute
.PHONY: check-quick
check-quick:
	@MAKE="$(MAKE)" bash tests/house/check.sh test-quick test-readme

# --- make check-packages: one line per thing that was built and run, `N passed, N failed` ---------
PACKAGE_ROWS := install host tool cross onefile cmake meson debian arduino boards wasm rust \
                python cpp export inkscape hygiene

## Install what check-packages needs (Debian's build tools, shells, compilers of other languages)
.PHONY: deps-packages
deps-packages: deps deps-target
	@sh tests/house/deps.sh mandoc groff bash zsh fish bsdextrautils musl-tools cmake meson \
	    ninja-build debhelper lintian fakeroot clang arduino-core-avr arduino-builder \
	    arduino-ctags libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib \
	    python3-kconfiglib python3-yaml lld nodejs rustc cargo bindgen python3-pip \
	    python3-setuptools python3-wheel python3-dev python3-cffi python3-numpy \
	    python3-matplotlib reuse gcc-aarch64-linux-gnu inkscape xvfb libxml2-utils
	@sh ports/packages/sysroot.sh arm64 build/sysroot/arm64 \
	    $(filter-out libclang%,$(filter %-dev,$(HOST_PACKAGES)))

$(PACKAGE_ROWS:%=check-packages-%): check-packages-%: lib/names.h
	@timeout 3600 bash tests/packages/$*.sh || \
	    { [ $$? != 124 ] || echo "FAIL $*: not over after 3600 s"; exit 1; }

# these compare with the archives, or link them
check-packages-onefile check-packages-install check-packages-cpp: $(STATIC)

## Build and run loft in every tool chain (one: make check-packages-cmake)
.PHONY: check-packages $(PACKAGE_ROWS:%=check-packages-%)
check-packages:
	@MAKE="$(MAKE)" bash tests/house/check.sh $(PACKAGE_ROWS:%=check-packages-%)
