"""The command `neurosym practise`: more is learned of the operators that break plans."""

from typing import Annotated

from tyro.conf import arg

from neurosym.commands.options import CPUS, Folder, Seed, Workers, opened
from neurosym.console import say, say_next, show_table
from neurosym.stages.layout import DOMAIN, PRACTICE
from neurosym.wording import counted, quoted


def practise(
    folder: Folder,
    interactions: Annotated[
        int, arg(help="Interactions in all, with those of earlier calls; the last round is finished.")
    ] = 2000,
    seed: Seed = 0,
    workers: Workers = CPUS,
) -> int:
    """Practise where plans fail: draw tasks, execute plans, improve what broke them.

    Then the domain is compiled anew. Interrupt it when you like: the same command goes on from the last round
    that was finished.
    """
    from neurosym.pddl.compiler import CELL
    from neurosym.stages.compiling import compile_stage
    from neurosym.stages.practised import practice_of
    from neurosym.stages.practising import practise_stage

    domain = opened(folder)
    stage = practise_stage(domain, interactions=interactions, seed=seed, workers=workers)
    domain.perform(stage, again=True)
    compiled = domain.manifest().stages.get("compile-domain")
    domain.perform(
        compile_stage(domain, cell=compiled.options.get("cell", CELL) if compiled else CELL), again=False
    )
    found = practice_of(domain)
    rounds = found.practised.rounds if found else ()
    rows = [
        [
            str(number),
            f"{one.reached} of {one.planned}",
            ", ".join(f"{name} ({count})" for name, count in one.broke.items()) or "-",
            ", ".join(
                f"{lesson.operator} {lesson.before:.2f} -> {lesson.after:.2f}" for lesson in one.lessons
            ),
        ]
        for number, one in enumerate(rounds, 1)
    ]
    columns = ["round", "came true", "broke plans", "practised: competence before -> after"]
    show_table(f"{counted(len(rounds), 'round')} of practice", columns, rows)
    spent = counted(sum(one.spent for one in rounds), "interaction")
    say(f"{spent}; what was practised lies in {domain / PRACTICE}")
    if sum(one.spent for one in rounds) < interactions:
        say("note: it ended earlier, because no task had a plan, and no operator was left to be practised")
    say(f"{domain / DOMAIN} is compiled from it")
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0
