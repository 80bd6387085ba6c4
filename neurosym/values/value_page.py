"""The page of a domain of values: one lifted domain of positive STRIPS, and its problems.

`act` performs an operator on a thing that is of its category in the state it is in. Then each axis in turn
moves by as many cells, or to the one, that the operator says. So nothing is grounded over all axes at once.
"""

import textwrap
from collections.abc import Iterable, Iterator, Sequence

from neurosym.data.category_names import traits_of
from neurosym.data.cells import Cells
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import Symbol
from neurosym.pddl.movement import Along, movement_actions, movement_predicates, sums
from neurosym.pddl.strips import WIDTH
from neurosym.pddl.syntax import OBJECT, Atom, Domain, Facts, PddlProblem, Typed, actions_in, predicates_in
from neurosym.tasks.transition import PlanStep
from neurosym.values.domain import ValueDomain, ValueOperator
from neurosym.values.problem import Cell, Thing, ValueTask


def _along(domain: ValueDomain) -> tuple[Along, ...]:
    """Return the axes as the page has them."""
    names = (axis.name for axis in domain.axes)
    return tuple(Along(one, f"?{one}-cell", f"?{one}-to", f"?{one}-step", f"{one}-step") for one in names)


def value_page(domain: ValueDomain) -> Domain:
    """Return the page of a learned domain of values."""
    axes = _along(domain)
    shown = domain.of_shown(axes)
    types = {"?o": "thing", "?do": "operator", "?k": "category", "?c": "price"}
    types |= {variable: kind for axis in axes for variable, kind in axis.types.items()}
    here, steps = " ".join(one.cell for one in shown), " ".join(one.step for one in axes)
    at_here = _each(shown, "(at-{name} ?o {cell})")
    predicates = f"""
        (ready) ; no operator is under way
        (is-then ?o {here} ?k) ; the category of ?o in that state
        (does ?do ?k {steps} ?c) ; by how far, and its price
        {_each(axes, "(at-{name} ?o {cell}) ; the {name} of ?o is in that cell")}
        {movement_predicates(axes)}
        {_each(axes, "(goal-{name} ?o {cell}) ; that cell meets its goal")}
        {_each(axes, "(done-{name} ?o) ; it was noted to meet its goal")}
    """
    reach = """
        (reach-{name} ?o {cell}) ; note that {name} meets the goal of ?o
            needs (ready) (at-{name} ?o {cell}) (goal-{name} ?o {cell})
            adds (done-{name} ?o)
    """
    actions = f"""
        (act ?o ?do ?k {here} {steps} ?c) ; perform an operator on ?o, which is of its category here
            needs (ready) (is-then ?o {here} ?k) {at_here} (does ?do ?k {steps} ?c)
            adds {_each(axes, "(due-{name} ?o {step})")}
            deletes (ready) {_each(axes, "(done-{name} ?o)")}
            costs (cost ?c)
        {movement_actions(axes)}
        {_each(axes, reach)}
    """
    return Domain(
        name=domain.name,
        head=tuple(_head(domain)),
        types=(
            *((one, OBJECT) for one in ("thing", "category", "operator", "price")),
            *((kind, OBJECT) for axis in axes for kind in (f"{axis.name}-cell", axis.steps)),
        ),
        constants=(),
        predicates=predicates_in(predicates, types),
        costs=predicates_in("(cost ?c)", types),
        actions=actions_in(actions, types),
    )


def _each(axes: Iterable[Along], text: str) -> str:
    """Write the same of each axis."""
    return "\n".join(text.format(**axis._asdict()) for axis in axes)


def _head(domain: ValueDomain) -> Iterator[str]:
    yield f"Learned domain {domain.name}. Printed by neurosym; do not edit."
    yield "What goes as promised with chance p costs 1 + round(-100 ln p), by rows of the data."
    for cells in domain.cells:
        yield f"{cells.axis.name} ({cells.axis.kind}): {cells}"
    traits = traits_of(domain.categories, domain.features)
    for category in domain.categories:
        pairs = zip(domain.features, category.feature_means, strict=False)
        means = ", ".join(f"{name} {mean:.3g}" for name, mean in pairs)
        apart = ", ".join(map(str, traits.get(category.symbol, ())))
        said = f"{apart}; on average {means}" if apart else means or "never seen"
        yield from textwrap.wrap(f"{category.name}: {said}", WIDTH, break_on_hyphens=False)
    for one in domain.operators:
        yield f"{one.name}: {domain.in_words(one)}, {one.chance:.0%}"


