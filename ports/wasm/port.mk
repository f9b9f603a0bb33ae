# ports/wasm/port.mk -- the library for WebAssembly: clang and wasm-ld, no libc, no imports
# SPDX-License-Identifier: MIT
WASM_FLAGS = --target=wasm32 -std=c99 -O2 -ffreestanding -nostdlib $(CPPFLAGS) -Wl,--no-entry \
             -Wl,--export-dynamic -Wl,--export=__heap_base -Wl,-z,stack-size=65536 \
             -fvisibility=default
# both libraries in one module
WASM_SRC   = $(LIB_SRC) ports/bare/memory.c ports/wasm/layout.c
build/wasm/loft-%.wasm: $(WASM_SRC) $(LIB_HDR) | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)clang $(WASM_FLAGS) $(INCLUDE) $(call num_flag,$*) $(WASM_SRC) -o $@

## Build build/wasm/loft-q16.wasm, f32, f64 and loft.mjs for browsers and node
.PHONY: wasm
wasm: $(NUMS:%=build/wasm/loft-%.wasm)
	@cp ports/wasm/loft.mjs build/wasm
