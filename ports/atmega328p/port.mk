# ports/atmega328p/port.mk -- build, measure and flash the firmware
# SPDX-License-Identifier: MIT
AVR_BAUD  ?= 115200
AVR_SLOTS ?= 80
# cycles of a pulse, 16..: 1 us
AVR_PULSE ?= 32
AVR_TICK_HZ ?= 1000
# spindle or laser, coolant, pauses; 0: 2.5 kB less, and a span more in the queue
AVR_OUTPUTS ?= 2
# a servo in place of the third motor, if the settings say so; 0: 400 bytes less, and a span more
AVR_SERVO ?= 1
AVR_MAX    = 32256 1600             # bytes of flash, and of RAM without the stack
AVR_FLAGS  = -mmcu=atmega328p -DF_CPU=16000000UL -std=c99 -ffreestanding -ffunction-sections \
             -fdata-sections -flto $(WARN) $(DEPS) -Ilib -Iports $(call num_flag,q16) \
             -DLOFT_MACHINE_TICK_PREPARES=0 -DLOFT_MACHINE_OVERRIDE_LIMITS=0 \
             -DLOFT_MACHINE_SLOT_HALTS=0 -DLOFT_MACHINE_SQUARES=0 \
             -DLOFT_FRAME_MAX=88 -DLOFT_MACHINE_OUTPUTS=$(AVR_OUTPUTS) \
             -DLOFT_SERVO=$(AVR_SERVO) -DLOFT_BAUD=$(AVR_BAUD) \
             -DLOFT_SLOTS=$(AVR_SLOTS) -DLOFT_TICK_HZ=$(AVR_TICK_HZ) -DLOFT_PULSE=$(AVR_PULSE)
AVR_OPTIMIZE = -Os
# all files are optimized as one: 2.2 kB less. Functions with much on the stack stay separate.
AVR_STACK  = --param large-stack-frame=16 --param large-stack-frame-growth=0
# 620 bytes less, and no tick is slower
AVR_SMALL  = -mstrict-X -finline-limit=50
AVR_DIR   ?= build/firmware/atmega328p
AVR_OBJ    = $(patsubst %.c,$(AVR_DIR)/%.o,$(MACHINE_SRC))

$(AVR_DIR)/lib/%.o: lib/%.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)avr-gcc $(AVR_FLAGS) $(AVR_OPTIMIZE) -c $< -o $@

$(AVR_DIR)/port.o: ports/atmega328p/port.c | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  CC  $@"
	$(Q)avr-gcc $(AVR_FLAGS) $(AVR_OPTIMIZE) -c $< -o $@

# the slot interrupt and making slots are worth some flash
$(AVR_DIR)/port.o $(AVR_DIR)/lib/machine/step.o: AVR_OPTIMIZE = -O2
# shared prologues: small, and 30 cycles per call, which the main loop has
$(AVR_DIR)/lib/wire/%.o $(AVR_DIR)/lib/machine/machine.o $(AVR_DIR)/lib/machine/settings.o: \
    AVR_OPTIMIZE = -Os -mcall-prologues

-include $(AVR_DIR)/port.d $(AVR_OBJ:.o=.d)

$(AVR_DIR)/loft.elf: $(AVR_DIR)/port.o $(AVR_OBJ)
	$(SAY) "  LD  $@"
	$(Q)avr-gcc -mmcu=atmega328p -Os -flto $(AVR_STACK) $(AVR_SMALL) -mrelax -Wl,--gc-sections \
	    -Wl,--section-start=.ring=0x800100,-Tdata=0x800180 $^ -o $@
$(AVR_DIR)/loft.hex: $(AVR_DIR)/loft.elf
	$(Q)avr-objcopy -O ihex -R .eeprom $< $@

## Build loft.hex for an Arduino Uno with CNC shield   AVR_BAUD=250000|1000000  AVR_SLOTS=80
.PHONY: firmware-atmega328p
firmware-atmega328p: $(AVR_DIR)/loft.hex
	@avr-size $(AVR_DIR)/loft.elf | awk -v most="$(AVR_MAX)" 'NR == 2 { split(most, m, " "); \
	    printf "atmega328p: %d bytes of flash (at most %d), ", $$1 + $$2, m[1]; \
	    printf "%d of RAM without the stack (at most %d)\n", $$2 + $$3, m[2]; \
	    exit $$1 + $$2 > m[1] || $$2 + $$3 > m[2] }'

