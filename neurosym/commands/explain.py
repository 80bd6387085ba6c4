"""The command `neurosym explain`: what the symbols mean, in words."""

from pathlib import Path
from typing import Annotated, Optional

from tyro.conf import arg

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.options import Folder, check_file, opened
from neurosym.console import say, say_next
from neurosym.files import write_atomically
from neurosym.stages.layout import GROUNDING, WORLD
from neurosym.wording import quoted


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
    from neurosym.commands.explain_text import explanation_page, is_long, show_explanation
    from neurosym.explain.from_folder import explain_folder

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
