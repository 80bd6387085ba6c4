"""Reading the text of a printed domain and problem, and what of the two a plan touches.

Other people's validators read PDDL slowly: a grid with its thousands of facts takes them many seconds.
But whether a plan is valid depends on its own actions alone, and on facts whose words occur in these, in its
steps or in the goal. So a validator may be given only those, and what it says is true of the whole. Where
conditions speak of all objects (`exists`), every fact is kept.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

from neurosym.errors import InvalidValue

Tree = list["Tree | str"]
"""A text in parentheses: words and trees."""
Action = tuple[str, ...]
"""A ground action: its name, and its arguments."""
_TOKEN = re.compile(r"[()]|[^\s()]+")
_COMMENT = re.compile(r";[^\n]*")
_QUANTIFIED = ("exists", "forall")


@dataclass(frozen=True, slots=True)
class Excerpt:
    """What of a domain and a problem a plan touches, as PDDL."""

    domain: str
    problem: str


def excerpt_for(domain: str, problem: str, actions: Sequence[Action]) -> Excerpt:
    """Leave out of a domain and a problem what cannot matter to a plan.

    Args:
        domain: The text of the domain.
        problem: The text of the problem.
        actions: The plan.

    Raises:
        InvalidValue: If a text is no PDDL.
    """
    parts, task = tree_of(domain), tree_of(problem)
    names = {action[0] for action in actions}
    first = next((str(part[1]) for part in parts if _head(part) == ":action"), "")
    names = names or {first}  # readers trip over no action
    kept = [part for part in parts if _head(part) != ":action" or part[1] in names]
    words = {word for action in actions for word in action}
    words |= {word for part in kept if _head(part) == ":action" for word in _words(part)}
    words |= {word for part in task if _head(part) in (":goal", ":metric") for word in _words(part)}
    if words.isdisjoint(_QUANTIFIED):
        kept, task = ([_narrowed(part, words) for part in text] for text in (kept, task))
    return Excerpt(_text(kept), _text(task))


def parameters_of(domain: str) -> Mapping[str, int]:
    """Return how many parameters each action of a domain has, by name.

    Args:
        domain: The text of the domain.

    Raises:
        InvalidValue: If it is no PDDL.
    """
    found = dict[str, int]()
    for part in tree_of(domain):
        if _head(part) == ":action":
            fields = list(part[2:])
            declared = fields[fields.index(":parameters") + 1] if ":parameters" in fields else ()
            found[str(part[1])] = sum(str(word).startswith("?") for word in declared)
    return found


def tree_of(text: str) -> Tree:
    """Read a text in parentheses.

    Args:
        text: The text, whose comments are left out.

    Raises:
        InvalidValue: If parentheses do not fit.
    """
    open_trees: list[Tree] = [[]]
    for token in _TOKEN.findall(_COMMENT.sub("", text).lower()):
        if token == "(":
            open_trees.append([])
        elif token == ")" and len(open_trees) > 1:
            closed = open_trees.pop()
            open_trees[-1].append(closed)
        else:
            open_trees[-1].append(token)
    if len(open_trees) != 1 or len(open_trees[0]) != 1 or isinstance(open_trees[0][0], str):
        raise InvalidValue("The text is no PDDL: its parentheses do not fit together.")
    return open_trees[0][0]


def _head(part: "Tree | str") -> "Tree | str":
    return part[0] if part and not isinstance(part, str) else part


def _words(part: "Tree | str") -> Iterable[str]:
    return [part] if isinstance(part, str) else chain.from_iterable(map(_words, part))


def _narrowed(part: "Tree | str", words: set[str]) -> "Tree | str":
    """Keep what occurs of the facts and values at the start, and of what is declared."""
    if _head(part) == ":init":  # of a value, what it is given to counts
        subjects = [(fact, fact[1] if _head(fact) == "=" else fact) for fact in part[1:]]
        return [":init", *(fact for fact, about in subjects if words.issuperset(_words(about)))]
    if _head(part) in (":objects", ":constants", ":functions", ":predicates"):
        return [_head(part), *_declared(list(part[1:]), words)]
    return part


def _declared(declared: Tree, words: set[str]) -> Tree:
    """Keep what occurs of the names that are declared, each group of them with its type."""
    rest = iter(declared)
    kept: Tree = []
    names: Tree = []
    for one in rest:
        if one == "-":
            kind = next(rest, "object")
            kept += [*names, "-", kind] if names else []
            names = []
        elif _head(one) in words:
            names.append(one)
    return [*kept, *names]


def _text(part: "Tree | str") -> str:
    return part if isinstance(part, str) else f"({' '.join(map(_text, part))})"
