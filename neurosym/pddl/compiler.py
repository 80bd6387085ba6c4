"""The compiler: from the table of operators to a grounding, whose names PDDL can take."""

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain

import msgspec

from neurosym.checks import check_kind, check_length
from neurosym.choices import CELL as CELL
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import FORMAT, FORMAT_WITH_PLACES, FORMAT_WITH_RELATIONS, Grounding
from neurosym.operators import MIN_CHANCE, OperatorTable, counted_axes, name_operator
from neurosym.pair_operators import PlaceOperators, RelationOperators
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_domain, numeric_problem, read_numeric, write_numeric
from neurosym.pddl.strips import WORDS, page
from neurosym.pddl.strips_plan import GroundPlan as GroundPlan
from neurosym.pddl.strips_plan import led_by, led_in, read, write
from neurosym.pddl.strips_problem import STEPS, StripsProblem
from neurosym.pddl.syntax import ENCODINGS, FORMER, NUMERIC, STRIPS, Atom, Domain, EncodingName, PddlProblem
from neurosym.problems import LEGAL_NAME, SPOT, Problem, SceneObject
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep
from neurosym.world import Table

MAX_CELLS = 5000
RESERVED_PREFIXES = ("finish-", "put-down-", "reach-", "move-", "a-")
"""What no operator's name begins with: steps and plans of earlier versions use it otherwise."""


def compile_domain(
    table: OperatorTable,
    *,
    name: str,
    table_bounds: Table,
    lift_height: float,
    cell: float = CELL,
    places: PlaceOperators | None = None,
    relations: RelationOperators | None = None,
) -> Grounding:
    """Turn a table of operators into everything that planning needs, an operator for each outcome.

    Args:
        table: What each primitive does to each category.
        name: Name of the domain, that of the world.
        table_bounds: Where objects may stand.
        lift_height: How far the hand rises after the last waypoint [m].
        cell: Edge of a grid cell [m].
        places: What carries objects of the same categories to places, if that was learned.
        relations: What puts objects in relations to one another, if that was learned.

    Raises:
        InvalidValue: If effects are not along x, y and z, the cell is no sensible size, or a name is not
            legal, taken, or reserved.
    """
    check_kind("table", table, OperatorTable, "an OperatorTable, as tabulate returns it")
    check_kind("name", name, str, "a PDDL name")
    check_kind("table_bounds", table_bounds, Table, "a Table")
    check_length("lift_height", lift_height)
    check_length("cell", cell)
    check_axes(table)
    widest = max(high - low for low, high in (table_bounds.x, table_bounds.y))
    if not (math.isfinite(cell) and widest / MAX_CELLS <= cell <= widest):
        raise InvalidValue(f"A cell of {cell} m will not do; valid: {widest / MAX_CELLS:g} to {widest:g} m.")
    expanded = with_every_outcome(table)
    categories = [category.name for category in table.categories]
    operators = [operator.name for operator in expanded.operators]
    carriers = [operator.name for operator in places.operators.operators] if places else []
    related = [one.name for one in relations.states] if relations else []
    related += [one.name for one in relations.operators] if relations else []
    _check_names([name, *WORDS, *categories, *operators, *carriers, *related])
    if taken := [operator for operator in operators if operator.startswith(RESERVED_PREFIXES)]:
        raise InvalidValue(
            f"No operator can be called {taken[0]}; {', '.join(RESERVED_PREFIXES)} are reserved."
        )
    return Grounding(
        format=FORMAT_WITH_RELATIONS if relations else FORMAT_WITH_PLACES if places else FORMAT,
        name=name,
        cell=cell,
        table=table_bounds,
        lift_height=lift_height,
        operators=expanded,
        places=_with_objects(places) if places else None,
        relations=relations,
    )


def with_every_outcome(table: OperatorTable) -> OperatorTable:
    """Add to each operator those that promise its other outcomes, at rest or held.

    A primitive that lifts two objects of a category out of three leaves the third where it is, and a planner
    may want either. So each outcome that is seen often enough becomes an operator of its own, at a cost that
    says how rare it is: the all-outcomes determinisation of FF-Replan (Yoon, Fern and Givan, 2007). Execution
    sees what really happens, and replans if it was another.

    Args:
        table: A table whose operators promise what is most frequent.
    """
    names = {category.symbol: category.name for category in table.categories}
    operators = [
        msgspec.structs.replace(
            operator,
            name=name_operator(operator.label, names[operator.category], [mode]),
            promised=mode.kind,
        )
        for operator in table.operators
        for mode in operator.modes
        if mode is not operator.promise and mode.kind in ("resting", "held") and mode.share >= MIN_CHANCE
    ]
    return msgspec.structs.replace(table, operators=(*table.operators, *operators))


