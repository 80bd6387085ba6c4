"""The stage that compiles a domain: it prints the domain as PDDL, and its problems anew."""

from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from functools import partial

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, quoted
from neurosym.files import MOST_JSON, digest, make_folder, read_bytes, read_text, remove, write_atomically
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable, Versioned
from neurosym.pair_operators import PlaceOperators, RelationOperators
from neurosym.pddl.compiler import (
    GroundPlan,
    check_axes,
    check_object,
    compile_domain,
    domain_text,
    problem_text,
)
from neurosym.pddl.durative import durative_domain_text, durative_problem_text
from neurosym.pddl.syntax import NUMERIC, STRIPS, EncodingName
from neurosym.problems import Problem
from neurosym.regression import save_fits
from neurosym.stages.folder import Claim, DomainFolder, Stage, load_scene
from neurosym.stages.layout import (
    DOMAIN,
    DURATIVE,
    DURATIVE_DOMAIN,
    FORMER,
    FORMER_DOMAINS,
    GROUNDING,
    NUMERIC_DOMAIN,
    NUMERIC_PDDL,
    PDDL,
    PLACE_OPERATORS,
    PLAIN,
    PLAIN_DOMAIN,
    PRACTICE,
    PRIMITIVES,
    PROBLEMS,
    RELATION_OPERATORS,
    SCENE,
    TABLE_FILES,
    WORLD,
    printed_file,
    problem_file,
    scene_file,
)
from neurosym.stages.plan_records import recorded_plans
from neurosym.stages.rounds import Practised
from neurosym.tasks.promises import fits_of
from neurosym.tasks.supports import is_relational
from neurosym.tasks.task import understand
from neurosym.worlds.world_file import read_world

FORMAT = "neurosym-practice-1"


class PracticeFile(Versioned, frozen=True):
    """What was practised.

    Attributes:
        format: Version of this file.
        of: SHA-256 of the `primitives.json` that practice began with.
        seed: Where its draws started.
        evenly: Whether all operators were rehearsed in turn instead.
        practised: The operators that it came to, and the rounds.
    """

    format: str
    of: str
    seed: int
    evenly: bool
    practised: Practised
    readable = (FORMAT,)


def practice_of(folder: DomainFolder) -> PracticeFile | None:
    """Return what was practised with the operators that the folder has; None if nothing was.

    Raises:
        InvalidFile: If the file is none.
    """
    path = folder / PRACTICE
    if not (path.is_file() and (folder / PRIMITIVES).is_file()):
        return None
    remedy = "; remove it to go back to what was distilled"
    found = PracticeFile.decoded(path, read_bytes(path, MOST_JSON), remedy)
    return found if found.of == digest(folder / PRIMITIVES) else None


def operator_table(folder: DomainFolder) -> OperatorTable:
    """Read the operators as they are now: after practice, those that it came to.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file is none, or of another version.
    """
    distilled = OperatorTable.load(folder.require(PRIMITIVES))
    found = practice_of(folder)
    return found.practised.table if found else distilled


# What a domain folder holds for other planners: the page without costs, and with durative actions.
#
# No command reads these files, so no stage is out of date for want of them.


@dataclass(frozen=True)
class _Form:
    """One more way to print a domain: its file, what those of problems end with, and what prints them."""

    domain: str
    ending: str
    domain_text: Callable[[Grounding], str]
    problem_text: Callable[[Problem, Grounding], str]

    def is_there(self, folder: DomainFolder, wanted: Collection[str]) -> bool:
        """Say whether the domain is to be printed so: it is asked for now, or was before."""
        return self.domain in wanted or (folder / self.domain).exists()


_FORMS = (
    _Form(PLAIN_DOMAIN, PLAIN, partial(domain_text, costs=False), partial(problem_text, costs=False)),
    _Form(DURATIVE_DOMAIN, DURATIVE, durative_domain_text, durative_problem_text),
)


def print_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, wanted: Collection[str] = ()
) -> None:
    """Print a problem for other planners, in every way, such that plans beside it stay plans.

    Domains that are `wanted` are about to be there.
    """
    problem, name = _placed(problem, grounding), problem.name
    printed = texts_of(problem, grounding, recorded_plans(folder, problem, grounding))
    for form in _FORMS:
        if form.is_there(folder, wanted):
            with suppress(InvalidValue):  # an object cannot be carried to its goal
                printed[problem_file(name, form.ending)] = form.problem_text(problem, grounding)
    for file, text in sorted(printed.items()):
        write_atomically(folder / file, text)
    for ending in (PDDL, NUMERIC_PDDL, PLAIN, DURATIVE, *FORMER):
        if (file := problem_file(name, ending)) not in printed and (folder / file).exists():
            remove(folder / file)  # a former problem of that name was printed so


