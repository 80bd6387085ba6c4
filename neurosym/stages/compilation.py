"""The stage that compiles a domain: it prints the domain as PDDL, and its problems anew."""

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import partial
from typing import NamedTuple

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, quoted
from neurosym.files import digest, make_folder, read_json, read_text, remove, write_atomically
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
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
    DURATIVE_DOMAIN,
    FORMER,
    FORMER_DOMAINS,
    GROUNDING,
    NUMERIC_DOMAIN,
    PLACE_OPERATORS,
    PLAIN_DOMAIN,
    PRACTICE,
    PRIMITIVES,
    PROBLEMS,
    RELATION_OPERATORS,
    SCENE,
    TABLE_FILES,
    WORLD,
    durative_file,
    plain_file,
    printed_file,
    problem_files,
    scene_file,
)
from neurosym.stages.plan_records import recorded_plans
from neurosym.stages.rounds import Practised
from neurosym.tasks.promises import fits_of
from neurosym.tasks.supports import is_relational
from neurosym.tasks.task import understand
from neurosym.worlds.world_file import read_world

# What practice came to: `practice.json`, and the operators as they are after it

FORMAT = "neurosym-practice-1"


class PracticeFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
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


def practice_of(folder: DomainFolder) -> PracticeFile | None:
    """Return what was practised with the operators that the folder has; None if nothing was.

    Args:
        folder: The domain folder.

    Raises:
        InvalidFile: If the file is none.
    """
    path = folder / PRACTICE
    if not (path.is_file() and (folder / PRIMITIVES).is_file()):
        return None
    found = read_json(path, PracticeFile, "; remove it to go back to what was distilled")
    if found.format != FORMAT:
        raise InvalidFile(path, f"it is of the format {found.format!r}, and this version reads {FORMAT!r}")
    return found if found.of == digest(folder / PRIMITIVES) else None


def operator_table(folder: DomainFolder) -> OperatorTable:
    """Read the operators as they are now: after practice, those that it came to.

    Args:
        folder: The domain folder.

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


class _Form(NamedTuple):
    """One more way to print a domain: its files, and what writes them."""

    domain: str
    problem_file: Callable[[str], str]
    domain_text: Callable[[Grounding], str]
    problem_text: Callable[[Problem, Grounding], str]


_FORMS = (
    _Form(PLAIN_DOMAIN, plain_file, partial(domain_text, costs=False), partial(problem_text, costs=False)),
    _Form(DURATIVE_DOMAIN, durative_file, durative_domain_text, durative_problem_text),
)


def write_domains(folder: DomainFolder, grounding: Grounding, wanted: Collection[str]) -> None:
    """Write the domain in each form that is wanted, or was before.

    Args:
        folder: The domain folder.
        grounding: The learned domain.
        wanted: Names of the files that are asked for now.

    Raises:
        InvalidValue: If it is asked for durative actions, and nothing carries objects to places.
    """
    for form in _FORMS:
        if form.domain in wanted or (folder / form.domain).exists():
            try:
                write_atomically(folder / form.domain, form.domain_text(grounding))
            except InvalidValue:
                if form.domain in wanted:
                    raise


def write_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, wanted: Collection[str] = ()
) -> None:
    """Write a problem in each form that there is a domain in; none is left from before where it has none.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        wanted: Names of the domains that are about to be there.
    """
    for form in _FORMS:
        if form.domain in wanted or (folder / form.domain).exists():
            file = folder / form.problem_file(problem.name)
            try:
                write_atomically(file, form.problem_text(problem, grounding))
            except InvalidValue:  # an object cannot be carried to its goal
                file.unlink(missing_ok=True)


# Printing the problems of a domain folder as PDDL, in every way that the domain is printed


def print_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Print a problem for other planners, in every way, such that plans beside it stay plans.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
    """
    problem = placed(problem, grounding)
    printed = texts_of(problem, grounding, recorded_plans(folder, problem, grounding))
    for file in sorted(printed):
        write_atomically(folder / file, printed[file])
    _remove_stale(folder, problem.name, printed)
    write_problem(folder, problem, grounding)


