# make demo    build, start the service, match a pair over HTTP, show the result
#              SOURCE=a.nii.gz TARGET=b.nii.gz: use your own pair; KEEP=1: leave the service running
# make test    all tests that this machine can run, fault injection in a short form; it lists those that were skipped, and
#              why; HOMOLOG_REAL_DATA=dir: the real data that some need
# make faults  fault injection in full length, an hour: processes and children killed, databases stopped, disks filled;
#              TEST=a06: only the test of that name
# make soak    an hour of mixed load with faults: memory and open files must not grow, no job may be lost; SECONDS=600: shorter;
#              the record is target/soak.md
# make memory  attack the service in a memory group, or measure its memory if groups are unavailable: 2 GiB with workers, 512 MiB
#              without; SECONDS=60; the record is target/memory.md
# make check   words (scripts/words.txt), packages of the library crates, formatting, lints, documentation, unused dependencies,
#              licenses and sources of dependencies (deny.toml)
# make sbom    software bill of materials of the program, target/homolog.cdx.json (CycloneDX)
# make advisories  known vulnerabilities of dependencies; needs the internet
# make contract  test a running service on each store against its OpenAPI document with schemathesis; EXAMPLES=50: requests for
#              each operation
# make build   target/release/homolog
# make api     regenerate api/ and docs/parameters.md
# make client  target/wheels: the Python package with this machine's program in it
# make dashboard build the page of the dashboard, dashboard/dist, with node; make screenshots: the pictures in docs/dashboard,
#              by the tests in a browser; TEST=batch: only the test of that name
# make picture redraw docs/match.png; make method-pictures: redraw the pictures in docs/methods
# make experiment  measure every method and write a report that includes the newest accuracy table; DATA=dir: real label
#              volumes in dir/hippocampus
# make accuracy  measure accuracy and compare it with other programs; DATA=dir: label volumes in dir/hippocampus;
#              EVAL=dir: the folder of real_cases.py; CASES=10: pairs per set; OURS_ONLY=1: without the other programs
# make energies  compare the energy of the truth with the result of each minimizer; DATA, EVAL, CASES as for make accuracy
# make thresholds  effect of each number of benches/thresholds.toml: compare builds with a larger and a smaller number with the
#              normal build, hours; ONLY=NAME,...: some of them; DATA, EVAL, CASES as for make accuracy; the record is target/thresholds/thresholds.md
# make answers compare the answers of this build with tests/answers.tsv, to the bit, on 20 real pairs and eight methods;
#              DATA=dir: label volumes in dir/hippocampus
# make peers-read  read files of other programs, mutations of them and test data of PyPI packages with homolog and with nibabel, VTK,
#              SimpleITK, pynrrd, trimesh and highdicom; writes docs/formats-read.md; ROUNDS=6: mutations of each kind
# make fuzz    coverage-guided fuzzing of the readers, or of client requests: PART=json, form, headers, query or token; FOR=600:
#              seconds; WITHIN=10: seconds that an input may take (2 unless set), for busy machines; needs a nightly toolchain
# make methods  published methods (docs/methods) beside other programs of the same methods; DATA, EVAL as for make accuracy;
#             CASES=set:index,... pairs other than the default ones
# make study   measure studies of real hippocampi: models, joint maps, simulated atrophy, splits without an effect, time, memory;
#              DATA=dir: label volumes in dir/hippocampus; PARTS=time,null: some of them; SPLITS=200: splits without an effect
# make study-others  the same studies with correspondences by spherical harmonics, ICP and coherent point drift; DATA as above;
#              PARTS=model,cycles,atrophy: some of them
# make bench   benchmarks of a match
# make bench-service  benchmarks of the service; PART=poll: one part of them

SHELL := /usr/bin/env bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.PHONY: help demo test faults fuzz soak memory check sbom advisories contract build api client picture method-pictures experiment accuracy energies thresholds methods answers study study-others study-env bench bench-service dashboard screenshots peers-read

