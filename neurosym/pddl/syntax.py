"""PDDL as data: actions, domains and problems, with one printer, and what their plans do.

Everything is positive STRIPS with types, and costs. An atom is its words, like `("stands", "?o", "?p")`.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Literal

from neurosym.errors import InvalidValue, UnknownChoice, counted
from neurosym.grounding import Grounding

Atom = tuple[str, ...]
"""A predicate or a function and its arguments."""
Typed = tuple[str, str]
"""A name, and its type."""
OBJECT = "object"
TOTAL_COST = "(total-cost)"


@dataclass(frozen=True, slots=True)
class Action:
    """A lifted action.

    Attributes:
        name: What it is called.
        about: What it does, in a sentence.
        parameters: Its parameters, each with its type.
        needs: What must hold.
        adds: What holds afterwards.
        deletes: What no longer holds.
        cost: The function that says what it costs, if it costs anything.
        tests: What must hold of numbers, as PDDL prints it.
        changes: What becomes of numbers, as PDDL prints it.
    """

    name: str
    about: str
    parameters: tuple[Typed, ...]
    needs: tuple[Atom, ...]
    adds: tuple[Atom, ...]
    deletes: tuple[Atom, ...] = ()
    cost: Atom | None = None
    tests: tuple[str, ...] = ()
    changes: tuple[str, ...] = ()

    def text(self, *, costs: bool) -> str:
        """Print it.

        Args:
            costs: Whether what it costs is printed, too.
        """
        effects = [*(f"(not {words(atom)})" for atom in self.deletes), *map(words, self.adds), *self.changes]
        if costs and self.cost:
            effects.append(f"(increase {TOTAL_COST} {words(self.cost)})")
        return "\n".join(
            [
                f"  (:action {self.name} ; {self.about}",
                f"    :parameters ({declared(self.parameters)})",
                f"    :precondition (and {' '.join([*map(words, self.needs), *self.tests])})",
                f"    :effect (and {' '.join(effects)}))",
            ]
        )


@dataclass(frozen=True, slots=True)
class Predicate:
    """A predicate.

    Attributes:
        name: What it is called.
        parameters: Its parameters, each with its type.
        about: What it says.
    """

    name: str
    parameters: tuple[Typed, ...]
    about: str

    @property
    def text(self) -> str:
        """Print it, with what it says behind it."""
        parameters = declared(self.parameters)
        return f"    ({' '.join(filter(None, (self.name, parameters)))}) ; {self.about}"


@dataclass(frozen=True, slots=True)
class Domain:
    """A domain.

    Attributes:
        name: What it is called.
        head: What it begins with as comments, a line each.
        types: The types, each with its parent; parents before children.
        constants: The constants, each with its type.
        predicates: The predicates.
        costs: The functions that say what steps cost.
        actions: The actions.
        functions: Other functions.
    """

    name: str
    head: tuple[str, ...]
    types: tuple[Typed, ...]
    constants: tuple[Typed, ...]
    predicates: tuple[Predicate, ...]
    costs: tuple[Predicate, ...]
    actions: tuple[Action, ...]
    functions: tuple[Predicate, ...] = ()

    def action(self, name: str) -> Action:
        """Return the action of a name.

        Raises:
            UnknownChoice: If there is none.
        """
        found = next((action for action in self.actions if action.name == name), None)
        if found is None:
            raise UnknownChoice("action", name, [action.name for action in self.actions])
        return found

    def text(self, *, costs: bool = True) -> str:
        """Print it.

        Args:
            costs: Whether what steps cost is printed, too.
        """
        requirements = ":strips :typing" + " :numeric-fluents" * bool(self.functions)
        requirements += " :action-costs" * costs
        blocks = [
            "\n".join([*(f"; {line}".rstrip() for line in self.head), f"(define (domain {self.name})"]),
            f"  (:requirements {requirements})",
            _section("types", self.types),
            *([f"  (:constants {declared(self.constants)})"] if self.constants else []),
            "\n".join(["  (:predicates", *(one.text for one in self.predicates), "  )"]),
        ]
        functions = [*self.functions, *(self.costs if costs else ())]
        printed = [f"({one.name} {declared(one.parameters)}) - number" for one in functions]
        if printed := [*([f"{TOTAL_COST} - number"] if costs else []), *printed]:
            blocks.append(f"  (:functions {' '.join(printed)})")
        blocks += [action.text(costs=costs) for action in self.actions]
        return "\n".join(blocks) + ")\n"


@dataclass(frozen=True, slots=True)
class Facts:
    """Facts of a problem that belong together.

    Attributes:
        about: What they say, as a comment; none if empty.
        atoms: The facts.
    """

    about: str
    atoms: tuple[Atom, ...]


@dataclass(frozen=True, slots=True)
class PddlProblem:
    """A problem.

    Attributes:
        name: What it is called.
        domain: Name of its domain.
        head: What it begins with as comments, a line each.
        objects: The objects, each with its type.
        facts: What holds at the start.
        costs: What steps cost.
        goals: What shall hold.
        values: The values of other functions at the start.
        tests: What shall hold of numbers, as PDDL prints it.
    """

    name: str
    domain: str
    head: tuple[str, ...]
    objects: tuple[Typed, ...]
    facts: tuple[Facts, ...]
    costs: Mapping[Atom, int]
    goals: tuple[Atom, ...]
    values: Mapping[Atom, int] = field(default_factory=dict)
    tests: tuple[str, ...] = ()

    @property
    def atoms(self) -> frozenset[Atom]:
        """All facts that hold at the start."""
        return frozenset(atom for facts in self.facts for atom in facts.atoms)

    def text(self, *, costs: bool = True) -> str:
        """Print it.

        Args:
            costs: Whether what steps cost is printed, too.
        """
        lines = [f"; {line}".rstrip() for line in self.head]
        lines += [f"(define (problem {self.name})", f"  (:domain {self.domain})"]
        lines += [_section("objects", self.objects), "  (:init"]
        for facts in self.facts:
            lines += [f"    ; {facts.about}"] if facts.about else []
            for _, row in groupby(facts.atoms, key=lambda atom: atom[1:2]):
                lines.append(f"    {' '.join(map(words, row))}")
        for _, valued in groupby(self.values.items(), key=lambda one: one[0][1]):
            lines.append("    " + " ".join(_equal(atom, value) for atom, value in valued))
        if costs:
            values = [f"(= {TOTAL_COST} 0)", *(_equal(atom, value) for atom, value in self.costs.items())]
            lines.append("    " + " ".join(values))
        lines += ["  )", f"  (:goal (and {' '.join([*map(words, self.goals), *self.tests])}))"]
        lines += [f"  (:metric minimize {TOTAL_COST})"] * costs
        return "\n".join(lines) + ")\n"


def _equal(atom: Atom, value: int) -> str:
    return f"(= {words(atom)} {value})"


def words(atom: Atom) -> str:
    """Print an atom."""
    return f"({' '.join(atom)})"


def declared(names: Iterable[Typed]) -> str:
    """Print names with their types, those of one type that follow each other together."""
    rows = groupby(names, key=lambda one: one[1])
    return " ".join(f"{' '.join(name for name, _ in row)} - {kind}" for kind, row in rows)


def _section(title: str, names: Sequence[Typed]) -> str:
    rows = groupby(names, key=lambda one: one[1])
    lines = [f"    {' '.join(name for name, _ in row)} - {kind}" for kind, row in rows]
    return "\n".join([f"  (:{title}", *lines]) + ")"


@dataclass(slots=True)
class Course:
    """What holds while the ground actions of a plan are taken, one after another.

    Attributes:
        domain: The domain.
        holds: The facts that hold now.
    """

    domain: Domain
    holds: set[Atom] = field(default_factory=set)

    def take(self, name: str, arguments: Sequence[str]) -> None:
        """Take a ground action.

        Args:
            name: Name of the action.
            arguments: What its parameters stand for.

        Raises:
            UnknownChoice: If the domain has no such action.
            InvalidValue: If it has more or fewer parameters, or something does not hold that it needs.
        """
        action = self.domain.action(name)
        if len(arguments) != len(action.parameters):
            wanted = " ".join([name, *(parameter for parameter, _ in action.parameters)])
            told = counted(len(arguments), "argument")
            raise InvalidValue(f"it has {told}; valid: ({wanted})")
        given = {
            parameter: argument for (parameter, _), argument in zip(action.parameters, arguments, strict=True)
        }
        missing = next((atom for atom in ground(action.needs, given) if atom not in self.holds), None)
        if missing:
            raise InvalidValue(f"{words(missing)} does not hold there{self._instead(missing)}")
        self.holds.difference_update(ground(action.deletes, given))
        self.holds.update(ground(action.adds, given))

    def _instead(self, missing: Atom) -> str:
        """Say what holds in the place of an atom, where one thing does."""
        alike = sorted(atom for atom in self.holds if atom[:2] == missing[:2])
        return f"; what holds is {words(alike[0])}" if len(alike) == 1 else ""


def ground(atoms: Iterable[Atom], given: Mapping[str, str]) -> list[Atom]:
    """Put arguments in the place of parameters."""
    return [tuple([given.get(word, word) for word in atom]) for atom in atoms]


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
FORMER = ("stepwise", "operators", "places", "relational", "relational-lifted")
"""What earlier versions had in the place of `strips`."""


def domain_name(grounding: Grounding, encoding: str) -> str:
    """Name the domain in an encoding, like `tabletop-numeric`; the page has the name of the domain itself."""
    return grounding.name if encoding in (STRIPS, SAS) else f"{grounding.name}-{encoding}"
