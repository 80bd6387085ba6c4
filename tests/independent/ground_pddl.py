"""A judge of ground plans: as much of PDDL as we print, read and performed in plain Python.

Strict where planners may be lenient: what is not declared, or of another type or arity, is an error.
"""

import operator as arithmetic
import re
from collections.abc import Iterator
from typing import Any

Tree = list[Any]
Fact = tuple[str, ...]
COMPARED = {"<=": arithmetic.le, ">=": arithmetic.ge, "=": arithmetic.eq}
CALCULATED = {"+": arithmetic.add, "-": arithmetic.sub, "*": arithmetic.mul}


def judge(domain: str, problem: str, plan: str) -> str:
    """Say what is wrong with a plan of ground actions, one in parentheses a line; nothing if it is valid."""
    task = read_task(domain, problem)
    for number, line in enumerate(_actions(plan), start=1):
        if wrong := task.do(line):
            return f"action {number} ({' '.join(line)}): {wrong}"
    return "" if task.holds(task.goal, {}) else "goals that do not hold"


def read_task(domain: str, problem: str) -> "Task":
    """Read domain and problem."""
    return Task(_read(domain), _read(problem))


class Task:
    """A domain and a problem, and the state they are in."""

    def __init__(self, domain: Tree, problem: Tree) -> None:
        sections = {part[0]: part[1:] for part in domain[2:] if part[0] != ":action"}
        self.supertypes = dict(_typed(sections[":types"]))
        self.declared = {head[0]: [kind for _, kind in _typed(head[1:])] for head in sections[":predicates"]}
        self.functions = {
            head[0]: [kind for _, kind in _typed(head[1:])]
            for head in sections[":functions"]
            if isinstance(head, list)
        }
        self.actions: dict[str, dict[str, Any]] = {}
        for _, name, *rest in (part for part in domain[2:] if part[0] == ":action"):
            assert name not in self.actions, f"two actions are called {name}"
            self.actions[name] = dict(zip(rest[::2], rest[1::2], strict=True))
        parts = {part[0]: part[1:] for part in problem[2:]}
        self.types = dict(_typed([*sections.get(":constants", []), *parts[":objects"]]))
        self.facts: set[Fact] = set()
        self.numbers: dict[Fact, int] = {}
        for part in parts[":init"]:
            if part[0] == "=":
                self.numbers[self._checked(part[1], {}, self.functions)] = int(part[2])
            else:
                self.facts.add(self._checked(part, {}, self.declared))
        self.goal: Tree = parts[":goal"][0]

    def do(self, words: tuple[str, ...]) -> str:
        """Do a ground action and return what is wrong with it; nothing if it is possible."""
        name, *given = words
        if name not in self.actions:
            return "there is no such action"
        action = self.actions[name]
        parameters = list(_typed(action[":parameters"]))
        if len(parameters) != len(given):
            return f"{len(parameters)} parameters are declared"
        for thing, (_, kind) in zip(given, parameters, strict=True):
            if not self._is_a(thing, kind):
                return f"{thing} is no {kind}"
        bound = {variable: thing for (variable, _), thing in zip(parameters, given, strict=True)}
        if wrong := [one for one in _conjuncts(action[":precondition"]) if not self.holds(one, bound)]:
            return f"{wrong} does not hold"
        self._change(_conjuncts(action[":effect"]), bound)
        return ""

    def holds(self, part: Tree, bound: dict[str, str]) -> bool:
        """Say whether a condition holds, its variables replaced."""
        if part[:1] == ["and"]:
            return all(self.holds(one, bound) for one in part[1:])
        if part[0] in COMPARED:
            return COMPARED[part[0]](*(self._value(side, bound) for side in part[1:]))
        return self._checked(part, bound, self.declared) in self.facts

    def _change(self, effects: list[Tree], bound: dict[str, str]) -> None:
        added, deleted, numbers = set(), set(), dict(self.numbers)
        for part in effects:
            if part[0] == "assign":
                numbers[self._checked(part[1], bound, self.functions)] = self._value(part[2], bound)
            elif part[0] in ("increase", "decrease"):
                fact = self._checked(part[1], bound, self.functions)
                by = self._value(part[2], bound)
                numbers[fact] += by if part[0] == "increase" else -by
            elif part[0] == "not":
                deleted.add(self._checked(part[1], bound, self.declared))
            else:
                added.add(self._checked(part, bound, self.declared))
        self.facts = (self.facts - deleted) | added  # what is deleted and added stays
        self.numbers = numbers

    def _value(self, part: Any, bound: dict[str, str]) -> int:
        if isinstance(part, str):
            return int(part)
        if part[0] in CALCULATED:
            return CALCULATED[part[0]](*(self._value(side, bound) for side in part[1:]))
        return self.numbers[self._checked(part, bound, self.functions)]

    def _checked(self, part: Tree, bound: dict[str, str], declared: dict[str, list[str]]) -> Fact:
        """Return an atom with its variables replaced, if it is declared and all types are right."""
        name, *words = part
        things = [bound[word] if word.startswith("?") else word for word in words]
        kinds = declared[name]
        assert len(kinds) == len(things), f"{part} has another arity than declared"
        assert all(map(self._is_a, things, kinds)), f"{part} has other types than declared"
        return (name, *things)

    def _is_a(self, thing: str, kind: str) -> bool:
        has = self.types.get(thing)
        while has is not None and has != kind:
            has = self.supertypes.get(has)
        return has is not None


def _typed(words: Tree) -> Iterator[tuple[str, str]]:
    """Read `a b - kind c - other` as pairs of a name and its type."""
    names: list[str] = []
    rest = iter(words)
    for word in rest:
        if word == "-":
            kind = next(rest)
            yield from ((name, kind) for name in names)
            names = []
        else:
            names.append(word)
    yield from ((name, "object") for name in names)


def _conjuncts(part: Tree) -> list[Tree]:
    return part[1:] if part[:1] == ["and"] else [part]


def _read(text: str) -> Tree:
    """Read one expression in parentheses."""
    stack: list[Tree] = [[]]
    for word in re.findall(r"[()]|[^\s()]+", re.sub(r";[^\n]*", "", text.lower())):
        if word == "(":
            stack.append([])
        elif word == ")":
            stack[-2].append(stack.pop())
        else:
            stack[-1].append(word)
    (whole,) = stack
    return whole[0]


def _actions(plan: str) -> Iterator[tuple[str, ...]]:
    for raw in plan.lower().splitlines():
        line = re.sub(r"^[\d.]+\s*:\s*|\s*\[[\d.\s]+\]\s*$", "", raw.split(";")[0].strip())
        if words := tuple(line.strip("()").split()):
            yield words
