"""Tables as Markdown, and figures over several repetitions."""

from collections.abc import Sequence

import numpy as np


def markdown_table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table as Markdown.

    Args:
        columns: Headings.
        rows: One text for each heading.
    """
    lines = [columns, ["---"] * len(columns), *rows]
    escaped = [[cell.replace("|", "\\|") for cell in line] for line in lines]
    return "\n".join(f"| {' | '.join(line)} |" for line in escaped)


def mean_and_spread(values: Sequence[float | int], digits: int = 3) -> str:
    """Write mean and standard deviation over repetitions.

    Args:
        values: One for each repetition, at least one.
        digits: How many stand after the point.
    """
    return f"{np.mean(values):.{digits}f} ± {np.std(values):.{digits}f}"
