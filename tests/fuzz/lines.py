"""Command lines: every command with its options, drawn from its own signature."""

import inspect
import shlex
import types
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from random import Random
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from fuzz.mutations import WORDS, odd_text

from neurosym.commands.catalogue import SUMMARIES, command_named

ENDING = {name: command_named(name) for name in SUMMARIES if name != "studio"}
"""The commands that come to an end; the studio is open until somebody closes it (tests/studio)."""

FOLDER = "toy"
"""What the domain folder is called, in the folder that commands are run in."""
_USUAL = f"""
folder {FOLDER}
folders {FOLDER}
data {FOLDER} {FOLDER}/interactions.npz
test {FOLDER} {FOLDER}/interactions.npz
problem task-01 task-02 far long {FOLDER}/problems/task-02.pddl {FOLDER}/problems/task-01.scene.json
scene {FOLDER}/problems/task-01.scene.json {FOLDER}/problems/task-02.scene.json
plan_file {FOLDER}/plans/task-01.fast-downward.plan {FOLDER}/plans/task-02.fast-downward.plan other.plan
record {FOLDER}/runs/task-01.fast-downward.run.json task-02.fast-downward {FOLDER}/plans/task-01.bfs.json
world toy toy toy tabletop own:world own:angry own:gone own:odd
name task-01 task-09 mine
goal item-01=0.6,0.1 item-02=0.7,0.0 item-01=0.7,-0.2,0.225
primitive 000 001 011 111
interaction 0 1 1023
strategy random random disagreement entropy active
steps 1 64 600 1024 1100
rehearsals 1 5
interactions 1 60
places 0 64 512
relations 0 0 64
relation 'item-01 rests-on item-02' 'item-01 on item-01'
choice own predictable lowest-error
problems 1 2
tasks 1 2
objects 1 2 3
actions 1 2
replans 0 1 2
seed 0 3
workers 1
time_limit 0.2 1.0
tolerance 0.05 0.02
cell 0.005 0.01 0.02
regime quick
gif out.gif
strip out.png
output out.png out.md out.html out.json out
"""
_PLANNERS = """fast-downward counting bfs bfs-operators lama-first lmcut own:planner own:raising own:leaving
own:rubbish"""
USUAL = {name: tuple(values) for name, *values in map(shlex.split, _USUAL.strip().splitlines())}
USUAL |= dict.fromkeys(("planner", "planners", "replanner"), tuple(_PLANNERS.split()))
"""What each parameter is mostly given: something that can be, and costs little."""
_WORK = """steps interactions places relations rehearsals problems tasks objects workers
time_limit"""
ALWAYS = {*_WORK.split(), "strategy", "regime"}
"""Options whose defaults cost too much to be tried over and over."""
WORK = {*_WORK.split(), "actions", "replans"}
"""Options that may ask for work without end: then the command is interrupted soon."""


def command_line(draw: Random, name: str, command: Callable[..., int]) -> tuple[str, ...]:
    """Draw what is typed to have a command done, whose parameters say what can be typed."""
    hints = get_type_hints(command, include_extras=True)
    arguments = [name]
    for parameter in inspect.signature(command).parameters.values():
        arguments += _typed(draw, parameter, hints[parameter.name])
    if draw.randint(0, 11) == 0:
        arguments = _garbled(draw, arguments)
    return tuple(arguments)


def _typed(draw: Random, parameter: inspect.Parameter, hint: Any) -> list[str]:
    values = [_value(draw, parameter.name, hint)]
    is_many = get_origin(_plain(hint)) is tuple
    if is_many and draw.randint(0, 3) == 0:
        values.append(_value(draw, parameter.name, hint))
    if parameter.default is inspect.Parameter.empty:
        return values
    if parameter.name not in ALWAYS and draw.randint(0, 3):
        return []
    option = f"--{parameter.name.replace('_', '-')}"
    if _plain(hint) is bool:
        return [option]
    if parameter.name == "goal":
        return [part for value in values for part in (option, value)]
    return [option, *values]


def _value(draw: Random, name: str, hint: Any) -> str:
    if draw.randint(0, 19) == 0:
        return odd_text(draw)
    kind = _plain(hint)
    if get_origin(kind) is Literal:
        return str(draw.choice(USUAL.get(name, get_args(kind))))
    if name in USUAL:
        return draw.choice(USUAL[name])
    return str({int: draw.randint(0, 3), float: draw.random()}.get(kind, draw.choice(WORDS)))


def _plain(hint: Any) -> Any:
    """Take away what is annotated, and that there may be none."""
    if get_origin(hint) is Annotated:
        return _plain(get_args(hint)[0])
    if get_origin(hint) in (Union, types.UnionType):
        return _plain(next(kind for kind in get_args(hint) if kind is not type(None)))
    return hint if hint is not Path else str


def _garbled(draw: Random, arguments: list[str]) -> list[str]:
    place = draw.randint(0, len(arguments))
    ways = {
        "drop": lambda: arguments[:place] + arguments[place + 1 :],
        "insert": lambda: [*arguments[:place], odd_text(draw), *arguments[place:]],
        "twice": lambda: arguments + arguments[place:],
        "joined": lambda: ["=".join(arguments[:2]), *arguments[2:]],
        "help": lambda: [*arguments, "--help"],
        "nothing": list,
    }
    return ways[draw.choice((*ways,))]()


def asks_for_much(arguments: tuple[str, ...]) -> bool:
    """Say whether a command line asks for more work than the usual."""
    if arguments[:1] == ("run",) and not {"predictable", "lowest-error"} & {*arguments}:
        return True  # in a new folder it is of the tabletop, with auditions for each category
    for option, value in pairwise(arguments):
        name = option.removeprefix("--").partition("=")[0].replace("-", "_")
        if option.startswith("--") and name in WORK and value not in USUAL[name]:
            return True
    return any(part.startswith("--") and "=" in part for part in arguments)
