"""How figures are summed up, and written into pages of Markdown."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from statistics import mean, stdev
from typing import Any

from neurosym.stages.verdicts import wilson

NOT_YET = "not measured yet"


def share_of(part: float, of: float) -> float | None:
    """Return a share; None of nothing."""
    return part / of if of else None


def mean_of(values: Iterable[float | None]) -> float | None:
    """Return the mean of what is known; None if nothing is."""
    known = [value for value in values if value is not None]
    return float(mean(known)) if known else None


def tally(names: Iterable[str]) -> dict[str, int]:
    """Count names but empty ones, the most frequent first."""
    return dict(sorted(Counter(filter(None, names)).items(), key=lambda item: (-item[1], item[0])))


def document(*parts: str) -> str:
    """Join the parts of a page."""
    return "\n\n".join(parts) + "\n"


def table(columns: str | Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Write a table, its columns named as in `size | tasks`; or say that there is nothing to write yet."""
    if not rows:
        return NOT_YET
    titles = columns.split(" | ") if isinstance(columns, str) else columns
    lines = [titles, ["---"] * len(titles), *rows]
    escaped = [[cell.replace("|", "\\|") for cell in line] for line in lines]
    return "\n".join(f"| {' | '.join(line)} |" for line in escaped)


def figures_table(columns: str, cells: Mapping[str, Mapping[str, Any]], *names: str) -> str:
    """Write a row of figures for each cell, but for those whose first figure is nothing; see `written`."""
    first = names[0].partition(":")[0]
    return table(columns, [[name, *written(cell, *names)] for name, cell in cells.items() if cell[first]])


def written(found: Mapping[str, Any], *names: str) -> list[str]:
    """Write figures, each as it is or as a form says: `share:1%` and `seconds:2` with so many digits."""
    texts = []
    for name, _, form in (one.partition(":") for one in names):
        value = found[name]
        if form:
            texts.append(percent(value, None, int(form[0])) if form[1:] else number(value, int(form)))
        else:
            texts.append(counts(value) if isinstance(value, Mapping) else str(value))
    return texts


def listed(values: Mapping[str, Any]) -> str:
    """Write names with their values, as of a machine."""
    return ", ".join(f"{name} {value}" for name, value in values.items())


def counts(reasons: Mapping[str, int]) -> str:
    """Write reasons, each with how often it was one."""
    return ", ".join(f"{reason} ({count})" for reason, count in reasons.items()) or "-"


def number(value: float | None, digits: int = 2) -> str:
    """Write a number, or a dash for none."""
    return "-" if value is None else f"{value:.{digits}f}"


def percent(share: float | None, spread: float | None = None, digits: int = 0) -> str:
    """Write a share with its standard deviation, or a dash for none."""
    if share is None:
        return "-"
    told = f"{100 * share:.{digits}f}"
    return f"{told} ± {100 * spread:.{digits}f} %" if spread is not None else f"{told} %"


def with_interval(share: float | None, of: int, spread: str = "") -> str:
    """Write a share with its Wilson interval at 95 %, or a dash for none."""
    if share is None:
        return "-"
    low, high = wilson(round(share * of), of)
    return f"{100 * share:.0f} %{spread} ({100 * low:.0f} to {100 * high:.0f})"


def over_seeds(values: Sequence[float | None], form: str = "{:.1f}", digits: int = 1) -> str:
    """Write mean and standard deviation of what is known, or a dash if nothing is."""
    known = [value for value in values if value is not None]
    return (form.format(mean(known)) if known else "-") + spread_of(known, digits)


def spread_of(known: Sequence[float], digits: int) -> str:
    """Write the standard deviation of several values; nothing of a single one."""
    return f" ± {stdev(known):.{digits}f}" if len(known) > 1 else ""
