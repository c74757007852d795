# Everything goes through .venv, which is made on first use from the locked, hashed requirements.
# It needs Python 3.11, or uv to fetch it; scripts/environment.sh says how to get either.
PYTHON ?= python3.11
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready

CREW := $(VENV)/.crew
LOCAL := $(VENV)/.local-llm
BROWSER := $(VENV)/.browser

.PHONY: storyboard test test-all crew test-crew test-local-model test-studio check bench clean

storyboard: $(READY)  ## Make the example storyboard into out/casablanca.storyboard
	$(BIN)/storyblender make examples/casablanca.fountain --out out/casablanca.storyboard

test: $(READY)  ## Run the tests that CI runs
	$(BIN)/python -m pytest -n 2 -m "not slow"

test-all: $(READY)  ## Run every test, the slow ones too
	$(BIN)/python -m pytest -n 2

crew: $(CREW)  ## Install what language models in the crew need

test-crew: $(CREW)  ## Run the tests of language models, against servers on this machine
	$(BIN)/python -m pytest -n 0 tests/wire

test-local-model: $(LOCAL)  ## Install a small model with its server, compiled here in some ten minutes, and run a crew on it
	$(BIN)/python -m pytest -n 0 -s tests/local_model

test-studio: $(BROWSER)  ## Look at the studio's page in a real browser; it needs Chromium
	$(BIN)/python -m pytest -n 2 tests/browser

check: $(READY)  ## Lint, types, layers
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright
	$(BIN)/lint-imports

bench: $(READY)  ## Print the benchmark tables
	$(BIN)/python -m benchmarks

$(READY): requirements.lock pyproject.toml
	@sh scripts/environment.sh $(PYTHON) $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	$(BIN)/python -m storyblender.library.body_data
	$(BIN)/storyblender doctor
	@touch $@

$(CREW): $(READY) requirements-crew.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --require-hashes -r requirements-crew.lock
	@touch $@

$(LOCAL): $(CREW) requirements-local-llm.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --require-hashes -r requirements-local-llm.lock
	@touch $@

$(BROWSER): $(READY) requirements-browser.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --require-hashes -r requirements-browser.lock
	@touch $@

clean:  ## Remove what was made, not the environment
	rm -rf out build
