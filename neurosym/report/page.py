"""The page: gathered from what a domain folder holds, and written as one HTML file."""

from collections import Counter
from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.evaluation.comparison_summary import Comparison
from neurosym.evaluation.paper_tables import comparisons_of
from neurosym.grounding import Grounding
from neurosym.pictures.motions import surest_carriers
from neurosym.progress import Progress
from neurosym.reading import read_bytes
from neurosym.report.charts import Chart
from neurosym.report.examples import Example, problem_reader, runs_of, telling_examples
from neurosym.report.exploration import Aimed, Explored, aimed, explored
from neurosym.report.films import Film, Films, films_of
from neurosym.report.learning import Learned, curve_charts, learned
from neurosym.report.operators import OperatorRow, operator_rows
from neurosym.report.plans import PlannerSummary, PlanRow, plan_rows, summaries
from neurosym.report.strips import Picture, Shown, operator_picture, primitive_picture, run_picture, shown
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, MODEL, PLACE_INTERACTIONS, PRIMITIVES, WORLD
from neurosym.stages.manifest import versions
from neurosym.stages.practising import operator_table
from neurosym.worlds.pool import worker_pool

if TYPE_CHECKING:
    from neurosym.explain.explained import Explanation

EXAMPLES = 6
"""How many runs are shown in pictures."""
PICTURED = 16
"""How many primitives are shown in pictures: each takes seconds, and symbols of six bits are 64."""


@dataclass(frozen=True, slots=True)
class Page:
    """What stands on the page; what is missing is empty or None.

    Attributes:
        name: Name of the domain folder.
        path: The domain folder as it was named, for the commands that the page tells.
        explanation: What the symbols mean.
        pictures: A strip for each action symbol.
        carried: Strips of what carries objects to places, one for each category that is carried.
        without_picture: Why an action symbol has none, or why none has.
        data: What was explored.
        aimed: What was explored by actions that are aimed at places.
        learned: How well the model predicts.
        curves: The learning curve.
        operators: The table of operators.
        compiled: Whether there is a domain.
        measured: What the operators were measured by.
        plans: The plans and their runs.
        planners: The same, counted by planner.
        examples: Pictures of runs, by name.
        films: The same runs, whose view can be turned.
        unlike: Runs that go another way when they are performed again.
        comparisons: How planners did, by the kind of task.
        texts: The PDDL files, by name.
        versions: Versions of the packages that decide the outcome.
    """

    name: str
    path: str
    explanation: "Explanation | None"
    pictures: dict[str, Shown]
    carried: tuple[Shown, ...]
    without_picture: dict[str, str]
    data: Explored | None
    aimed: Aimed | None
    learned: Learned | None
    curves: tuple[Chart, ...]
    operators: tuple[OperatorRow, ...]
    compiled: bool
    measured: str
    plans: tuple[PlanRow, ...]
    planners: tuple[PlannerSummary, ...]
    examples: dict[str, Shown]
    films: Films | None
    unlike: tuple[str, ...]
    comparisons: dict[str, Comparison]
    texts: dict[str, str]
    versions: dict[str, str] = field(default_factory=versions)


def gather(folder: DomainFolder, progress: Progress, *, workers: int = 1, film: Film | None = None) -> Page:
    """Read a domain folder, and make the pictures that are not there yet.

    Args:
        folder: The domain folder.
        progress: Called after each picture.
        workers: Processes that make pictures; their number does not change these.
        film: Makes films of runs, if these are wanted.

    Raises:
        InvalidFile: If a file is damaged, other than a plan's record, a run or a problem: those are named.
    """
    from neurosym.data.interactions import Interactions
    from neurosym.explain.from_folder import explain_folder

    has = {name: (folder / name).is_file() for name in (INTERACTIONS, PRIMITIVES, GROUNDING)}
    table = operator_table(folder) if has[PRIMITIVES] else None
    grounding = Grounding.load(folder / GROUNDING) if has[GROUNDING] else None
    interactions = Interactions.load(folder / INTERACTIONS) if has[INTERACTIONS] else None
    places = folder / PLACE_INTERACTIONS
    read_problem = problem_reader(folder)
    runs = runs_of(folder, read_problem)
    plans = plan_rows(folder, runs, read_problem)
    explanation = explain_folder(folder) if table else None
    domains = sorted(folder.path.glob("domain*.pddl"))
    texts = {path.name: read_bytes(path).decode(errors="replace") for path in domains}
    report, curves = learned(folder), curve_charts(folder)
    pictures, carried, without_picture, examples, unlike = _pictures(
        folder, grounding, runs, progress, workers
    )
    return Page(
        name=folder.path.resolve().name,
        path=str(folder.path),
        explanation=explanation,
        pictures=pictures,
        carried=carried,
        without_picture=without_picture,
        data=explored(interactions) if interactions and len(interactions) else None,
        aimed=aimed(Interactions.load(places)) if places.is_file() else None,
        learned=report,
        curves=curves,
        operators=operator_rows(table, grounding) if table else (),
        compiled=grounding is not None,
        measured=table.measured if table else "",
        plans=plans,
        planners=summaries(plans),
        examples=examples,
        films=films_of({one.name: film(one) for one in runs if one.name in examples}) if film else None,
        unlike=unlike,
        comparisons=comparisons_of(folder.path),
        texts=texts,
    )


