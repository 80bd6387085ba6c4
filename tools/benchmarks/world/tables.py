"""The results of `evaluate.py` as a page of Markdown tables."""

from typing import Any

from tools.benchmarks.tables import document, listed, table


def page(results: dict[str, Any]) -> str:
    """Write the page."""
    details = results["details"]
    matters = details["object_matters"]
    return document(
        "# The tabletop world, measured",
        f"By `{results['command']}`, which wrote this page and `world.json`. "
        f"Machine: {listed(results['machine'])}.",
        "## Main figures",
        table("figure | value", _main_figures(results)),
        "## Hand-written primitives",
        "Success on objects that afford the primitive; in brackets the share of objects that do.",
        _hand_written(results["hand_written"]),
        "## Carried to a place",
        "Hand-written, to places all over the table but for 5 cm along its edge. Offset: from the place to "
        "the centre of the object, where it stands in the end.",
        _carrying(details["carrying"], details["predictability_of_carrying"]),
        "## What the object decides",
        f"{matters['actions']} random actions on the same {matters['objects']} random objects: how each kind "
        "of object ends. Unmoved: by less than 1 cm.",
        _outcomes(matters["outcomes_by_kind"]),
        "## Speed",
        _speeds(details),
    )


def _main_figures(results: dict[str, Any]) -> list[list[str]]:
    details = results["details"]
    chaos, coarse, chance = (
        details[name] for name in ("predictability", "predictability_at_1_120", "random")
    )
    other = details["predictability_other_seed"]
    by_shape = ", ".join(f"{shape} {share:.3f}" for shape, share in chaos["by_shape"].items())
    held = ", ".join(f"{kind} {share:.1%}" for kind, share in chance["held_by_kind"].items())
    by_axis = ", ".join(f"{share:.2f}" for share in details["object_matters"]["by_axis"])
    down = f"{chance['put_down_within_1cm']:.1%}, median {chance['put_down_median_mm']:.1f} mm"
    rows = {
        "share of the effects' variance that survives 0.1 mm": f"{chaos['share']:.3f} ({by_shape})",
        "the same, another seed; at 1/120 s": f"{other['share']:.3f}; {coarse['share']:.3f}",
        "held after a random action; at 1/120 s": f"{chaos['held']:.1%}; {coarse['held']:.1%}",
        "held, by kind of object": held,
        f"put down within 1 cm of where it hung ({chance['lifts']} lifts)": down,
        "toppled; lost": f"{chance['toppled']:.1%}; {chance['lost']:.1%}",
        "moved less than 1 cm": f"{chance['moved_less_than_1cm']:.1%}",
        "greatest displacement at rest": f"{chance['greatest_displacement_m']:.2f} m",
        "ended inside the table": str(chance["below_the_table"]),
        "variance of the effect decided by the action alone (x, y, z)": (
            f"{results['variance_by_action_alone']:.2f} ({by_axis})"
        ),
        f"{chance['interactions']} random interactions with {chance['workers']} workers": (
            f"{chance['minutes']} min"
        ),
    }
    for part in (details["two_objects"], details["eight_objects"]):
        title = f"{part['objects']} objects: the robot touched another; another moved by over 5 mm"
        rows[title] = f"{part['robot_touched_a_bystander']:.1%}; {part['a_bystander_moved']:.1%}"
    return [list(row) for row in rows.items()]


def _hand_written(found: dict[str, Any]) -> str:
    shapes = list(next(iter(found.values())))
    rows = [
        [name, *(f"{row[shape]['success']:.0%} ({row[shape]['afforded_by']:.0%})" for shape in shapes)]
        for name, row in found.items()
    ]
    failures = [
        f"{name} on {shape}: " + ", ".join(f"{count} {reason}" for reason, count in cell["failures"].items())
        for name, row in found.items()
        for shape, cell in row.items()
        if cell["failures"]
    ]
    return f"{table(['primitive', *shapes], rows)}\n\nFailures: {'; '.join(failures) or 'none'}."


def _carrying(found: dict[str, Any], chaos: dict[str, Any]) -> str:
    rows = [
        [
            f"{shape} ({row['objects']} objects; {row['afforded_by']:.0%} can be grasped so)",
            *(f"{row['success']:.0%}", *(f"{one:.1f}" for one in (*row["offset_mm"], row["turn_degrees"]))),
        ]
        for shape, row in found.items()
    ]
    median, most = chaos["carried_ends_apart_mm"]
    said = (
        f"Of {chaos['interactions']} random actions with a random place {chaos['carried']:.1%} carry the "
        f"object. Changed by 0.1 mm, {chaos['carried_in_one_of_two']} carry it in one case only, and "
        f"{chaos['ends_apart_by_over_10_mm']:.1%} end over 10 mm apart; what is carried both times ends "
        f"{median} mm apart (90 %: {most} mm)."
    )
    columns = "shape | set down there | median offset [mm] | 90 % [mm] | 90 % of turns [degrees]"
    return f"{table(columns, rows)}\n\n{said}"


def _outcomes(kinds: dict[str, dict[str, float]]) -> str:
    modes = sorted({mode for row in kinds.values() for mode in row if mode != "objects"})
    rows = [
        [kind, f"{row['objects']:.0f}", *(f"{row.get(mode, 0.0):.1%}" for mode in modes)]
        for kind, row in kinds.items()
    ]
    return table(["kind", "objects", *modes], rows)


def _speeds(details: dict[str, Any]) -> str:
    fine, coarse = details["speed"], details["speed_at_1_120"]
    names = [name for name in fine if not name.startswith("memory") and name not in ("time_step", "profile")]
    rows = [[name.replace("_", " "), str(fine[name]), str(coarse[name])] for name in names]
    memory = details["memory"]
    spent = ", ".join(f"{part} {share:.0%}" for part, share in fine["profile"].items())
    grown = f"{memory['memory_growth_mb']} MB over {memory['memory_growth_over_interactions']} interactions"
    return (
        f"{table('figure | 1/240 s | 1/120 s', rows)}\n\n"
        f"Where the time goes at 1/240 s, as the profiler sees it: {spent}.\n\n"
        f"One worker takes {memory['memory_mb_a_worker']} MB and grows by {grown}."
    )
