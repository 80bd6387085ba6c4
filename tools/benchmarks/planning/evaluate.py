"""Measure what docs/planning.md claims: Table III, plans that are valid and come true, scale, and failures.

Every job writes a file of its own into a working folder, so that the run can be interrupted and goes on where
it was; what was measured with another domain is measured again. The results go to docs/results/ (planning and
scaling, each as .json, .md and .png), as far as they are known.
"""

from pathlib import Path
from typing import Annotated

import tyro

from neurosym.files import write_atomically
from tools.benchmarks import options
from tools.benchmarks.jobs import Evaluation, as_text
from tools.benchmarks.planning.jobs import USUAL, Agenda, Strategy, size_of
from tools.benchmarks.planning.pictures import draw_scaling, draw_table3
from tools.benchmarks.planning.summary import summarise
from tools.benchmarks.planning.tables import page, scaling_page


def main(
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of Table III; 1 is the short form.")] = 5,
    steps: options.Steps = 2560,
    strategies: Annotated[tuple[Strategy, ...], tyro.conf.arg(help="Whom Table III compares.")] = USUAL,
    work: options.Work = Path("evaluation/planning"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Learn, do every job that was not done, and write the results."""
    options.check_positive(seeds=seeds, steps=steps, workers=workers)
    evaluation = Evaluation("planning", work, results, workers)
    agenda = Agenda(work, size_of(seeds, steps, strategies))
    write_results(evaluation, agenda)
    for label, turn in agenda.turns(learn=True):
        wanted = {name: job for name, job in turn.items() if "-none-" not in name}
        evaluation.perform(wanted, label, fresh=label == "scaling")
        write_results(evaluation, agenda)


def write_results(evaluation: Evaluation, agenda: Agenda) -> None:
    """Write JSON, Markdown and PNG from the jobs that are done."""
    results = evaluation.results
    summary = summarise(evaluation.found(), agenda)
    evaluation.write(summary, page(summary))
    write_atomically(results / "scaling.json", as_text(summary["scaling"]))
    write_atomically(results / "scaling.md", scaling_page(summary))
    draw_table3(summary, results / "planning.png")
    draw_scaling(summary["scaling"], results / "scaling.png")


if __name__ == "__main__":
    options.begin(main)
