"""The table of a campaign, to be read and to be read by programs."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from tools.faults.trials import Trial

TITLES = {
    "kills": "Killed at a drawn moment, and started again",
    "disk": "On a full disk, and again with room",
    "pairs": "The same command twice at once in one folder",
    "limits": "With low limits",
    "clock": "With clocks that jump",
}


def summarise(trials: Iterable[Trial], about: Mapping[str, Any]) -> dict[str, Any]:
    """Count trials and findings."""
    groups: dict[str, list[Trial]] = {}
    for trial in trials:
        groups.setdefault(f"{trial.part} {trial.subject} {trial.world}", []).append(trial)
    parts: dict[str, list[dict[str, Any]]] = {}
    for group in groups.values():
        parts.setdefault(group[0].part, []).append(_row(group))
    return {**about, "parts": {part: parts[part] for part in TITLES if part in parts}}


def _row(group: Sequence[Trial]) -> dict[str, Any]:
    findings = [f"{trial.told}: {found}" for trial in group for found in trial.found]
    return {
        "command": group[0].subject,
        "world": group[0].world,
        "trials": len(group),
        "kills": sum(trial.kills for trial in group),
        "as_promised": sum(not trial.found for trial in group),
        "outcomes": dict(Counter(_kind(trial) for trial in group).most_common()),
        "findings": findings,
        "seconds": round(sum(trial.seconds for trial in group), 1),
    }


def _kind(trial: Trial) -> str:
    """Say how a trial ended, without what is different each time."""
    return trial.outcome.partition(":")[0]


def page(summary: Mapping[str, Any]) -> str:
    """Print a summary as Markdown."""
    lines = [
        "# A campaign of faults",
        "",
        f"`{summary['command']}`, seed {summary['seed']}, {summary['minutes']:.0f} minutes. "
        f"What is promised stands in [reliability.md](../reliability.md).",
        *(f"Left out: {reason}." for reason in summary["left_out"]),
        "",
    ]
    for part, rows in summary["parts"].items():
        lines += [f"## {TITLES[part]}", "", *_table(part, rows), ""]
        lines += [f"- {row['command']}, {row['world']}: {text}" for row in rows for text in row["findings"]]
        lines += [""] if any(row["findings"] for row in rows) else []
    return (
        "\n".join(" ".join(line.split()) if line.startswith("- ") else line for line in lines).rstrip() + "\n"
    )


def _table(part: str, rows: Sequence[Mapping[str, Any]]) -> list[str]:
    what = "kills" if part == "kills" else "trials"
    head = f"| command | world | {what} | as promised | how they ended |"
    body = [
        f"| {row['command']} | {row['world']} | {row[what]} | {row['as_promised']} of {row['trials']} | "
        f"{'; '.join(f'{count} {kind}' for kind, count in row['outcomes'].items())} |"
        for row in rows
    ]
    return [head, "| --- | --- | --- | --- | --- |", *body]