def put_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Write a problem that was made just now, printed and as we read it."""
    make_folder(folder / PROBLEMS)
    print_problem(folder, problem, grounding)
    problem.save(folder / scene_file(problem.name))


def print_beside(
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName,
    plans: Sequence[GroundPlan],
    planner: str,
) -> None:
    """Print a problem anew where it is missing, or lacks what plans beside it need.

    `plans` are what a planner found just now, maybe in another encoding than the one that was planned in.
    """
    wanted: dict[str, EncodingName] = {
        printed_file(problem.name, plan.encoding): plan.encoding for plan in plans
    }
    if not plans and not is_relational(problem, grounding):
        wanted = {printed_file(problem.name, encoding): encoding}
    lacking = [
        file
        for file in wanted
        if not (path := folder / file).is_file()
        or any(plan.missing(read_text(path)) for plan in _beside(file, problem, plans))
    ]
    if not lacking:
        return
    problem = _placed(problem, grounding)
    recorded = recorded_plans(folder, problem, grounding)
    every = (*plans, *recorded_plans(folder, problem, grounding, besides=planner))
    for file in sorted(lacking):
        path, print_with = folder / file, partial(problem_text, problem, grounding, wanted[file])
        ours = (print_with(plans=known) for known in ((), _beside(file, problem, recorded)))
        if path.is_file() and read_text(path) not in ours:
            folder.notify(f"{path} is not as it was printed, so it stays; the plan may be none of it")
        else:
            write_atomically(path, print_with(plans=_beside(file, problem, every)))


def _beside(file: str, problem: Problem, plans: Iterable[GroundPlan]) -> list[GroundPlan]:
    """Keep the plans whose problem is printed into a file."""
    return [plan for plan in plans if printed_file(problem.name, plan.encoding) == file]


def _placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it."""
    for item in problem.objects:
        check_object(item, grounding)
    return msgspec.structs.replace(problem, places=understand(problem, grounding).flat.places)


def texts_of(problem: Problem, grounding: Grounding, plans: Sequence[GroundPlan] = ()) -> dict[str, str]:
    """Print a problem in each way, by file; one of relations has none in numbers.

    The problem has its places.
    """
    encodings = [STRIPS, *([] if understand(problem, grounding).relates else [NUMERIC])]
    files = {printed_file(problem.name, each): each for each in encodings}
    return {
        file: problem_text(problem, grounding, each, plans=_beside(file, problem, plans))
        for file, each in files.items()
    }


def compile_stage(
    folder: DomainFolder,
    *,
    cell: float,
    name: str | None = None,
    with_places: bool | None = None,
    with_relations: bool | None = None,
    durative: bool = False,
    plain: bool = False,
) -> Stage:
    """Compile the domain: `primitives.json` -> `domain.pddl`, the same in numbers, and `grounding.json`.

    After practice, the operators are those in `practice.json`. What carries objects to places stands in
    `places/operators.json`, if it was learned, or will be by then; what puts them on and into one another in
    `relations/operators.json`.
    Problems that are there already are printed again, so that they fit the new domain.
    If asked, what carries objects to places is printed with durations, too, and all of it without costs.

    Args:
        folder: The domain folder.
        cell: Edge of a grid cell [m].
        name: Name of the domain; the one it has, or else that of its world, if not given.
        with_places: Whether places are learned by then; by what is there if not given.
        with_relations: The same for relations.
        durative: Whether to print it with durations.
        plain: Whether to print it without costs, too.
    """

    def work() -> None:
        table = operator_table(folder)
        check_axes(table)
        if not (folder / WORLD).exists():
            raise InvalidValue(
                f"{folder / WORLD} is missing: a domain also needs where objects may stand and how far the "
                f"hand rises; `neurosym init {quoted(folder.path)} --world module:factory` writes it."
            )
        world = read_world(folder / WORLD)()
        grounding = compile_domain(
            table,
            name=name or _former_name(folder) or world.name,
            cell=cell,
            table_bounds=world.table,
            lift_height=world.lift_height,
            places=PlaceOperators.load(folder / PLACE_OPERATORS) if has_places else None,
            relations=RelationOperators.load(folder / RELATION_OPERATORS) if has_relations else None,
        )
        write_atomically(folder / DOMAIN, domain_text(grounding))
        write_atomically(folder / NUMERIC_DOMAIN, domain_text(grounding, NUMERIC))
        for file in (*(folder / former for former in FORMER_DOMAINS), *folder.path.glob("*planviz.js*")):
            remove(file)  # what earlier versions printed, and is on the page now
        for form in _FORMS:
            if form.is_there(folder, wanted):
                with nullcontext() if form.domain in wanted else suppress(InvalidValue):
                    write_atomically(folder / form.domain, form.domain_text(grounding))
        grounding.save(folder / GROUNDING)
        save_fits(folder / GROUNDING, fits_of(grounding))
        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            print_problem(folder, load_scene(scene), grounding, wanted)

    wanted = [name for name, asked in ((PLAIN_DOMAIN, plain), (DURATIVE_DOMAIN, durative)) if asked]
    has_places = (folder / PLACE_OPERATORS).exists() if with_places is None else with_places
    has_relations = (folder / RELATION_OPERATORS).exists() if with_relations is None else with_relations
    inputs = (WORLD, *TABLE_FILES, *([PLACE_OPERATORS] if has_places else []))
    inputs += (RELATION_OPERATORS,) if has_relations else ()
    outputs = (DOMAIN, NUMERIC_DOMAIN, GROUNDING)
    options = {"cell": cell} | ({"name": name} if name else {})
    return Stage("compile-domain", inputs, outputs, work, options, Claim.ALONE)


def _former_name(folder: DomainFolder) -> str:
    """Return the name that the domain has by now, or nothing if there is none that can be read."""
    try:
        return Grounding.load(folder / GROUNDING).name if (folder / GROUNDING).is_file() else ""
    except InvalidFile:
        return ""
