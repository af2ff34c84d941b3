# PipeGS. `make run` and `make test` do all their set-up on a fresh Debian 12 machine; nothing is done twice.

BUILD ?= build
PACKAGES := verilator yosys clang ccache ninja-build cmake libopenexr-dev libglm-dev libpng-dev zlib1g-dev libcli11-dev \
            nlohmann-json3-dev libfmt-dev libgtest-dev
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)
CTEST := ctest --test-dir $(BUILD) --output-on-failure -j 2

.PHONY: help tools build run test test-long bench lint prove synth rooms package wave clean

help:  ## this list
	@sed -n 's/^\([a-z-]*\):.*##/  make \1:/p' $(MAKEFILE_LIST)

INSTALL = missing=""; for p in $(1); do dpkg -s $$p 2>/dev/null | grep -q '^Status: install ok' || missing="$$missing $$p"; done; \
	if [ -n "$$missing" ]; then echo "installing:$$missing"; \
	$(SUDO) apt-get update -qq && DEBIAN_FRONTEND=noninteractive $(SUDO) apt-get install -y -qq --no-install-recommends $$missing >/dev/null; fi

tools:  ## install what is missing (apt)
	@$(call INSTALL,$(PACKAGES))

$(BUILD)/build.ninja: | tools
	CC=clang CXX=clang++ cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null

build: tools $(BUILD)/build.ninja  ## compile everything, the default RTL included
	cmake --build $(BUILD) --target pipegs rtl

run: build  ## simulate our own scene; prints where every cycle went and where the picture is
	$(BUILD)/pipegs sim --out $(BUILD)/out

test: build  ## every test but the long ones
	cmake --build $(BUILD)
	$(CTEST) -LE long

test-long: build  ## the long tests too, those of the netlists among them
	@$(call INSTALL,opensta qflow-tech-osu018)
	cmake --build $(BUILD)
	$(CTEST)

bench: build  ## speed of golden model and RTL on our own scene, apart from the tests
	$(BUILD)/pipegs sim --no-truth --out $(BUILD)/bench --json | grep -A 5 wall_seconds

lint: tools build  ## each RTL module alone through Verilator's lint and Yosys
	BUILD=$(BUILD) synth/lint.sh

prove: tools $(BUILD)/build.ninja  ## formal proofs, and changed copies of the RTL that they must refute
	cmake --build $(BUILD) --target package_sv
	BUILD=$(BUILD) synth/prove.sh

synth: tools $(BUILD)/build.ninja  ## gates of a library: area and longest paths of every module; RUNG=, SET="key=value ...", LIBERTY=, JOBS=
	@$(call INSTALL,opensta qflow-tech-osu018)
	@cmake --build $(BUILD) --target package_sv >/dev/null
	@synth/synth.py --build $(BUILD) $(if $(RUNG),--rung $(RUNG)) --set "$(SET)" $(if $(LIBERTY),--liberty $(LIBERTY)) $(if $(JOBS),--jobs $(JOBS))

rooms:  ## what lacks its rhyme: module, twin, test, heading
	verif/self/rooms.sh

package: build  ## print rtl/pipegs_pkg.sv from cpp_model/config.def and records.def
	$(BUILD)/cpp_model/package_sv > rtl/pipegs_pkg.sv.new && mv rtl/pipegs_pkg.sv.new rtl/pipegs_pkg.sv

wave: build  ## waves of one window of our own scene: build/window.fst
	$(BUILD)/pipegs sim --no-truth --window 8,6 --out $(BUILD)/wave --waves $(BUILD)/window.fst

clean:  ## remove the build folder
	rm -rf $(BUILD)
