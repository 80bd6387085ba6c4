"""The results of `evaluate.py` as pages of Markdown tables."""

from collections.abc import Mapping, Sequence
from typing import Any

NOT_YET = "not measured yet"
_SHARES = ("found", "valid", "reached", "reached_with_replanning")
_SHARE_NAMES = ("plan found", "valid in the model", "reached, followed blindly", "reached with replanning")


def page(results: Mapping[str, Any], trials: Sequence[str] = ()) -> str:
    """Write the page."""
    versions = ", ".join(f"{name} {value}" for name, value in results["versions"].items())
    missing, size = results["missing"], results["size"]
    unfinished = f" **Not finished**: {missing} jobs to do; the same command goes on." if missing else ""
    sections = [
        "# Planning, measured",
        f"By `{results['command']}`, which wrote this page, `planning.json` and `planning.png`; "
        f"[scaling.md](scaling.md) is about size. Machine: {versions}. Means ± standard deviations over "
        f"seeds; docs/planning.md says what is what.{unfinished}",
        "## Table III: goals reached",
        f"{size['tasks']} tasks with one and {size['tasks']} with two objects, drawn as the paper draws them "
        "(section III-E: random scene, random action, its result is the goal, mid-air included), the same "
        "for every domain; every object must end within 50 mm. No task is met at the start. Shares of all "
        "tasks, those without a plan included. *bfs* is the paper's search, 3 deep, over what the network "
        "predicts; *valid* means that the rehearsed operators promise that the plan ends at the goal. "
        "*Blindly*: the plan is followed to its end. *Replanning*: whoever made the plan makes another when "
        f"it would miss by what is seen. *shipped* is `domains/tabletop` (10,000 interactions); the others "
        f"had {size['steps']:,}, and *curiosity* is what `neurosym explore` does by default.",
        _table3(results["table3"]),
        "![Shares of the goals that were reached](planning.png)",
        _paper(results["paper"]),
        "## The same within 20 mm",
        _table3(results["table3_at_20_mm"]),
        *trials,
        "## Where the two models disagree, and what went wrong",
        "In the shipped domain, at 50 mm; numbers of tasks.",
        *(f"**{kind}**\n\n{_reasons(reasons)}" for kind, reasons in results["reasons"].items()),
        "## Off the table, and into others",
        "In the runs of the shipped domain. *Touched* and *moved* are shares of the interactions in which "
        "the robot touched another object, and of other objects that ended elsewhere; *off the table*: runs.",
        _collisions(results["collisions"]),
        "## Plans that are true in the model",
        "Symbolic tasks in the shipped domain: goals that are 1 to 3 (easy) or 5 to 8 (hard) primitives away "
        "for each object alone, by the shortest plan, and for which a plan together is known. *Valid*: share "
        "of Fast Downward's plans that the exact replay confirms. *When BFS solves*: share of the tasks "
        "solved by breadth-first search "
        "over the same operators, 3 deep, that Fast Downward solves, too; *when counting solves* the same "
        "for the exact planner at any depth. *Shortest*: share of its plans with the fewest primitives there "
        "can be; it minimises cost, and what is reliable may be longer.",
        _symbolic(results),
        "The paper's search over the network on the same tasks: how often it finds a plan 3 deep, how many "
        "of these plans the operators confirm, and of how many of Fast Downward's plans the network, too, "
        "predicts that they end at the goal.",
        _network(results["symbolic"]),
        "## Reliable, not only short",
        "Fast Downward's plans, followed blindly, with action costs and with all operators costing alike; on "
        "the tasks of Table III that both have a plan for.",
        _costs(results["costs"]),
        "## Disturbed",
        "An object is nudged once during the run by 3 to 8 cm, in a direction and before a step drawn from a "
        "seed. Share of those with a plan at the start that end at their goal; the aim is 90 %.",
        _disturbed(results["disturbed"]),
        "## Seconds",
        _timings(results["timings"]),
    ]
    return "\n\n".join(sections) + "\n"


def _table3(table: Mapping[str, Any]) -> str:
    rows = []
    for strategy, kinds in table.items():
        for kind, planners in kinds.items():
            for planner, cell in planners.items():
                seeds = len(cell["by_seed"])
                shares = [_share(cell[name], cell["spread"][name] if seeds > 1 else None) for name in _SHARES]
                rows.append([strategy, kind, planner, str(seeds), str(cell["tasks"]), *shares])
    columns = ["domain", "objects", "planner", "seeds", "tasks", *_SHARE_NAMES]
    return markdown(columns, rows)


def _paper(paper: Mapping[str, Mapping[str, float]]) -> str:
    told = "; ".join(
        f"{kind}: " + ", ".join(f"{name} {share:.0%}" for name, share in shares.items())
        for kind, shares in paper.items()
    )
    return (
        f"The paper's Table III, which has one figure for each: {told}. Its objects, simulator and number of "
        "interactions are others, so the two tables compare strategies, not percentages."
    )


