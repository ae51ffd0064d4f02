# Two commands matter: `make demo` (set up and run the simulated preflight) and `make test` (set up and run every check).
PYTHON ?= python3
SEED ?= 0
VENV := .venv
BIN := $(VENV)/bin
SHELL := /bin/bash

.PHONY: demo test lint slow papers blind coverage sensitivity campaign clients bench gui bundle release soak clean
.DEFAULT_GOAL := demo

$(VENV)/.run: pyproject.toml
	@echo "Setting up labcal in $(VENV) (once; about a minute) ..."
	@$(PYTHON) tools/set_up.py $(VENV) --editable .
	@touch $@

$(VENV)/.dev: pyproject.toml $(VENV)/.run
	@echo "Setting up what the checks need ..."
	@$(PYTHON) tools/set_up.py $(VENV) --editable '.[dev,dcc,paper]'
	@touch $@

demo: $(VENV)/.run
	@$(BIN)/labcal demo --out demo-out --seed $(SEED)

gui: $(VENV)/.run
	@$(BIN)/labcal gui

test: $(VENV)/.dev
	@BIN=$(BIN) bash tools/check.sh

lint: $(VENV)/.dev
	$(BIN)/ruff check . && $(BIN)/ruff format --check . && $(BIN)/mypy && $(BIN)/mypy --platform win32 --no-warn-unreachable && $(BIN)/lint-imports --no-cache

bench: $(VENV)/.dev
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 $(BIN)/python benchmarks/window_budget.py
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 $(BIN)/python benchmarks/window_events.py
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 $(BIN)/python benchmarks/window_start.py
	@OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -q -s benchmarks/test_loop_speed.py
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 $(BIN)/python benchmarks/million_samples.py

slow: $(VENV)/.dev
	$(BIN)/pytest -m slow

papers: $(VENV)/.dev
	@OPENBLAS_NUM_THREADS=1 PYTHONPATH=tests/papers:tests/fit $(BIN)/python tests/papers/tables.py docs/papers.md

BLIND_RUNS ?= 250
BLIND_SEED ?= 2026
blind: $(VENV)/.dev
	@rm -rf blind-out && $(BIN)/python tests/blind/trial.py blind-out $(BLIND_RUNS) $(BLIND_SEED) --processes 2

COVERAGE_RUNS ?= 1000
coverage: $(VENV)/.dev
	@OPENBLAS_NUM_THREADS=1 PYTHONPATH=tests/uncertainty $(BIN)/python tests/uncertainty/cover.py $(COVERAGE_RUNS) coverage.jsonl

sensitivity: $(VENV)/.dev
	@$(BIN)/python tests/blind/sensitivity.py sensitivity-out

FAULTS ?= 20
BENCHES ?= 2
campaign: $(VENV)/.dev
	@PYTHONPATH=tests/runner $(BIN)/python tests/campaign/campaign.py --out campaign-out --number $(FAULTS) --benches $(BENCHES)
	@PYTHONPATH=tests/runner $(BIN)/python tests/campaign/reliability.py table campaign-out docs/reliability.md
	@OPENBLAS_NUM_THREADS=1 PYTHONPATH=tests/archive:tests/study $(BIN)/python tests/campaign/pushes_and_studies.py \
	    --out campaign-out --number $(FAULTS)

CLIENTS := .venv-clients
$(CLIENTS)/.made: pyproject.toml tests/clients/requirements.txt
	@echo "Setting up other people's programs in $(CLIENTS) (once) ..."
	@$(PYTHON) tools/set_up.py $(CLIENTS) --editable .
	@$(CLIENTS)/bin/pip install --quiet --disable-pip-version-check -r tests/clients/requirements.txt
	@touch $@

clients: $(CLIENTS)/.made
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 LABCAL_CLIENTS=docs/instruments.md $(CLIENTS)/bin/pytest -q tests/clients \
	    tests/drivers/test_thorlabs_apt.py tests/drivers/test_pi_gcs2.py tests/drivers/test_trinamic_tmcl.py tests/drivers/test_ros_topic.py

BUNDLE ?= dist/labcal-bundle
BUNDLE_PYTHON ?= 3.11
bundle: $(VENV)/.dev
	@$(BIN)/python tools/bundle/make.py --out $(BUNDLE) --python $(BUNDLE_PYTHON)

release: $(VENV)/.dev
	@$(BIN)/python tools/release.py --out dist

SOAK ?= --preflights 30 --minutes 60 --runs 10000
soak: $(VENV)/.dev
	@QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1 $(BIN)/python benchmarks/soak.py $(SOAK) --picture docs/images/soak.png

clean:
	rm -rf $(VENV) $(CLIENTS) demo-out soak-out build dist .pytest_cache .mypy_cache .ruff_cache .import_linter_cache
