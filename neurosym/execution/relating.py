"""Relations while a plan runs: what is observed of pairs, what steps promised of them, and what was learned.

After each step the learned states of pairs say what bears what; the world tells which objects touch. What
failed with a pair twice in a row is not tried with it again, unless there is no plan without, and then twice
more. Another operator for the same is tried in its place.
"""

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.execution.record import StepRecord, named_positions
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.pair_states import describe_pair, extent
from neurosym.problems import Problem
from neurosym.related import Contacts, bearers_of, relating, with_contacts
from neurosym.relation_goals import RelationGoal, pair_key
from neurosym.relation_operators import PairState
from neurosym.table import OtherObject, Place
from neurosym.tasks.puts import put_named
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import understand
from neurosym.world import Outcome, Scene

GIVEN_UP, LAST_HOPE = 2, 4
"""After how many failures in a row an operator is not tried again with a pair; and if there is no plan
otherwise."""


@dataclass(slots=True)
class PairExperience:
    """What was seen of operators on pairs of objects.

    Attributes:
        grounding: What was learned of kinds of pairs.
        patience: After how many failures in a row an operator is not tried again with a pair.
    """

    grounding: Grounding
    patience: int = GIVEN_UP
    _kept: dict[tuple[str, str], list[bool]] = field(default_factory=dict)

    def learn(self, step: PlanStep, outcome: Outcome) -> None:
        """Remember whether a step on a pair did as promised.

        Args:
            step: The step.
            outcome: What happened.
        """
        put = put_named(step.operator, self.grounding)
        kept = put is not None and ended_in(outcome, self.grounding) == put.state
        self._kept.setdefault((pair_key(step.object, step.place), step.operator), []).append(kept)

    def hoping_again(self) -> "PairExperience":
        """Return the same with the patience for some more failures."""
        return PairExperience(self.grounding, LAST_HOPE, self._kept)

    def believed(self, problem: Problem) -> Problem:
        """Return a problem in which nothing is foreseen of what is given up.

        Args:
            problem: The problem.
        """
        most = self.patience
        lost = [key for key, kept in self._kept.items() if len(kept) >= most and not any(kept[-most:])]
        if not lost:
            return problem
        known = problem.foreseen if isinstance(problem.foreseen, dict) else {}
        foreseen = {pair: dict(shares) for pair, shares in known.items()}
        for pair, operator in lost:
            foreseen.setdefault(pair, {})[operator] = 0.0
        return msgspec.structs.replace(problem, foreseen=foreseen)


