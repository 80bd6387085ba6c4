"""The command that lists the planners."""

from neurosym.console import say, show_table


def planners() -> int:
    """List the planners: what each is, the encodings it takes, the usual first, and whether it is here."""
    from neurosym.planners import PLANNERS

    rows = []
    for planner in PLANNERS.values():
        encodings = ", ".join(planner.encodings) or "-"
        cell = planner.program.cell if planner.program else 0.0
        cells = f", cells from {cell * 1000:g} mm" if cell else ""
        rows.append([planner.name, planner.about, encodings + cells, planner.missing() or "yes"])
    show_table("Planners", ["planner", "what it is", "encodings", "installed"], rows)
    say("`pip install 'neurosym[planners]'` brings those that are not")
    return 0
