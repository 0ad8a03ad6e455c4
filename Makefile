# Every day
#   build          target/release/homolog
#   demo           build, start the service, match a pair over HTTP, show the result; SOURCE=a.nii.gz TARGET=b.nii.gz: your own
#                  pair; KEEP=1: leave the service running
#   test           the tests, but for the campaigns below; lists what it skipped and why
#   check          words, packages, formatting, lints
#   audit          documentation of the code, unused dependencies, licenses and sources, the matching library without the
#                  published methods
#   api            regenerate api/ and docs/parameters.md
#   client         target/wheels: the Python package with this machine's program in it
#   dashboard      build the page of the dashboard, dashboard/dist, with node
#
# Campaigns of tests
#   long           tests that measure or attack: predicted memory and prices, every published method, studies, hostile input, PostgreSQL, real
#                  data, examples in documentation: a quarter of an hour; HOMOLOG_REAL_DATA=dir: the folder of real data (data/ unless set)
#   faults         processes killed, databases stopped, disks filled: an hour; SHORT=1: minutes; TEST=a06: the test of that name,
#                  a_killed_: 200 kills of children and 200 of the service
#   contract       a service on each store against its OpenAPI document, with schemathesis; EXAMPLES=50: requests an operation
#   readers        outputs and clients in other programs: Python readers, browsers, generated clients, Orthanc, Prometheus
#   answers        the answers of this build against tests/answers.tsv, to the bit, on 20 real pairs; DATA=dir
#   peers-read     files of other programs read by homolog and by them; writes docs/formats-read.md; ROUNDS=6: mutations a kind
#   fuzz           coverage-guided fuzzing of the readers, or of requests: PART=json, form, headers, query or token; FOR=600:
#                  seconds; WITHIN=10: seconds an input may take (2 unless set); needs a nightly toolchain
#   soak           an hour of mixed load with faults; SECONDS=600: shorter; the record is target/soak.md
#
# Before a release
#   memory         attack the service in a memory group, or measure its memory without one; SECONDS=60; target/memory.md
#   properties     the property tests with new random inputs; RUNS=20: seeds
#   msrv           build with the oldest supported toolchain, which Cargo.toml states; needs rustup
#   public-api     write the public items of the library crates into api/rust; `scripts/public-api check` compares
#   advisories     known vulnerabilities of dependencies; needs the internet
#   sbom           software bill of materials, target/homolog.cdx.json (CycloneDX)
#   screenshots    the pictures in docs/dashboard, by the tests in a browser; TEST=batch: only the test of that name
#   pictures       redraw docs/match.png and the pictures in docs/methods
#
# Measurements of the method (DATA=dir: label volumes in dir/hippocampus; EVAL=dir: the folder of real_cases.py)
#   accuracy       accuracy beside other programs; CASES=10: pairs a set; OURS_ONLY=1: without the others
#   experiment     every method, as a report that includes the newest accuracy table
#   methods        published methods beside other programs of the same methods; CASES=set:index,...
#   energies       the energy of the truth beside the result of each minimizer
#   thresholds     the effect of each number of benches/thresholds.toml, hours; ONLY=NAME,...; target/thresholds/thresholds.md
#
# Measurements of studies and of speed
#   study          studies of real hippocampi: models, effects, time, memory; PARTS=joint,null; SPLITS=200
#   study-others   the same with correspondences by other methods; PARTS=model,cycles,atrophy
#   study-taxa     genera and families of molars by their nearest neighbors, by maps and by landmarks
#   study-landmarks landmarks of femurs, molars and vertebrae inferred from those of other specimens: target/landmarks/landmarks.md
#   validate-study known deformations in real groups, against an oracle, and splits without an effect: target/validate-study/report.md;
#                  SHORT=1: 20 subjects, minutes
#   bench          a match
#   bench-service  the service; PART=poll: one part

SHELL := /usr/bin/env bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.PHONY: help build demo test check audit api client dashboard
.PHONY: long faults contract readers answers peers-read fuzz soak memory
.PHONY: properties msrv public-api advisories sbom screenshots pictures
.PHONY: accuracy experiment methods energies thresholds study study-others study-taxa study-landmarks validate-study study-env bench bench-service

