"""The stage that compiles a domain: it prints the domain as PDDL, and its problems anew."""

from collections.abc import Callable, Collection, Sequence
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from functools import partial

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, quoted
from neurosym.files import make_folder, read_text, remove, write_atomically
from neurosym.formats import PairFile, PlaceFile
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
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
from neurosym.stages import layout
from neurosym.stages.folder import Claim, DomainFolder, Stage, load_scene
from neurosym.stages.plan_records import recorded_plans
from neurosym.tasks.promises import fits_of
from neurosym.tasks.task import is_relational, understand
from neurosym.world import turns
from neurosym.worlds.world_file import read_world

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


_PLAIN = partial(domain_text, costs=False), partial(problem_text, costs=False)
_FORMS = (
    _Form(layout.PLAIN_DOMAIN, layout.PLAIN, *_PLAIN),
    _Form(layout.DURATIVE_DOMAIN, layout.DURATIVE, durative_domain_text, durative_problem_text),
)


def _forms(folder: DomainFolder, wanted: Collection[str]) -> list[_Form]:
    """List those in which the domain is printed: they are asked for now, or were before."""
    return [form for form in _FORMS if form.domain in wanted or (folder / form.domain).exists()]


def print_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, wanted: Collection[str] = ()
) -> None:
    """Print a problem for other planners, in every way, such that plans beside it stay plans.

    Domains that are `wanted` are about to be there.
    """
    problem, name = _placed(problem, grounding), problem.name
    printed = texts_of(problem, grounding, recorded_plans(folder, problem, grounding))
    for form in _forms(folder, wanted):
        with suppress(InvalidValue):  # an object cannot be carried to its goal
            printed[layout.problem_file(name, form.ending)] = form.problem_text(problem, grounding)
    for file, text in sorted(printed.items()):
        write_atomically(folder / file, text)
    for ending in (layout.PDDL, layout.NUMERIC_PDDL, layout.PLAIN, layout.DURATIVE, *layout.FORMER):
        if (file := layout.problem_file(name, ending)) not in printed and (folder / file).exists():
            remove(folder / file)  # a former problem of that name was printed so


def put_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Write a problem that was made just now, printed and as we read it."""
    make_folder(folder / layout.PROBLEMS)
    print_problem(folder, problem, grounding)
    problem.save(folder / layout.scene_file(problem.name))


def print_beside(
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName,
    plan: GroundPlan | None,
    planner: str,
) -> None:
    """Print a problem anew where it is missing, or lacks what a plan needs that its planner found just now.

    The plan may be in another encoding than the one that was planned in.
    """
    if not plan and is_relational(problem, grounding):
        return
    encoding = plan.encoding if plan else encoding
    file = layout.printed_file(problem.name, encoding)
    path = folder / file
    if path.is_file() and not (plan and plan.missing(read_text(path))):
        return
    problem = _placed(problem, grounding)
    recorded = recorded_plans(folder, problem, grounding)
    others = recorded_plans(folder, problem, grounding, besides=planner)
    print_with = partial(_text, problem, grounding, encoding)
    is_ours = not path.is_file() or folder.is_as_made(file)  # by what was known of its objects then
    if not is_ours and read_text(path) not in (print_with(()), print_with(recorded)):
        folder.notify(f"{path} is not as it was printed, so it stays; the plan may be none of it")
    else:
        write_atomically(path, print_with((plan, *others) if plan else others))


def _text(problem: Problem, grounding: Grounding, encoding: EncodingName, plans: Sequence[GroundPlan]) -> str:
    """Print a problem in an encoding, such that those of some plans that are in it are plans of it."""
    file = layout.printed_file(problem.name, encoding)
    beside = [plan for plan in plans if layout.printed_file(problem.name, plan.encoding) == file]
    return problem_text(problem, grounding, encoding, plans=beside)


def _placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it."""
    for item in problem.objects:
        check_object(item, grounding)
    return msgspec.structs.replace(problem, places=understand(problem, grounding).flat.places)


