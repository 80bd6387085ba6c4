# Two commands do everything on a fresh machine: `make demo` and `make test`.
# They take the first of PYTHONS that runs and is supported. Another: make demo PYTHON=/path/to/python
VENV ?= .venv
PYTHONS ?= python3.11 python3.12 python3.13 python3
SUPPORTED := import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))
PYTHON ?= $(shell for each in $(PYTHONS); do $$each -c '$(SUPPORTED)' 2>/dev/null && echo $$each && break; done)
BIN := $(VENV)/bin
comma := ,

.PHONY: install demo test test-pythons lint fuzz evaluate evaluate-world evaluate-budget evaluate-learning evaluate-planning evaluate-places evaluate-relations evaluate-planners evaluate-foreign evaluate-scale evaluate-any-data evaluate-asked evaluate-objects evaluate-camera evaluate-studio faults tutorial architecture pictures films docs clean

install: $(VENV)/.installed

# Modules are compiled as they are imported, which takes half of what compiling all of them does.
$(VENV)/.installed: pyproject.toml constraints.txt
	@$(or $(PYTHON),false) -c '$(SUPPORTED)' || \
	  { echo "neurosym needs Python 3.11, 3.12 or 3.13$(if $(PYTHON),$(comma) and $(PYTHON) is none of these);"; \
	    echo "install one, or name it with: make $(or $(MAKECMDGOALS),install) PYTHON=/path/to/python"; exit 2; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --no-compile --constraint constraints.txt --editable '.[dev]'
	@touch $@

# Plans with the shipped domain, executes in the simulator, writes pictures to demo/.
demo: install
	$(BIN)/neurosym demo

# A test that hangs is named, after many times what the slowest takes [s]. Each process computes in one thread, since
# there is one for each core.
test: install
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -m "not evaluation" --numprocesses auto --dist loadfile --no-loadscope-reorder \
	  --timeout 900 --timeout-method thread

# The same on each supported Python that runs here, in an environment of its own.
test-pythons:
	@for each in python3.11 python3.12 python3.13; do \
	  if $$each -c '$(SUPPORTED)' 2>/dev/null; \
	  then $(MAKE) --no-print-directory test PYTHON=$$each VENV=.venv-$$each || exit; \
	  else echo "$$each does not run here; its tests are left out"; fi; done

lint: install
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy

# The tests that need minutes of physics or training; each prints its figures. Shapes of arrays are checked everywhere.
evaluate: install
	$(BIN)/pytest -m evaluation -s --jaxtyping-packages=neurosym,beartype.beartype

# Fuzzes the command line for MINUTES, with files and arguments of all kinds. What it finds is kept in FUZZ, and the
# same command goes on. A short round is part of the tests.
MINUTES ?= 60
FUZZ ?= /var/tmp/neurosym-fuzz
fuzz: install
	PYTHONPATH=tests $(BIN)/python -m fuzz --minutes $(MINUTES) --folder $(FUZZ)

# Every figure of docs/world.md, into docs/results/; goes on where it was interrupted. SCALE=0.1 for a glance.
SCALE ?= 1.0
evaluate-world: install
	$(BIN)/python -m tools.benchmarks.world.evaluate --scale $(SCALE)

# What plans can do by all interactions they cost, into docs/results/budget.*; goes on where it was interrupted.
evaluate-budget: install
	$(BIN)/python -m tools.benchmarks.budget.evaluate

# Every figure of docs/learning.md, into docs/results/; goes on where it was interrupted. SEEDS=1 is the short form.
SEEDS ?= 5
STEPS ?= 5120
evaluate-learning: install
	$(BIN)/python -m tools.benchmarks.learning.evaluate --seeds $(SEEDS) --steps $(STEPS)

# Every figure of docs/planning.md, into docs/results/; goes on where it was interrupted. SEEDS=1 is the short form.
evaluate-planning: STEPS := 2560
evaluate-planning: STRATEGIES := curiosity random active
evaluate-planning: install
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev,planners]'
	$(BIN)/python -m tools.benchmarks.planning.evaluate --seeds $(SEEDS) --steps $(STEPS) --strategies $(STRATEGIES)

