"""The results of `evaluate.py` as pages of Markdown tables."""

from collections.abc import Mapping
from typing import Any

from neurosym.stages.plan_records import MORE_MOTIONS
from tools.benchmarks.planning.figures import WAYS
from tools.benchmarks.tables import (
    NOT_YET,
    document,
    figures_table,
    listed,
    number,
    percent,
    table,
    with_interval,
    written,
)

Figures = Mapping[str, Any]
_SHARES = ("found", "valid", "reached", "reached_with_replanning")


def page(results: Figures) -> str:
    """Write the page."""
    missing, size = results["missing"], results["size"]
    unfinished = f" **Not finished**: {missing} jobs to do; the same command goes on." if missing else ""
    return document(
        "# Planning, measured",
        f"By `{results['command']}`, which wrote this page, `planning.json` and `planning.png`; "
        f"[scaling.md](scaling.md) is about size. Machine: {listed(results['versions'])}. Means ± standard "
        f"deviations over seeds; docs/planning.md says what is what.{unfinished}",
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
        *_trial_sections(results),
        "## Where the two models disagree, and what went wrong",
        "In the shipped domain, at 50 mm; numbers of tasks.",
        *(f"**{kind}**\n\n{_reasons(reasons)}" for kind, reasons in results["reasons"].items()),
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
        figures_table(
            "objects | tasks | found by bfs | of these valid by the operators | "
            "of these solved by Fast Downward | its plans that the network confirms",
            {size: cell | cell["network_bfs"] for size, cell in results["symbolic"].items()},
            *("tasks", "found", "valid", "pddl_when_it_solves:0%", "predicted_too:0%"),
        ),
        "## Reliable, not only short",
        "Fast Downward's plans, followed blindly, with action costs and with all operators costing alike; on "
        "the tasks of Table III that both have a plan for.",
        figures_table(
            "objects | tasks | reached with costs | reached without | primitives with costs | without",
            results["costs"],
            *("both_found", "with_costs:0%", "without_costs:0%", "primitives_with:2", "primitives_without:2"),
        ),
        "## Disturbed",
        "An object is nudged once during the run by 3 to 8 cm, in a direction and before a step drawn from a "
        "seed. Share of those with a plan at the start that end at their goal; the aim is 90 %.",
        figures_table(
            "objects | tasks | without a plan | disturbed | reached | share | new plans | why others missed",
            results["disturbed"],
            *("tasks", "without_plan", "nudged", "reached", "share:0%", "replans", "missed"),
        ),
    )


def _table3(results: Figures) -> str:
    rows = [
        [strategy, kind, planner, str(len(cell["by_seed"])), str(cell["tasks"]), *_shares(cell)]
        for strategy, kinds in results.items()
        for kind, planners in kinds.items()
        for planner, cell in planners.items()
    ]
    columns = "domain | objects | planner | seeds | tasks | plan found | valid in the model | "
    return table(f"{columns}reached, followed blindly | reached with replanning", rows)


def _shares(cell: Figures) -> list[str]:
    spreads = cell["spread"] if len(cell["by_seed"]) > 1 else {}
    return [percent(cell[name], spreads.get(name)) for name in _SHARES]


def _paper(paper: Figures) -> str:
    told = "; ".join(
        f"{kind}: " + ", ".join(f"{name} {share:.0%}" for name, share in shares.items())
        for kind, shares in paper.items()
    )
    return (
        f"The paper's Table III, which has one figure for each: {told}. Its objects, simulator and number of "
        "interactions are others, so the two tables compare strategies, not percentages."
    )


def _reasons(reasons: Figures) -> str:
    if not reasons["tasks"]:
        return NOT_YET
    rows = [["-", "no planner has a plan", str(reasons["solved_by_none"])]]
    for planner, without in reasons["without_plan"].items():
        told = reasons[planner]
        found = {
            "no plan": without,
            "no plan, and the other has one": told["unfound"],
            "plan not valid": told["invalid"],
            "missed, followed blindly": told["missed"],
            "missed in spite of replanning": told["missed_with_replanning"],
        }
        rows += [[planner, f"{title}: {why}", str(n)] for title, of in found.items() for why, n in of.items()]
        rows.append([planner, "plans that the network predicts to arrive", str(told["predicted"])])
        rows.append([planner, "new plans asked for, in all runs", str(told["replans"])])
    return table(f"planner | what | of {reasons['tasks']}", rows)


def _symbolic(results: Figures) -> str:
    both = ("valid_share:1%", "solved_when_bfs_solves:1%")
    names = ("tasks", "found", "valid", *both, "bfs_solves", "solved_when_counting_solves:1%")
    more = ("fewest:2", "extra_steps:2", "shortest:0%", "seconds:2")
    rows = [[size, *written(cell, *names, *more)] for size, cell in results["symbolic"].items()]
    if rows:
        rows.append(["all", "", "", "", *written(results, *both), "", "", "", "", "", ""])
    columns = "objects | tasks | found | valid | valid share | when BFS solves | (tasks) | "
    return table(f"{columns}when counting solves | fewest steps | extra steps | shortest | median [s]", rows)


