"""The stage that compiles a domain: it prints the domain as PDDL, and its problems anew."""

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import remove, write_atomically
from neurosym.fits import save_fits
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import check_axes, compile_domain
from neurosym.pddl.encoding_names import NUMERIC
from neurosym.pddl.encodings import domain_text
from neurosym.place_operators import PlaceOperators
from neurosym.promises import fits_of
from neurosym.relation_operators import RelationOperators
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import (
    DOMAIN,
    DURATIVE_DOMAIN,
    FORMER,
    FORMER_DOMAINS,
    GROUNDING,
    NUMERIC_DOMAIN,
    PLACE_OPERATORS,
    PLAIN_DOMAIN,
    PROBLEMS,
    RELATION_OPERATORS,
    SCENE,
    TABLE_FILES,
    WORLD,
)
from neurosym.stages.manifest import Claim, Stage
from neurosym.stages.other_tools import write_domains, write_problem
from neurosym.stages.plan_records import recorded_plans
from neurosym.stages.practised import operator_table
from neurosym.stages.problem_printing import placed, texts_of
from neurosym.wording import quoted
from neurosym.worlds.world_file import read_world


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
