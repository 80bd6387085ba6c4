"""PDDL as data: actions, domains and problems, with one printer, and what their plans do.

Everything is positive STRIPS with types, and costs. An atom is its words, like `("stands", "?o", "?p")`.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Literal

from neurosym.errors import InvalidValue, counted, one_called
from neurosym.grounding import Grounding

Atom = tuple[str, ...]
"""A predicate or a function and its arguments."""
Typed = tuple[str, str]
"""A name, and its type."""
OBJECT = "object"
_TOTAL, _BELOW = ("total-cost",), "\n    "


@dataclass(frozen=True, slots=True)
class Action:
    """A lifted action; parameters have their types."""

    name: str
    about: str  # what it does, in a sentence
    parameters: tuple[Typed, ...]
    needs: tuple[Atom, ...]
    adds: tuple[Atom, ...]
    deletes: tuple[Atom, ...] = ()
    cost: Atom | None = None  # the function that says what it costs, if it costs anything
    tests: tuple[str, ...] = ()  # what must hold of numbers, as PDDL prints it
    changes: tuple[str, ...] = ()  # what becomes of numbers, as PDDL prints it

    def text(self, *, costs: bool) -> str:
        """Print it, with what it costs or without."""
        effects = [*(f"(not {words(atom)})" for atom in self.deletes), *map(words, self.adds), *self.changes]
        if costs and self.cost:
            effects.append(f"(increase {words(_TOTAL)} {words(self.cost)})")
        return (
            f"  (:action {self.name} ; {self.about}\n    :parameters ({_declared(self.parameters)})\n"
            f"    :precondition (and {' '.join([*map(words, self.needs), *self.tests])})\n"
            f"    :effect (and {' '.join(effects)}))"
        )


@dataclass(frozen=True, slots=True)
class Predicate:
    """A predicate or a function: what it is called, its parameters with their types, and what it says."""

    name: str
    parameters: tuple[Typed, ...]
    about: str

    @property
    def text(self) -> str:
        """It as it is declared."""
        return f"({' '.join(filter(None, (self.name, _declared(self.parameters))))})"


@dataclass(frozen=True, slots=True)
class Domain:
    """A domain."""

    name: str
    head: tuple[str, ...]  # what it begins with as comments, a line each
    types: tuple[Typed, ...]  # each with its parent; parents before children
    constants: tuple[Typed, ...]
    predicates: tuple[Predicate, ...]
    costs: tuple[Predicate, ...]  # the functions that say what steps cost
    actions: tuple[Action, ...]
    functions: tuple[Predicate, ...] = ()  # other functions

    def action(self, name: str) -> Action:
        """Return the action of a name; `UnknownChoice` if there is none."""
        return one_called("action", name, self.actions)

    def text(self, *, costs: bool = True) -> str:
        """Print it, with what steps cost or without."""
        numbers = [words(_TOTAL)] * costs
        numbers += [one.text for one in (*self.functions, *(self.costs if costs else ()))]
        more = " :numeric-fluents" * bool(self.functions) + " :action-costs" * costs
        lines = [
            *(f"; {line}".rstrip() for line in self.head),
            f"(define (domain {self.name})",
            f"  (:requirements :strips :typing{more})",
            f"  (:types\n    {_declared(self.types, _BELOW)})",
            *([f"  (:constants {_declared(self.constants)})"] if self.constants else []),
            "  (:predicates",
            *(f"    {one.text} ; {one.about}" for one in self.predicates),
            "  )",
            *([f"  (:functions {' '.join(f'{one} - number' for one in numbers)})"] if numbers else []),
            *(action.text(costs=costs) for action in self.actions),
        ]
        return "\n".join(lines) + ")\n"


@dataclass(frozen=True, slots=True)
class Facts:
    """Facts of a problem that belong together, and what they say as a comment; none if empty."""

    about: str
    atoms: tuple[Atom, ...]


@dataclass(frozen=True, slots=True)
class PddlProblem:
    """A problem."""

    name: str
    domain: str
    head: tuple[str, ...]  # what it begins with as comments, a line each
    objects: tuple[Typed, ...]
    facts: tuple[Facts, ...]  # what holds at the start
    costs: Mapping[Atom, int]  # what steps cost
    goals: tuple[Atom, ...]
    values: Mapping[Atom, int] = field(default_factory=dict)  # of other functions at the start
    tests: tuple[str, ...] = ()  # what shall hold of numbers, as PDDL prints it

    @property
    def atoms(self) -> frozenset[Atom]:
        """All facts that hold at the start."""
        return frozenset(atom for facts in self.facts for atom in facts.atoms)

    def text(self, *, costs: bool = True) -> str:
        """Print it, with what steps cost or without."""
        lines = [*(f"; {line}".rstrip() for line in self.head), f"(define (problem {self.name})"]
        lines += [f"  (:domain {self.domain})", f"  (:objects\n    {_declared(self.objects, _BELOW)})"]
        lines += ["  (:init"]
        for facts in self.facts:
            lines += [f"    ; {facts.about}"] if facts.about else []
            rows = groupby(facts.atoms, key=lambda atom: atom[1:2])
            lines += [f"    {' '.join(map(words, row))}" for _, row in rows]
        tables = [dict(row) for _, row in groupby(self.values.items(), key=lambda one: one[0][1])]
        for table in (*tables, *([{_TOTAL: 0, **self.costs}] if costs else [])):
            lines.append("    " + " ".join(f"(= {words(atom)} {value})" for atom, value in table.items()))
        lines += ["  )", f"  (:goal (and {' '.join([*map(words, self.goals), *self.tests])}))"]
        lines += [f"  (:metric minimize {words(_TOTAL)})"] * costs
        return "\n".join(lines) + ")\n"


def words(atom: Atom) -> str:
    """Print an atom."""
    return f"({' '.join(atom)})"


def _declared(names: Iterable[Typed], between: str = " ") -> str:
    """Print names with their types, those of one type that follow each other in a row."""
    rows = groupby(names, key=lambda one: one[1])
    return between.join(f"{' '.join(name for name, _ in row)} - {kind}" for kind, row in rows)


def actions_in(text: str, types: Mapping[str, str]) -> tuple[Action, ...]:
    """Read actions that are written as the page has them: a head, and under it what each needs and does."""
    found = []
    for block in filter(str.strip, re.split(r"\n(?=\s*\([^()]*\) ;)", text)):
        head, *clauses = re.split(r"\s(needs|adds|deletes|costs|tests|changes)\s", block)
        clause = dict(zip(clauses[::2], clauses[1::2], strict=True))
        (one,) = predicates_in(head, types)
        needs, adds, deletes, costs = (
            _atoms(clause.get(name, "")) for name in ("needs", "adds", "deletes", "costs")
        )
        numbers = [
            (" ".join(clause[name].split()),) if name in clause else () for name in ("tests", "changes")
        ]
        price = costs[0] if costs else None
        found.append(Action(one.name, one.about, one.parameters, needs, adds, deletes, price, *numbers))
    return tuple(found)


def predicates_in(text: str, types: Mapping[str, str]) -> tuple[Predicate, ...]:
    """Read predicates, each on a line with what it says behind it."""
    found = []
    for line in filter(None, map(str.strip, text.splitlines())):
        words, _, about = line.partition(" ; ")
        ((name, *parameters),) = _atoms(words)
        found.append(Predicate(name, tuple((one, types[one]) for one in parameters), about))
    return tuple(found)


def _atoms(text: str) -> tuple[Atom, ...]:
    return tuple(tuple(found.split()) for found in re.findall(r"\(([^()]*)\)", text))


@dataclass(slots=True)
class Course:
    """What holds while the ground actions of a plan are taken, one after another."""

    domain: Domain
    holds: set[Atom]

    def take(self, name: str, arguments: Sequence[str]) -> None:
        """Take a ground action, or refuse one that the domain does not have, or that is not possible here."""
        action = self.domain.action(name)
        parameters = [parameter for parameter, _ in action.parameters]
        if len(arguments) != len(parameters):
            told = counted(len(arguments), "argument")
            raise InvalidValue(f"it has {told}; valid: {words((name, *parameters))}")
        given = dict(zip(parameters, arguments, strict=True))
        needs, deletes, adds = (
            [tuple([given.get(word, word) for word in atom]) for atom in atoms]
            for atoms in (action.needs, action.deletes, action.adds)
        )
        if missing := next((atom for atom in needs if atom not in self.holds), None):
            alike = [atom for atom in self.holds if atom[:2] == missing[:2]]
            instead = f"; what holds is {words(alike[0])}" if len(alike) == 1 else ""
            raise InvalidValue(f"{words(missing)} does not hold there{instead}")
        self.holds.difference_update(deletes)
        self.holds.update(adds)


# The encodings of a domain, by name

EncodingName = Literal["strips", "numeric", "sas"]

STRIPS: EncodingName = "strips"
"""The page: lifted actions, places, relations, and cells for what can only be pushed."""
NUMERIC: EncodingName = "numeric"
"""Positions are numbers; there are no cells, places and relations."""
SAS: EncodingName = "sas"
"""No PDDL: what Fast Downward's search reads of objects that are led over cells."""
ENCODINGS: tuple[EncodingName, ...] = (STRIPS, NUMERIC)
"""Those that are printed."""
DURATIVE = "durative"
"""Objects are carried by actions that take time; no command plans in it."""


def domain_name(grounding: Grounding, encoding: str) -> str:
    """Name the domain in an encoding, like `tabletop-numeric`; the page has the name of the domain itself."""
    return grounding.name if encoding in (STRIPS, SAS) else f"{grounding.name}-{encoding}"
