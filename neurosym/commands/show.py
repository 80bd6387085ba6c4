"""Commands that show what is there (`show`, `report`, `explain`) and measure it (`compare`, `evaluate`)."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Optional

from tyro.conf import Positional, arg

from neurosym.choices import TOLERANCE
from neurosym.commands.arguments import (
    CPUS,
    Folder,
    Json,
    Seed,
    Task,
    TimeLimit,
    Workers,
    answer_in,
    check_file,
    check_least,
    check_time_limit,
    opened,
)
from neurosym.errors import InvalidValue, counted, quoted
from neurosym.files import check_writable, make_folder, write_atomically, write_json
from neurosym.stages.console import progress_bar, say, say_next, show_table
from neurosym.stages.folder import Claim, DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, MODEL, PAGE, PICTURES, WORLD

if TYPE_CHECKING:
    from neurosym.evaluation.paper_tables import Table
    from neurosym.evaluation.summary import Comparison
    from neurosym.pictures.motions import Motion
    from neurosym.stages.verdicts import Verdict
    from neurosym.world import Outcome, World


def show(
    folder: Folder,
    interaction: Annotated[
        Optional[int], arg(metavar="I", help="Make row I of interactions.npz (0, 1, ...) happen again.")
    ] = None,
    primitive: Annotated[
        Optional[str],
        arg(
            metavar="CODE",
            help="Perform a primitive, like 101 or 101b, on an object of each category it is for.",
        ),
    ] = None,
    operator: Annotated[
        Optional[str],
        arg(metavar="NAME", help="Perform an operator of the domain, like carry-to-010-hollow-narrow-01."),
    ] = None,
    problem: Annotated[
        Optional[str], arg(metavar="NAME", help="Show a problem's start, with its goals transparently.")
    ] = None,
    output: Annotated[
        Optional[Path],
        arg(help="Write a PNG, or an animated GIF, here and not in DIR/pictures; its ending decides."),
    ] = None,
    gui: Annotated[bool, arg(help="Show the motion live in a window instead.")] = False,
) -> int:
    """Show an interaction, a primitive, an operator or a problem, in pictures or live.

    The dots mark the action's waypoints, as in the paper: blue the first, green the second, red the third.
    """
    from neurosym.worlds.world_file import read_world

    domain = opened(folder)
    if sum(chosen is not None for chosen in (interaction, primitive, operator, problem)) != 1:
        raise InvalidValue(
            "Name one thing to show: --interaction I, --primitive CODE, --operator NAME or --problem NAME."
        )
    if gui and (output or problem is not None):
        raise InvalidValue("--gui shows a motion live and writes no file; leave out --output and --problem.")
    check_file(output, "picture", ".png", ".gif")
    world = read_world(domain.require(WORLD))()
    if problem is not None:
        _show_problem(domain, world, domain.problem(problem), output)
    elif interaction is not None:
        _show_interaction(domain, world, interaction, output, gui)
    else:
        name = f"operator-{operator}" if operator is not None else f"primitive-{primitive}"
        _show_motions(domain, world, _learned(domain, world, primitive, operator), name, output, gui)
    return 0


def _show_problem(domain: DomainFolder, world: "World", name: str, output: Path | None) -> None:
    from neurosym.pictures.film import picture_problem
    from neurosym.stages.planning import load_problem

    problem = load_problem(domain, name, world)
    path = _picture_path(domain, f"problem-{problem.name}", output)
    picture_problem(world, problem, path)
    say(f"wrote {path}")
    say_next(f"neurosym plan {quoted(domain.path)} {problem.name}")


def _show_interaction(
    domain: DomainFolder, world: "World", number: int, output: Path | None, gui: bool
) -> None:
    from neurosym.data.interactions import Interactions
    from neurosym.pictures.motions import judge, recall_interaction

    interactions = Interactions.load(domain.require(INTERACTIONS))
    motion, is_same_scene = recall_interaction(world, interactions, number)
    (outcome,) = _show_motions(domain, world, [motion], f"interaction-{number}", output, gui)
    say(judge(interactions, number, outcome, is_same_scene))
    say_next(f"neurosym show {quoted(domain.path)} --interaction {number} --output interaction-{number}.gif")


def _learned(
    domain: DomainFolder, world: "World", primitive: str | None, operator: str | None
) -> "Sequence[Motion]":
    """Return the motions of a primitive or an operator, on objects drawn as when it was rehearsed."""
    from neurosym.grounding import Grounding
    from neurosym.learning.network import EffectModel
    from neurosym.pictures.motions import operator_motions, operators_of, pair_motion
    from neurosym.stages.folder import rehearsal_options
    from neurosym.stages.problem_making import sight_of_pairs

    grounding = Grounding.load(domain.require(GROUNDING))
    if operator is not None and (on_pair := grounding.relation_named(operator)):
        return [pair_motion(world, grounding, on_pair, sight=sight_of_pairs(domain))]
    by_name = (grounding.operator_named(operator),) if operator is not None else ()
    asked = by_name if primitive is None else operators_of(grounding, primitive)
    categorise = EffectModel.load(domain.require(MODEL)).object_symbols
    objects, seed = rehearsal_options(domain.manifest())
    drawn: dict[str, Any] = {"categorise": categorise, "objects": objects, "seed": seed}
    return operator_motions(world, grounding, asked, **drawn)


def _show_motions(
    domain: DomainFolder,
    world: "World",
    motions: "Sequence[Motion]",
    name: str,
    output: Path | None,
    gui: bool,
) -> "tuple[Outcome, ...]":
    from neurosym.pictures.film import picture_motions, show_live, tell

    if not motions:
        raise InvalidValue("Rehearsal sampled no object that this is for, so there is nothing to show.")
    path = None if gui else _picture_path(domain, name, output)
    outcomes = picture_motions(world, motions, path) if path else show_live(world, motions)
    for motion, outcome in zip(motions, outcomes, strict=True):
        say(f"{motion.title}: {tell(outcome)}")
    if path:
        say(f"wrote {path}")
    return outcomes


def _picture_path(domain: DomainFolder, name: str, output: Path | None) -> Path:
    if output:
        return output
    path = domain / f"{PICTURES}/{name}.png"
    make_folder(path.parent)
    check_writable(path)
    return path


_MEGABYTE = 1e6


def report(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FILE.html", help="Write the page here and not to DIR/report.html.")
    ] = None,
    workers: Workers = CPUS,
) -> int:
    """Write one HTML page about a domain: symbols, exploration, operators, plans.

    It needs no network, and has no scripts. What is missing is said with the command that makes it.
    Pictures are made once, by performing primitives and runs again.
    """
    from neurosym.report.html_page import gather, render
    from neurosym.worlds.workers import check_workers

    check_workers(workers)
    domain = opened(folder)
    path = output or domain / PAGE
    check_file(path, "page", ".html")
    with progress_bar("pictures") as advance:
        page = gather(domain, advance, workers=workers)
    text = render(page)
    write_atomically(path, text)
    say(f"wrote {path} ({len(text) / _MEGABYTE:.1f} MB)")
    say(f"next: open {path} in a browser")
    return 0


def explain(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FILE.md", help="Write it as Markdown here instead of printing it.")
    ] = None,
    symbol: Annotated[
        Optional[str], arg(metavar="SYMBOL", help="Say it of this symbol only: bits, a name, or an operator.")
    ] = None,
    json: Json = False,
) -> int:
    """Say in words what each symbol means: what is done, and which objects are alike."""
    from neurosym.commands.tables import explanation_page, is_long, show_explanation
    from neurosym.report.explanation import explain_folder

    answer, domain = answer_in(json), opened(folder)
    check_file(output, "explanation", ".md")
    every = explain_folder(domain)
    explanation = every if symbol is None else every.only(symbol)
    if output:
        write_atomically(output, explanation_page(explanation, domain.path.resolve().name))
        for line in explanation.summary[:1]:
            say(line)
        say(f"wrote {output}")
    else:
        show_explanation(explanation)
    first = explanation.actions[0].symbol if explanation.actions else ""
    if not output and is_long(explanation):
        say_next(f"neurosym explain {quoted(folder)} --symbol {first}")
    elif first and (domain / GROUNDING).is_file() and (domain / WORLD).is_file():
        say_next(f"neurosym show {quoted(folder)} --primitive {first}")
    elif first and (domain / WORLD).is_file():
        say_next(f"neurosym compile-domain {quoted(folder)}")
    answer(explanation)
    return 0


def compare(
    folder: Folder,
    tasks: Annotated[int, arg(help="How many tasks to draw.")] = 100,
    objects: Annotated[int, arg(help="Objects in each; each gets a goal.")] = 1,
    seed: Seed = 0,
    task: Task = None,
    planners: Annotated[
        tuple[str, ...],
        arg(help="bfs (reads the network), bfs-operators (the table), ..., or module:factory."),
    ] = ("bfs", "fast-downward"),
    workers: Workers = CPUS,
    tolerance: Annotated[float, arg(help="How near each object must come to its goal [m].")] = TOLERANCE,
    time_limit: TimeLimit = None,
    json: Json = False,
) -> int:
    """Give the same drawn tasks to several planners, and judge each plan.

    Task number i is drawn with seed SEED + i. A plan is followed blindly, and once more with replanning by
    the planner that made it. Interrupt it when you like: what is measured is kept in DIR/comparison, and the
    same command goes on.
    """
    from neurosym.commands.tables import show_verdict
    from neurosym.evaluation.comparison import Order, check_planners, compare_tasks
    from neurosym.evaluation.summary import summarise
    from neurosym.files import write_json
    from neurosym.worlds.workers import check_workers

    check_workers(workers)
    check_least(1, tasks=tasks, objects=objects)
    check_least(0, seed=seed)
    check_time_limit(time_limit)
    if not 0 < tolerance < math.inf:
        raise InvalidValue(f"tolerance = {tolerance} must be a number greater than 0.")
    answer, planners = answer_in(json), tuple(dict.fromkeys(planners))
    check_planners(planners, folder)
    domain = opened(folder)
    order = Order(domain.path, objects, planners, tolerance, time_limit, task)
    records = []
    with domain.claimed(Claim.SHARED), progress_bar("comparing") as advance:
        for record in compare_tasks(order, range(seed, seed + tasks), workers=workers):
            records.append(record)
            advance(len(records), tasks)
    comparison = summarise(records, planners)
    write_json(order.place / "comparison.json", comparison)
    kind = f"{counted(objects, 'object')}, {1000 * tolerance:g} mm" + (f", {task}" if task else "")
    seeds = f"seed {seed}" if tasks == 1 else f"seeds {seed} to {seed + tasks - 1}"
    title = f"{counted(comparison.counted, 'task')} drawn with {seeds}, {kind}"
    _show(comparison, title)
    say(f"wrote {order.place / 'comparison.json'}, and a file for each task")
    verdict = _judged(comparison, tolerance)
    show_verdict(verdict)
    like = "" if objects == 1 else f" --objects {objects}"
    like += "" if task is None else f" --task {task}"
    like += "" if tolerance == TOLERANCE else f" --tolerance {tolerance:g}"
    say_next(f"neurosym new-problem {quoted(folder)} --name mine --seed {seed}{like}")
    answer(comparison, file=str(order.place / "comparison.json"), verdict=verdict)
    return 0


def _judged(comparison: "Comparison", tolerance: float) -> "Verdict":
    from neurosym.stages.verdicts import Tries, judge_tries

    tries = {
        name: Tries(tally.reached_with_replanning, tally.found, comparison.counted)
        for name, tally in comparison.planners.items()
    }
    return judge_tries(tries, how="with replanning", tolerance=tolerance)


def _show(comparison: "Comparison", title: str) -> None:
    """Print how each planner did, and why where it did not."""
    tasks = max(comparison.counted, 1)
    columns = [title, *comparison.planners]
    shares = {
        "plan found": "found",
        "valid in the model": "valid",
        "predicted to arrive by the network": "predicted",
        "reached, followed blindly": "reached",
        "reached with replanning": "reached_with_replanning",
    }
    rows = [
        [words, *(f"{getattr(tally, field) / tasks:.0%}" for tally in comparison.planners.values())]
        for words, field in shares.items()
    ]
    tallies = comparison.planners.values()
    rows.append(["primitives, mean", *("-" if t.steps is None else f"{t.steps:.2f}" for t in tallies)])
    rows.append(
        ["planning, median [s]", *("-" if t.seconds is None else f"{t.seconds:.3f}" for t in tallies)]
    )
    rows.append(["own steps of those performed then", *(f"{t.own} of {t.performed}" for t in tallies)])
    show_table("the same tasks to each planner", columns, rows)
    if comparison.met_at_start:
        more = comparison.met_at_start
        said = "task needs no step and is" if more == 1 else "tasks need no step and are"
        say(f"{more} more {said} not counted")
    say(f"no plan by any of them: {comparison.solved_by_none} of {counted(comparison.counted, 'task')}")
    for name, tally in comparison.planners.items():
        for words, reasons in (
            ("no plan where another has one", tally.unfound),
            ("plan not valid", tally.invalid),
            ("missed, followed blindly", tally.missed),
            ("missed in spite of replanning", tally.missed_with_replanning),
        ):
            for reason, count in reasons.items():
                say(f"  {name}: {words}: {reason} ({count})")


def evaluate(
    folders: Annotated[
        Positional[tuple[Path, ...]], arg(metavar="DIR...", help="Domain folders, say of several seeds.")
    ],
    test: Annotated[
        Optional[Path],
        arg(
            metavar="DATA",
            help="Interactions that errors are measured on, best random ones: an .npz file or a folder.",
        ),
    ] = None,
    output: Annotated[
        Optional[Path], arg(metavar="FILE", help="Also write the tables here, as .md or .json.")
    ] = None,
    workers: Workers = CPUS,
) -> int:
    """Print the paper's Tables I (errors), II (primitives) and III (planning).

    Folders are grouped by strategy: mean and standard deviation over those of each. The primitives of a
    folder are rehearsed once, to judge their kinds (`kinds.json`); Table III is of what `neurosym compare`
    left there.
    """
    from neurosym.data.interactions import Interactions
    from neurosym.evaluation.paper_tables import measure, tables
    from neurosym.worlds.workers import check_workers

    if not folders:
        raise InvalidValue("Name at least one domain folder.")
    check_workers(workers)
    check_file(output, "tables", ".md", ".json")
    domains = [opened(folder) for folder in dict.fromkeys(folders)]
    for domain in domains:
        domain.require(INTERACTIONS)
    path = test / INTERACTIONS if test and test.is_dir() else test
    data = Interactions.load(path) if path else None
    measured = []
    for domain in domains:
        with progress_bar("rehearsing") as advance:
            measured.append(measure(domain, data, workers=workers, progress=advance))
    found = tables(measured, test)
    for table in found:
        show_table(table.title, table.columns, table.rows)
        say(table.remark)
    if output:
        if output.suffix == ".json":
            write_json(output, {"folders": measured, "tables": found})
        else:
            write_atomically(output, _page(found))
        say(f"wrote {output}")
    return 0


def _page(tables: "tuple[Table, ...]") -> str:
    from neurosym.evaluation.summary import markdown_table

    parts = [
        f"## {table.title}\n\n{table.remark}\n\n{markdown_table(table.columns, table.rows)}"
        for table in tables
    ]
    return "\n\n".join(parts) + "\n"