def _trial_sections(results: Figures) -> list[str]:
    """Tell what came of trials in the shipped domain."""
    motions = [f"{kind} {number(value, 1)}" for kind, value in results["motions"].items()]
    kinds = [f"{seed}: {len(kinds)}" for seed, kinds in results["kinds_by_seed"].items()]
    return [
        "## How near plans come",
        "The shipped domain, Fast Downward, tasks drawn as above; shares of all tasks with Wilson intervals "
        "at 95 %. *Blindly* and *replanning* start from the same plan.",
        _precision(results["precision"]),
        "## Goals anywhere",
        "Objects of all shapes, starts and goals uniform over the table, footprints on the table and apart, "
        "each goal at least 15 cm from the start; 50 mm, with replanning. A task without a plan is a miss. "
        "*Motions* are primitives that were performed.",
        figures_table(
            "objects | tasks | reached | without a plan | primitives of the plan | motions | "
            "what ended the others",
            {
                objects: told | {"reached": with_interval(results["far_goals"][objects], told["tasks"])}
                for objects, told in results["far_details"].items()
            },
            *("tasks", "reached", "without_plan", "primitives:1", "motions:1", "missed"),
        ),
        "## Promises, step by step",
        "Distances between what the operator of a step promised for the object at hand and what came, at "
        "50 mm. *Worst* is the worst category. A grasp that fails outweighs many other steps, so intervals "
        "(bootstrap over runs, 95 %) are wide. *First step* is that of each run.",
        _promises(results["promises"]),
        f"Motions a task, replanned: {', '.join(motions)}. "
        f"Kinds of primitive, by seed: {', '.join(kinds) or NOT_YET}.",
        "## The chance that is printed",
        _calibration(
            "Chance that `neurosym plan` prints, beside how often the plan came true, followed blindly to "
            "50 mm",
            results["calibration"],
        ),
        _calibration(
            f"Chance that it prints of being there within {MORE_MOTIONS} motions more than the plan has, "
            "beside how often that was so, with replanning",
            results["calibration_replanned"],
        ),
    ]


def _precision(results: Figures) -> str:
    rows = [
        [f"{mm} mm", kind, str(cell["tasks"]), *(with_interval(cell[way], cell["tasks"]) for way in WAYS)]
        for mm, kinds in results.items()
        for kind, cell in kinds.items()
        if cell["tasks"]
    ]
    return table("within | objects | tasks | followed blindly | with replanning", rows)


def _promises(results: Figures) -> str:
    def with_rms(told: Figures) -> Figures:
        low, high = told["interval"] or (None, None)
        return {**told, "rms": f"{number(told['all'], 1)} ({number(low, 1)} to {number(high, 1)})"}

    return figures_table(
        "runs | steps | RMS [mm] | median [mm] | first step, RMS [mm] | worst RMS [mm] | "
        "its median [mm] | ended in the way promised",
        {runs: with_rms(told) for runs, told in results.items()},
        *("steps", "rms", "median:1", "first:1", "worst:1", "worst_median:1", "kinds_kept:0%"),
    )


def _calibration(what: str, told: Figures) -> str:
    if not told["plans"]:
        return NOT_YET
    rows = [
        [str(part["plans"]), percent(part["chance"]), with_interval(part["reached"], int(part["plans"]))]
        for part in told["bins"]
    ]
    return (
        f"{what} ({told['plans']} plans). Brier score {told['brier']:.3f}; of the base rate "
        f"{told['brier_of_base_rate']:.3f}.\n\n{table('plans | mean chance | came true', rows)}"
    )


def scaling_page(results: Figures) -> str:
    """Write the page about how many objects there are."""
    scaling, missing = results["scaling"], results["missing"]
    cap, tasks = scaling["cap_seconds"], scaling["tasks_in_a_cell"]
    unfinished = f" **Not finished**: {missing} jobs of the evaluation to do." if missing else ""
    return document(
        "# Planning at scale, measured",
        f"By `{results['command']}`, which wrote this page, `scaling.json` and `scaling.png`.{unfinished} "
        f"{tasks} symbolic tasks in each cell, in the shipped domain with cells of 5 mm: goals that are "
        "1 to 3 (easy) or 5 to 8 (hard) primitives away for each object alone, by the shortest plan; "
        "above 4 objects, none is wider than 75 mm. *Object by object*: a problem for each object, plans put "
        f"one after another; *whole*: one problem. {cap:g} s at most; after two time-outs in a cell, its "
        "other tasks are not tried. BFS is allowed 3 primitives, which hard goals and many objects exceed.",
        "![Seconds and steps against objects](scaling.png)",
        "*Over the fewest*: primitives beyond the fewest there can be, counted exactly. With its costs, Fast "
        "Downward asks for what is reliable, which takes more steps; *no costs*: all operators cost alike. "
        "*Memory*: of the largest process, Python's own included.",
        *(
            f"## {difficulty.capitalize()} goals\n\n{_contenders(scaling['contenders'], difficulty)}"
            for difficulty in ("easy", "hard")
        ),
        "## Why not",
        _why_not(scaling["contenders"]),
    )


def _contenders(contenders: Figures, difficulty: str) -> str:
    def told(cell: Figures) -> list[str]:
        over = None if cell["over_fewest"] is None else f"{100 * (cell['over_fewest'] - 1):+.0f} %"
        also = {"of": f"{cell['solved']} of {cell['tasks']}", "over": over or "-"}
        names = ("of", "valid", "seconds:2", "slowest:2", "primitives:1", "over", "megabytes:0")
        return written({**cell, **also}, *names)

    rows = [
        [contender, size.split()[0], *told(cell)]
        for contender, of_sizes in contenders.items()
        for size, cell in of_sizes.items()
        if size.split()[1] == difficulty
    ]
    columns = "planner | objects | solved | valid | median [s] | slowest [s] | primitives"
    return table(f"{columns} | over the fewest | memory [MB]", rows)


def _why_not(contenders: Figures) -> str:
    rows = []
    for contender, of_sizes in contenders.items():
        for size, cell in of_sizes.items():
            left = cell["status"].get("not tried", 0)
            reasons = {"not tried after two time-outs": left} if left else {}
            told = {**reasons, **cell["reasons"]}
            rows += [[contender, size, why, str(count)] for why, count in told.items()]
    return table("planner | cell | what it said | tasks", rows)