def texts_of(problem: Problem, grounding: Grounding, plans: Sequence[GroundPlan] = ()) -> dict[str, str]:
    """Print a problem in each way, by file; in numbers neither relations nor what is set upright can be said.

    The problem has its places.
    """
    encodings: tuple[EncodingName, ...] = (STRIPS, NUMERIC)
    task = understand(problem, grounding)
    encodings = encodings[:1] if task.relates or task.lying else encodings
    files = {layout.printed_file(problem.name, each): each for each in encodings}
    return {file: _text(problem, grounding, each, plans) for file, each in files.items()}


def compile_stage(
    folder: DomainFolder,
    *,
    cell: float,
    name: str | None = None,
    durative: bool = False,
    plain: bool = False,
) -> Stage:
    """Compile the domain: `primitives.json` -> `domain.pddl`, the same in numbers, and `grounding.json`.

    Problems that are there already are printed again, so that they fit the new domain.

    Args:
        folder: The domain folder.
        cell: Edge of a grid cell [m].
        name: Name of the domain; the one it has, or else that of its world, if not given.
        durative: Whether to print it with durations, too.
        plain: Whether to print it without costs, too.
    """
    asked = {layout.PLAIN_DOMAIN: plain, layout.DURATIVE_DOMAIN: durative}
    wanted = [file for file, is_asked in asked.items() if is_asked]
    besides = (layout.PLACE_OPERATORS, layout.RELATION_OPERATORS, layout.UPRIGHT_OPERATORS)
    places, relations, upright = (folder / file if (folder / file).exists() else None for file in besides)

    def work() -> None:
        table = OperatorTable.load(folder.require(layout.PRIMITIVES))
        check_axes(table)
        if not (folder / layout.WORLD).exists():
            raise InvalidValue(
                f"{folder / layout.WORLD} is missing: a domain also needs where objects may stand and how "
                f"far the hand rises; `neurosym init {quoted(folder.path)} --world module:factory` writes it."
            )
        world, former = read_world(folder / layout.WORLD)(), _former(folder)
        grounding = compile_domain(
            table,
            name=name or (former or world).name,
            cell=cell,
            table_bounds=world.table,
            lift_height=world.lift_height,
            turned=turns(world),
            places=PlaceFile.load(places).table() if places else None,
            relations=PairFile.load(relations).table() if relations else None,
            upright=OperatorTable.load(upright) if upright else None,
        )
        if former == grounding:
            grounding = former  # by which what follows from it is found sooner than by its equal
        write_atomically(folder / layout.DOMAIN, domain_text(grounding))
        write_atomically(folder / layout.NUMERIC_DOMAIN, domain_text(grounding, NUMERIC))
        formers = (folder / former for former in layout.FORMER_DOMAINS)
        for file in (*formers, *folder.path.glob("*planviz.js*")):
            remove(file)  # what earlier versions printed, and is on the page now
        for form in _forms(folder, wanted):
            with nullcontext() if form.domain in wanted else suppress(InvalidValue):
                write_atomically(folder / form.domain, form.domain_text(grounding))
        grounding.save(folder / layout.GROUNDING)
        save_fits(folder / layout.GROUNDING, fits_of(grounding))
        for scene in sorted((folder / layout.PROBLEMS).glob(f"*{layout.SCENE}")):
            print_problem(folder, load_scene(scene), grounding, wanted)

    inputs = (layout.WORLD, layout.PRIMITIVES, *folder.there(layout.EYE, *besides))
    outputs = (layout.DOMAIN, layout.NUMERIC_DOMAIN, layout.GROUNDING)
    options = {"cell": cell} | ({"name": name} if name else {})
    return Stage("compile-domain", inputs, outputs, work, options, Claim.ALONE)


def _former(folder: DomainFolder) -> Grounding | None:
    """Return the domain as it is by now, or None if there is none that can be read."""
    with suppress(InvalidFile):
        return Grounding.load(folder / layout.GROUNDING)
    return None
