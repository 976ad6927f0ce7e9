# Front door. The build itself is CMake: see CMakePresets.json.
JOBS ?= $(shell nproc)
DEMO ?= parts/bracket
DEMO_OUT ?= out/$(notdir $(DEMO))
BENCH ?=
BASE ?=
MINUTES ?= 5
COUNT ?= 200
SEED ?= 1
PROVEOUT := build/release/bin/proveout

.PHONY: help deps step configure program build demo test soak study peer bench asan tsan clean

help:
	@echo 'make demo   install what is missing, build, run $(DEMO) and say where the results are'
	@echo 'make test   build the program and the tests, then run the whole test suite'
	@echo 'make soak   random whole jobs against the laws of tests/soak, some of a wire, and the second soak; MINUTES=$(MINUTES) each, SEED=$(SEED)'
	@echo 'make study  all planted defects of tests/study 100 programs of tests/reference (make test runs some)'
	@echo 'make peer   random programs of LinuxCNC here and in its interpreter, where linuxcnc-uspace is installed; COUNT=$(COUNT), SEED=$(SEED)'
	@echo 'make step   install OpenCASCADE and build the program with what reads STEP files'
	@echo 'make program build the program alone: $(PROVEOUT)'
	@echo 'make build  build everything, with the tests, the benchmarks and the soak'
	@echo 'make bench  build and run the benchmarks; BENCH=--all runs the heavy cases as well; BASE=COMMIT builds that'
	@echo '            commit in build/base and runs each case in turn with it'
	@echo 'make asan   the test suite under the address and undefined-behaviour sanitizers'
	@echo 'make tsan   the test suite under the thread sanitizer'
	@echo 'make clean  remove build/ and out/'

deps:
	@.ci/install-deps

step:
	@.ci/install-deps step-packages.txt
	$(MAKE) program

program: deps
	cmake --preset release
	cmake --build --preset release --target proveout -j $(JOBS)

configure: deps
	cmake --preset release

build: configure
	cmake --build --preset release --target all benches soak -j $(JOBS)

demo: program
	@test -f $(DEMO)/job.toml || { echo 'no job file $(DEMO)/job.toml' >&2; exit 2; }
	@mkdir -p $(DEMO_OUT)
	@status=0; $(PROVEOUT) run $(DEMO)/job.toml --out $(DEMO_OUT) || status=$$?; \
	if [ $$status -gt 1 ]; then exit $$status; fi; \
	echo; echo 'Results in $(DEMO_OUT):'; ls -1 $(DEMO_OUT) | sed 's/^/  /'; \
	echo 'Start with $(DEMO_OUT)/report.html'

test: deps
	@.ci/install-deps step-packages.txt || echo 'OpenCASCADE cannot be installed: the tests of STEP files are left out'
	cmake --preset release
	cmake --build --preset release -j $(JOBS)
	ctest --preset release -j $(JOBS) --output-on-failure

soak: configure
	cmake --build --preset release --target soak -j $(JOBS)
	build/release/bin/soak --minutes $(MINUTES) --seed $(SEED)
	build/release/bin/soak --minutes $(MINUTES) --seed $(SEED) --wire
	build/release/bin/soak --minutes $(MINUTES) --seed $(SEED) --second --keep out/soak

study: configure
	cmake --build --preset release --target planted_defects planted_causes reference_test random_mesh_test -j $(JOBS)
	PROVEOUT_STUDY_WHOLE=1 build/release/bin/planted_defects
	PROVEOUT_STUDY_COUNT=100 build/release/bin/planted_causes
	PROVEOUT_REFERENCE_PROGRAMS=100 PROVEOUT_REFERENCE_FACETS=96 build/release/bin/reference_test
	PROVEOUT_RANDOM_WIRES=40 PROVEOUT_RANDOM_WIRE=110 build/release/bin/random_mesh_test --gtest_filter='*RandomWire*'

peer: configure
	cmake --build --preset release --target peer -j $(JOBS)
	build/release/bin/peer $(COUNT) $(SEED) out/peer

bench: configure
	cmake --build --preset release --target benches -j $(JOBS)
ifeq ($(BASE),)
	build/release/bin/bench_programs $(BENCH)
	build/release/bin/bench_compare
	build/release/bin/bench_sweeps
	build/release/bin/bench_prediction
else
	base=$$(.ci/build-base $(BASE) $(JOBS)) && build/release/bin/bench_programs --times 5 $(BENCH) --against $$base && \
	build/release/bin/bench_compare --times 3 --against $$base
endif

asan tsan: deps
	cmake --preset $@
	cmake --build --preset $@ -j $(JOBS)
	ctest --preset $@ -j $(JOBS) --output-on-failure

clean:
	rm -rf build out
