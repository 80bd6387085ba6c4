"""A judge of ground plans: as much of PDDL as we print, and SAS+, read and performed in plain Python.

Strict where planners may be lenient: what is not declared, or of another type or arity, is an error.
`pddl-pyvalidator` judges the same (see `pyval_says`), at a thousand times the time.
"""

import operator as arithmetic
import re
import tempfile
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

Tree = list[Any]
Fact = tuple[str, ...]
COMPARED: dict[str, Callable[[int, int], bool]] = {
    "<=": arithmetic.le,
    ">=": arithmetic.ge,
    "=": arithmetic.eq,
}
CALCULATED: dict[str, Callable[[int, int], int]] = {
    "+": arithmetic.add,
    "-": arithmetic.sub,
    "*": arithmetic.mul,
}


def judge(domain: str, problem: str, plan: str) -> str:
    """Say what is wrong with a ground plan in PDDL; nothing if it is valid.

    Args:
        domain: The text of the domain.
        problem: The text of the problem.
        plan: Ground actions, one in parentheses a line.
    """
    task = read_task(domain, problem)
    for number, line in enumerate(_actions(plan), start=1):
        if wrong := task.do(line):
            return f"action {number} ({' '.join(line)}): {wrong}"
    wrong = [part for part in _conjuncts(task.goal) if not task.holds(part, {})]
    return f"goals that do not hold: {wrong}" if wrong else ""


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
        for part in _conjuncts(action[":precondition"]):
            if not self.holds(part, bound):
                return f"{part} does not hold"
        self._change(_conjuncts(action[":effect"]), bound)
        return ""

    def holds(self, part: Tree, bound: dict[str, str]) -> bool:
        """Say whether a condition holds, its variables replaced."""
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


def judge_sas(task: str, plan: str) -> str:
    """Say what is wrong with a plan for a task in Fast Downward's format of SAS+; nothing if it is valid."""
    lines = iter(task.splitlines())
    operators: dict[str, list[str]] = {}
    state: list[int] = []
    goals: list[str] = []
    for line in lines:
        if line == "begin_state":
            state = [int(word) for word in _until("end_state", lines)]
        elif line == "begin_goal":
            goals = _until("end_goal", lines)[1:]
        elif line == "begin_operator":
            name, *rest = _until("end_operator", lines)
            operators[name] = rest
    for number, words in enumerate(_actions(plan), start=1):
        if (name := " ".join(words)) not in operators:
            return f"action {number} ({name}): there is no such operator"
        if not _apply(operators[name], state):
            return f"action {number} ({name}) does not apply"
    wrong = [goal for goal in goals if not _is(state, *map(int, goal.split()))]
    return f"goals that do not hold: {wrong}" if wrong else ""


def _until(end: str, lines: Iterator[str]) -> list[str]:
    return list(iter(lambda: next(lines), end))


def _apply(operator: list[str], state: list[int]) -> bool:
    prevail = operator[1 : 1 + int(operator[0])]
    changes = operator[2 + len(prevail) : 2 + len(prevail) + int(operator[1 + len(prevail)])]
    triples = [tuple(map(int, change.split()[1:])) for change in changes]  # no conditions of their own
    asked = [tuple(map(int, line.split())) for line in prevail]
    asked += [(variable, before) for variable, before, _ in triples if before >= 0]
    if not all(_is(state, variable, value) for variable, value in asked):
        return False
    for variable, _, after in triples:
        state[variable] = after
    return True


def _is(state: list[int], variable: int, value: int) -> bool:
    return state[variable] == value


def pyval_says(domain: str, problem: str, plan: str) -> bool:
    """Ask `pddl-pyvalidator` if a plan is valid."""
    with warnings.catch_warnings(), tempfile.TemporaryDirectory() as name:
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from pyval import PDDLValidator

        files = [Path(name) / file for file in ("domain.pddl", "problem.pddl", "my.plan")]
        for file, text in zip(files, (domain, problem, plan), strict=True):
            file.write_text(text)
        return bool(PDDLValidator().validate(*map(str, files)).is_valid)
