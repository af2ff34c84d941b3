# SPDX-License-Identifier: Apache-2.0
# PipeGS. `make run` and `make test` do all their set-up on a fresh Debian 12 machine; nothing is done twice.

BUILD ?= build
DESIGN ?= fast
PACKAGES := verilator yosys clang ccache ninja-build cmake libopenexr-dev libglm-dev libpng-dev zlib1g-dev \
            libwebp-dev libzstd-dev libminizip-dev libjpeg62-turbo-dev pkg-config libcli11-dev nlohmann-json3-dev \
            libfmt-dev libgtest-dev libeigen3-dev libnanoflann-dev libstb-dev libclang-rt-14-dev
STYLE := clang-format black shellcheck codespell
GATES := opensta qflow-tech-osu018
SITE := mkdocs mkdocs-material
TESTED := $(STYLE) $(GATES) $(SITE) python3-numpy python3-pil curl iverilog parallel
PAGES := chromium fonts-dejavu-core
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)
CTEST := ctest --test-dir $(BUILD) --output-on-failure -j 2

.PHONY: help tools build core run page test test-long fuzz bench figures site lint prove synth fpga \
        format style lacks layout package wave clean

help:  ## this list
	@sed -n 's/^\([a-z-]*\):.*##/  make \1:/p' $(MAKEFILE_LIST)

INSTALL = missing=""; \
	for p in $(1); do dpkg -s $$p 2>/dev/null | grep -q '^Status: install ok' || missing="$$missing $$p"; done; \
	if [ -n "$$missing" ]; then echo "installing:$$missing"; $(SUDO) apt-get update -qq && \
	DEBIAN_FRONTEND=noninteractive $(SUDO) apt-get install -y -qq --no-install-recommends $$missing >/dev/null; fi

# npm may have come from elsewhere than Debian, whose package would not go beside it.
NODE = command -v npm >/dev/null || { $(call INSTALL,nodejs npm); }

tools:  ## install what is missing (apt)
	@$(call INSTALL,$(PACKAGES))

$(BUILD)/build.ninja: | tools
	CC=clang CXX=clang++ cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null

build: tools $(BUILD)/build.ninja  ## compile everything, studies and the default RTL included
	cmake --build $(BUILD) --target programs rtl

core: tools $(BUILD)/build.ninja  ## compile what `make run` runs: everything but the studies
	cmake --build $(BUILD) --target pipegs rtl

run: core  ## simulate our own scene; prints where every cycle went and where the picture is
	$(BUILD)/pipegs sim --out $(BUILD)/out

page: core  ## our own frame as a page to click through: build/out/page.html
	@$(NODE)
	$(BUILD)/pipegs sim --out $(BUILD)/out --page

test: build  ## every test but the long ones
	@$(call INSTALL,$(TESTED) $(PAGES))
	@$(NODE)
	cmake --build $(BUILD)
	$(CTEST) -LE long; code=$$?; [ ! -t 2 ] || verif/self/skipped.sh $(BUILD); exit $$code

test-long: build  ## the long tests too, those of the netlists among them
	@$(call INSTALL,$(TESTED) $(PAGES))
	@$(NODE)
	cmake --build $(BUILD)
	$(CTEST); code=$$?; [ ! -t 2 ] || verif/self/skipped.sh $(BUILD); exit $$code

fuzz: tools $(BUILD)/build.ninja  ## the readers under libFuzzer, eight targets of SECONDS / 8 each (60 s without it)
	cmake --build $(BUILD) --target fuzz
	verif/fuzz/fuzz.sh $(BUILD)/verif/fuzz $$((($(if $(SECONDS),$(SECONDS),60) + 8) / 9))

bench: core  ## speed of golden model and RTL on our own scene, apart from the tests
	$(BUILD)/pipegs sim --no-truth --out $(BUILD)/bench --json | grep -A 5 wall_seconds

figures: build  ## measure what is cheap or older than the sources, fill pages: CLASS=a,b PAGE=ladder ONLY='bus/*' ALL=1
	BUILD=$(BUILD) python3 -B docs/figures $(if $(CLASS),--classes $(CLASS)) $(if $(PAGE),--page $(PAGE)) \
	  $(if $(ONLY),--only '$(ONLY)') $(if $(ALL),--all)

site:  ## the pages as a site with search: build/site/html; `python3 -m http.server -d build/site/html` shows it
	@$(call INSTALL,$(SITE))
	@docs/site.py $(BUILD)/site

lint: tools build  ## each RTL module alone through Verilator's lint and Yosys
	BUILD=$(BUILD) synth/lint.sh

prove: tools $(BUILD)/build.ninja  ## formal proofs, and mutants of the RTL that they must refute
	cmake --build $(BUILD) --target package_sv
	BUILD=$(BUILD) synth/prove.sh

synth: tools $(BUILD)/build.ninja  ## area and longest paths of every module; DESIGN=, SET="key=value", LIBERTY=, JOBS=
	@$(call INSTALL,$(GATES))
	@cmake --build $(BUILD) --target package_sv >/dev/null
	@synth/synth.py --build $(BUILD) --design $(DESIGN) --set "$(SET)" \
	  $(if $(LIBERTY),--liberty $(LIBERTY)) $(if $(JOBS),--jobs $(JOBS))

fpga: tools $(BUILD)/build.ninja  ## what it takes of an FPGA by unit; DESIGN=, UNITS=1,2,4, FAMILIES=, SET=, JOBS=
	@cmake --build $(BUILD) --target package_sv >/dev/null
	@synth/fpga/fpga.py --build $(BUILD) --design $(DESIGN) --set "$(SET)" $(if $(UNITS),--units $(UNITS)) \
	  $(if $(FAMILIES),--families $(FAMILIES)) $(if $(JOBS),--jobs $(JOBS))

format:  ## apply the formats of C++ and Python
	@$(call INSTALL,$(STYLE))
	clang-format -i $$(git ls-files '*.cpp' '*.hpp')
	black -q $$(git ls-files '*.py')

style:  ## columns, formats, links, spelling, layers
	verif/self/style.sh

lacks:  ## what belongs to a module and what a change to it lacks: MODULE=pu_conic, SINCE=main
	verif/self/lacks.sh $(MODULE) $(SINCE)

layout:  ## what a module lacks of model, test and page
	verif/self/layout.sh

package: tools $(BUILD)/build.ninja  ## print what follows from the tables of cpp_model: pipegs_pkg.sv, package/ ...
	cmake --build $(BUILD) --target package_sv registers_print
	python3 -B verif/self/package_test.py --write $(BUILD)

wave: build  ## waves of one window of our own scene: build/wave/waves.fst
	$(BUILD)/pipegs sim --no-truth --window 4,3 --out $(BUILD)/wave --waves

clean:  ## remove the build folder
	rm -rf $(BUILD)
