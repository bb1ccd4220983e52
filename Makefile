# Two commands on a fresh machine with Python 3.11+ and make: `make perform` and `make test`.

PYTHON ?= python3
BIN := .venv/bin
# One more than there are cores, since many tests wait.
TEST_PROCESSES ?= $(shell $(PYTHON) -c "import os; print(min(4, 1 + (os.cpu_count() or 1)))")

# Every target with its first line of comment.
help:
	@awk '/^# /{c=substr($$0,3)} /^[a-z][a-z-]*:/{sub(":.*",""); printf "%-14s %s\n", $$0, c; c=""}' $(MAKEFILE_LIST)

.PHONY: help format docs bench perform test types suite search drill audit sbom test-clients serve npc plugin test-plugins lock client-types clean

# Installs into .venv and performs the bundled line: out/example.bml.
perform: .venv/installed
	mkdir -p out
	$(BIN)/understudy perform examples/example.flac --text-file examples/example.txt -o out/example.bml --trace out/example.json

# The service and the studio at http://127.0.0.1:8000/.
serve: .venv/installed
	$(BIN)/understudy serve

# The example of a game's page with two characters.
npc: .venv/installed
	cd clients/typescript && npm ci --silent && npm run --silent build
	cd examples/npc && npm ci --silent && npm start

# The test suite and all static checks, as CI runs them: the quick ones first, types beside the tests.
test: .venv/installed-test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(MAKE) --no-print-directory --jobs 2 types suite

# The types alone, and the rules.
types: .venv/installed-test
	$(BIN)/mypy
	$(BIN)/understudy rules check

# The tests alone.
suite: .venv/installed-test
	OMP_NUM_THREADS=1 $(BIN)/pytest -n $(TEST_PROCESSES) --dist loadfile --no-loadscope-reorder -rs

# The service under attack, on loopback alone, some ten minutes; python -m benchmarks.api.drill takes longer.
drill: .venv/installed-test
	OMP_NUM_THREADS=1 $(BIN)/python -m benchmarks.api.drill --inputs 2000 --messages 2000 --files 4000 --soak 500 --kills 5 --no-load

# Known holes in what the locks install; skipped, with the reason, without a network.
audit:
	PYTHON=$(PYTHON) .ci/audit

# What a release is made of, by the lock: out/sbom.json (CycloneDX).
sbom:
	mkdir -p out
	test -x .venv-audit/bin/cyclonedx-py || { $(PYTHON) -m venv .venv-audit && .venv-audit/bin/pip install --quiet --disable-pip-version-check "cyclonedx-bom>=7,<8"; }
	.venv-audit/bin/cyclonedx-py requirements requirements.lock --pyproject pyproject.toml --output-reproducible --of JSON -o out/sbom.json

# Formats the Python code.
format: .venv/installed-test
	$(BIN)/ruff check --fix --select I .
	$(BIN)/ruff format .

# The documentation as a site in out/site; a link that leads nowhere fails.
docs: .venv/installed
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[docs]'
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet

# The figures that can be taken in some minutes without further data: speed, start-up, structure.
bench: .venv/installed-test
	$(BIN)/python -m benchmarks.structure
	$(BIN)/python -m benchmarks.startup --runs 3
	$(BIN)/python -m benchmarks.pipeline

# New examples for the properties, twenty times as many as the suite tries, which are always the same: an hour on two cores.
search: .venv/installed-test
	UNDERSTUDY_EXAMPLES=20 OMP_NUM_THREADS=1 $(BIN)/pytest -m hypothesis -n $(TEST_PROCESSES)

# The client and its example, with node, npm and chromium where they are; what is missing is said and skipped.
test-clients: .venv/installed
	clients/test.sh

# The extension for Blender (docs/blender.md), and its tests in Blender's own module: 374 MB, so in a place of its own.
plugin:
	$(PYTHON) plugins/build_blender.py

test-plugins: .venv/installed-test .venv-bpy/installed
	-$(BIN)/pip install --quiet --disable-pip-version-check pyufbx
	UNDERSTUDY_BLENDER=.venv-bpy/bin/python OMP_NUM_THREADS=1 $(BIN)/pytest -rs tests/realizer/exporting/test_fbx.py
	OMP_NUM_THREADS=1 .venv-bpy/bin/python -m pytest -c tests/plugins/in_blender.ini --rootdir=. \
	    --confcutdir=tests/plugins tests/plugins/blender/in_blender

.venv-bpy/installed:
	$(PYTHON) -m venv .venv-bpy
	.venv-bpy/bin/pip install --quiet --disable-pip-version-check "bpy>=4.2" pytest requests
	touch $@

.venv/bin/python:
	$(PYTHON) -c 'import sys; sys.exit(None if sys.version_info >= (3, 11) else "understudy needs Python 3.11 or newer")'
	$(PYTHON) -m venv .venv

# With what draws pictures (contact sheets, plots), which the image of the service does without.
.venv/installed: .venv/bin/python requirements-plot.lock pyproject.toml
	$(BIN)/pip install --quiet --disable-pip-version-check --require-hashes -r requirements-plot.lock
	$(BIN)/pip install --quiet --disable-pip-version-check --no-deps --editable .
	touch $@

.venv/installed-test: .venv/installed requirements-test.lock
	$(BIN)/pip install --quiet --disable-pip-version-check --require-hashes -r requirements-test.lock
	touch $@

# For maintainers, after a change of the dependencies in pyproject.toml. One version of each for every Python.
LOCK := $(BIN)/uv pip compile --quiet --universal --fork-strategy fewest --python-version 3.11 --generate-hashes --no-header

lock: .venv/installed-test
	$(BIN)/pip install --quiet uv
	$(LOCK) --output-file requirements.lock pyproject.toml
	$(LOCK) --extra plot --constraint requirements.lock --output-file requirements-plot.lock pyproject.toml
	$(LOCK) --extra test --constraint requirements.lock --output-file requirements-test.lock pyproject.toml

# After a change of what the service takes or answers: the client's types are generated from it.
client-types: .venv/installed
	cd clients/typescript && npm ci --silent && UNDERSTUDY_PYTHON=../../$(BIN)/python node scripts/generate.js

# Removes everything that make has made.
clean:
	rm -rf .venv .venv-bpy .venv-audit out dist clients/typescript/dist examples/npc/.cache .mypy_cache .ruff_cache .pytest_cache .import_linter_cache
