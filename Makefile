# Two commands do everything on a fresh machine: `make demo` and `make test`.
# Another Python than python3.11: make demo PYTHON=/path/to/python
VENV ?= .venv
PYTHON ?= $(firstword $(shell command -v python3.11) $(shell command -v python3))
BIN := $(VENV)/bin

.PHONY: install demo test lint fuzz evaluate evaluate-world evaluate-learning evaluate-planning evaluate-practice evaluate-places evaluate-bits evaluate-planners evaluate-scale faults tutorial architecture clean

install: $(VENV)/.installed

$(VENV)/.installed: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info[:2] != (3, 11))' || \
	  { echo "neurosym is tested on Python 3.11, and PyBullet has no wheels for newer ones;"; \
	    echo "install Python 3.11, or name another with: make $(or $(MAKECMDGOALS),install) PYTHON=..."; \
	    $(if $(filter command line environment,$(origin PYTHON)),true,exit 2); }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev]'
	@touch $@

# Plans with the shipped domain, executes in the simulator, writes pictures to demo/.
demo: install
	$(BIN)/python tools/demo.py

# A test that hangs is named, after many times what the slowest takes [s].
test: install
	$(BIN)/pytest -m "not evaluation" --numprocesses auto --dist loadfile --no-loadscope-reorder \
	  --timeout 900 --timeout-method thread

lint: install
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy

# The tests that need minutes of physics or training; each prints its figures.
evaluate: install
	$(BIN)/pytest -m evaluation -s

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

# Whether practice helps, beside rehearsing evenly, into docs/results/practice.*; goes on where it was interrupted.
evaluate-practice: install
	$(BIN)/python -m tools.benchmarks.planning.practice

# How well objects are carried to places, over seeds, into docs/results/places.*; goes on where it was interrupted.
evaluate-places: install
	$(BIN)/python -m tools.benchmarks.carrying.evaluate

# How many bits the data carry, over seeds, into docs/results/bits.*; goes on where it was interrupted.
evaluate-bits: install
	$(BIN)/python -m tools.benchmarks.planning.bits

# How far it goes (rows, symbols, objects), into docs/results/scale.*; goes on where it was interrupted.
evaluate-scale: install
	$(BIN)/python -m tools.benchmarks.scale.evaluate

# Kills, full disks, two at once, low limits and clocks that jump, into docs/results/faults.*; goes on where it was
# interrupted. KILLS=5 for a glance.
KILLS ?= 50
faults: install
	$(BIN)/python -m tools.faults --kill $(KILLS) --kill-slow $(KILLS)

# Runs docs/tutorial.ipynb and stores what its cells say: some minutes.
tutorial: install
	$(BIN)/python tools/run_tutorial.py

# Draws the folders and their imports anew, into docs/images/architecture.svg.
architecture: install
	$(BIN)/python -m tools.draw_architecture

# Which planner takes which encoding, into docs/results/planners.*; installs the planners first, and Tamer,
# which takes no encoding. ENHSP needs Java.
evaluate-planners: install
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev,planners]' up-tamer
	$(BIN)/python -m tools.benchmarks.planning.planner_matrix

clean:
	rm -rf $(VENV) demo