def put_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Write a problem that was made just now, printed and as we read it.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
    """
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

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        encoding: The encoding that was planned in; plans may be in another.
        plans: What a planner found just now.
        planner: Name of the planner.
    """
    wanted: dict[str, EncodingName] = {
        printed_file(problem.name, plan.encoding): plan.encoding for plan in plans
    }
    if not plans and not is_relational(problem, grounding):
        wanted = {printed_file(problem.name, encoding): encoding}
    lacking = [file for file in wanted if _lacks(folder, file, _beside(file, problem, plans))]
    if not lacking:
        return
    problem = placed(problem, grounding)
    recorded = recorded_plans(folder, problem, grounding)
    every = (*plans, *recorded_plans(folder, problem, grounding, besides=planner))
    for file in sorted(lacking):
        path, print_with = folder / file, partial(problem_text, problem, grounding, wanted[file])
        ours = (print_with(plans=known) for known in ((), _beside(file, problem, recorded)))
        if path.is_file() and read_text(path) not in ours:
            folder.notify(f"{path} is not as it was printed, so it stays; the plan may be none of it")
        else:
            write_atomically(path, print_with(plans=_beside(file, problem, every)))


def _lacks(folder: DomainFolder, file: str, plans: Iterable[GroundPlan]) -> bool:
    """Say whether a printed problem is missing, or lacks what some plans need."""
    path = folder / file
    return not path.is_file() or any(plan.missing(read_text(path)) for plan in plans)


def _beside(file: str, problem: Problem, plans: Iterable[GroundPlan]) -> list[GroundPlan]:
    """Keep the plans whose problem is printed into a file."""
    return [plan for plan in plans if printed_file(problem.name, plan.encoding) == file]


def placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    for item in problem.objects:
        check_object(item, grounding)
    return msgspec.structs.replace(problem, places=understand(problem, grounding).flat.places)


def texts_of(problem: Problem, grounding: Grounding, plans: Sequence[GroundPlan] = ()) -> dict[str, str]:
    """Print a problem in each way, by file; one of relations has none in numbers.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
        plans: The plans that stand beside it.
    """
    encodings = [STRIPS, *([] if understand(problem, grounding).relates else [NUMERIC])]
    files = {printed_file(problem.name, each): each for each in encodings}
    return {
        file: problem_text(problem, grounding, each, plans=_beside(file, problem, plans))
        for file, each in files.items()
    }


def _remove_stale(folder: DomainFolder, name: str, printed: Collection[str]) -> None:
    """Remove what a former problem of that name was printed as, and this one is not."""
    for file in (*problem_files(name), *(f"{PROBLEMS}/{name}{ending}" for ending in FORMER)):
        if file not in printed and (folder / file).exists():
            remove(folder / file)


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
        _remove_former(folder)
        write_domains(folder, grounding, wanted)
        grounding.save(folder / GROUNDING)
        save_fits(folder / GROUNDING, fits_of(grounding))
        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            problem = placed(load_scene(scene), grounding)
            plans = recorded_plans(folder, problem, grounding)
            for file, text in texts_of(problem, grounding, plans).items():
                write_atomically(folder / file, text)
            write_problem(folder, problem, grounding, wanted)

    wanted = [name for name, asked in ((PLAIN_DOMAIN, plain), (DURATIVE_DOMAIN, durative)) if asked]
    has_places = (folder / PLACE_OPERATORS).exists() if with_places is None else with_places
    has_relations = (folder / RELATION_OPERATORS).exists() if with_relations is None else with_relations
    inputs = (WORLD, *TABLE_FILES, *([PLACE_OPERATORS] if has_places else []))
    inputs += (RELATION_OPERATORS,) if has_relations else ()
    outputs = (DOMAIN, NUMERIC_DOMAIN, GROUNDING)
    options = {"cell": cell} | ({"name": name} if name else {})
    return Stage("compile-domain", inputs, outputs, work, options, Claim.ALONE)


def _remove_former(folder: DomainFolder) -> None:
    """Remove what earlier versions printed, and is on the page now."""
    files = [folder / name for name in FORMER_DOMAINS]
    files += [folder / "planviz.js", *folder.path.glob("*.planviz.json")]
    files += [file for ending in FORMER for file in (folder / PROBLEMS).glob(f"*{ending}")]
    for file in files:
        remove(file)


def _former_name(folder: DomainFolder) -> str:
    """Return the name that the domain has by now, or nothing if there is none that can be read."""
    try:
        return Grounding.load(folder / GROUNDING).name if (folder / GROUNDING).is_file() else ""
    except InvalidFile:
        return ""
