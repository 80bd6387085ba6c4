"""Odd values: what careless or hostile people type, and write into files."""

import json
from random import Random

DEEP = 20_000
NUMBERS = (
    *(
        "0",
        "-1",
        "1",
        "2",
        "0.0",
        "-0.0",
        "1e308",
        "-1e308",
        "1e309",
        "1e-320",
        "NaN",
        "Infinity",
        "-Infinity",
    ),
    *(
        "2147483648",
        "9223372036854775807",
        "9223372036854775808",
        "-9223372036854775809",
        "1" * 5000,
        "1e",
        "0x1",
    ),
)
"""As they stand in JSON, or are typed; not all are numbers."""
WORDS = (
    *(
        "",
        " ",
        "-",
        "--",
        ".",
        "..",
        "nan",
        "inf",
        "None",
        "true",
        "null",
        "[]",
        "{}",
        "toy",
        "item-01",
        "task-01",
    ),
    *("item-1", "000", "0", "10", "resting", "held", "left\x1b[31mred", "\x07", "<script>alert(1)</script>"),
    *(
        "line\nbreak",
        "tab\there",
        "\ufeff",
        "\u202eright to left",
        "ä",
        "\u0130",
        "\U0001d7d9",
        "%s%n",
        "{0}",
        "[red]markup[/]",
    ),
    *("os:system", "subprocess:run", "neurosym.worlds.toy:make_world", "own:nothing", ":", "a:b:c", "../toy"),
    *("nowhere/at/all.png", "/dev/null", "/dev/full", "out.png", "out.gif", "out.md", "out.html", "out.json"),
    *(
        "x" * 300,
        "x" * 300 + ".png",
        "item-01=0.6,0.1",
        "item-01=nan,nan",
        "item-01=",
        "=0,0",
        "item-01=1e308,0",
    ),
    *("\udcff.plan", "a\udc80b"),
)
"""Texts that mean something here, or somewhere else."""
RAW = (
    *(
        "true",
        "false",
        "null",
        '""',
        "[]",
        "{}",
        "[null]",
        "[[]]",
        "[0,0,0]",
        '{"a":1}',
        "1979-05-27T07:32:00Z",
    ),
    *('"\\ud800"', '"\\u0000"', '"\\u001b[31m"', '"' + "x" * 100_000 + '"', '"' + "item-01 " * 3 + '"'),
    *("[" * DEEP + "]" * DEEP, "[" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "[" + "0," * 100_000 + "0]"),
)
"""Values as JSON and TOML write them, valid or not."""


def odd_text(draw: Random) -> str:
    """Draw what may be typed: no NUL, which no command line holds, and no path out of the case's folder."""
    return str(draw.choice((_word, _word, _number, _characters, _integer, _float))(draw))


def odd_value(draw: Random) -> str:
    """Draw what may stand for a value in a JSON or TOML document."""
    what = draw.randint(0, 5)
    if what < 2:
        return _number(draw)
    if what == 2:
        return draw.choice(RAW)
    return json.dumps(odd_text(draw)) if what == 3 else str((_integer, _float)[what - 4](draw))


def _word(draw: Random) -> str:
    return draw.choice(WORDS)


def _number(draw: Random) -> str:
    return draw.choice(NUMBERS)


def _integer(draw: Random) -> int:
    return draw.choice((-1, 1)) * draw.getrandbits(draw.choice((1, 3, 8, 16, 33, 65)))


def _float(draw: Random) -> float:
    return draw.choice((-1.0, 1.0)) * draw.random() * 10.0 ** draw.randint(-20, 20)


def _characters(draw: Random) -> str:
    signs = (
        chr(draw.choice((draw.randint(1, 0x7F), draw.randint(0x80, 0xD7FF), draw.randint(0xE000, 0x10FFFF))))
        for _ in range(draw.randint(0, 12))
    )
    return "".join(signs).replace("/", "")
