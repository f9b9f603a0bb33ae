# ports/cortex-m/port.mk -- the boards with a Cortex-M
# SPDX-License-Identifier: MIT

CORTEX_M0  = -mcpu=cortex-m0
CORTEX_M0P = -mcpu=cortex-m0plus
CORTEX_M3  = -mcpu=cortex-m3
CORTEX_M4F = -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard
CORTEX_M7  = -mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard
CORTEX_M33 = -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard

# cortex BOARD, core, memory (flash, its size, RAM, its size), flags, source, script if not its own
cortex_memory = -DFLASH=$(word 1,$(1)) -DFLASH_SIZE=$(word 2,$(1)) \
                -DRAM=$(word 3,$(1)) -DRAM_SIZE=$(word 4,$(1))
cortex_gcc = arm-none-eabi-gcc -mthumb $(1) $(call cortex_memory,$(2)) $(3)
cortex = $(eval $(call firmware,$(1),$(call cortex_gcc,$(2),$(3),$(4)),arm-none-eabi,$(strip \
    ports/cortex-m/start.c $(5)),$(or $(6),ports/cortex-m/cortex.ld.in)))

STM32F405 = -DCORTEX_IRQS=82 -DCORTEX_LINE_IRQ=37 -DCORTEX_STREAM_IRQ=68 -DSTREAM_AHEAD=1 \
            -DSTREAM_OUTPUTS=2
STM32F103 = -DCORTEX_IRQS=43 -DCORTEX_LINE_IRQ=37 -DCORTEX_STREAM_IRQ=15 -DLOFT_MACHINE_PLANS=0
NO_OUTPUTS = ports/bare/no_outputs.c
NRF51_PORT = ports/nrf51/port.c ports/cortex-m/stream.c $(NO_OUTPUTS)
MPS2_PORT  = ports/mps2/port.c $(NO_OUTPUTS)
NRF51     = -DCORTEX_IRQS=32 -DCORTEX_LINE_IRQ=2 -DCORTEX_STREAM_IRQ=8 -DCORTEX_SAMPLE_IRQ=9 \
            -DSTREAM_BY_CORE -DSTREAM_SAMPLES=20000u '-DSTREAM_LAYOUT="nrf51/layout.h"' \
            -DLOFT_SLOTS=100 -DLOFT_MACHINE_PLANS=0
STM32G0   = -DCORTEX_IRQS=31 -DCORTEX_LINE_IRQ=27 -DCORTEX_STREAM_IRQ=13 -DSTREAM_BY_CORE \
            -DLOFT_MACHINE_PLANS=0
STM32G0_SRC = $(strip ports/stm32g0/port.c ports/cortex-m/stream.c $(NO_OUTPUTS))
MPS2      = -DCORTEX_IRQS=32 -DCORTEX_LINE_IRQ=0 -DMPS2_CLOCK=25000000 \
            -DMPS2_UART0=0x40004000 -DMPS2_GPIO0=0x40010000 -DMPS2_GPIO1=0x40011000
MPS2_33   = -DCORTEX_IRQS=64 -DCORTEX_LINE_IRQ=32 -DMPS2_CLOCK=20000000 \
            -DMPS2_UART0=0x50200000 -DMPS2_GPIO0=0x50100000 -DMPS2_GPIO1=0x50101000

# the last two sectors of 128K keep settings; a chip of 512K has none there, and keeps none
# slots of a millisecond: with 250 a pulse has 2 us, which all drivers take; with 1000 it has 0.5 us
$(call cortex,stm32f405,$(CORTEX_M4F),0x08000000 768K 0x20000000 128K,$(STM32F405) \
    -DLOFT_SLOTS=250,$(strip ports/stm32f405/port.c ports/cortex-m/stream.c))
$(call cortex,stm32f405-fast,$(CORTEX_M4F),0x08000000 768K 0x20000000 128K,$(STM32F405) \
    -DLOFT_SLOTS=1000,$(strip ports/stm32f405/port.c ports/cortex-m/stream.c))
# the same: with 500 a pulse has 1 us
$(call cortex,stm32f103,$(CORTEX_M3),0x08000000 64K 0x20000000 20K,$(STM32F103) \
    -DLOFT_SLOTS=250,$(strip ports/stm32f103/port.c ports/cortex-m/stream.c $(NO_OUTPUTS)))
$(call cortex,stm32f103-fast,$(CORTEX_M3),0x08000000 64K 0x20000000 20K,$(STM32F103) \
    -DLOFT_SLOTS=500,$(strip ports/stm32f103/port.c ports/cortex-m/stream.c $(NO_OUTPUTS)))
# the same: with 320 a pulse has 1 us
$(call cortex,stm32g0,$(CORTEX_M0P),0x08000000 64K 0x20000000 36K,$(STM32G0) \
    -DLOFT_SLOTS=200,$(STM32G0_SRC))
$(call cortex,stm32g0-fast,$(CORTEX_M0P),0x08000000 64K 0x20000000 36K,$(STM32G0) \
    -DLOFT_SLOTS=320,$(STM32G0_SRC))
