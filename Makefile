# `make help` says what there is. Debian's own Python runs everything: FreeCAD is built for it.
PYTHON := /usr/bin/python3
RUFF := build/tools/bin/ruff
SUITES := bookworm trixie sid
ARGS ?=
# our matrices are small: threads of the linear algebra only wait for each other
export OPENBLAS_NUM_THREADS := 1

help: ## this list
	@sed -nE 's/^([a-z-]+):.*## (.*)/\1|\2/p' $(MAKEFILE_LIST) | awk -F'|' '{printf "  make %-14s %s\n", $$1, $$2}'

docs: ## tables of the pages, and the picture of the architecture, from the registries
	$(PYTHON) docs/tables.py

demo: ## a curve becomes a tube, and what prints it: into build/demo
	@.ci/install demo
	$(PYTHON) -m BistableWB.program.demo --out build/demo

pictures: ## the pictures and the film of the README, anew
	@.ci/install demo
	$(PYTHON) -m BistableWB.program.demo --pictures resources/pictures

test: install ## every test: fast, FreeCAD 0.20 · 1.0 · sid, in the window, lint
	@.ci/test

test-fast: ## the mathematics and the house rules, no FreeCAD (seconds); ARGS="-k name" for some
	$(PYTHON) -m pytest -m "not slow" $(ARGS)

test-random: ## the fast tests in another order every time; SEED=n for one order
	$(PYTHON) -m pytest -q -m "not slow" --shuffle=$(or $(SEED),$(shell date +%s)) $(ARGS)

test-alone: ## each file of the fast tests by itself
	for file in $$(find tests/origami tests/checks tests/slicing tests/house tests/imports tests/designs -name 'test_*.py' | sort); do \
		$(PYTHON) -m pytest -q -m "not slow" $$file || [ $$? = 5 ] || exit 1; done

test-freecad: $(SUITES:%=test-freecad-%) ## the tests inside freecadcmd of bookworm, trixie and sid; test-freecad-SUITE for one

test-gui: $(SUITES:%=test-gui-%) ## the tests in FreeCAD's window on a virtual screen; test-gui-SUITE for one

# what other programs say of our files does not depend on FreeCAD's version: one of them asks
test-freecad-trixie test-freecad-sid: SELECT := -m "not slow"

test-freecad-%:
	.ci/in-freecad $* tests --ignore=tests/house --durations=10 $(SELECT) $(ARGS)

test-gui-%:
	.ci/in-freecad --gui $* tests/gui $(ARGS)

fuzz: install ## hostile documents, design files and drawings; SEED=n COUNT=n SECONDS=n
	.ci/in-freecad host --script tests/fuzz/run.py

lint: $(RUFF) ## style, mistakes and types, by ruff and mypy
	$(RUFF) check .
	$(RUFF) format --check .
	build/tools/bin/mypy --python-executable $(PYTHON)

format: $(RUFF) ## let ruff mend what it can
	$(RUFF) check --fix .
	$(RUFF) format .

bench: install ## how long things take: one table, with ratios and the change since the last run; ARGS="panel" for some rows
	$(PYTHON) benchmarks/table.py $(ARGS)

bench-all: install ## every benchmark
	for file in $(filter-out benchmarks/table.py benchmarks/panel_elsewhere.py,$(wildcard benchmarks/*.py)); do .ci/in-freecad host --script $$file || exit 1; done

clean: ## remove build/ and caches (the trees of other Debians stay in ~/.cache/bistable-workbench)
	rm -rf build .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

install: ## with apt, what is missing
	@.ci/install

$(RUFF): .ci/requirements.txt
	@$(PYTHON) -m venv build/tools
	@build/tools/bin/pip install -q --disable-pip-version-check -r .ci/requirements.txt
	@touch $@

.PHONY: help docs demo pictures test test-fast test-random test-alone test-freecad test-gui fuzz lint format bench bench-all clean install
.DEFAULT_GOAL := help
