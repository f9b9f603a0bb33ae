# ports/linux-gpio/port.mk -- build and check the machine on the GPIO lines of a Linux board
# SPDX-License-Identifier: MIT

# libgpiod 1.x or 2.x, whichever pkg-config finds
GPIO_VERSION ?= $(shell pkg-config --atleast-version=2 libgpiod 2>/dev/null && echo 2 || echo 1)
GPIO_SRC   = $(wildcard ports/host/*.c) \
             $(patsubst %,ports/linux-gpio/%.c,main config_file machine_lines inputs powers pulses)
GPIO_HDR   = $(wildcard ports/*.h ports/host/*.h ports/linux-gpio/*.h)
GPIO_FLAGS = -std=c99 $(WARN) -D_GNU_SOURCE -Ilib -Iports -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=3

# loft-gpio, version of libgpiod, its flags, its libraries
define gpio_program
$(1): $$(GPIO_SRC) ports/linux-gpio/gpio_v$(2).c $$(GPIO_HDR) \
      $$(call libs,build/q16x3)
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(BUILT) $$(GPIO_FLAGS) $(3) $$(filter %.c %.a,$$^) $(4) \
	    -pthread -lm -o $$@
endef
$(eval $(call gpio_program,build/loft-gpio,$(GPIO_VERSION),$$(GPIO_CFLAGS),$$(GPIO_LIBS)))
build/loft-gpio: GPIO_CFLAGS = $(patsubst -I%,-isystem %,\
                     $(shell pkg-config --cflags libgpiod 2>/dev/null))
build/loft-gpio: GPIO_LIBS   = $(or $(shell pkg-config --libs libgpiod 2>/dev/null),-lgpiod)

## Build build/loft-gpio, the machine on the GPIO lines of a Linux board (libgpiod 1.x or 2.x)
.PHONY: gpio
gpio:
	@pkg-config --exists libgpiod || \
	    { echo "libgpiod is missing: apt install libgpiod-dev"; exit 1; }
	@$(MAKE) --no-print-directory build/loft-gpio

# --- on a kernel with simulated chips -------------------------------------------------------------
# what the guest runs, static: with both versions of libgpiod, which gpio_get.sh has fetched
GPIO_CACHE ?= $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/loft/gpio
GPIO_GUEST  = build/target/gpio
gpio_guest = $(call gpio_program,$(GPIO_GUEST)/loft-gpio$(1),$(1),-Werror -static \
    -isystem $(GPIO_CACHE)/v$(1),$(GPIO_CACHE)/v$(1)/libgpiod.a)
$(foreach v,1 2,$(eval $(call gpio_guest,$(v))))
$(GPIO_GUEST)/guest: tests/target/gpio_guest.c
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -D_GNU_SOURCE -static $< -o $@

# and on paper, here, under sanitizers
define gpio_paper
$(GPIO_GUEST)/loft-gpio-$(1): $$(GPIO_SRC) tests/target/gpio_paper.c $$(GPIO_HDR) \
                              $$(call libs,build/q16x3)
	@mkdir -p $$(@D)
	$$(SAY) "  LD  $$@"
	$$(Q)$$(CC) $$(LDFLAGS) $$(TESTED) $$(GPIO_FLAGS) -Werror $(2) $$(filter %.c %.a,$$^) \
	    -pthread -lm -o $$@
endef
$(eval $(call gpio_paper,race,-fsanitize=thread))
$(eval $(call gpio_paper,memory,$(SANITIZE)))

## Run loft-gpio on a real kernel with simulated GPIO chips (QEMU): jobs, switches, ends, lateness
.PHONY: check-gpio
check-gpio: $(TOOL_OUT)/loft $(GPIO_GUEST)/loft-gpio-race $(GPIO_GUEST)/loft-gpio-memory
	@bash tests/target/gpio_get.sh $(GPIO_CACHE) >/dev/null && \
	    $(MAKE) -s --no-print-directory \
	        $(addprefix $(GPIO_GUEST)/,loft-gpio1 loft-gpio2 guest) || \
	    { echo "FAIL no kernel with GPIO chips could be had, nothing was tested"; \
	      echo "0 passed, 1 failed"; exit 1; }
	@bash tests/target/gpio.sh $(GPIO_CACHE) $(GPIO_GUEST) $(TOOL_OUT)/loft
TARGET_BESIDE += check-gpio
