"""Our compiler beside SAM (Juba, Le and Stern, 2021) on the same traces of bits, which macq draws at random.

The hidden domain is a robot with two hands, two rooms and two balls. Problems go from one state that walks
come to, to another. A plan is judged by unified-planning's validator on the hidden domain: it solves the
problem, or it is a false one.
"""

import csv
import io
import json
import random
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from unified_planning.engines import PlanGenerationResultStatus, ValidationResultStatus
from unified_planning.io import PDDLReader
from unified_planning.shortcuts import OneshotPlanner, PlanValidator, get_environment

from neurosym.data.interactions import Interactions
from neurosym.files import read_json
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.value_stages import domain_of
from tools.benchmarks.any_data.way import neurosym
from tools.benchmarks.jobs import Found, Jobs
from tools.benchmarks.tables import mean_of, percent, table

LEARNERS = {
    "sam": "SAM",
    "given": "our compiler, bits as given",
    "learned": "our network and compiler, 4 bits of these",
}
PREFIX, NEEDS = "traces", ("macq", "sam_learning", "pddl_plus_parser")
TITLE = "## Beside a learner of action models"
ABOUT = (
    "macq draws traces of ten steps at random in a hidden domain: a robot with two hands, two rooms, two "
    "balls. What holds is told as bits. SAM (Juba, Le and Stern, 2021) learns preconditions and effects of "
    "each action; we compile, with the bits as symbols, or with four bits that our network learns of them. "
    "Ten problems ask for one state that is come to from another; Fast Downward plans, and "
    "unified-planning's validator judges plans on the hidden domain. One seed."
)
TRACES = (20, 80, 320)  # how many, of so many steps each
_STEPS, _PROBLEMS, _SEED = 10, 10, 900
_DOMAIN = """(define (domain hidden) (:requirements :strips :typing) (:types room ball hand - object)
(:predicates (robot ?r - room) (in ?b - ball ?r - room) (free ?h - hand) (carry ?b - ball ?h - hand))
(:action move :parameters (?x - room ?y - room) :precondition (and (robot ?x))
 :effect (and (not (robot ?x)) (robot ?y)))
(:action pick :parameters (?b - ball ?r - room ?h - hand) :precondition (and (robot ?r) (in ?b ?r) (free ?h))
 :effect (and (carry ?b ?h) (not (in ?b ?r)) (not (free ?h))))
(:action drop :parameters (?b - ball ?r - room ?h - hand) :precondition (and (robot ?r) (carry ?b ?h))
 :effect (and (in ?b ?r) (free ?h) (not (carry ?b ?h)))))
"""
_PROBLEM = """(define (problem one) (:domain hidden)
(:objects west east - room red blue - ball left right - hand)
(:init {start}) (:goal (and {goal})))
"""
_START = "(robot west) (in red west) (in blue west) (free left) (free right)"
_DRAW = """
import json, sys
from macq.generate.pddl import VanillaSampling
drawn = VanillaSampling("domain.pddl", "problem.pddl", plan_len={steps}, num_traces={count}, seed={seed})
print(json.dumps([
    [[sorted(str(one) for one, holds in step.state.items() if holds),
      [step.action.name, *(one.name for one in step.action.obj_params)] if step.action else []]
     for step in trace]
    for trace in drawn.traces
]))
"""
get_environment().credits_stream = None
Walk = list[tuple[list[str], list[str]]]
"""What holds in turn, and the action that is taken there."""


def jobs(work: Path, seeds: int = 1) -> Jobs:
    """List the jobs: one for each learner, number of traces and seed."""
    return {
        f"{PREFIX}-{learner}-{count}-{seed}": partial(_try, work, learner, count, seed)
        for learner in LEARNERS
        for count in TRACES
        for seed in range(1, seeds + 1)
    }


