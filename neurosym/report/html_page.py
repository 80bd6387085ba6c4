"""The page: gathered from what a domain folder holds, and written as one HTML file."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from neurosym.errors import InvalidValue, Progress, UnknownChoice
from neurosym.evaluation.paper_tables import comparisons_of
from neurosym.files import read_bytes, read_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport, error_table
from neurosym.pictures.motions import surest_carriers
from neurosym.report.sections import (
    Example,
    Picture,
    Shown,
    aimed_in_words,
    explored,
    motion_picture,
    operator_rows,
    plan_rows,
    problem_reader,
    run_picture,
    runs_of,
    shown,
    summaries,
    telling_examples,
)
from neurosym.stages.compilation import operator_table
from neurosym.stages.folder import DomainFolder, versions
from neurosym.stages.layout import (
    GROUNDING,
    INTERACTIONS,
    MODEL,
    PLACE_INTERACTIONS,
    PRIMITIVES,
    TRAINING,
    WORLD,
)
from neurosym.worlds.workers import worker_pool

# Runs on the page whose view can be turned: what was seen of each, and one viewer for all of them

Film = Callable[[Example], bytes]
"""Performs a run again and returns what was seen as one HTML file, empty if nothing moves."""
_BEGIN, _END = 'window.__VISER_EMBED_DATA__="', '"'  # what the viewer shows stands between these


@dataclass(frozen=True, slots=True)
class Films:
    """Films that share a viewer.

    Attributes:
        before: The viewer as HTML, up to what it shows.
        after: The rest of it.
        seen: What it shows, by the name of the run.
    """

    before: str
    after: str
    seen: Mapping[str, str]


def films_of(pages: Mapping[str, bytes]) -> Films | None:
    """Take films, as whole pages by run, apart that have the same viewer; None if there are none."""
    viewers, seen = dict[tuple[str, str], None](), dict[str, str]()
    for name, page in pages.items():
        before, begin, rest = page.decode().partition(_BEGIN)
        shown, end, after = rest.partition(_END)
        if begin and end:
            viewers[before + begin, end + after] = None
            seen[name] = shown
    if not seen:
        return None
    (before, after), *others = viewers
    assert not others, "all films have the same viewer"
    return Films(before, after, seen)


T = TypeVar("T")
EXAMPLES = 6
"""How many runs are shown in pictures."""
PICTURED = 16
"""How many primitives are shown in pictures: each takes seconds, and symbols of six bits are 64."""


def gather(
    folder: DomainFolder, progress: Progress, *, workers: int = 1, film: Film | None = None
) -> dict[str, Any]:
    """Read a domain folder, and make the pictures that are not there yet.

    Args:
        folder: The domain folder.
        progress: Called after each picture.
        workers: Processes that make pictures; their number does not change these.
        film: Makes films of runs, if these are wanted.

    Returns:
        What the template `page.html` shows, by name; what is missing is empty or None.

    Raises:
        InvalidFile: If a file is damaged, other than a plan's record, a run or a problem: those are named.
    """
    from neurosym.data.interactions import Interactions
    from neurosym.report.explanation import explain_folder

    def found(name: str, load: Callable[[Path], T]) -> T | None:
        return load(folder / name) if (folder / name).is_file() else None

    table = operator_table(folder) if (folder / PRIMITIVES).is_file() else None
    grounding = found(GROUNDING, Grounding.load)
    interactions = found(INTERACTIONS, Interactions.load)
    places = found(PLACE_INTERACTIONS, Interactions.load)
    report = found(TRAINING, lambda path: read_json(path, TrainingReport))
    read_problem = problem_reader(folder)
    runs = runs_of(folder, read_problem)
    plans = plan_rows(folder, runs, read_problem)
    explanation = explain_folder(folder) if table else None
    domains = sorted(folder.path.glob("domain*.pddl"))
    pictures = _pictures(folder, grounding, runs, progress, workers)
    turned = [one for one in runs if one.name in pictures["examples"]]
    return {
        "name": folder.path.resolve().name,
        "path": str(folder.path),
        "explanation": explanation,
        **pictures,
        "data": explored(interactions) if interactions and len(interactions) else None,
        "aimed": aimed_in_words(places) if places else "",
        "learned": report,
        "errors": error_table(report) if report else None,
        "operators": operator_rows(table, grounding) if table else (),
        "compiled": grounding is not None,
        "measured": table.measured if table else "",
        "plans": plans,
        "planners": summaries(plans),
        "films": films_of({one.name: film(one) for one in turned}) if film else None,
        "comparisons": comparisons_of(folder.path),
        "texts": {path.name: read_bytes(path).decode(errors="replace") for path in domains},
        "versions": versions(),
    }


def _pictures(
    folder: DomainFolder,
    grounding: Grounding | None,
    runs: Sequence[Example],
    progress: Progress,
    workers: int,
) -> dict[str, Any]:
    """Make the strips of primitives, carriers and example runs, as far as there is what they need."""
    symbols, others, carriers, chosen = list[str](), list[str](), list[str](), list[Example]()
    if grounding and (folder / WORLD).is_file():
        chosen = list(telling_examples(runs)[:EXAMPLES])
        if (folder / MODEL).is_file():
            symbols, others = _pictured(grounding)
            carriers = [one.name for one in surest_carriers(grounding)]
    pictures = [
        *(motion_picture(folder, "primitive", symbol) for symbol in symbols),
        *(motion_picture(folder, "operator", name) for name in carriers),
        *(run_picture(folder, example) for example in chosen),
    ]
    made = iter(_made(folder, pictures, progress, workers))
    primitives = {symbol: next(made) for symbol in symbols}
    carried = [next(made) for _ in carriers]
    ran = {example.name: next(made) for example in chosen}
    return {
        "pictures": {symbol: strip for symbol, strip in primitives.items() if isinstance(strip, Shown)},
        "carried": [strip for strip in carried if isinstance(strip, Shown)],
        "without_picture": {symbol: why for symbol, why in primitives.items() if isinstance(why, str)}
        | {symbol: f"`neurosym show DIR --primitive {symbol}` pictures it" for symbol in others},
        "examples": {name: strip for name, strip in ran.items() if isinstance(strip, Shown)},
        "unlike": [f"{name}: {reason}" for name, reason in ran.items() if isinstance(reason, str)],
    }


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
    with worker_pool(min(workers, len(left))) as submit:
        return _kept(folder, pictures, {one.name: submit(one.make) for one in left}, progress)


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


def render(page: Mapping[str, Any]) -> str:
    """Write what was gathered as HTML; whatever comes from files is escaped."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("neurosym.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("page.html").render(page=page)
