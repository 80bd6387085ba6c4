"""Commands that show what is there (`show`, `report`, `explain`) and compare planners (`compare`)."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import arg

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
    opened,
    refuse_options,
)
from neurosym.errors import InvalidValue, counted, quoted
from neurosym.files import check_writable, make_folder, write_atomically, write_json
from neurosym.stages.console import progress_bar, say, say_next, show_table
from neurosym.stages.folder import Claim, DomainFolder, rehearsal_options
from neurosym.stages.layout import GROUNDING, INTERACTIONS, PAGE, PICTURES, WORLD

if TYPE_CHECKING:
    from neurosym.evaluation.summary import Comparison
    from neurosym.pictures.motions import Motion
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
    symbols: Annotated[
        bool, arg(help="Draw which objects have which bits, and what each action does to them, as an SVG.")
    ] = False,
    output: Annotated[
        Optional[Path],
        arg(help="Write a PNG, or an animated GIF, here and not in DIR/pictures; its ending decides."),
    ] = None,
    gui: Annotated[bool, arg(help="Show the motion live in a window instead.")] = False,
) -> int:
    """Show interactions, primitives, operators, problems or symbols, in pictures or live.

    The dots mark the action's waypoints, as in the paper: blue the first, green the second, red the third.
    """
    from neurosym.stages.painting import painted_world

    domain = opened(folder)
    if symbols + sum(chosen is not None for chosen in (interaction, primitive, operator, problem)) != 1:
        raise InvalidValue(
            "Name one thing to show: --interaction I, --primitive CODE, --operator NAME, --problem NAME or "
            "--symbols."
        )
    if gui and (output or symbols or problem is not None):
        what = "--symbols" if symbols else "--output and --problem"
        raise InvalidValue(f"--gui shows a motion live and writes no file; leave out {what}.")
    check_file(output, "picture", *((".svg",) if symbols else (".png", ".gif")))
    world = painted_world(domain.require(WORLD))
    if symbols:
        _show_symbols(domain, world, output)
    elif problem is not None:
        _show_problem(domain, world, domain.problem(problem), output)
    elif interaction is not None:
        _show_interaction(domain, world, interaction, output, gui)
    else:
        name = f"operator-{operator}" if operator is not None else f"primitive-{primitive}"
        _show_motions(domain, world, _learned(domain, world, primitive, operator), name, output, gui)
        say_next(f"neurosym explain {quoted(folder)} --symbol {quoted(operator or primitive or '')}")
    return 0


def _show_symbols(domain: DomainFolder, world: "World", output: Path | None) -> None:
    from neurosym.grounding import Grounding
    from neurosym.report.symbol_map import atlas_of
    from neurosym.report.symbol_sheet import symbol_sheet

    grounding = Grounding.load(domain.require(GROUNDING))
    categorise = domain.network().object_symbols
    path = _picture_path(domain, "symbols", output, "svg")
    write_atomically(path, symbol_sheet(atlas_of(world, categorise), grounding))
    say(f"wrote {path}")
    say_next(f"neurosym explain {quoted(domain.path)}")


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
    from neurosym.pictures.motions import operator_motions, operators_of, pair_motion
    from neurosym.stages.problem_making import sight_of_pairs

    grounding = Grounding.load(domain.require(GROUNDING))
    by_name = (grounding.operator_named(operator),) if operator is not None else ()
    if by_name and by_name[0].frame == "pair":
        return [pair_motion(world, grounding, by_name[0], sight=sight_of_pairs(domain))]
    asked = by_name if primitive is None else operators_of(grounding, primitive)
    categorise = domain.network().object_symbols
    objects, seed = rehearsal_options(domain.manifest())
    return operator_motions(world, grounding, asked, categorise=categorise, objects=objects, seed=seed)


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


def _picture_path(domain: DomainFolder, name: str, output: Path | None, ending: str = "png") -> Path:
    if output:
        return output
    path = domain / f"{PICTURES}/{name}.{ending}"
    make_folder(path.parent)
    check_writable(path)
    return path


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
    from neurosym.report.value_report import gather_values
    from neurosym.stages.value_stages import is_of_values

    domain = opened(folder)
    path = output or domain / PAGE
    check_file(path, "page", ".html")
    if is_of_values(domain):
        text = render(gather_values(domain), "values.html")
    else:
        with progress_bar("pictures") as advance:
            text = render(gather(domain, advance, workers=workers))
    write_atomically(path, text)
    say(f"wrote {path} ({len(text) / 1e6:.1f} MB)")
    say(f"next: open {path} in a browser")
    return 0


def traces(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FILE", help="Write it here, not in DIR/traces.csv.")
    ] = None,
) -> int:
    """Write (bits, action symbol, bits) of all interactions, for learners of action models.

    It is a text table as macq reads it, where features show what actions change. `neurosym init --data` takes
    such tables of anybody's; then `compile-domain` needs no network.
    """
    from neurosym.data.axes import axes_in
    from neurosym.data.interactions import Interactions
    from neurosym.stages.value_stages import symbols_of
    from neurosym.values.traces import traces_text

    check_file(output, "table", ".csv")
    domain = opened(folder)
    data, given = Interactions.load(domain.require(INTERACTIONS)), symbols_of(domain)
    text = traces_text(
        data,
        axes_in(data.origin.get("axes", [])),
        object_symbols=given.object_symbols,
        action_symbols=given.action_symbols,
    )
    path = output or folder / "traces.csv"
    write_atomically(path, text)
    say(f"wrote {path}, {counted(len(data), 'trace')}")
    say_next(f"neurosym init my-traces --data {quoted(path)}")
    return 0


def explain(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FILE.md", help="Write it as Markdown here instead of printing it.")
    ] = None,
    symbol: Annotated[
        Optional[str], arg(metavar="SYMBOL", help="Say it of this symbol only: bits, a name, or an operator.")
    ] = None,
    all: Annotated[  # noqa: A002  (it is typed so)
        bool, arg(help="Say all that is known of every symbol, and not one screen.")
    ] = False,
    json: Json = False,
) -> int:
    """Say in words what each symbol means: what is done, and which objects are alike.

    It takes one screen. `--all`, `--symbol`, `--output` and `--json` tell more.
    """
    from neurosym.commands.tables import (
        explanation_page,
        show_explanation,
        show_kinds,
        show_screen,
        show_values,
    )
    from neurosym.grounding import Grounding
    from neurosym.report.explanation import explain_folder
    from neurosym.stages.meeting import met_in_words
    from neurosym.stages.value_stages import domain_of, is_of_values

    answer, domain = answer_in(json), opened(folder)
    if is_of_values(domain):
        refuse_options(output=output, symbol=symbol, all=all)
        show_kinds(learned := domain_of(domain))
        show_values(domain)
        say_next(f"neurosym report {quoted(folder)}")
        answer(learned)
        return 0
    check_file(output, "explanation", ".md")
    every, is_whole = explain_folder(domain), all or symbol is not None
    explanation = every if symbol is None else every.only(symbol)
    if output:
        write_atomically(output, explanation_page(explanation, domain.path.resolve().name))
        for line in explanation.summary[:1]:
            say(line)
        say(f"wrote {output}")
    elif is_whole:
        show_explanation(explanation)
    else:
        show_screen(explanation)
    if (domain / GROUNDING).is_file() and not (output or is_whole):
        for line in met_in_words(domain, Grounding.load(domain / GROUNDING)):
            say(line)
    first = explanation.actions[0].symbol if explanation.actions else ""
    if not (output or is_whole):
        say("all of one symbol: --symbol SYMBOL; of every symbol: --all, or --output FILE.md")
        say_next(f"neurosym explain {quoted(folder)} --symbol {first}")
    elif first and (domain / WORLD).is_file():
        show = f"show {quoted(folder)} --primitive {first}"
        is_compiled = (domain / GROUNDING).is_file()
        say_next(f"neurosym {show if is_compiled else f'compile-domain {quoted(folder)}'}")
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
    from neurosym.evaluation.drawn_tasks import Order, compare_tasks
    from neurosym.evaluation.summary import summarise
    from neurosym.evaluation.value_comparison import ACTIONS
    from neurosym.planners.registry import planner_named
    from neurosym.stages.value_stages import is_of_values
    from neurosym.stages.verdicts import Tries, judge_tries

    answer, planners = answer_in(json), tuple(dict.fromkeys(planners))
    if not planners:
        raise InvalidValue("Name at least one planner; `neurosym planners` lists them.")
    for name in planners:
        planner_named(name, folder)
    domain = opened(folder)
    if of_values := is_of_values(domain):
        refuse_options(task=task, tolerance=None if tolerance == TOLERANCE else tolerance)
    order = Order(domain.path, objects, planners, None if of_values else tolerance, time_limit, task)
    records = []
    with domain.claimed(Claim.SHARED), progress_bar("comparing") as advance:
        for record in compare_tasks(order, range(seed, seed + tasks), workers=workers):
            records.append(record)
            advance(len(records), tasks)
    comparison, file = summarise(records, planners), order.place / "comparison.json"
    write_json(file, comparison)
    within = f"{ACTIONS} actions" if of_values else f"{1000 * tolerance:g} mm"
    kind = f"{counted(objects, 'object')}, {within}" + (f", {task}" if task else "")
    seeds = f"seed {seed}" if tasks == 1 else f"seeds {seed} to {seed + tasks - 1}"
    _show(comparison, f"{counted(comparison.counted, 'task')} drawn with {seeds}, {kind}")
    say(f"wrote {file}, and a file for each task")
    ran, of = comparison.executed, comparison.counted
    tries = {
        name: Tries(one.reached_with_replanning if ran else one.valid, one.found, of)
        for name, one in comparison.planners.items()
    }
    verdict = judge_tries(tries, how="with replanning" if ran else "by the data", tolerance=tolerance)
    for line in verdict.lines:
        say(line)
    like = "" if objects == 1 else f" --objects {objects}"
    like += f" --actions {ACTIONS}" if of_values else "" if task is None else f" --task {task}"
    like += "" if tolerance == TOLERANCE else f" --tolerance {tolerance:g}"
    say_next(f"neurosym new-problem {quoted(folder)} --name mine --seed {seed}{like}")
    answer(comparison, file=str(file), verdict=verdict)
    return 0


def _show(comparison: "Comparison", title: str) -> None:
    """Print how each planner did, and why where it did not."""
    tasks, tallies = max(comparison.counted, 1), comparison.planners.values()

    def shares(field: str) -> Iterator[str]:
        return (f"{getattr(tally, field) / tasks:.0%}" for tally in tallies)

    tells_places = any(one.performed for one in tallies)  # which data of a user's own do not
    own = [f"{one.own} of {one.performed}" for one in tallies]
    hows = (", followed blindly", "reached"), (" with replanning", "reached_with_replanning")
    rows = [
        ["plan found", *shares("found")],
        ["valid in the model", *shares("valid")],
        *([["predicted to arrive by the network", *shares("predicted")]] if tells_places else []),
        *([[f"reached{how}", *shares(field)] for how, field in hows] if comparison.executed else []),
        ["primitives, mean", *("-" if one.steps is None else f"{one.steps:.2f}" for one in tallies)],
        ["planning, median [s]", *("-" if one.seconds is None else f"{one.seconds:.3f}" for one in tallies)],
        *([["own steps of those performed then", *own]] if tells_places else []),
    ]
    show_table("the same tasks to each planner", [title, *comparison.planners], rows)
    if comparison.met_at_start:
        say(f"met at the start, and not counted: {counted(comparison.met_at_start, 'more task')}")
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
