# Every target sets itself up: a virtual environment in .venv, and in it this package.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
export OMP_NUM_THREADS ?= 2

.PHONY: app lab test verify bench lint bundle clean

app: $(VENV)/app.stamp
	$(BIN)/workbench app

lab: $(VENV)/app.stamp
	$(BIN)/workbench lab

test: $(VENV)/test.stamp
	$(BIN)/python -m pytest

verify: $(VENV)/test.stamp
	$(BIN)/workbench verify --slow
	$(BIN)/workbench verify --features

bench: $(VENV)/test.stamp
	$(BIN)/python -m tests.benchmarks

lint: $(VENV)/test.stamp
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/nbstripout --verify notebooks/*.ipynb

# The browser bundle of the 3-D view is committed; this makes it anew from its source (needs Node.js).
bundle:
	cd workbench/scene/js && npm ci && npm run build

$(VENV)/pyvenv.cfg:
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade pip

# The first use of the panel method tabulates its Green function, some 20 s, once per machine.
$(VENV)/app.stamp: $(VENV)/pyvenv.cfg pyproject.toml
	$(BIN)/python -m pip install --quiet --editable .
	$(BIN)/workbench prepare
	touch $@

$(VENV)/test.stamp: $(VENV)/pyvenv.cfg pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[test,lint]"
	$(BIN)/workbench prepare
	touch $@

clean:
	rm -rf $(VENV)
