# host-tools/page/page.mk -- the page: a static folder with the library as WebAssembly
# SPDX-License-Identifier: MIT
PAGE_SRC = $(wildcard host-tools/page/*.html host-tools/page/*.css host-tools/page/*.js) \
           ports/wasm/loft.mjs
PAGE_USES = bezier_init bezier_eval bezier_deriv bezier_split bezier_elevate bezier_curvature_vec \
            forward_init forward_next flatten_init flatten_next cubic_shape cubic_line \
            plan_init plan_push plan_end plan_next \
            tensor_init surface_from_tensor gb_init gb_count gb_from_boundary domain_init \
            disk_from_gb surface_from_disk level_light level_at contour_init contour_init_level \
            contour_next
PAGE_SITE = build/site

# what the page calls, in one number type
$(PAGE_SITE)/loft-%.wasm: $(WASM_SRC) $(LIB_HDR) host-tools/page/page.mk | lib/names.h
	@mkdir -p $(@D)
	$(SAY) "  LD  $@"
	$(Q)clang --target=wasm32 -std=c99 -O2 -ffreestanding -nostdlib -ffunction-sections \
	    -fdata-sections $(CPPFLAGS) $(INCLUDE) $(call num_flag,$*) -Wl,--no-entry \
	    -Wl,--gc-sections -Wl,--strip-all -Wl,--export=__heap_base -Wl,--export=loft_layout \
	    -Wl,--export=loft_wachspress \
	    -Wl,-z,stack-size=65536 $(PAGE_USES:%=-Wl,--export=loft_%_$*x3) \
	    $(WASM_SRC) -o $@

## Build the page in build/site: static files, and `make tools` puts them into loft serve
.PHONY: page
page: $(PAGE_SITE)/loft-q16.wasm
	@cp $(PAGE_SRC) $(PAGE_SITE) && touch $(PAGE_SITE).built
	@echo "$(PAGE_SITE): $$(du -bsh $(PAGE_SITE) | cut -f1); python3 -m http.server -d $(PAGE_SITE)"

# the browser that tests it, and what drives it
PAGE_DRIVER = build/page/node_modules/playwright-core/index.js
$(PAGE_DRIVER):
	@mkdir -p build/page && cd build/page && \
	    PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm install --silent --no-save playwright-core

## Install what `make page check-page` need: clang, lld, node, Chromium
.PHONY: deps-page
deps-page:
	@sh tests/house/deps.sh clang lld $(if $(shell command -v node),,nodejs) \
	    $(if $(shell command -v npm),,npm) chromium

## Check the page in Chromium, beside the command and its machine; build/page has pictures
.PHONY: check-page
check-page: page tools $(PAGE_DRIVER)
	@node tests/page/check_page.mjs build/loft $(PAGE_DRIVER) "$$(command -v chromium)" build/page
	@node tests/page/check_serve.mjs build/loft $(PAGE_DRIVER) "$$(command -v chromium)" \
	    build/page build/site