$(call cortex,nrf51,$(CORTEX_M0),0x00000000 256K 0x20000000 16K,$(NRF51),$(NRF51_PORT))
$(call cortex,mps2-an385,$(CORTEX_M3),0x00000000 4M 0x20000000 4M,$(MPS2),$(MPS2_PORT))
$(call cortex,mps2-an386,$(CORTEX_M4F),0x00000000 4M 0x20000000 4M,$(MPS2),$(MPS2_PORT))
$(call cortex,mps2-an500,$(CORTEX_M7),0x00000000 4M 0x20000000 4M,$(MPS2),$(MPS2_PORT))
$(call cortex,mps2-an505,$(CORTEX_M33),0x10000000 4M 0x38000000 4M,$(MPS2_33),$(MPS2_PORT))

# --- the RP2040 and the RP2350: their program lies in a file of blocks ----------------------------
RP2040 = -DCORTEX_IRQS=26 -DCORTEX_LINE_IRQ=20 -DCORTEX_STREAM_IRQ=11 -DSTREAM_LAG=5
RP2040_SRC = $(strip ports/rp2040/boot.S ports/rp2040/port.c ports/cortex-m/stream.c \
    $(NO_OUTPUTS))
RP2040_AT  = 0x10000000 2M 0x20000000 256K
RP2040_LD  = ports/rp2040/rp2040.ld.in
$(call cortex,rp2040,$(CORTEX_M0P),$(RP2040_AT),$(RP2040) -DLOFT_SLOTS=250,$(strip \
    $(RP2040_SRC)),$(RP2040_LD))
$(call cortex,rp2040-fast,$(CORTEX_M0P),$(RP2040_AT),$(RP2040) -DLOFT_SLOTS=1000,$(strip \
    $(RP2040_SRC)),$(RP2040_LD))
RP2350 = -DCORTEX_IRQS=52 -DCORTEX_LINE_IRQ=33 -DCORTEX_STREAM_IRQ=10 -DSTREAM_LAG=5 -DRP2350
RP2350_AT = 0x10000000 4M 0x20000000 512K
$(call cortex,rp2350,$(CORTEX_M33),$(RP2350_AT),$(RP2350) -DLOFT_SLOTS=250,$(strip \
    $(RP2040_SRC)),$(RP2040_LD))
$(call cortex,rp2350-fast,$(CORTEX_M33),$(RP2350_AT),$(RP2350) -DLOFT_SLOTS=1000,$(strip \
    $(RP2040_SRC)),$(RP2040_LD))
build/firmware/%/loft.uf2: build/firmware/%/loft.elf ports/rp2040/image.py
	$(SAY) "  UF2 $@"
	$(Q)arm-none-eabi-objcopy -O binary $< $(@:.uf2=.bin)
	$(Q)python3 ports/rp2040/image.py $(*:-fast=) $(@:.uf2=.bin) $@
PICO := rp2040 rp2040-fast rp2350 rp2350-fast
$(PICO:%=firmware-%): firmware-%: build/firmware/%/loft.uf2

## Write it to a Raspberry Pi Pico, or Pico 2, plugged in with BOOTSEL held   RP2040_DRIVE=
RP2040_DRIVE ?= /media/$(USER)/RPI-RP2
RP2350_DRIVE ?= /media/$(USER)/RP2350
.PHONY: $(PICO:%=flash-%)
$(filter flash-rp2040%,$(PICO:%=flash-%)): DRIVE = RP2040_DRIVE
$(filter flash-rp2350%,$(PICO:%=flash-%)): DRIVE = RP2350_DRIVE
$(PICO:%=flash-%): flash-%: firmware-%
	@test -d "$($(DRIVE))" || { echo "$($(DRIVE)) is not there: plug the board in with" \
	    "BOOTSEL held, and name its drive: $(DRIVE)=/path"; exit 1; }
	cp build/firmware/$*/loft.uf2 "$($(DRIVE))"

# --- flashing: the usual tool, or a clear word when it is missing ---------------------------------
flash_tool = @command -v $(1) >/dev/null || { echo "$(1) is missing: apt install $(2)"; exit 1; }

# to a board with an ST-Link, BOOT0 low
.PHONY: $(patsubst %,flash-%,stm32f405 stm32f405-fast stm32f103 stm32f103-fast \
                                        stm32g0 stm32g0-fast)
$(patsubst %,flash-%,stm32f405 stm32f405-fast stm32f103 stm32f103-fast stm32g0 stm32g0-fast): \
        flash-%: firmware-%
	$(call flash_tool,st-flash,stlink-tools)
	arm-none-eabi-objcopy -O binary build/firmware/$*/loft.elf build/firmware/$*/loft.bin
	st-flash --reset write build/firmware/$*/loft.bin 0x08000000

## Write it to a micro:bit (version 1) through its own debugger
.PHONY: flash-nrf51
flash-nrf51: firmware-nrf51
	$(call flash_tool,openocd,openocd)
	openocd -f interface/cmsis-dap.cfg -f target/nrf51.cfg \
	    -c "program build/firmware/nrf51/loft.elf verify reset exit"