# 100,000 steps/s on each axis, pulses of 1 us: not for a DRV8825
AVR_FAST = AVR_SLOTS=100 AVR_PULSE=16 AVR_DIR=build/firmware/atmega328p-fast
.PHONY: firmware-atmega328p-fast flash-atmega328p-fast
firmware-atmega328p-fast flash-atmega328p-fast:
	@$(MAKE) --no-print-directory $(@:-fast=) $(AVR_FAST)

## Write it to a board with avrdude   PORT=/dev/ttyUSB0  FLASH_BAUD=115200
.PHONY: flash-atmega328p
flash-atmega328p: firmware-atmega328p
	@command -v avrdude >/dev/null || \
	    { echo "avrdude is missing: apt install avrdude"; exit 1; }
	@test -n "$(PORT)" || { echo "name the board's port: make $@ PORT=/dev/ttyUSB0"; exit 1; }
	avrdude -p atmega328p -c arduino -P $(PORT) -b $(or $(FLASH_BAUD),115200) \
	    -D -U flash:w:$(AVR_DIR)/loft.hex:i

# --- the emulated chip ----------------------------------------------------------------------------
SIMAVR   = -D_GNU_SOURCE $(INCLUDE) -isystem /usr/include/simavr $(call num_flag,q16)
CHIP_SRC = $(patsubst %,tests/target/avr_%.c,chip core meter gate servo) tests/target/chip_line.c \
           ports/host/line.c ports/host/record.c
build/target/chip: $(CHIP_SRC) $(wildcard tests/target/avr_*.h tests/target/chip_*.h) \
                   build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) $(SIMAVR) -Iports -Itests/target $(CHIP_SRC) \
	    build/q16x3/libloft.a -lsimavr -lm -o $@
TRIALS_SRC = $(patsubst %,tests/target/avr_%.c,trials core meter servo) ports/host/record.c
build/target/trials: $(TRIALS_SRC) $(wildcard tests/target/avr_*.h) build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) $(SIMAVR) -Iports -Itests/target $(TRIALS_SRC) \
	    build/q16x3/libloft.a -lsimavr -lm -o $@
build/target/rate: tests/target/rate.c build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) -D_GNU_SOURCE $(INCLUDE) $(call num_flag,q16) $^ \
	    -lm -o $@

build/target/bench_%: tests/bench/bench_%.c build/q16x3/libloft.a
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)$(CC) $(LDFLAGS) $(BUILT) $(STD) $(INCLUDE) $(call num_flag,q16) $^ -lm -o $@

## Measure homing, stops, laser, servo, settings; then speed and line beside grbl   ROWS= TRIALS=
.PHONY: bench-machine
bench-machine: firmware-atmega328p $(TOOL_OUT)/loft build/e2e/pty \
               $(addprefix build/target/,chip rate trials bench_line bench_frames)
	@bash tests/bench/bench_machine.sh $(AVR_DIR)/loft.elf $(TOOL_OUT)/loft build/target \
	    build/e2e/pty

## Run whole jobs on an emulated ATmega328P, cycle by cycle: pulses, timing, limits
.PHONY: check-atmega328p
check-atmega328p: firmware-atmega328p firmware-atmega328p-fast \
                  build/target/chip build/target/rate $(TOOL_OUT)/loft
	@bash tests/target/avr.sh $(AVR_DIR)/loft.elf $(TOOL_OUT)/loft build/target
TARGET_BESIDE += check-atmega328p

## Run the commands of ports/README.md on an emulated ATmega328P and on the simulated machine
.PHONY: check-walk
check-walk: firmware-atmega328p build/target/chip build/e2e/pty build/e2e/shim.so $(TOOL_OUT)/loft
	@bash tests/target/walk.sh $(AVR_DIR)/loft.elf $(TOOL_OUT)/loft build/target
	@bash tests/e2e/e2e.sh $(TOOL_OUT)/loft $(TOOL_OUT)/loft build/e2e the_page_of_the_boards
TARGET_BESIDE += check-walk