def _drawn(folder: Path, count: int, seed: int) -> list[Walk]:
    """Let macq walk through the hidden domain."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "domain.pddl").write_text(_DOMAIN)
    (folder / "problem.pddl").write_text(_PROBLEM.format(start=_START, goal=_START))
    code = _DRAW.format(steps=_STEPS + 1, count=count, seed=seed)
    said = subprocess.run(
        [sys.executable, "-c", code],
        cwd=folder,
        env={"PYTHONHASHSEED": "0"},
        check=True,
        capture_output=True,
        text=True,
    )
    return [
        [([_plain(fact) for fact in state], action) for state, action in walk]
        for walk in json.loads(said.stdout.splitlines()[-1])
    ]


def _plain(fact: str) -> str:
    """Write `(robot room west)`, as macq names it, as `robot west`."""
    name, *rest = fact.strip("()").split()
    return " ".join([name, *rest[1::2]])


def _try(work: Path, learner: str, count: int, seed: int) -> dict[str, int]:
    """Learn from traces, and count problems that are solved, planned falsely, and not planned."""
    folder = work / f"{learner}-{count}-{seed}"
    walks = _drawn(folder, count, seed)
    bits = sorted({fact for walk in walks for state, _ in walk for fact in state})
    every = {
        state
        for walk in _drawn(folder / "problems", 50, _SEED)
        for state, _ in ((tuple(s), a) for s, a in walk)
    }
    rng = random.Random(_SEED)
    problems = [tuple(rng.sample(sorted(every), 2)) for _ in range(_PROBLEMS)]
    (folder / "traces.csv").write_text(_as_csv(walks, bits))
    planned = (
        _sam(folder, walks, bits, problems)
        if learner == "sam"
        else _ours(folder, learner, seed, bits, problems)
    )
    solved = [
        _is_plan(*pair, steps) for pair, steps in zip(problems, planned, strict=True) if steps is not None
    ]
    return {"solved": sum(solved), "false": len(solved) - sum(solved), "problems": len(problems)}


def _as_csv(walks: Sequence[Walk], bits: Sequence[str]) -> str:
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow([*(bit.replace(" ", "-") for bit in bits), "action", "plan_id"])
    for number, walk in enumerate(walks):
        rows.writerows(
            [[*(int(bit in state) for bit in bits), "-".join(action), number] for state, action in walk]
        )
    return text.getvalue()


def _is_plan(start: Sequence[str], goal: Sequence[str], steps: Sequence[str]) -> bool:
    """Ask unified-planning whether steps, named as `move-west-east`, are a plan of the hidden domain."""
    start, goal = ("".join(f"({fact})" for fact in facts) for facts in (start, goal))
    problem = PDDLReader().parse_problem_string(_DOMAIN, _PROBLEM.format(start=start, goal=goal))
    text = "".join(f"({' '.join(step.split('-'))})\n" for step in steps)
    with PlanValidator(problem_kind=problem.kind) as validator:
        judged = validator.validate(problem, PDDLReader().parse_plan_string(problem, text))
    return bool(judged.status is ValidationResultStatus.VALID)


def _sam(
    folder: Path,
    walks: Sequence[Walk],
    bits: Sequence[str],
    problems: Sequence[tuple[Sequence[str], Sequence[str]]],
) -> list[list[str] | None]:
    """Learn with SAM, and plan with Fast Downward."""
    from pddl_plus_parser.lisp_parsers import DomainParser, TrajectoryParser
    from sam_learning.learners import SAMLearner

    actions = sorted({"-".join(action) for walk in walks for _, action in walk if action})
    declared = " ".join(f"({bit.replace(' ', '-')})" for bit in bits)
    signatures = "\n".join(f"(:action {one} :parameters () :precondition () :effect ())" for one in actions)
    head = f"(define (domain bits) (:requirements :strips) (:predicates {declared})\n"
    (folder / "bits.pddl").write_text(f"{head}{signatures})\n")
    known = DomainParser(folder / "bits.pddl", partial_parsing=True).parse_domain()
    observed = []
    for walk in walks:
        states = [" ".join(f"({fact.replace(' ', '-')})" for fact in state) for state, _ in walk]
        then = "".join(
            f"(operator: ({'-'.join(action)} ))\n(:state {state})\n"
            for (_, action), state in zip(walk, states[1:], strict=False)
        )
        (folder / "walk.traj").write_text(f"((:init {states[0]})\n{then})\n")
        observed.append(TrajectoryParser(known).parse_trajectory(folder / "walk.traj"))
    learned = SAMLearner(partial_domain=known).learn_action_model(observed)[0].to_pddl()
    return [_planned(learned, bits, *pair) for pair in problems]


def _planned(domain: str, bits: Sequence[str], start: Sequence[str], goal: Sequence[str]) -> list[str] | None:
    holds = " ".join(f"({fact.replace(' ', '-')})" for fact in start if fact in bits)
    wanted = " ".join(
        f"({bit.replace(' ', '-')})" if bit in goal else f"(not ({bit.replace(' ', '-')}))" for bit in bits
    )
    text = f"(define (problem p) (:domain bits) (:init {holds}) (:goal (and {wanted})))"
    problem = PDDLReader().parse_problem_string(domain, text)
    acting = [action for action in problem.actions if action.effects]  # Fast Downward takes no others
    problem.clear_actions()
    problem.add_actions(acting)
    with OneshotPlanner(name="fast-downward") as planner:
        found = planner.solve(problem)
    if found.status not in (
        PlanGenerationResultStatus.SOLVED_SATISFICING,
        PlanGenerationResultStatus.SOLVED_OPTIMALLY,
    ):
        return None
    return [step.action.name for step in found.plan.actions]


def _ours(
    folder: Path,
    learner: str,
    seed: int,
    bits: Sequence[str],
    problems: Sequence[tuple[Sequence[str], Sequence[str]]],
) -> list[list[str] | None]:
    """Compile the traces, with a network of its own or without, and plan with Fast Downward."""
    domain = folder / "domain"
    shutil.rmtree(domain, ignore_errors=True)
    neurosym("init", domain, "--data", folder / "traces.csv")
    origin = Interactions.load(domain / layout.INTERACTIONS).origin
    choices, names = origin["action_names"], origin["feature_names"]
    named = {bit.replace(" ", "-"): bit for bit in bits}
    if learner == "learned":
        bits = "--object-bits", 4, "--action-bits", (len(choices) - 1).bit_length()
        neurosym("train", domain, "--seed", seed, *bits)
        neurosym("distill", domain, "--seed", seed)
    neurosym("compile-domain", domain)
    planned = list[list[str] | None]()
    for number, (start, goal) in enumerate(problems):
        thing = {"name": "thing-01", "features": [float(named[name] in start) for name in names]}
        goals = {"thing-01": {name: float(named[name] in goal) for name in names}}
        scene = {
            "format": "neurosym-value-problem-1",
            "name": f"p{number}",
            "things": [thing],
            "goals": goals,
        }
        (folder / "p.scene.json").write_text(json.dumps(scene))
        neurosym("new-problem", domain, "--name", f"p{number}", "--scene", folder / "p.scene.json")
        neurosym("plan", domain, f"p{number}")
        planned.append(_steps(domain, f"p{number}", choices))
    return planned


def _steps(domain: Path, name: str, choices: Sequence[str]) -> list[str] | None:
    """Return the choices that a plan of ours makes; None if there is no plan."""
    folder, record = DomainFolder(domain), layout.plan_files(name, "fast-downward")[1]
    found, known = read_json(domain / record, PlanRecord), domain_of(folder)
    if not found.solved:
        return None
    actions = [known.primitive_of(known.operator_named(step[0])).action for step in found.steps]
    return [choices[int(np.argmax(action))].removeprefix("action=") for action in actions]


def summarise(found: Found) -> dict[str, Any]:
    """Gather shares of problems for each learner and number of traces, seed by seed."""
    summary = dict[str, Any]()
    for learner in LEARNERS:
        for count in TRACES:
            cells = [found[name] for name in found if name.startswith(f"{PREFIX}-{learner}-{count}-")]
            if not cells:
                continue
            told = {key: [one[key] / one["problems"] for one in cells] for key in ("solved", "false")}
            summary.setdefault(learner, {})[str(count)] = told
    return summary


def tables(summary: Mapping[str, Any]) -> str:
    """Write a row for each learner and number of traces."""
    rows = [
        [LEARNERS[learner], count, *(percent(mean_of(told[key])) for key in ("solved", "false"))]
        for learner, by_count in summary.items()
        for count, told in by_count.items()
    ]
    return table("learner | traces | solved | falsely planned", rows)