def _with_objects(places: PlaceOperators) -> PlaceOperators:
    """Keep with each operator the objects that it was rehearsed on: its category may have had others."""
    rehearsed = {one.symbol: one.objects for one in places.operators.categories}
    operators = tuple(
        msgspec.structs.replace(one, objects=one.objects or rehearsed.get(one.category, ()))
        for one in places.operators.operators
    )
    return msgspec.structs.replace(
        places, operators=msgspec.structs.replace(places.operators, operators=operators)
    )


def check_axes(table: OperatorTable) -> None:
    """Raise `InvalidValue` unless effects are displacements along x, y and z."""
    if table.axes != 3:
        raise InvalidValue(
            f"The table of operators has effects of {counted_axes(table.axes)}; "
            "a PDDL domain needs 3: x, y and z [m]."
        )


def _check_names(names: Iterable[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if not LEGAL_NAME.fullmatch(name):
            raise InvalidValue(
                f"{name!r} is not a legal PDDL name; valid: a lower-case letter, then a-z, 0-9 and hyphens."
            )
        if name in seen:
            raise InvalidValue(f"Two parts of the domain are called {name}; each needs a name of its own.")
        seen.add(name)


# The encodings: how a domain, its problems and plans are written, and how plans are read back.
#
# A problem is printed before anybody plans. Goal regions leave out the edge of what the tolerance allows,
# since grids round, and only some places are drawn. So the exact replay may take a plan that ends a cell
# beside the region, or that uses a spot of the table that has no name yet. Such a plan says which facts it
# needs; the problem beside it is then printed with them, and any validator takes the two together.

Plan = tuple[PlanStep, ...]


@dataclass(frozen=True, slots=True)
class Encoding:
    """How domains, problems and plans are written.

    Attributes:
        name: What it is called.
        domain: Writes a learned domain.
        problem: Writes a task, such that some plans are plans of it; takes off its goal regions what the
            rounding of so many steps may take.
        write: Writes a plan of a task as ground actions.
        read: Reads ground actions as a plan.
    """

    name: EncodingName
    domain: Callable[[Grounding], Domain]
    problem: Callable[[Task, Sequence[GroundPlan], int], PddlProblem]
    write: Callable[[Plan, Task], GroundPlan]
    read: Callable[[Sequence[Atom], Task], Plan]


def encoding_named(name: str) -> Encoding:
    """Return an encoding that is printed, or refuse one that earlier versions had, or that there is not."""
    check_former(name)
    if name not in _VALUES:
        raise UnknownChoice("encoding", name, ENCODINGS)
    return _VALUES[name]


def check_former(encoding: str) -> None:
    """Raise `InvalidValue` if earlier versions had an encoding, and it is gone.

    Args:
        encoding: Its name.
    """
    if encoding in FORMER:
        raise InvalidValue(
            f"The encoding {encoding} is gone: one page, {STRIPS!r}, says what it said; valid: "
            f"{', '.join(ENCODINGS)}."
        )


def domain_text(grounding: Grounding, encoding: EncodingName = STRIPS, *, costs: bool = True) -> str:
    """Print the domain; equal groundings give equal bytes.

    Args:
        grounding: The learned domain.
        encoding: `strips` for the page, or `numeric` for planners that take numbers.
        costs: Whether what steps cost is printed; some planners take no costs.

    Raises:
        UnknownChoice: If there is no such encoding.
    """
    return encoding_named(encoding).domain(grounding).text(costs=costs)


def ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: EncodingName = STRIPS
) -> GroundPlan:
    """Turn a plan into ground actions of the domain, cells and all, such that plan validators take it.

    Args:
        steps: The plan; every operator in it must be in the domain.
        problem: The problem it solves.
        grounding: The learned domain.
        encoding: `numeric`, or else the page.

    Raises:
        InvalidValue: If an operator is not in the domain, or not for its object, or leads off the grid.
    """
    return _VALUES.get(encoding, PAGE).write(tuple(steps), understand(problem, grounding))


def _page_problem(task: Task, plans: Sequence[GroundPlan], steps: int) -> PddlProblem:
    led = {name for plan in plans for name in plan.led}
    printed = StripsProblem(
        task,
        led=[name for name in task.names if name in led or name in task.led],
        kept=[move for plan in plans for move in plan.moves],
        steps=steps,
    )
    facts = sorted(fact for plan in plans for fact in plan.facts)
    return printed.data(facts, sorted({spot for plan in plans for spot in plan.spots}))


def _page_plan(steps: Plan, task: Task) -> GroundPlan:
    return write(steps, StripsProblem(task, led=led_by(steps, task)))


def _read_page(actions: Sequence[Atom], task: Task) -> Plan:
    return read(actions, StripsProblem(task, led=led_in(actions, task), every=True))


def _numeric_problem(task: Task, plans: Sequence[GroundPlan], steps: int) -> PddlProblem:
    del plans  # their regions leave out no more than what numbers round
    return numeric_problem(task, steps=steps * NUMERIC_STEPS)


def _numeric_plan(steps: Plan, task: Task) -> GroundPlan:
    return GroundPlan(NUMERIC, tuple(write_numeric(steps, task)))


PAGE = Encoding(STRIPS, page, _page_problem, _page_plan, _read_page)
NUMBERS = Encoding(NUMERIC, numeric_domain, _numeric_problem, _numeric_plan, read_numeric)
_VALUES: Mapping[str, Encoding] = {one.name: one for one in (PAGE, NUMBERS)}


# Printing a problem as PDDL, and which names its objects may have

_PARTICULAR = r"[xy]\d*|d[xy](-?\d+)?|cost\d+|way\d+|m-[01]+[a-z]*(-.*)?"
"""What problems call cells, steps, prices, ways and motions."""
_OF_PLACES = rf"(start|goal|park)-.*|n\d+|{SPOT.pattern}"


def problem_text(
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName = STRIPS,
    *,
    steps: int = STEPS,
    plans: Sequence[GroundPlan] = (),
    costs: bool = True,
) -> str:
    """Print a problem.

    Args:
        problem: The problem.
        grounding: The learned domain.
        encoding: The encoding of the domain it is for.
        steps: How many steps the rounding of is taken off the goal regions; in numbers ten times as many.
        plans: Plans that the replay takes, and that stand beside the problem: it is printed such that they
            are its plans.
        costs: Whether what steps cost is printed; some planners take no costs.

    Raises:
        InvalidValue: If an object stands off the table, its name means something else in the domain, or the
            domain knows nothing of relations and the problem asks for some.
        UnknownChoice: If an object is of a category that the domain does not have, or there is no such
            encoding.
    """
    written = encoding_named(encoding)
    for item in problem.objects:
        check_object(item, grounding)
    return written.problem(understand(problem, grounding), plans, steps).text(costs=costs)


def check_object(item: SceneObject, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless an object stands on the table and its name is free in the domain."""
    grounding.category(item.category)
    check_on_table(item, grounding)
    by_name = grounding.places or grounding.relations
    if is_taken(item.name, grounding) or (by_name and re.fullmatch(_OF_PLACES, item.name)):
        raise InvalidValue(f"No object can be called {item.name}, the domain uses that; try item-01.")


def is_taken(name: str, grounding: Grounding) -> bool:
    """Say whether the domain itself uses a name, so that no object or place of a problem can have it."""
    return name in _known_words(grounding) or bool(re.fullmatch(_PARTICULAR, name))


@lru_cache(maxsize=8)
def _known_words(grounding: Grounding) -> frozenset[str]:
    """List what the page calls its types, actions and constants."""
    domain = page(grounding)
    names = [name for name, _ in (*domain.types, *domain.constants)]
    return frozenset(["object", *names, *(action.name for action in domain.actions)])


# Reading the text of a printed domain and problem, and what of the two a plan touches.
#
# Other people's validators read PDDL slowly: a grid with its thousands of facts takes them many seconds.
# But whether a plan is valid depends on its own actions alone, and on facts whose words occur in these, in
# its steps or in the goal. So a validator may be given only those, and what it says is true of the whole.
# Where conditions speak of all objects (`exists`), every fact is kept.

Tree = list["Tree | str"]
"""A text in parentheses: words and trees."""
Action = tuple[str, ...]
"""A ground action: its name, and its arguments."""
_TOKEN = re.compile(r"[()]|[^\s()]+")
_COMMENT = re.compile(r";[^\n]*")
_QUANTIFIED = ("exists", "forall")


@dataclass(frozen=True, slots=True)
class Excerpt:
    """What of a domain and a problem a plan touches, as PDDL."""

    domain: str
    problem: str


def excerpt_for(domain: str, problem: str, actions: Sequence[Action]) -> Excerpt:
    """Leave out of a domain and a problem what cannot matter to a plan.

    Args:
        domain: The text of the domain.
        problem: The text of the problem.
        actions: The plan.

    Raises:
        InvalidValue: If a text is no PDDL.
    """
    parts, task = tree_of(domain), tree_of(problem)
    names = {action[0] for action in actions}
    first = next((str(part[1]) for part in parts if _head(part) == ":action"), "")
    names = names or {first}  # readers trip over no action
    kept = [part for part in parts if _head(part) != ":action" or part[1] in names]
    words = {word for action in actions for word in action}
    words |= {word for part in kept if _head(part) == ":action" for word in _words(part)}
    words |= {word for part in task if _head(part) in (":goal", ":metric") for word in _words(part)}
    if words.isdisjoint(_QUANTIFIED):
        kept, task = ([_narrowed(part, words) for part in text] for text in (kept, task))
    return Excerpt(_text(kept), _text(task))


def parameters_of(domain: str) -> Mapping[str, int]:
    """Return how many parameters each action of a domain has, by name.

    Args:
        domain: The text of the domain.

    Raises:
        InvalidValue: If it is no PDDL.
    """
    found = dict[str, int]()
    for part in tree_of(domain):
        if _head(part) == ":action":
            fields = list(part[2:])
            declared = fields[fields.index(":parameters") + 1] if ":parameters" in fields else ()
            found[str(part[1])] = sum(str(word).startswith("?") for word in declared)
    return found


def tree_of(text: str) -> Tree:
    """Read a text in parentheses.

    Args:
        text: The text, whose comments are left out.

    Raises:
        InvalidValue: If parentheses do not fit.
    """
    open_trees: list[Tree] = [[]]
    for token in _TOKEN.findall(_COMMENT.sub("", text).lower()):
        if token == "(":
            open_trees.append([])
        elif token == ")" and len(open_trees) > 1:
            closed = open_trees.pop()
            open_trees[-1].append(closed)
        else:
            open_trees[-1].append(token)
    if len(open_trees) != 1 or len(open_trees[0]) != 1 or isinstance(open_trees[0][0], str):
        raise InvalidValue("The text is no PDDL: its parentheses do not fit together.")
    return open_trees[0][0]


def _head(part: "Tree | str") -> "Tree | str":
    return part[0] if part and not isinstance(part, str) else part


def _words(part: "Tree | str") -> Iterable[str]:
    return [part] if isinstance(part, str) else chain.from_iterable(map(_words, part))


def _narrowed(part: "Tree | str", words: set[str]) -> "Tree | str":
    """Keep what occurs of the facts and values at the start, and of what is declared."""
    if _head(part) == ":init":  # of a value, what it is given to counts
        subjects = [(fact, fact[1] if _head(fact) == "=" else fact) for fact in part[1:]]
        return [":init", *(fact for fact, about in subjects if words.issuperset(_words(about)))]
    if _head(part) in (":objects", ":constants", ":functions", ":predicates"):
        return [_head(part), *_declared(list(part[1:]), words)]
    return part


def _declared(declared: Tree, words: set[str]) -> Tree:
    """Keep what occurs of the names that are declared, each group of them with its type."""
    rest = iter(declared)
    kept: Tree = []
    names: Tree = []
    for one in rest:
        if one == "-":
            kind = next(rest, "object")
            kept += [*names, "-", kind] if names else []
            names = []
        elif _head(one) in words:
            names.append(one)
    return [*kept, *names]


def _text(part: "Tree | str") -> str:
    return part if isinstance(part, str) else f"({' '.join(map(_text, part))})"
