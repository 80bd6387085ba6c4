"""`neurosym explain` says in words what symbols mean, from whatever of a domain folder is there."""

import re
from itertools import takewhile

import msgspec
import numpy as np
import pytest
from command_line import neurosym, refusal
from shipped import FOLDER, GROUNDING
from tables import table

from neurosym.choices import DOMAINS, shipped_domain
from neurosym.commands.tables import explanation_page, show_screen
from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.grounding import Grounding
from neurosym.operators import Category, OperatorTable
from neurosym.report import symbols
from neurosym.report.explanation import explain, explain_folder
from neurosym.stages.folder import DomainFolder
from neurosym.world import three_waypoints


def test_shipped_domain_is_explained_under_its_own_names():
    rows = [row for action in explain_folder(FOLDER).actions for row in action.effects]
    learned = [operator for operator in GROUNDING.objects.operators if operator.promised is None]
    assert {row.operator for row in rows} == {operator.name for operator in learned}
    live = {operator.name for operator in GROUNDING.live}
    assert all((row.domain == "yes") == (row.operator in live) for row in rows)


@pytest.mark.parametrize("name", DOMAINS)
def test_what_a_shipped_domain_learned_fits_one_screen(name, capsys):
    assert neurosym("explain", shipped_domain(name)) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines[:-1])) <= 80  # the last one names the folder
    table = OperatorTable.load(shipped_domain(name) / "primitives.json")
    for category in table.categories:
        line = next(line for line in lines if line.startswith(f"{category.symbol} "))
        sizes = [round(1000 * mean) for mean in category.feature_means[:3]]
        assert f"{category.name} " in line
        assert f"{category.share:.0%} " in line
        assert "{} mm deep, {} wide, {} high".format(*sizes) in line
    for symbol in table.symbols:
        of_symbol = [one for one in table.operators if one.primitive == symbol]
        rate = sum(one.successes for one in of_symbol) / sum(one.trials for one in of_symbol)
        line = next(line for line in lines if line.startswith(f"{symbol} "))
        assert line.endswith(f"{rate:.0%}")
        beneath = takewhile(lambda one: one.startswith("   "), lines[lines.index(line) + 1 :])
        assert of_symbol[0].name.partition(f"-{symbol}")[0] in "".join([line, *beneath])
    assert lines[-1].endswith(f"--symbol {table.symbols[0]}")


def test_more_symbols_than_a_screen_has_room_for_are_counted(capsys):
    many = tuple(symbols.SymbolExplanation(f"{n:05b}", "lift (50% of objects)", "") for n in range(32))
    show_screen(symbols.Explanation(("", "Thus."), many, many))
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) <= 38
    assert [line for line in lines if line.startswith("and ")] == ["and 24 more", "and 16 more"]


def test_every_symbol_is_printed_and_what_is_left_out_with_its_reason(kept, tmp_path, capsys):
    assert neurosym("explain", kept, "--all") == 0
    lines = capsys.readouterr().out
    said, learned = " ".join(lines.split()), Grounding.load(kept / "grounding.json")
    assert all(f"Action symbol {one.symbol}: " in said for one in learned.objects.primitives)
    assert all(f"Object symbol {one.symbol}: {one.name}" in said for one in learned.objects.categories)
    assert "next: neurosym show" in said
    assert learned.left_out
    for name, reason in learned.left_out.items():
        left_out = learned.operator_named(name)
        if left_out.promised:  # a rarer outcome, which is told of below its operator
            continue
        promised = f"{left_out.trials} trials, {left_out.successes} as promised"
        assert f"- {name} ({promised}, not in the domain: {reason})" in said
    page = tmp_path / "symbols.md"
    assert neurosym("explain", kept, "--output", page) == 0
    assert f"wrote {page}" in capsys.readouterr().out
    assert page.read_text() == explanation_page(explain_folder(DomainFolder(kept)), kept.name)


def test_one_symbol_may_be_asked_for_by_its_bits_or_its_name(kept, capsys):
    category = OperatorTable.load(kept / "primitives.json").categories[0]
    for word in (category.symbol, category.name):
        assert neurosym("explain", kept, "--symbol", word) == 0
        said = capsys.readouterr().out
        assert f"Object symbol {category.symbol}: {category.name}" in said
        assert "Action symbol" not in said
    operator = OperatorTable.load(kept / "primitives.json").operators[0]
    assert neurosym("explain", kept, "--symbol", operator.name) == 0
    assert operator.name in capsys.readouterr().out


def test_table_of_operators_alone_is_enough(tmp_path, capsys):
    write_json(tmp_path / "primitives.json", table())
    assert neurosym("explain", tmp_path, "--all") == 0
    said = capsys.readouterr().out
    assert "There is no world.toml here" in said
    assert "in the domain" not in said
    assert "next:" not in said  # there is nothing to compile a domain with


