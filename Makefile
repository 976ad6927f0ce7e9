# Front door. The build itself is CMake: see CMakePresets.json.
JOBS ?= $(shell nproc)
DEMO ?= parts/bracket
DEMO_OUT ?= out/$(notdir $(DEMO))
BENCH ?=
MINUTES ?= 5
SEED ?= 1
PROVEOUT := build/release/bin/proveout

.PHONY: help deps program build demo test soak study bench asan tsan clean

help:
	@echo 'make demo   install what is missing, build, run $(DEMO) and say where the results are'
	@echo 'make test   the same build, then the whole test suite'
	@echo 'make soak   random whole jobs against the laws of tests/soak, then some of a wire; MINUTES=$(MINUTES) each, SEED=$(SEED)'
	@echo 'make study  all planted defects of tests/study (make test plants a tenth of them): a quarter of an hour'
	@echo 'make program build the program alone: $(PROVEOUT)'
	@echo 'make build  build everything, the tests among it'
	@echo 'make bench  build and run the benchmarks; BENCH=--all runs the heavy cases as well'
	@echo 'make asan   the test suite under the address and undefined-behaviour sanitizers'
	@echo 'make tsan   the test suite under the thread sanitizer'
	@echo 'make clean  remove build/ and out/'

deps:
	@.ci/install-deps

program: deps
	cmake --preset release
	cmake --build --preset release --target proveout -j $(JOBS)

build: deps
	cmake --preset release
	cmake --build --preset release -j $(JOBS)

demo: program
	@test -f $(DEMO)/job.toml || { echo 'no job file $(DEMO)/job.toml' >&2; exit 2; }
	@mkdir -p $(DEMO_OUT)
	@status=0; $(PROVEOUT) run $(DEMO)/job.toml --out $(DEMO_OUT) || status=$$?; \
	if [ $$status -gt 1 ]; then exit $$status; fi; \
	echo; echo 'Results in $(DEMO_OUT):'; ls -1 $(DEMO_OUT) | sed 's/^/  /'; \
	echo 'Start with $(DEMO_OUT)/report.html'

test: build
	ctest --preset release -j $(JOBS) --output-on-failure

soak: build
	build/release/bin/soak --minutes $(MINUTES) --seed $(SEED)
	build/release/bin/soak --minutes $(MINUTES) --seed $(SEED) --wire

study: build
	PROVEOUT_STUDY_WHOLE=1 build/release/bin/planted_defects

bench: build
	build/release/bin/bench_programs $(BENCH)
	build/release/bin/bench_sweeps
	build/release/bin/bench_prediction

asan tsan: deps
	cmake --preset $@
	cmake --build --preset $@ -j $(JOBS)
	ctest --preset $@ -j $(JOBS) --output-on-failure

clean:
	rm -rf build out
