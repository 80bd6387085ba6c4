"""The results of `evaluate.py` as a page of Markdown tables."""

from collections.abc import Mapping
from typing import Any, get_args

from neurosym.errors import counted
from tools.benchmarks.relations.geometry import Relation
from tools.benchmarks.relations.summary import PUTS
from tools.benchmarks.tables import document, over_seeds, table, written

RELATIONS = get_args(Relation)


def page(found: Mapping[str, Any]) -> str:
    """Write the tables."""
    return document(
        "# One object relative to another",
        f"`{found['command']}` wrote this page. Which relation two objects have is told by "
        "geometry that a person wrote (`tools/benchmarks/relations/geometry.py`). *On*: upright, "
        "touching, and not sunk. *In*: upright inside of a hollow one. *Leaning*: tilted. "
        "*Against*: touching from the side. *Beside*: at most 5 cm apart. *Around*: the other is in it.",
        *_by_hand(found),
        *(_learned(found) if found["learned"] else ()),
    )


def _by_hand(found: Mapping[str, Any]) -> list[str]:
    over, towers, chance = found["put_over"], found["towers_by_hand"], found["random"]
    rows = [
        [
            pair,
            f"{cell['carried']} of {cell['tried']}",
            *(str(cell["ends"].get(name, 0) or "") for name in RELATIONS),
            *("{} of {}".format(*cell[f"taken_{name}"]) for name in PUTS),
        ]
        for pair, cell in over.items()
    ]
    ends = ", ".join(f"{count} {name}" for name, count in chance["ends_of_carried"].items())
    built = "; ".join(f"{cell['stand']} of {cell['tried']} of {height}" for height, cell in towers.items())
    return [
        "## Put over one another by hand",
        "One action that a person wrote grasps an object of random size and sets it down over "
        "another. What then stands on or in that one is taken to a place by the same action, "
        "without moving the other by over 5 mm.",
        table(["pair", "carried", *RELATIONS, "taken off", "taken out"], rows),
        f"Towers of solid objects by hand, the widest below, that stand: {built}.",
        "## At random",
        f"Of {chance['interactions']} random actions aimed at another object, "
        f"{chance['carried']:.1%} carry the target over it: {ends}. Changed by 0.1 mm, "
        f"{chance['another_relation']} end in another relation.",
    ]


def _learned(found: Mapping[str, Any]) -> list[str]:
    rows = [[f"seed {seed}", *_symbols(one)] for seed, one in found["learned"].items()]
    rows += [[f"seed {seed}, at random", *_symbols(one)] for seed, one in found["at_random"].items()]
    errors = [
        [size, *written(one, "error:2", "nothing_moves:2"), f"{one['carried']:.0%}"]
        for size, one in found["effect_errors"].items()
    ]
    return [
        "## What was learned",
        f"{counted(found['seeds'], 'seed')}, each with {found['steps']:,} interactions that are aimed at "
        "other objects. The actions that it starts from are those that carry to places with the same seed "
        "([Carried to places](places.md)). *On* and *in*: each operator is performed on 48 new pairs with "
        "which it is foreseen to keep its promise surely. How often the one that geometry calls so on the "
        "first half is right on the second; in brackets, the share of all pairs with which that is foreseen. "
        "*States* and *kinds*: balanced accuracy of the codes against geometry, matched on one half and "
        "counted on the other; *kinds* is the mean of what *carries* and what *fits*. *Recalled*: of new "
        "actions that end on the reference, how many are foreseen to; and how much of what is foreseen is "
        "so. At random: learned from as many actions that nobody chose.",
        table(" | on | in | states | kinds | carries | fits | recalled | precision", rows),
        "## Tasks",
        "A person draws the tasks and solves each by hand beforehand: the same tasks, by actions that a "
        "person wrote, are reached in all cases. Goals are told to the domain in the words that geometry "
        "matched with its states. Geometry says what was reached. Shares are means over seeds, with their "
        "standard deviation. *Single objects*: a person says what to carry where to, one after another. "
        "What carries that object to places most surely is aimed at the other object. "
        "*At random*: learned with one seed from as many actions that nobody chose.",
        table(
            "task | number | planned | followed blindly | with replanning | single objects | "
            "at random, blindly | at random, replanned",
            [_task(name, cell, found) for name, cell in found["table"].items()],
        ),
        "The last two rows are near to what others asked (`tools/benchmarks/relations/protocols.py`). With "
        "three objects, a person puts one to three times something on or into something else. Among five to "
        "eight, something is put near something else; every object must then be within 9 cm of where it was.",
        "## Predicted ends",
        "New actions, drawn as exploring draws them, and where the network of pairs says that all objects "
        "end. Error of an object, summed over x, y and z, and the same if nothing moved.",
        table("objects | error [cm] | nothing moves [cm] | target carried", errors),
    ]


def _task(name: str, cell: Mapping[str, Any], found: Mapping[str, Any]) -> list[str]:
    at_random = found["table_at_random"][name]
    tried = (cell["blind"], cell["replanned"], found["singly"].get(name, ()))
    shares = ([100 * one for one in each] for each in (*tried, at_random["blind"], at_random["replanned"]))
    return [name, *written(cell, "tasks", "planned"), *(over_seeds(one, "{:.0f}%", 0) for one in shares)]


def _symbols(one: Mapping[str, Any]) -> list[str]:
    best = [one["operators"][name] for name in PUTS]
    static, recall = one["static_bits"], one["recall_on"]
    return [
        *(f"{each['right']:.0%} ({each['pairs']:.1%})" if each else "none" for each in best),
        *(f"{each:.1%}" for each in (one["state_bits"]["balanced"], static["balanced"])),
        *(f"{static[name]:.0%}" for name in ("carries", "fits")),
        *(f"{recall[name]:.0%}" for name in ("recall", "precision")),
    ]
