"""The command that lists the planners."""

from neurosym.commands.answers import Json, answer_in
from neurosym.console import say, show_table


def planners(json: Json = False) -> int:
    """List the planners, the encodings that they take, and whether they are here."""
    from neurosym.planners.catalogue import PLANNERS
    from neurosym.planners.track_record import track_record

    record = track_record()
    answer, rows = answer_in(json), []
    for planner in PLANNERS.values():
        encodings = ", ".join(planner.encodings) or "-"
        cell = planner.program.cell if planner.program else 0.0
        cells = f", cells from {cell * 1000:g} mm" if cell else ""
        solved = record.of(planner.name) or "-"
        rows.append([planner.name, planner.about, encodings + cells, solved, planner.missing() or "yes"])
    show_table("Planners", ["planner", "what it is", "encodings", "solved", "installed"], rows)
    problems = " and ".join(record.problems)
    say(f"solved: of {problems} of tabletop, whole, in {record.time_limit:g} s each; - is one of ours")
    say("strips is the page, domain.pddl; sas is what Fast Downward makes of objects that are led over cells")
    say("`pip install 'neurosym-pddl[planners]'` brings those that are not")
    answer(
        [
            {
                "name": one.name,
                "about": one.about,
                "encodings": one.encodings,
                "solved": record.solved.get(one.name, {}),
                "missing": one.missing(),
            }
            for one in PLANNERS.values()
        ]
    )
    return 0