def value_problem(task: ValueTask) -> PddlProblem:
    """Return the printed problem of a task."""
    problem, domain = task.problem, task.domain
    met = {symbol for known in task.categories.values() for symbol in known}
    offered = [one for one in domain.operators if one.category in met]
    acted = sorted({one.category for one in offered})
    prices = sorted({one.cost for one in offered})
    objects: list[Typed] = [(thing.name, "thing") for thing in problem.things]
    objects += [(domain.category(symbol).name, "category") for symbol in acted]
    objects += [(one.name, "operator") for one in offered]
    leads = list[Facts]()
    for number, cells in enumerate(domain.cells):
        name, steps = cells.axis.name, {one.outcome.steps[number] for one in offered}
        named = sorted((cells.step_name(step), step) for step in steps)
        told = (atom for step_name, step in named for atom in sums(cells, step, step_name))
        leads.append(Facts(f"where steps of {name} lead", tuple(told)))
        objects += [(cell, f"{name}-cell") for cell in cells.names]
        objects += [(step_name, f"{name}-step") for step_name, _ in named]
    return PddlProblem(
        name=problem.name,
        domain=domain.name,
        head=(
            f"Problem {problem.name} of the learned domain {domain.name}.",
            f"How it came about: {' '.join(problem.provenance.split())}.",
        ),
        objects=(*objects, *((f"cost{price}", "price") for price in prices)),
        facts=(
            Facts("", (("ready",),)),
            *(one for thing in problem.things for one in _of_thing(task, thing, acted)),
            Facts("what operators do", tuple(_does(domain, one) for one in offered)),
            *leads,
            Facts("what meets goals", tuple(_meets(task))),
        ),
        costs={("cost", f"cost{price}"): price for price in prices},
        goals=tuple((f"done-{domain.axes[number].name}", thing) for thing, number in task.goals),
    )


def _of_thing(task: ValueTask, thing: Thing, acted: Sequence[Symbol]) -> Iterator[Facts]:
    """Say where a thing is, and its category in each state in which something can be done with it."""
    domain, here = task.domain, task.start[thing.name]
    at = zip(domain.cells, here, strict=True)
    begin = tuple((f"at-{cells.axis.name}", thing.name, cells.name(number)) for cells, number in at)
    yield Facts(f"{thing.name} at the start", begin)
    kinds = zip(domain.states(), task.categories[thing.name], strict=True)
    then = tuple(
        ("is-then", thing.name, *_named(domain.shown_cells, state), domain.category(symbol).name)
        for state, symbol in kinds
        if symbol in acted
    )
    yield Facts("its category in each state", then)


def _does(domain: ValueDomain, one: ValueOperator) -> Atom:
    return ("does", one.name, domain.category(one.category).name, *_steps(domain, one), f"cost{one.cost}")


def _steps(domain: ValueDomain, operator: ValueOperator) -> Iterator[str]:
    """Name the step of an operator along each axis."""
    along = zip(domain.cells, operator.outcome.steps, strict=True)
    return (cells.step_name(step) for cells, step in along)


def _meets(task: ValueTask) -> Iterator[Atom]:
    for (thing, number), meeting in task.goals.items():
        cells = task.domain.cells[number]
        yield from ((f"goal-{cells.axis.name}", thing, cells.name(one)) for one in meeting)


def _named(cells: Sequence[Cells], state: Cell) -> Iterator[str]:
    return (one.name(here) for one, here in zip(cells, state, strict=True))


def written(steps: Sequence[PlanStep], task: ValueTask) -> tuple[Atom, ...]:
    """Write a plan as ground actions of the page; `InvalidValue` if it is none."""
    domain, found, states = task.domain, list[Atom](), dict(task.start)
    if said := task.replay(steps)[1]:
        raise InvalidValue(f"It is no plan: {said}.")
    for step in steps:
        operator, here = domain.operator_named(step.operator), states[step.object]
        states[step.object] = there = task.apply(here, operator) or ()
        done = [*_steps(domain, operator)]
        shown = _named(domain.shown_cells, domain.of_shown(here))
        kind = domain.category(operator.category).name
        found.append(("act", step.object, operator.name, kind, *shown, *done, f"cost{operator.cost}"))
        for cells, name, one, other in zip(domain.cells, done, here, there, strict=True):
            found.append((f"move-{cells.axis.name}", step.object, name, cells.name(one), cells.name(other)))
    for thing, number in task.goals:
        cells = domain.cells[number]
        found.append((f"reach-{cells.axis.name}", thing, cells.name(states[thing][number])))
    return tuple(found)


def known_words(task: ValueTask) -> set[str]:
    """Name the actions of the page, the operators and the things, by which a line is known for a step."""
    names = {action.name for action in value_page(task.domain).actions}
    return {*names, *(one.name for one in task.domain.operators), *task.start}


def check_actions(actions: Sequence[Atom], task: ValueTask) -> None:
    """Raise `UnknownChoice` if there is an action that is neither of the page nor a step in short."""
    page = {action.name for action in value_page(task.domain).actions}
    for words in actions:
        if words[0] not in page:
            task.domain.operator_named(words[0])
        elif words[0] == "act" and len(words) > 2:
            task.domain.operator_named(words[2])
        if len(words) > 1 and words[1] not in task.start:
            raise UnknownChoice("thing", words[1], task.start)


def read_steps(actions: Sequence[Atom], domain: ValueDomain) -> tuple[PlanStep, ...]:
    """Read ground actions of the page as steps; what else they say, the replay knows.

    In short, a step is the operator and the thing.
    """
    names = {one.name for one in domain.operators}
    page = (
        words[1:] if words[0] == "act" else (words[1:2] + words[:1]) * (words[0] in names)
        for words in actions
    )
    return tuple(PlanStep(words[1], words[0]) for words in page if len(words) > 1)