def test_what_is_in_the_domain_is_not_said_without_a_grounding_or_of_another(folder):
    (folder / "grounding.json").rename(folder / "kept.json")
    before = explain_folder(DomainFolder(folder))
    (folder / "kept.json").rename(folder / "grounding.json")
    write_json(folder / "primitives.json", table())
    explanation = explain_folder(DomainFolder(folder))
    assert "compiled from another primitives.json" in explanation.summary[-1]
    for told in (before, explanation):
        assert not any(row.domain for action in told.actions for row in action.effects)


def test_what_is_damaged_missing_or_asked_for_in_vain_is_refused(folder, capsys):
    for name in ("symbols.html", "nowhere/symbols.md", "."):
        said = refusal(capsys, "explain", folder, "--output", folder / name)
        assert "name a file that ends in .md, in an existing folder" in said
    assert "There is no symbol 'banana'; valid: " in refusal(capsys, "explain", folder, "--symbol", "banana")
    (folder / "primitives.json").unlink()
    assert f"`neurosym distill {folder}` writes it" in refusal(capsys, "explain", folder)
    assert "no folder" in refusal(capsys, "explain", folder / "nowhere")


def test_names_of_a_stranger_are_refused_or_shown_and_never_acted_on(folder, tmp_path, capsys):
    text = (folder / "primitives.json").read_text()
    before, _, after = text.partition('"name": "')
    for name in ("\\u001b[2Jx", "<script>", "a b", "[red]x", "x" * 300, "A"):
        (folder / "primitives.json").write_text(f'{before}"name": "{name}{after}')
        assert "primitives.json cannot be used" in refusal(capsys, "explain", folder)
    (folder / "primitives.json").write_text(text)
    strange = (folder.parent / "<script>[bold]\x1b[2J").resolve()
    folder.rename(strange)
    assert neurosym("explain", strange, "--output", tmp_path / "page.md") == 0
    assert "\x1b" not in capsys.readouterr().out
    assert "# What the symbols of &lt;script>[bold]\\x1b[2J mean" in (tmp_path / "page.md").read_text()


GRIPPER = three_waypoints().gripper.tolist()


def said_of(explanation, symbol):
    return next(action for action in explanation.actions if action.symbol == symbol)


def test_action_is_told_from_start_to_rise():
    action = (-0.042, 0.044, -0.025, 0.84, -0.028, 0.0, 0.0, 0.1, 0.0, 0.0, 0.01, 0.2)
    assert symbols.action_in_words(action, GRIPPER) == (
        "The hand starts open, 42 mm back and 44 mm left of the object's centre, 25 mm below it.",
        "It closes there and moves to 28 mm back of the centre, level with it.",
        "Still closed, it moves to 10 mm above the centre.",
        "It rises closed; from start to end it has moved 42 mm forward, 44 mm right, 35 mm up.",
    )


def test_words_give_the_numbers_back():
    rng = np.random.default_rng(3)
    signs = {"forward": 1, "back": -1, "left": 1, "right": -1, "up": 1, "down": -1}
    axes = {"forward": 0, "back": 0, "left": 1, "right": 1, "up": 2, "down": 2}
    for vector in rng.uniform(-0.3, 0.3, size=(100, 3)):
        read = np.zeros(3)
        for millimetres, word in re.findall(
            r"(\d+) mm (\w+)", symbols.displacement_in_words(vector.tolist())
        ):
            read[axes[word]] = signs[word] * int(millimetres)
        np.testing.assert_array_equal(read, np.round(1000 * vector))


@pytest.mark.parametrize("types", [[0, 0, 1, 2], [1, 1], [0], [2, 0, 0, 0, 2], [0, 1, 1]])
def test_shares_of_types_follow_from_mean_and_spread(types):
    shares = symbols.type_shares(float(np.mean(types)), float(np.std(types)))
    np.testing.assert_allclose(shares, [types.count(kind) / len(types) for kind in range(3)], atol=1e-12)


def test_every_mode_has_its_row_with_mean_spread_and_share():
    lift, away = said_of(explain(table()), "010").effects[:2]
    assert (lift.ends, lift.share, lift.trials, lift.promised) == ("held", 0.8, 20, 15)
    assert lift.effect == "12 mm forward, 21 mm right, 203 mm up"
    assert lift.spread == "± 4, 3, 1 mm"
    assert away.operator == lift.operator
    assert away.ends == "at rest"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"categories": (Category("00", "block", 1.0, (0.1,), ()),)}, "spread for each mean"),
        ({"categories": table().categories[:1]}, "unknown primitive or category"),
    ],
)
def test_table_that_does_not_fit_together_is_refused(tmp_path, change, message):
    write_json(tmp_path / "primitives.json", msgspec.structs.replace(table(), **change))
    with pytest.raises(InvalidFile, match=message):
        explain_folder(DomainFolder(tmp_path))
