# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian/Ubuntu machine to a flown mission or a tested build: see `make help`.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help

PYTHON ?= python3
JOBS ?= $(shell nproc)
# Warnings stop the build; for CI.
WERROR ?= OFF

VENV := .venv
BIN := $(VENV)/bin
LTP_BENCH := build/bench/tests/bench/ltp_bench
STAMPS := build/stamps
# A file's tests stay together: they share what they have set up.
PARALLEL := -n $(JOBS) --dist loadfile
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet --quiet

# ccache, where there is one, compiles the core once for the package, the tests and the benchmarks;
# all must call the compiler by the same name.
export CMAKE_CXX_COMPILER_LAUNCHER = $(shell command -v ccache)
export CXX
# What one clone has compiled serves another.
export CCACHE_BASEDIR ?= $(CURDIR)
export CCACHE_NOHASHDIR ?= 1
export CMAKE_BUILD_PARALLEL_LEVEL = $(JOBS)
# The tests are to see the installed package, and no other.
unexport PYTHONPATH

BUILD_FILES := pyproject.toml CMakeLists.txt README.md LICENSE
SOURCES := $(BUILD_FILES) $(shell find cpp python -type f \
  \( -name '*.[ch]pp' -o -name '*.in' -o -name '*.py' -o -name '*.pyi' -o -name py.typed \))
CPP_FILES := $(shell find cpp examples tests -name '*.[ch]pp')
# Changes with the list of sources, so that a file that is gone counts as a change too.
WHEEL := $(STAMPS)/wheel-$(WERROR)-$(shell printf '%s\n' $(sort $(SOURCES)) | cksum | cut -d' ' -f1)

.PHONY: help
help:  ## say what there is to make
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-11s %s\n", $$1, $$2 }' Makefile

.PHONY: demo
demo: $(STAMPS)/viewer  ## fly the built-in city, into out/demo
	@# A demo that was stopped goes on, but not with the flights of another build.
	@[ out/demo/journal.jsonl -nt $(STAMPS)/package ] || rm -rf out/demo
	$(BIN)/ltp demo --out out/demo

.PHONY: test
test: $(STAMPS)/test build-tests  ## run the C++ tests and the Python tests
	ctest --test-dir build/tests -j $(JOBS) --output-on-failure
	$(BIN)/python -m pytest $(PARALLEL)

# Asked for once, so that what is printed is what is used.
ifndef SEED
SEED := $(shell od -An -N4 -tu4 /dev/urandom | tr -d ' ')
endif

.PHONY: test-random
test-random: $(STAMPS)/test  ## run the Python tests on examples that nobody has seen
	@echo "ltp: make test-random SEED=$(SEED) repeats this run"
	$(BIN)/python -m pytest --hypothesis-profile=random --hypothesis-seed=$(SEED) $(PARALLEL)

# Without the viewer: rerun needs NumPy 2, which is not the lowest.
LOWEST := build/lowest

