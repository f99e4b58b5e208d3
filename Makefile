# `make help` lists the targets. A step runs only when something it reads has changed
# (tools/once.py).

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
ONCE := @$(PYTHON) tools/once.py
PYTEST_ARGS ?= --numprocesses auto --maxprocesses 8 --dist loadgroup

# Read by every step that runs the engine.
ENGINE := $(addprefix armillary/,algebra derivation mechanism program targets vocabulary.py) \
  pyproject.toml requirements/dev.txt
SOURCES := $(ENGINE) derivations

COMPILE := CUSTOM_COMPILE_COMMAND="make lock" $(BIN)/pip-compile --quiet --generate-hashes \
  --strip-extras --allow-unsafe --no-emit-index-url --no-emit-trusted-host --no-emit-find-links

export PIP_DISABLE_PIP_VERSION_CHECK := 1

# A step that has something to do leaves this behind (tools/once.py).
$(shell rm -f build/worked)

.NOTPARALLEL:
.PHONY: all help environment package katex generate check audit site serve lint test test-all benchmark \
  benchmark-environment mutants tools wheel try-wheel lock clean distclean

all: site ## Set up, regenerate, check and build the site: all that changed since last time
	@test -e build/worked || echo "Nothing to do: kernels, checks and site are up to date."

help: ## This list
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 24

environment: ## .venv with exactly what requirements/dev.txt names
	$(ONCE) $(VENV)/stamps/environment --reads requirements/dev.txt --makes $(BIN)/python -- \
	  tools/environment.sh $(PYTHON) requirements/dev.txt

package: environment
	@mkdir -p generated/python/armillary_kernels generated/c/src/armillary
	$(ONCE) $(VENV)/stamps/package --reads pyproject.toml setup.py --makes $(BIN)/armillary -- \
	  $(BIN)/pip install -qq --no-deps --no-build-isolation --editable .

katex: environment ## Copy KaTeX into the theme, from npm by the lock file
	$(ONCE) build/stamps/katex --reads package.json package-lock.json .npmrc tools/copy_katex.py \
	  --makes $(addprefix armillary/site/theme/assets/katex/,katex.min.js katex.min.css LICENSE) -- \
	  sh -c 'PATH="$(CURDIR)/$(BIN):$$PATH" npm ci --loglevel=error --no-audit --no-fund && $(BIN)/python tools/copy_katex.py'

generate: package ## Regenerate the kernels that changed
	$(ONCE) build/stamps/generate --reads $(SOURCES) --updates generated \
	  --makes generated/manifest.json -- \
	  $(BIN)/armillary generate

check: generate ## Compare the kernels with identities and independent engines
	$(ONCE) build/stamps/check --reads $(SOURCES) armillary/verify generated --makes build/checks.json -- \
	  $(BIN)/armillary check

audit: package ## Compare what papers print with what is derived
	$(ONCE) build/stamps/audit --reads $(SOURCES) armillary/verify \
	  $(addprefix armillary/site/,idioms.py notation.py structure.py) --makes build/audit.json -- \
	  $(BIN)/armillary audit

site: katex check audit ## Build the site
	$(ONCE) build/stamps/site --reads $(SOURCES) armillary/site armillary/verify generated site_docs mkdocs.yml build/checks.json build/audit.json \
	  --makes site/index.html -- $(BIN)/armillary site build

serve: katex check audit ## Serve the site and rebuild it while you edit
	$(BIN)/armillary site serve

# The generated C is laid out by its printer, so only C that people write is formatted.
lint: package ## Formatting, lint, types, import floors
	$(BIN)/ruff format --check --quiet .
	$(BIN)/ruff check --quiet .
	$(BIN)/mypy
	$(BIN)/lint-imports --cache-dir build/import-linter
	@find benchmarks tests -name '*.[ch]' -not -path '*/golden/*' | \
	  xargs $(BIN)/clang-format --dry-run -Werror

test: site lint ## Lint, then every test that this machine has the tools for
	$(BIN)/armillary generate --check
	PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/pytest $(PYTEST_ARGS)
	@$(PYTHON) tools/machine.py report

test-all: export ARMILLARY_REQUIRE_ALL := 1
test-all: ## What CI runs: everything, and a missing tool is an error
	@$(PYTHON) tools/machine.py require
	$(MAKE) benchmark-environment
	$(MAKE) test
	$(BIN)/python -m benchmarks --check
	$(BIN)/python -m mutation --check --most 25
	$(MAKE) try-wheel

benchmark-environment: environment
	$(ONCE) $(VENV)/stamps/benchmark --reads requirements/dev.txt requirements/benchmark.txt -- \
	  $(BIN)/pip install -qq --require-hashes -r requirements/benchmark.txt

benchmark: package benchmark-environment ## Measure against SymPy, CasADi, wrenfold and SymForce
	$(BIN)/python -m benchmarks

mutants: check ## Change the derivations in small ways; count the changes that the checks see
	$(BIN)/python -m mutation

tools: ## Install compilers, browser and the other generators, where apt is permitted
	@$(PYTHON) tools/machine.py install
	$(MAKE) benchmark-environment

wheel: katex generate ## dist/*.whl, with theme, KaTeX and kernels
	@rm -rf build/lib build/bdist.*
	$(BIN)/python -m build --quiet --wheel --no-isolation --outdir dist .

try-wheel: wheel ## Install the wheel by itself and follow a chapter with it
	$(BIN)/python tools/try_wheel.py dist/armillary-*.whl

lock: environment ## Renew the lock files (UPGRADE=--upgrade takes the newest versions)
	$(COMPILE) $(UPGRADE) --extra check --extra dev --output-file requirements/dev.txt pyproject.toml
	$(COMPILE) $(UPGRADE) --extra benchmark --constraint requirements/dev.txt \
	  --output-file requirements/benchmark.txt pyproject.toml
	PATH="$(CURDIR)/$(BIN):$$PATH" npm install --package-lock-only --silent

clean: ## Remove what was built; the environment stays
	rm -rf build site dist site_docs/systems site_docs/papers armillary/site/theme/assets/katex generated/.staging*
	find . -name __pycache__ -not -path './.venv/*' -prune -exec rm -rf {} +

distclean: clean ## Remove the environment and the downloads too
	rm -rf .venv node_modules *.egg-info .ruff_cache .hypothesis
