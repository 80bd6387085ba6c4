"""The guided tour: eight cards, from an experience to what went otherwise. Each has one thing to do."""

from dataclasses import dataclass
from enum import Enum

from neurosym.studio.library import Library


class Deed(Enum):
    """What the button of a card does."""

    EXPERIENCE = "experience"
    EFFECT = "effect"
    BIT = "bit"
    CATEGORY = "category"
    PRIMITIVE = "primitive"
    OPERATOR = "operator"
    PLAN = "plan"
    RUN = "run"


@dataclass(frozen=True, slots=True)
class Card:
    """One card.

    Attributes:
        title: What it is about.
        sentences: What it says; words in braces are numbers of the domain (`numbers_of`).
        button: What stands on its button.
        deed: What the button does.
    """

    title: str
    sentences: tuple[str, ...]
    button: str
    deed: Deed


CARDS = (
    Card(
        "an experience",
        (
            "The robot begins without words. It moves its hand through three points near an object, opens "
            "or closes it at each, and looks what happens.",
            "It did so {interactions} times, each time with another object elsewhere. Press the button "
            "to see one of them happen again; then your table is back.",
        ),
        "See one experience",
        Deed.EXPERIENCE,
    ),
    Card(
        "an effect",
        (
            "Of each experience three numbers are kept: how far the object moved forward, to the left and "
            "up. That is the effect.",
            "See another one. The numbers stand below when it is over.",
        ),
        "See another effect",
        Deed.EFFECT,
    ),
    Card(
        "a bit",
        (
            "A program that learns from examples, a neural network, predicts effects. But all that it may "
            "use of an object is {object_bits} bits, each 0 or 1. So it must choose what matters.",
            "Press the button: the object changes size until one bit flips. On the panel Table you can do it "
            "with the sliders, and the bars show how far each bit is from its flip.",
        ),
        "Flip a bit",
        Deed.BIT,
    ),
    Card(
        "a category",
        (
            "Objects with the same bits are one category. The robot expects the same of all of them.",
            "Nobody told it the {categories} categories that there are here. Their names were made "
            "afterwards, from what was measured. Draw four objects, and four others, and compare their bits.",
        ),
        "Draw four objects",
        Deed.CATEGORY,
    ),
    Card(
        "a primitive",
        (
            "Motions get bits, too: {action_bits} of them. For each pattern of bits the robot finds a motion "
            "that stands for it. That is a primitive, and there are {primitives}.",
            "See the one that it is surest of with an object on the table.",
        ),
        "Perform a primitive",
        Deed.PRIMITIVE,
    ),
    Card(
        "an operator",
        (
            "What a primitive does to a category is an operator. Each was tried many times, so the robot "
            "knows where an object ends, and how surely. It has {operators} of them.",
            "On the panel Symbols, arrows show where each takes the object. See one that it is less sure of: "
            "sometimes it goes as promised, and sometimes not.",
        ),
        "Perform a less sure one",
        Deed.OPERATOR,
    ),
    Card(
        "a plan",
        (
            "Operators are printed as PDDL, a language that planners read. A planner is a program that knows "
            "nothing of arms. It finds which operators lead to the goal, one after another.",
            "The see-through objects are goals: so shall things stand. If nothing on the table has a goal, "
            "two objects that have one are put there.",
            "Drag a goal by the ball above it if you like, and press the button. The panel Plan shows each "
            "step.",
        ),
        "Plan to the goal",
        Deed.PLAN,
    ),
    Card(
        "what went otherwise",
        (
            "Now the arm does it. The panel Run compares what each step promised with what happened.",
            "Where they part so far that the goal would be missed, the robot plans anew. Take an object by "
            "its body while it runs, and drag it elsewhere: before the next step it is there.",
        ),
        "Run the plan",
        Deed.RUN,
    ),
)


def numbers_of(library: Library) -> dict[str, str]:
    """Return the numbers of a domain that cards name.

    Args:
        library: The domain.
    """
    table, grounding = library.grounding.operators, library.grounding
    rows = library.rows
    return {
        "interactions": f"{rows:,}" if rows else "many",
        "object_bits": str(len(table.categories[0].symbol)) if table.categories else "some",
        "action_bits": str(len(table.symbols[0])) if table.symbols else "some",
        "categories": str(sum(1 for one in table.categories if one.share)),
        "primitives": str(len(table.symbols)),
        "operators": str(len(grounding.live)),
    }