def _pictures(
    folder: DomainFolder,
    grounding: Grounding | None,
    runs: Sequence[Example],
    progress: Progress,
    workers: int,
) -> tuple[dict[str, Shown], tuple[Shown, ...], dict[str, str], dict[str, Shown], tuple[str, ...]]:
    """Make the strips of primitives, carriers and example runs, as far as there is what they need."""
    if grounding is None or not (folder / WORLD).is_file():
        return {}, (), {}, {}, ()
    symbols, others = _pictured(grounding) if (folder / MODEL).is_file() else ([], [])
    carriers = [one.name for one in surest_carriers(grounding)] if (folder / MODEL).is_file() else []
    chosen = telling_examples(runs)[:EXAMPLES]
    pictures = [
        *(primitive_picture(folder, symbol) for symbol in symbols),
        *(operator_picture(folder, name) for name in carriers),
        *(run_picture(folder, example) for example in chosen),
    ]
    made = list(_made(folder, pictures, progress, workers))
    primitives = dict(zip(symbols, made, strict=False))
    carried, ran = made[len(symbols) :][: len(carriers)], made[len(symbols) + len(carriers) :]
    strips = dict(zip([example.name for example in chosen], ran, strict=True))
    return (
        {symbol: strip for symbol, strip in primitives.items() if isinstance(strip, Shown)},
        tuple(strip for strip in carried if isinstance(strip, Shown)),
        {symbol: reason for symbol, reason in primitives.items() if isinstance(reason, str)}
        | {symbol: f"`neurosym show DIR --primitive {symbol}` pictures it" for symbol in others},
        {name: strip for name, strip in strips.items() if isinstance(strip, Shown)},
        tuple(f"{name}: {reason}" for name, reason in strips.items() if isinstance(reason, str)),
    )


def _pictured(grounding: Grounding) -> tuple[list[str], list[str]]:
    """Divide the symbols into those to be pictured, which the domain uses most, and the others."""
    symbols = grounding.operators.symbols
    uses = Counter(operator.primitive for operator in grounding.live)
    chosen = set(sorted(symbols, key=lambda symbol: -uses[symbol])[:PICTURED])
    return [one for one in symbols if one in chosen], [one for one in symbols if one not in chosen]


def _made(
    folder: DomainFolder, pictures: Sequence[Picture], progress: Progress, workers: int
) -> list[Shown | str]:
    """Return each picture, or why it cannot be made; what is missing is made by so many processes."""
    left = [one for one in pictures if not folder.is_current(one.stage(folder))]
    if min(workers, len(left)) <= 1:
        return _kept(folder, pictures, {}, progress)
    with worker_pool(min(workers, len(left)), _begin, ()) as submit:
        return _kept(folder, pictures, {one.name: submit(one.make) for one in left}, progress)


def _begin() -> None:
    """Do nothing: workers that draw need nothing before."""


def _kept(
    folder: DomainFolder, pictures: Sequence[Picture], drawing: Mapping[str, Future[Any]], progress: Progress
) -> list[Shown | str]:
    """Put pictures into the folder, as soon as they are made, and return what they show."""
    made: list[Shown | str] = []
    for picture in pictures:
        elsewhere = drawing.get(picture.name)
        stage = picture.stage(folder, elsewhere.result if elsewhere else None)
        try:
            folder.perform(stage, again=False)
            made.append(shown(folder, stage))
        except (InvalidValue, UnknownChoice) as error:
            made.append(str(error))
        progress(len(made), len(pictures))
    return made


def render(page: Page) -> str:
    """Write a page as HTML; whatever comes from files is escaped.

    Args:
        page: What stands on it.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("neurosym.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("page.html").render(page=page)
