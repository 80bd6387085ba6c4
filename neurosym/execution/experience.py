"""Experience: what each object of a scene was seen to do during a run, so that the next plan reckons with it.

A category is an average over objects. Once an object has been acted upon, more is known of it: the same
primitive will probably do the same to it again. So during a run an object that was acted upon becomes a
category of its own, whose operators promise what it was last seen to do. Its other outcomes are still hoped
for, with half the chance each time that they did not come.
"""

from dataclasses import dataclass, field

import msgspec

from neurosym.grounding import Grounding
from neurosym.operators import Mode, Operator, vector
from neurosym.pddl.moves import PUT_DOWN
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem, SceneObject
from neurosym.symbols import Symbol
from neurosym.world import Outcome, OutcomeKind

DOUBT = 0.5
"""What the chance of an outcome is multiplied by, each time that another came."""
_OF = "-of-"


@dataclass(slots=True)
class Experience:
    """What was seen of the objects of one problem.

    Attributes:
        grounding: What was learned of their categories.
    """

    grounding: Grounding
    _seen: dict[tuple[str, Symbol], list[Outcome]] = field(default_factory=dict)

    @property
    def says_something(self) -> bool:
        """Whether anything was seen."""
        return bool(self._seen)

    def learn(self, step: PlanStep, outcome: Outcome) -> None:
        """Remember what a step did.

        Args:
            step: The step, by its learned name.
            outcome: What happened.
        """
        primitive = self.grounding.operator_named(step.base).primitive
        self._seen.setdefault((step.object, primitive), []).append(outcome)

    def believed(self, problem: Problem) -> tuple[Problem, Grounding]:
        """Give objects that were acted upon a category of their own.

        Args:
            problem: The problem as it stands now.

        Returns:
            The problem with these categories, and the grounding that has them.
        """
        known = {name for name, _ in self._seen}
        objects, categories, operators = [], [], []
        for item in problem.objects:
            if item.name not in known:
                objects.append(item)
                continue
            own = f"{item.category}{_OF}{item.name}"
            learned = self.grounding.category(item.category)
            objects.append(msgspec.structs.replace(item, category=own))
            categories.append(
                msgspec.structs.replace(learned, symbol=own, name=learned.name + _OF + item.name)
            )
            operators += self._operators_of(item, own)
        table = self.grounding.operators
        table = msgspec.structs.replace(
            table,
            categories=(*table.categories, *categories),
            operators=(*table.operators, *operators),
        )
        return (
            msgspec.structs.replace(problem, objects=tuple(objects)),
            msgspec.structs.replace(self.grounding, operators=table),
        )

    def _operators_of(self, item: SceneObject, own: Symbol) -> list[Operator]:
        found = []
        for operator in self.grounding.operators.operators:
            if operator.category == item.category:
                outcomes = self._seen.get((item.name, operator.primitive), [])
                changed = _after(operator, outcomes) if outcomes else operator
                found.append(
                    msgspec.structs.replace(changed, name=f"{operator.name}{_OF}{item.name}", category=own)
                )
        return found


def learned_name(step: PlanStep) -> PlanStep:
    """Return a step of a plan for believed categories by the name of the operator that was learned."""
    return PlanStep(step.operator.removesuffix(_OF + step.object), step.object)


def believed_name(step: PlanStep, grounding: Grounding) -> PlanStep:
    """Return a step of a plan for learned categories by the name of the operator that is believed in.

    Args:
        step: The step.
        grounding: A grounding that `Experience.believed` returned.
    """
    own = step.operator + _OF + step.object
    names = {operator.name for operator in grounding.operators.operators}
    return PlanStep(own, step.object) if own.removeprefix(PUT_DOWN) in names else step


def _after(operator: Operator, outcomes: list[Outcome]) -> Operator:
    """Return an operator that promises what was seen last, or still hopes for what was not."""
    promise = operator.promise
    if promise is None:
        return operator
    same = [outcome for outcome in outcomes if outcome.kind == promise.kind]
    if outcomes[-1].kind == promise.kind:
        return _promising(operator, _seen_mode(promise.kind, operator.trials, same[-1]))
    chance = promise.near_mean / operator.trials * DOUBT ** (len(outcomes) - len(same))
    hoped = _seen_mode(promise.kind, operator.trials, same[-1]) if same else promise
    return _promising(operator, msgspec.structs.replace(hoped, near_mean=int(chance * operator.trials)))


def _promising(operator: Operator, mode: Mode) -> Operator:
    others = tuple(other for other in operator.modes if other.kind != mode.kind)
    return msgspec.structs.replace(operator, modes=(mode, *others), promised=mode.kind)


def _seen_mode(kind: OutcomeKind, trials: int, outcome: Outcome) -> Mode:
    nothing = (0.0, 0.0, 0.0)
    return Mode(
        kind=kind,
        count=trials,
        share=1.0,
        effect=vector(outcome.effect),
        spread=nothing,
        resting_effect=vector(outcome.resting_effect),
        resting_spread=nothing,
        peak_height=float(outcome.peak_height),
        near_mean=trials,
    )