CARGO ?= cargo
SOURCE ?=
TARGET ?=
KEEP ?=
TEST ?=
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
SPLITS ?=
# The newest accuracy table.
ACCURACY ?= $(lastword $(sort $(wildcard docs/accuracy/*)))

help:
	@sed -n '/^#/!q; s/^# //p' Makefile

build:
	@scripts/setup build
	@[ -e target/release/homolog ] || echo "building homolog: the first build compiles several hundred libraries, which takes minutes" >&2
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

soak: build
	scripts/soak target/release/homolog --seconds $(SECONDS) --record target/soak.md

memory: build
	scripts/memory target/release/homolog --seconds $(if $(filter file,$(origin SECONDS)),60,$(SECONDS)) --record target/memory.md

check:
	@scripts/setup check
	scripts/words
	scripts/packages
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --locked --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --locked --no-deps --document-private-items
	target/tools/bin/cargo-machete
	target/tools/bin/cargo-deny --locked check bans licenses sources

peers-read: build
	@scripts/setup test
	target/readers-env/bin/python -W ignore tests/readers/peers/peers_read.py target/release/homolog --cache target/peers --rounds $(ROUNDS) \
	  --out docs/formats-read.md

sbom:
	@scripts/setup build
	mkdir -p target
	scripts/sbom > target/homolog.cdx.json

advisories:
	@scripts/setup check
	target/tools/bin/cargo-deny --locked check advisories

contract:
	@scripts/setup test
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
	@scripts/setup test
	$(CARGO) build --locked
	cd dashboard && DASHBOARD_BINARY="$(or $(CARGO_TARGET_DIR),$(CURDIR)/target)/debug/homolog" DASHBOARD_SCREENSHOTS="$(CURDIR)/docs/dashboard" \
	  node tests/run.mjs $(TEST)

picture: build
	[ -x target/picture-env/bin/python ] || python3 -m venv target/picture-env
	target/picture-env/bin/python -m pip --disable-pip-version-check --quiet install numpy==2.4.6 matplotlib==3.11.2
	target/picture-env/bin/python scripts/picture target/release/homolog docs/match.png

method-pictures: build
	[ -x target/picture-env/bin/python ] || python3 -m venv target/picture-env
	target/picture-env/bin/python -m pip --disable-pip-version-check --quiet install numpy==2.4.6 matplotlib==3.11.2
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
	$(CARGO) build --release --locked -p homolog -p homolog-study --example null_splits --example templates_apart --bins
	target/study-env/bin/python benches/study/study.py --binary target/release/homolog --examples target/release/examples \
	  --data "$(DATA)" --out target/study $(if $(PARTS),--parts "$(PARTS)") $(if $(SPLITS),--splits "$(SPLITS)")

study-others: build study-env
	$(CARGO) build --release --locked -p homolog -p homolog-study --example other_matches --bins
	target/study-env/bin/python benches/study/others.py --binary target/release/homolog --examples target/release/examples \
	  --data "$(DATA)" --out target/study $(if $(PARTS),--parts "$(PARTS)")

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
	HOMOLOG_FUZZ_SEEDS="$$PWD/fuzz/corpus/read" $(CARGO) test --locked -p homolog-formats --test hostile every_format
	find $(or $(DATA),../shared/data)/formats tests/fixtures crates/formats/tests -type f -size -64k -exec cp -n {} fuzz/corpus/read/ \; || true
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
	@scripts/setup test
	mkdir -p benches/records
	$(CARGO) build --release --locked --manifest-path benches/peers/graphile/Cargo.toml --target-dir target/peer || true
	@peer="$$PWD/target/peer/release/graphile-peer"; if [ -x "$$peer" ]; then export HOMOLOG_BENCH_PEER="$$peer"; fi; \
	  set -x; $(CARGO) bench --locked --bench service -- $(PART) | tee target/bench-service.md
	record="benches/records/$$(date -u +%Y-%m-%d)-$$(git rev-parse --short HEAD 2>/dev/null || echo unknown)-service.md"; \
	  { echo "# Benchmarks of the service, $$(date -u +%Y-%m-%d); command: make bench-service"; echo; cat target/bench-service.md; } > "$$record"; \
	  echo "record: $$record"
