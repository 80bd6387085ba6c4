"""The command that lists the planners."""

from neurosym.console import say, show_table


def planners() -> int:
    """List the planners: what each is, the encodings it takes, the usual first, and whether it is here."""
    from neurosym.planners import PDDL_PLANNERS, PLANNERS

    rows = []
    for name, about in PLANNERS.items():
        tool = PDDL_PLANNERS.get(name)
        encodings = ", ".join(tool.encodings) if tool else "-"
        cells = f", cells from {tool.cell * 1000:g} mm" if tool and tool.cell else ""
        rows.append([name, about, encodings + cells, (tool.missing() if tool else "") or "yes"])
    show_table("Planners", ["planner", "what it is", "encodings", "installed"], rows)
    say("`pip install 'neurosym[planners]'` brings those that are not")
    return 0