def _reasons(reasons: Mapping[str, Any]) -> str:
    if not reasons["tasks"]:
        return NOT_YET
    rows = [["-", "no planner has a plan", str(reasons["solved_by_none"])]]
    for planner, words in (("bfs", "bfs"), ("fast-downward", "fast-downward")):
        told = reasons[planner]
        for title, counts in (
            ("no plan", reasons["without_plan"][planner]),
            ("no plan, and the other has one", told["unfound"]),
            ("plan not valid", told["invalid"]),
            ("missed, followed blindly", told["missed"]),
            ("missed in spite of replanning", told["missed_with_replanning"]),
        ):
            rows += [[words, f"{title}: {reason}", str(count)] for reason, count in counts.items()]
        rows.append([words, "plans that the network predicts to arrive", str(told["predicted"])])
        rows.append([words, "new plans asked for, in all runs", str(told["replans"])])
    return markdown(["planner", "what", f"of {reasons['tasks']}"], rows)


def _collisions(kinds: Mapping[str, Any]) -> str:
    rows = [
        [kind, way, str(cell["runs"]), str(cell["interactions"])]
        + [_share(cell[name]) for name in ("kept", "touched", "disturbed", "off_table")]
        for kind, ways in kinds.items()
        for way, cell in ways.items()
        if cell["runs"]
    ]
    columns = ["objects", "runs of", "runs", "interactions", "as promised"]
    return markdown([*columns, "another touched", "another moved", "off the table"], rows)


def _symbolic(results: Mapping[str, Any]) -> str:
    rows = [
        [
            size,
            *(str(cell[name]) for name in ("tasks", "found", "valid")),
            *(_share(cell[name], digits=1) for name in ("valid_share", "solved_when_bfs_solves")),
            str(cell["bfs_solves"]),
            _share(cell["solved_when_counting_solves"], digits=1),
            _number(cell["fewest"]),
            _number(cell["extra_steps"]),
            _share(cell["shortest"]),
            _number(cell["seconds"]),
        ]
        for size, cell in results["symbolic"].items()
    ]
    if rows:
        both = [_share(results[name], digits=1) for name in ("valid_share", "solved_when_bfs_solves")]
        rows.append(["all", "", "", "", *both, "", "", "", "", "", ""])
    columns = ["objects", "tasks", "found", "valid", "valid share", "when BFS solves", "(tasks)"]
    more = ["when counting solves", "fewest steps", "extra steps", "shortest", "median [s]"]
    return markdown([*columns, *more], rows)


def _network(symbolic: Mapping[str, Any]) -> str:
    rows = [
        [
            size,
            str(cell["tasks"]),
            *(str(cell["network_bfs"][name]) for name in ("found", "valid")),
            _share(cell["network_bfs"]["pddl_when_it_solves"]),
            _share(cell["predicted_too"]),
        ]
        for size, cell in symbolic.items()
    ]
    columns = ["objects", "tasks", "found by bfs", "of these valid by the operators"]
    return markdown(
        [*columns, "of these solved by Fast Downward", "its plans that the network confirms"], rows
    )


def _costs(kinds: Mapping[str, Any]) -> str:
    rows = [
        [kind, str(cell["both_found"]), *(_share(cell[name]) for name in ("with_costs", "without_costs"))]
        + [_number(cell[name]) for name in ("primitives_with", "primitives_without")]
        for kind, cell in kinds.items()
        if cell["both_found"]
    ]
    columns = ["objects", "tasks", "reached with costs", "reached without"]
    return markdown([*columns, "primitives with costs", "without"], rows)


def _disturbed(kinds: Mapping[str, Any]) -> str:
    rows = [
        [
            kind,
            *(str(cell[name]) for name in ("tasks", "without_plan", "nudged", "reached")),
            _share(cell["share"]),
            str(cell["replans"]),
            _counts(cell["missed"]),
        ]
        for kind, cell in kinds.items()
        if cell["tasks"]
    ]
    columns = ["objects", "tasks", "without a plan", "disturbed", "reached", "share", "new plans"]
    return markdown([*columns, "why others missed"], rows)


def _timings(timings: Mapping[str, Any] | None) -> str:
    if not timings:
        return NOT_YET
    return (
        f"The whole process of `neurosym plan` for one object, median of "
        f"{len(timings['plan_process_one_object'])}: {timings['median_plan_process']:.2f} s. Breadth-first "
        f"search, 3 deep, for two objects, median of {len(timings['bfs_two_objects_depth_3'])}: "
        f"{1000 * timings['median_bfs']:.0f} ms, worst {1000 * max(timings['bfs_two_objects_depth_3']):.0f} "
        f"ms. Processes that were running meanwhile: {timings['load']:.1f}."
    )


def _counts(counts: Mapping[str, int]) -> str:
    return ", ".join(f"{reason} ({count})" for reason, count in counts.items()) or "-"


def _share(share: float | None, spread: float | None = None, digits: int = 0) -> str:
    if share is None:
        return "-"
    told = f"{100 * share:.{digits}f}"
    return f"{told} ± {100 * spread:.{digits}f} %" if spread is not None else f"{told} %"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"


def markdown(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Print a table, or say that there is nothing to print yet."""
    if not rows:
        return NOT_YET
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
