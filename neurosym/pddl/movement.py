"""Movement: what is under way goes along each axis in turn, so that nothing is grounded over all at once."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from neurosym.data.cells import Cells, Step
from neurosym.pddl.syntax import Atom


class Along(NamedTuple):
    """An axis as a page has it: its name, its variables, and the type of its steps."""

    name: str
    cell: str  # variable of the cell that a thing is in; its type is NAME-cell
    to: str  # and of the one that it comes to
    step: str  # variable of a step
    steps: str  # type of steps

    @property
    def types(self) -> dict[str, str]:
        """The type of each variable."""
        return {self.cell: f"{self.name}-cell", self.to: f"{self.name}-cell", self.step: self.steps}


def movement_predicates(axes: Sequence[Along]) -> str:
    """Say how far something has to go, and which steps lead where; see `predicates_in`."""
    begins = ("?o is under way, and has to go", *("and" for _ in axes[1:]))
    lines = [
        f"(due-{axis.name} ?o {axis.step}) ; {begin} so far along {axis.name}"
        for begin, axis in zip(begins, axes, strict=True)
    ]
    lines += [f"(went-{axis.name} ?o) ; ?o went along {axis.name} already" for axis in axes[:-1]]
    lines += [
        f"({name}-sum {step} {cell} {to}) ; from {cell}, {step} leads to {to}"
        for name, cell, to, step, _ in axes
    ]
    return "\n".join(lines)


def movement_actions(axes: Sequence[Along]) -> str:
    """Move something along each axis, after those before it; the last makes ready again; see `actions_in`."""
    return "".join(_action(axes, number) for number in range(len(axes)))


def _action(axes: Sequence[Along], number: int) -> str:
    name, cell, to, step, _ = axes[number]
    is_last = number == len(axes) - 1
    after = f"(went-{axes[number - 1].name} ?o)" if number else ""
    then = "(ready)" if is_last else f"(went-{name} ?o)"
    ends = ", which ends the motion" if is_last else ""
    return f"""
        (move-{name} ?o {step} {cell} {to}) ; {"and" if number else "shift ?o"} along {name}{ends}
            needs {after} (due-{name} ?o {step}) (at-{name} ?o {cell}) ({name}-sum {step} {cell} {to})
            adds {then} (at-{name} ?o {to})
            deletes {after} (due-{name} ?o {step}) (at-{name} ?o {cell})
    """


def sums(cells: Cells, step: Step, named: str, margin: int = 0) -> Iterator[Atom]:
    """Say from which cells a step of a name leads to which; none ends so near to the bounds."""
    names = cells.names
    for here, there in cells.leads(step, margin):
        yield f"{cells.axis.name}-sum", named, names[here], names[there]