# Whether what people ask for is done, into docs/results/asked.*; goes on where it was interrupted. SCALE=0.1 for a glance.
evaluate-asked: install
	$(BIN)/python -m tools.benchmarks.asked.evaluate --scale $(SCALE)

# Objects that nothing was learned of, by features and by what they did, into docs/results/objects.*; goes on where it was interrupted.
evaluate-objects: install
	$(BIN)/python -m tools.benchmarks.objects.evaluate --scale $(SCALE)

# What is learned from a depth camera beside true features, into docs/results/camera.*; goes on where it was interrupted.
evaluate-camera: install
	$(BIN)/python -m tools.benchmarks.camera.evaluate --scale $(SCALE)

# How well objects are carried to places, over seeds, into docs/results/places.*; goes on where it was interrupted.
evaluate-places: install
	$(BIN)/python -m tools.benchmarks.carrying.evaluate

# What one object can be done relative to another, into docs/results/relations.*; goes on where it was interrupted.
evaluate-relations: install
	$(BIN)/python -m tools.benchmarks.relations.evaluate

# How far it goes (rows, symbols, objects), into docs/results/scale.*; goes on where it was interrupted.
evaluate-scale: install
	$(BIN)/python -m tools.benchmarks.scale.evaluate

# Six data sets of any kind from rows to plans that are performed, into docs/results/any-data.*; goes on where it was
# interrupted. DEEPSYM is a folder with public data of another group, which are not part of the project.
DEEPSYM ?=
evaluate-any-data: install
	$(BIN)/pip install --quiet --no-deps panda-gym n-sam
	$(BIN)/pip install --quiet macq pddl-plus-parser anytree pandas scikit-learn
	$(BIN)/python -m tools.benchmarks.any_data.evaluate $(if $(DEEPSYM),--deepsym $(DEEPSYM))

# Kills, full disks, two at once and low limits, into docs/results/faults.*; goes on where it was
# interrupted. KILLS=5 for a glance.
KILLS ?= 50
faults: install
	$(BIN)/python -m tools.faults --kill $(KILLS) --kill-slow $(KILLS)

# Every figure of docs/studio.md, into docs/results/, in a Chromium of this machine; and its picture.
evaluate-studio: install
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev,browser]'
	$(BIN)/python -m tools.benchmarks.studio.evaluate
	$(BIN)/python -m tools.benchmarks.studio.pictures

# Runs docs/tutorial.ipynb and stores what its cells say: some minutes.
tutorial: install
	$(BIN)/python tools/run_tutorial.py

# Builds the site into site/html/, offline; a warning, as of a dead link, fails.
docs: install
	$(BIN)/sphinx-build -q -W --keep-going -b html docs site/html

# Draws the folders and their imports anew, into docs/images/architecture.svg.
architecture: install
	$(BIN)/python -m tools.draw_architecture

# Draws the pictures that open pages of docs/ anew, from the shipped domain and docs/results/.
pictures: install
	$(BIN)/python -m tools.draw_docs

# Films a shipped run of each domain, into docs/images/: some minutes.
films: install
	$(BIN)/python -m tools.draw_films

# How long the page is, and what Fast Downward makes of it, into docs/results/planners.json.
evaluate-planners: install
	$(BIN)/python -m tools.benchmarks.planning.one_page

# What ten planners of the package index make of the printed files, called without neurosym, into
# docs/results/foreign.*; each is installed into an environment of its own, below ~/.cache/neurosym-foreign.
# Some take no costs, so the plain page is printed, too.
evaluate-foreign: install
	rm -rf build/foreign && mkdir -p build && cp -r domains build/foreign
	set -e; for domain in build/foreign/*/; do $(BIN)/neurosym compile-domain --quiet $$domain --plain; done
	$(BIN)/python -m tools.benchmarks.foreign --domains build/foreign

clean:
	rm -rf $(VENV) demo