CARGO ?= cargo
SOURCE ?=
TARGET ?=
KEEP ?=
TEST ?=
SHORT ?=
DATA ?= data
EXAMPLES ?= 50
PART ?=
SECONDS ?= 3600
DEMO_OUT ?= target/demo
EVAL ?= eval
CASES ?=
OURS_ONLY ?=
ONLY ?=
PARTS ?=
ROUNDS ?= 6
RUNS ?= 20
SPLITS ?=
# The newest accuracy table.
ACCURACY ?= $(lastword $(sort $(wildcard docs/accuracy/*)))

help:
	@sed -n '/^#/!q; s/^# \{0,1\}//p' Makefile

build:
	@scripts/setup build
	@[ -e target/release/homolog ] || echo "building homolog: the first build compiles several hundred libraries, which takes minutes" >&2
	$(CARGO) build --release --locked

demo: build
	target/release/homolog demo --out "$(DEMO_OUT)" $(if $(filter-out 0,$(KEEP)),--keep) \
	  $(if $(SOURCE),"$(SOURCE)") $(if $(TARGET),"$(TARGET)")

test:
	@scripts/setup build
	@CARGO="$(CARGO)" scripts/test

long:
	@scripts/setup campaigns
	@CARGO="$(CARGO)" scripts/test long

faults:
	@scripts/setup campaigns
	@HOMOLOG_FAULTS=$(if $(filter-out 0,$(SHORT)),short,full) CARGO="$(CARGO)" scripts/test faults "$(TEST)"

readers:
	@scripts/setup campaigns
	@CARGO="$(CARGO)" scripts/test readers

properties:
	@scripts/setup build
	@CARGO="$(CARGO)" scripts/properties $(RUNS)

soak: build
	scripts/soak target/release/homolog --seconds $(SECONDS) --record target/soak.md

memory: build
	scripts/memory target/release/homolog --seconds $(if $(filter file,$(origin SECONDS)),60,$(SECONDS)) --record target/memory.md

check:
	@scripts/setup build
	scripts/words
	scripts/packages
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --locked --all-targets -- -D warnings

audit:
	@scripts/setup audit
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --locked --no-deps --document-private-items
	$(CARGO) clippy --locked -p homolog-matching -- -D warnings
	target/tools/bin/cargo-machete
	target/tools/bin/cargo-deny --locked check bans licenses sources

peers-read: build
	@scripts/setup campaigns
	target/readers-env/bin/python -W ignore tests/readers/peers/peers_read.py target/release/homolog --cache target/peers --rounds $(ROUNDS) \
	  --out docs/formats-read.md

msrv:
	scripts/msrv

public-api:
	scripts/public-api write

sbom:
	@scripts/setup build
	mkdir -p target
	scripts/sbom > target/homolog.cdx.json

advisories:
	@scripts/setup audit
	target/tools/bin/cargo-deny --locked check advisories

contract:
	@scripts/setup campaigns
	@CONTRACT_EXAMPLES=$(EXAMPLES) CARGO="$(CARGO)" scripts/test contract

api:
	@scripts/setup build
	mkdir -p api
	$(CARGO) build --workspace --locked --bins
	"$(or $(CARGO_TARGET_DIR),$(CURDIR)/target)/debug/homolog" openapi > api/openapi.json.tmp
	"$(or $(CARGO_TARGET_DIR),$(CURDIR)/target)/debug/homolog" problems > api/problems.md.tmp
	"$(or $(CARGO_TARGET_DIR),$(CURDIR)/target)/debug/homolog" parameters > docs/parameters.md.tmp
	mv api/openapi.json.tmp api/openapi.json
	mv api/problems.md.tmp api/problems.md
	mv docs/parameters.md.tmp docs/parameters.md

client: build
	@scripts/setup client
	mkdir -p target/wheels
	scripts/wheel target/release/homolog target/wheels

dashboard:
	cd dashboard && npm ci --no-audit --no-fund && npm run build

screenshots:
	@scripts/setup campaigns
	$(CARGO) build --locked
	cd dashboard && DASHBOARD_BINARY="$(or $(CARGO_TARGET_DIR),$(CURDIR)/target)/debug/homolog" DASHBOARD_SCREENSHOTS="$(CURDIR)/docs/dashboard" \
	  node tests/run.mjs $(TEST)

pictures: build
	[ -x target/picture-env/bin/python ] || python3 -m venv target/picture-env
	target/picture-env/bin/python -m pip --disable-pip-version-check --quiet install numpy==2.4.6 matplotlib==3.11.2
	target/picture-env/bin/python scripts/picture target/release/homolog docs/match.png
	target/picture-env/bin/python scripts/method-pictures target/release/homolog docs/methods

experiment: build
	target/release/homolog experiment --data "$(DATA)" --out target/experiment $(if $(ACCURACY),--accuracy "$(ACCURACY)")

accuracy: build
	benches/accuracy/run --binary target/release/homolog --data "$(DATA)" --eval "$(EVAL)" $(if $(CASES),--cases "$(CASES)") \
	  $(if $(filter-out 0,$(OURS_ONLY)),--ours-only)

energies:
	$(CARGO) build --release --locked -p homolog -p homolog-laboratory --example energies --bins
	benches/accuracy/run --binary target/release/homolog --data "$(DATA)" --eval "$(EVAL)" --ours-only \
	  --energies target/release/examples/energies $(if $(CASES),--cases "$(CASES)")

thresholds:
	@scripts/setup build
	benches/accuracy/run thresholds --data "$(DATA)" --eval "$(EVAL)" $(if $(CASES),--cases "$(CASES)") $(if $(ONLY),--only "$(ONLY)")

methods: build
	benches/methods/run --binary target/release/homolog --data "$(DATA)" --eval "$(EVAL)" --out target/methods $(if $(CASES),--cases "$(CASES)")
	target/methods-env/bin/python benches/methods/bent_tubes.py target/release/homolog

study: build study-env
	$(CARGO) build --release --locked -p homolog -p homolog-study --example null_splits --example templates_apart --example large_group --bins
	target/study-env/bin/python benches/study/study.py --binary target/release/homolog --examples target/release/examples \
	  --data "$(DATA)" --out target/study $(if $(PARTS),--parts "$(PARTS)") $(if $(SPLITS),--splits "$(SPLITS)")

study-others: build study-env
	$(CARGO) build --release --locked -p homolog -p homolog-study --example other_matches --bins
	target/study-env/bin/python benches/study/others.py --binary target/release/homolog --examples target/release/examples \
	  --data "$(DATA)" --out target/study $(if $(PARTS),--parts "$(PARTS)")

study-taxa: build study-env
	target/study-env/bin/python benches/study/taxa.py --binary target/release/homolog --data "$(DATA)" --out target/taxa

study-landmarks: build study-env
	target/study-env/bin/python benches/study/landmarks.py --binary target/release/homolog --data "$(DATA)" --out target/landmarks

validate-study:
	$(CARGO) build --release --locked -p homolog-study --example validate_study
	target/release/examples/validate_study "$(DATA)" target/validate-study$(if $(filter-out 0,$(SHORT)),-short short)

study-env:
	[ -x target/study-env/bin/python ] || python3 -m venv target/study-env
	target/study-env/bin/python -m pip --disable-pip-version-check --quiet install -r benches/accuracy/requirements.txt

answers: build
	scripts/answers target/release/homolog --data "$(DATA)" --against tests/answers.tsv

# Faults are a panic, a file that takes more than two seconds, a single request for more than 256 MiB (64 KiB may
# inflate to 64 MiB, and a growing buffer doubles), and memory above 64 times the inflated size plus 16 MiB. Found files
# go to fuzz/crashes, which a test reads under tighter time limits. Fuzzing of client requests starts from fuzz/kept and
# adds its findings there; a test reads them.
fuzz:
	command -v cargo-fuzz >/dev/null || $(CARGO) install --locked --version 0.13.2 cargo-fuzz
ifneq ($(filter-out read,$(PART)),)
	mkdir -p fuzz/corpus/$(PART)
	cd fuzz && $(CARGO) +nightly fuzz run --features service $(PART) corpus/$(PART) kept/$(PART) -- -max_total_time=$(or $(FOR),600) \
	  -timeout=$(or $(WITHIN),2) -malloc_limit_mb=64 -rss_limit_mb=2048 -max_len=8192
else
	mkdir -p fuzz/corpus/read fuzz/artifacts/read
	HOMOLOG_FUZZ_SEEDS="$$PWD/fuzz/corpus/read" $(CARGO) test --locked -p homolog-formats --test formats hostile::every_format
	find "$(DATA)"/formats tests/fixtures crates/formats/tests -type f -size -64k -exec cp -n {} fuzz/corpus/read/ \; || true
	cd fuzz && $(CARGO) +nightly fuzz run read corpus/read -- -max_total_time=$(or $(FOR),600) -timeout=$(or $(WITHIN),2) -malloc_limit_mb=256 \
	  -rss_limit_mb=2048 -max_len=65536 -dict=formats.dict
endif

bench:
	@scripts/setup build
	mkdir -p benches/records
	$(CARGO) bench --locked -p homolog-laboratory --bench matching -- | tee target/bench.md
	$(CARGO) bench --locked -p homolog-laboratory --bench kernel -- | tee -a target/bench.md
	$(CARGO) bench --locked -p homolog-formats --bench reading -- | tee -a target/bench.md
	record="benches/records/$$(date -u +%Y-%m-%d)-$$(git rev-parse --short HEAD 2>/dev/null || echo unknown).md"; \
	  { echo "# Benchmarks, $$(date -u +%Y-%m-%d); command: make bench"; echo; cat target/bench.md; } > "$$record"; \
	  echo "record: $$record"

# The peer that is compared is a separate package, so that homolog does not depend on it. If it cannot be built, its row
# says so.
bench-service:
	@scripts/setup campaigns
	mkdir -p benches/records
	$(CARGO) build --release --locked --manifest-path benches/peers/graphile/Cargo.toml --target-dir target/peer || true
	@peer="$$PWD/target/peer/release/graphile-peer"; if [ -x "$$peer" ]; then export HOMOLOG_BENCH_PEER="$$peer"; fi; \
	  set -x; $(CARGO) bench --locked --bench service -- $(PART) | tee target/bench-service.md
	record="benches/records/$$(date -u +%Y-%m-%d)-$$(git rev-parse --short HEAD 2>/dev/null || echo unknown)-service.md"; \
	  { echo "# Benchmarks of the service, $$(date -u +%Y-%m-%d); command: make bench-service"; echo; cat target/bench-service.md; } > "$$record"; \
	  echo "record: $$record"