.PHONY: test-lowest
test-lowest: $(WHEEL)  ## run the Python tests with the lowest versions of all dependencies
	@echo "ltp: setting up $(LOWEST)"
	@rm -rf $(LOWEST)
	@"$$(cat $(STAMPS)/system)" -m venv $(LOWEST)
	@$(BIN)/python .ci/lowest.py geo test > build/lowest.txt
	@$(LOWEST)/bin/python -m pip --disable-pip-version-check --quiet --quiet \
	  install --requirement build/lowest.txt dist/*.whl
	$(LOWEST)/bin/python -m pytest $(PARALLEL)

.PHONY: lint
lint: $(STAMPS)/dev  ## check layout, style and types
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	@echo "$(BIN)/clang-format --dry-run -Werror ($(words $(CPP_FILES)) files)"
	@$(BIN)/clang-format --dry-run -Werror $(CPP_FILES)

.PHONY: format
format: $(STAMPS)/dev  ## lay out all sources
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .
	$(BIN)/clang-format -i $(CPP_FILES)

.PHONY: bench
bench: $(STAMPS)/bench build-bench  ## measure ltp beside its peers, write docs/performance.md's tables
	$(LTP_BENCH) --benchmark_repetitions=3 --benchmark_report_aggregates_only=true \
	  --benchmark_out=build/bench/cpp.json --benchmark_out_format=json $(BENCH_ARGS)
	$(BIN)/python -m tests.bench.peers --out build/bench/python.json
	$(BIN)/python -m tests.bench.scale --out build/bench/scale.json \
	  --figure docs/figures/performance_scale.png
	$(BIN)/python -m tests.bench.latency --out build/bench/latency.json
	$(BIN)/python -m tests.bench.report

.PHONY: bench-cpp
bench-cpp: build-bench  ## run the C++ benchmarks only (BENCH_ARGS=--benchmark_filter=...)
	$(LTP_BENCH) $(BENCH_ARGS)

.PHONY: wheel
wheel: $(WHEEL)  ## build dist/ltp_uav-*.whl and check what is in it
	$(BIN)/python .ci/check_wheel.py dist/*.whl

.PHONY: stub
stub: $(STAMPS)/test  ## write python/ltp/_core.pyi anew from the compiled module
	$(BIN)/python .ci/make_stub.py python/ltp/_core.pyi

.PHONY: docs
docs: $(STAMPS)/docs  ## build docs/ and the API reference into build/docs/html
	$(BIN)/python -m sphinx -q -W --keep-going -d build/docs/doctrees docs build/docs/html

# The C++ tests that run under sanitizers, by the names of their files; none named: all of them.
SANITIZE_THREADS = concurrent_trajectory_planner local_trajectory_planner obstacle_memory
SANITIZE_MEMORY = carving inflation lidar obstacle_map obstacle_map_file occupancy_grid \
  octree_file octree_surface planner_contract raster ray_marker scenes

.PHONY: sanitize
sanitize: $(STAMPS)/system  ## run C++ tests of threads under TSan, of memory under ASan and UBSan
	@for preset in tsan asan; do \
	  tests='$(SANITIZE_THREADS)'; [ $$preset = tsan ] || tests='$(SANITIZE_MEMORY)'; \
	  echo "ltp: building the C++ tests for $$preset"; \
	  cmake --preset $$preset "-DLTP_TESTS=$$tests" --log-level=WARNING > /dev/null; \
	  cmake --build --preset $$preset; \
	  ctest --preset $$preset -E '^examples' -j $(JOBS); \
	done

FUZZ_SECONDS ?= 60

.PHONY: fuzz
fuzz: $(STAMPS)/fuzz  ## run each fuzzer for FUZZ_SECONDS (60)
	@echo "ltp: building the fuzzers"
	@cmake -S tests/fuzz -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ \
	  --log-level=WARNING > /dev/null
	@cmake --build build/fuzz
	@for fuzzer in build/fuzz/*_fuzz; do \
	  echo "$$fuzzer, $(FUZZ_SECONDS) s"; \
	  mkdir -p "$$fuzzer-corpus"; \
	  "$$fuzzer" -max_total_time=$(FUZZ_SECONDS) -verbosity=0 -print_final_stats=1 -print_funcs=0 \
	    -artifact_prefix=build/fuzz/ "$$fuzzer-corpus"; \
	done

.PHONY: clean
clean:  ## remove all that was made, but the virtual environment and out/
	rm -rf build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis

# ---- set-up: each stamp stands for a step done, and is as old as that step ----------------------

$(STAMPS)/system: .ci/system-packages
	@mkdir -p $(STAMPS)
	@PYTHON="$(PYTHON)" .ci/system-packages > $@

# What pyproject.toml needs to build the package: without pip's isolation, which would start the
# build from scratch each time.
$(VENV)/ready: $(STAMPS)/system pyproject.toml
	@echo "ltp: setting up $(VENV)"
	@[ -x $(BIN)/python ] || "$$(cat $(STAMPS)/system)" -m venv $(VENV)
	@$(BIN)/python -c "import tomllib; build = tomllib.load(open('pyproject.toml', 'rb')); \
	  print('\n'.join(build['build-system']['requires']))" > $(STAMPS)/requirements.txt
	@$(PIP) install --requirement $(STAMPS)/requirements.txt
	@touch $@

$(WHEEL): $(VENV)/ready $(SOURCES)
	@echo "ltp: building the package (the first time takes some minutes)"
	@rm -rf dist $(STAMPS)/wheel-*
	@$(PIP) wheel . --no-build-isolation --no-deps --wheel-dir dist \
	  --config-settings=build-dir=build/python \
	  --config-settings=cmake.define.LTP_WARNINGS_AS_ERRORS=$(WERROR)
	@touch $@

# The package, then the extras that one wants of it. pip leaves an installed package of the same
# version alone, hence the force.
$(STAMPS)/package: $(WHEEL)
	@echo "ltp: installing the package into $(VENV)"
	@# Its name until 0.2.0; both would own the same files.
	@$(PIP) uninstall --yes ltp
	@$(PIP) install dist/*.whl
	@$(PIP) install --force-reinstall --no-deps dist/*.whl
	@touch $@

$(STAMPS)/viewer: EXTRAS := viewer
$(STAMPS)/test: EXTRAS := viewer,geo,test
$(STAMPS)/dev: EXTRAS := viewer,geo,test,dev
$(STAMPS)/docs: EXTRAS := docs
$(STAMPS)/viewer $(STAMPS)/test $(STAMPS)/dev $(STAMPS)/docs: $(STAMPS)/package
	@echo "ltp: installing what ltp-uav[$(EXTRAS)] needs into $(VENV)"
	@$(PIP) install "$$(echo dist/*.whl)[$(EXTRAS)]"
	@touch $@

# Doxygen reads the comments of the C++ headers.
$(STAMPS)/docs-system: .ci/system-packages
	@mkdir -p $(STAMPS)
	@PYTHON="$(PYTHON)" .ci/system-packages doxygen > $@

$(STAMPS)/docs: $(STAMPS)/docs-system

# Fuzzing needs Clang and its run-time library, whatever compiles the rest.
$(STAMPS)/fuzz: .ci/system-packages
	@mkdir -p $(STAMPS)
	@PYTHON="$(PYTHON)" .ci/system-packages clang libclang-rt-dev > $@

# Debian's packages of peers and of what theirs from PyPI need, then those from PyPI: each on its own,
# so that one that cannot be had here stops no other.
$(STAMPS)/bench-system: .ci/system-packages
	@mkdir -p $(STAMPS)
	@PYTHON="$(PYTHON)" .ci/system-packages \
	  libembree-dev libopenvdb-dev libboost-dev libusb-1.0-0 patchelf > $@

$(STAMPS)/bench: $(STAMPS)/package $(STAMPS)/bench-system
	@echo "ltp: installing the peers into $(VENV)"
	@$(BIN)/python -c "import tomllib; project = tomllib.load(open('pyproject.toml', 'rb')); \
	  print('\n'.join(project['project']['optional-dependencies']['bench']))" | \
	  while read -r peer; do \
	    $(PIP) install "$$peer" || echo "ltp: going on without $$peer" >&2; \
	  done
	@touch $@

.PHONY: build-bench
build-bench: $(STAMPS)/system
	@echo "ltp: building the C++ benchmarks"
	@cmake -S . -B build/bench -G Ninja -DCMAKE_BUILD_TYPE=Release -DLTP_BUILD_BENCHMARKS=ON \
	  -DLTP_WARNINGS_AS_ERRORS=$(WERROR) --log-level=WARNING > /dev/null
	@cmake --build build/bench

.PHONY: build-tests
build-tests: $(STAMPS)/system
	@echo "ltp: building the C++ tests"
	@# Optimised as users get it, but no index goes astray unseen.
	@cmake -S . -B build/tests -G Ninja -DCMAKE_BUILD_TYPE=Release -DLTP_BUILD_TESTS=ON \
	  -DCMAKE_CXX_FLAGS=-D_GLIBCXX_ASSERTIONS -DLTP_WARNINGS_AS_ERRORS=$(WERROR) \
	  --log-level=WARNING > /dev/null
	@cmake --build build/tests
