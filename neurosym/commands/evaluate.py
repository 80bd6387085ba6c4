"""The command `neurosym evaluate`: the paper's tables from domain folders."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.commands.options import CPUS, Workers, check_file, opened
from neurosym.console import progress_bar, say, show_table
from neurosym.errors import InvalidValue
from neurosym.files import write_atomically, write_json
from neurosym.stages.layout import INTERACTIONS

if TYPE_CHECKING:
    from neurosym.evaluation.paper_tables import Table


def evaluate(
    folders: Annotated[
        Positional[tuple[Path, ...]], arg(metavar="DIR...", help="Domain folders, say of several seeds.")
    ],
    test: Annotated[
        Optional[Path],
        arg(
            metavar="DATA",
            help="Interactions that errors are measured on, best random ones: an .npz file or a folder.",
        ),
    ] = None,
    output: Annotated[
        Optional[Path], arg(metavar="FILE", help="Also write the tables here, as .md or .json.")
    ] = None,
    workers: Workers = CPUS,
) -> int:
    """Print the paper's Tables I (errors), II (primitives) and III (planning).

    Folders are grouped by strategy: mean and standard deviation over those of each. The primitives of a
    folder are rehearsed once, to judge their kinds (`kinds.json`); Table III is of what `neurosym compare`
    left there.
    """
    from neurosym.data.interactions import Interactions
    from neurosym.evaluation.paper_tables import measure, tables
    from neurosym.worlds.workers import check_workers

    if not folders:
        raise InvalidValue("Name at least one domain folder.")
    check_workers(workers)
    check_file(output, "tables", ".md", ".json")
    domains = [opened(folder) for folder in dict.fromkeys(folders)]
    for domain in domains:
        domain.require(INTERACTIONS)
    path = test / INTERACTIONS if test and test.is_dir() else test
    data = Interactions.load(path) if path else None
    measured = []
    for domain in domains:
        with progress_bar("rehearsing") as advance:
            measured.append(measure(domain, data, workers=workers, progress=advance))
    found = tables(measured, test)
    for table in found:
        show_table(table.title, table.columns, table.rows)
        say(table.remark)
    if output:
        if output.suffix == ".json":
            write_json(output, {"folders": measured, "tables": found})
        else:
            write_atomically(output, _page(found))
        say(f"wrote {output}")
    return 0


def _page(tables: "tuple[Table, ...]") -> str:
    from neurosym.markdown import markdown_table

    parts = [
        f"## {table.title}\n\n{table.remark}\n\n{markdown_table(table.columns, table.rows)}"
        for table in tables
    ]
    return "\n\n".join(parts) + "\n"
