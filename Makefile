# make demo    build, start the service, match a pair over HTTP, show the result
#              SOURCE=a.nii.gz TARGET=b.nii.gz: your own pair; KEEP=1: leave the service running
# make test    every test that this machine can run, those of faults in a short form; it says which were skipped, and why;
#              HOMOLOG_REAL_DATA=dir: the real data that some need
# make faults  the service while things break, in full length, half an hour; TEST=a06: one of its points
# make check   format, lints, documentation, unused dependencies
# make contract  a running service held against its OpenAPI document by schemathesis
# make build   target/release/homolog
# make api     writes the generated files under api/ anew
# make experiment  measure every method and write a report, with the newest accuracy table; DATA=dir: real label volumes
#              below dir/hippocampus
# make accuracy  the accuracy table beside the peers; DATA=dir: label volumes below dir/hippocampus; EVAL=dir: the folder
#              of real_cases.py; CASES=10: pairs a set; OURS_ONLY=1: without peers
# make bench   benchmarks of a match
# make bench-service  benchmarks of the service; PART=poll: one of its parts

SHELL := /usr/bin/env bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.PHONY: help demo test faults check contract build api experiment accuracy bench bench-service

CARGO ?= cargo
SOURCE ?=
TARGET ?=
KEEP ?=
TEST ?=
DATA ?= data
EXAMPLES ?= 50
PART ?=
DEMO_OUT ?= target/demo
EVAL ?= eval
CASES ?=
OURS_ONLY ?=
# The newest table.
ACCURACY ?= $(lastword $(sort $(wildcard docs/accuracy/*)))

help:
	@sed -n 's/^# //p' Makefile

build:
	@scripts/setup build
	$(CARGO) build --release --locked

demo: build
	target/release/homolog demo --out "$(DEMO_OUT)" $(if $(filter-out 0,$(KEEP)),--keep) \
	  $(if $(SOURCE),"$(SOURCE)") $(if $(TARGET),"$(TARGET)")

test:
	@scripts/setup test
	@CARGO="$(CARGO)" scripts/test

faults:
	@scripts/setup test
	@CARGO="$(CARGO)" scripts/test faults "$(TEST)"

check:
	@scripts/setup check
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --locked --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --locked --no-deps --document-private-items
	target/tools/bin/cargo-machete

contract:
	@scripts/setup test
	$(CARGO) build --locked
	scripts/check-contract $(EXAMPLES)

api:
	@scripts/setup build
	mkdir -p api
	$(CARGO) run --quiet --locked -- openapi > api/openapi.json.tmp
	$(CARGO) run --quiet --locked -- problems > api/problems.md.tmp
	mv api/openapi.json.tmp api/openapi.json
	mv api/problems.md.tmp api/problems.md

experiment: build
	target/release/homolog experiment --data "$(DATA)" --out target/experiment $(if $(ACCURACY),--accuracy "$(ACCURACY)")

# The program that is measured has learned nothing from the subjects of the pairs. The last build puts the other one back.
accuracy: build
	$(CARGO) build --release --locked --features left-out
	mkdir -p target/left-out && cp target/release/homolog target/left-out/homolog
	$(CARGO) build --release --locked
	benches/accuracy/run --binary target/left-out/homolog --data "$(DATA)" --eval "$(EVAL)" $(if $(CASES),--cases "$(CASES)") \
	  $(if $(filter-out 0,$(OURS_ONLY)),--ours-only)

bench:
	@scripts/setup build
	mkdir -p benches/records
	$(CARGO) bench --locked -p homolog-laboratory --bench matching -- | tee target/bench.md
	$(CARGO) bench --locked -p homolog-laboratory --bench kernel -- | tee -a target/bench.md
	record="benches/records/$$(date -u +%Y-%m-%d)-$$(git rev-parse --short HEAD 2>/dev/null || echo unknown).md"; \
	  { echo "# Benchmarks, $$(date -u +%Y-%m-%d); command: make bench"; echo; cat target/bench.md; } > "$$record"; \
	  echo "record: $$record"

# The peer is built apart, since nothing of it is a dependency; where it cannot be, its row says so.
bench-service:
	@scripts/setup test
	mkdir -p benches/records
	$(CARGO) build --release --locked --manifest-path benches/peers/graphile/Cargo.toml --target-dir target/peer || true
	@peer="$$PWD/target/peer/release/graphile-peer"; if [ -x "$$peer" ]; then export HOMOLOG_BENCH_PEER="$$peer"; fi; \
	  set -x; $(CARGO) bench --locked --bench service -- $(PART) | tee target/bench-service.md
	record="benches/records/$$(date -u +%Y-%m-%d)-$$(git rev-parse --short HEAD 2>/dev/null || echo unknown)-service.md"; \
	  { echo "# Benchmarks of the service, $$(date -u +%Y-%m-%d); command: make bench-service"; echo; cat target/bench-service.md; } > "$$record"; \
	  echo "record: $$record"