def prepared(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the kinds of its pairs, and with places that suit what bears what.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.
    """
    task = understand(problem, grounding)
    return msgspec.structs.replace(task.problem, places=task.flat.places)


def seen_now(problem: Problem, scene: Scene, contacts: Contacts | None) -> Problem:
    """Return a problem with its objects as they stand now, and what touches if that was seen.

    Args:
        problem: The problem.
        scene: Where everything is.
        contacts: Pairs of objects that touch; None where nobody saw it.
    """
    rows = zip(problem.objects, scene.positions, scene.orientations, strict=True)
    objects = tuple(
        msgspec.structs.replace(item, position=vector(position), orientation=tuple(orientation.tolist()))
        for item, position, orientation in rows
    )
    now = msgspec.structs.replace(problem, objects=objects)
    if contacts is None:
        return (
            now if problem.touching is msgspec.UNSET else msgspec.structs.replace(now, touching=msgspec.UNSET)
        )
    return with_contacts(now, contacts)


def ended_in(outcome: Outcome, grounding: Grounding) -> PairState | None:
    """Return the state that the target of an outcome ended in with its reference; None if it was not carried.

    Args:
        outcome: What happened.
        grounding: The learned domain.
    """
    if not (outcome.carried and isinstance(outcome.reference, OtherObject) and grounding.relations):
        return None
    described = describe_pair(outcome.end, outcome.target, outcome.reference.index, outcome.contacts)
    return grounding.relations.state_of(described.tolist())


def levelled(outcome: Outcome) -> Outcome:
    """Return an outcome as if what was carried to a place had stood on the table before.

    What carries to places promises nothing of heights; what was taken from another object comes down.

    Args:
        outcome: What happened.
    """
    if not (outcome.carried and isinstance(outcome.reference, Place)):
        return outcome
    positions = outcome.start.positions.copy()
    positions[outcome.target, 2] = extent(outcome.start, outcome.target)[2] / 2
    start = Scene(outcome.start.features, positions, outcome.start.orientations)
    return dataclasses.replace(outcome, start=start)


def record_put(step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome) -> StepRecord:
    """Record a step that was to put an object on or into another one.

    Args:
        step: The step.
        problem: The problem, whose objects are those of the outcome.
        grounding: What the operator promises.
        outcome: What happened.
    """
    put, state = put_named(step.operator, grounding), ended_in(outcome, grounding)
    target, other = outcome.target, problem.object_names.index(step.place)
    effect, promised = vector(outcome.resting_effect), None
    if outcome.carried:
        effect = vector(outcome.end.positions[target] - outcome.end.positions[other])
    if put:
        halves = (extent(outcome.end, target) + extent(outcome.end, other)) / 2
        promised = vector(np.array(put.end.offset) * halves)
    return StepRecord(
        operator=step.operator,
        object=step.object,
        promised="carried" if put else None,
        promised_effect=promised,
        happened=outcome.kind,
        effect=effect,
        deviation=_distance(effect, promised),
        as_promised=put is not None and outcome.kind == "carried" and state == put.state,
        positions=named_positions(problem, outcome.end),
        touched=tuple(problem.object_names[index] for index in outcome.touched),
        disturbed={problem.object_names[index]: how for index, how in outcome.disturbed},
        place=step.place,
        promised_state=put.state.name if put else msgspec.UNSET,
        state=state.name if state else msgspec.UNSET,
    )


def with_relations(
    record: StepRecord, problem: Problem, grounding: Grounding, outcome: Outcome
) -> StepRecord:
    """Return the record of a step that says what bears what after it.

    Args:
        record: The record.
        problem: The problem.
        grounding: The learned domain; if it knows no relations, the record stays as it is.
        outcome: What happened.
    """
    if grounding.relations is None or not (problem.related or relating(record.operator, grounding)):
        return record
    bearers = bearers_of(seen_now(problem, outcome.end, outcome.contacts), grounding.relations)
    told = {name: f"{borne.state.name} {borne.by}" for name, borne in bearers.items()}
    return msgspec.structs.replace(record, relations=told)


def missed_relations(
    unmet: Sequence[RelationGoal], records: Sequence[StepRecord], grounding: Grounding
) -> str:
    """Say which relations are missed in the end, and in which step one that held came to an end.

    Args:
        unmet: The goals by relation that are not met.
        records: The steps.
        grounding: The learned domain.
    """
    said = []
    for target, reference, name in unmet:
        wanted = f"{_name(name, grounding)} {reference}"
        now = _told(records[-1].relations).get(target, "borne by nothing") if records else "where it was"
        said.append(f"{target} is {now}, not {wanted}{_ended_in_step(target, wanted, records)}")
    return ", ".join(said)


def _ended_in_step(target: str, wanted: str, records: Sequence[StepRecord]) -> str:
    held = [_told(record.relations).get(target) == wanted for record in records]
    if not any(held) or held[-1]:
        return ""
    number = len(held) - held[::-1].index(True) + 1
    return f" as after step {number - 1}: that ended in step {number}"


def _told(relations: Mapping[str, str] | msgspec.UnsetType) -> Mapping[str, str]:
    return relations if isinstance(relations, dict) else {}


def _name(state: str, grounding: Grounding) -> str:
    return grounding.relations.state_named(state).name if grounding.relations else state


def _distance(one: Vector, other: Vector | None) -> float | None:
    return None if other is None else math.dist(one, other)
