"""The command that lists the planners."""

from neurosym.commands.answers import Json, answer_in
from neurosym.console import say, show_table


def planners(json: Json = False) -> int:
    """List the planners: what each is, the encodings it takes, the usual first, and whether it is here."""
    from neurosym.planners import PLANNERS

    answer, rows = answer_in(json), []
    for planner in PLANNERS.values():
        others = ("places", "relational") if "stepwise" in planner.encodings else ()
        encodings = ", ".join((*planner.encodings, *others)) or "-"
        cell = planner.program.cell if planner.program else 0.0
        cells = f", cells from {cell * 1000:g} mm" if cell else ""
        rows.append([planner.name, planner.about, encodings + cells, planner.missing() or "yes"])
    show_table("Planners", ["planner", "what it is", "encodings", "installed"], rows)
    say("where a domain has places, planners that take them try them first; so with relations")
    say("`pip install 'neurosym-pddl[planners]'` brings those that are not")
    answer(
        [
            {"name": one.name, "about": one.about, "encodings": one.encodings, "missing": one.missing()}
            for one in PLANNERS.values()
        ]
    )
    return 0
