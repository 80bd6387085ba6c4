"""Planners that crash, print rubbish, write malformed plans or never end: results, and nothing is left.

A planner here is a Python script of a few lines, called as the real ones are.
"""

import os
import subprocess
import sys
import tempfile
import time
from functools import partial
from pathlib import Path

import pytest
import toy_relations
from processes import alive
from tables import grounding, item, problem

from neurosym.errors import CannotStart, InvalidValue
from neurosym.pddl import domain_text, problem_text
from neurosym.planners import PLANNERS, PlannerAnswer, PlanResult, PlanStatus, external, pddl_planner, plan
from neurosym.planners.external import Program, plan_fast_downward, plan_program
from neurosym.planners.keeper import MARK, end_marked, marked
from neurosym.planners.planner import PlannerMissing
from neurosym.planners.registry import PROGRAMS
from neurosym.problems import Problem
from neurosym.tasks.transition import validate

TASK = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.571, -0.012, 0.025)})


@pytest.fixture
def scratch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder that stands in for the system's folder of temporary files."""
    with (
        external.scratch_folder()
    ):  # so that the keeper, which lives on, is there before and does not name the folder
        pass
    folder = tmp_path / "scratch"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def solved_by(script: str, *, time_limit: float = 20.0, encoding: str = "numeric") -> PlanResult:
    """What comes of planning with a script as the planner."""
    command = ("{python}", "-c", script, "{domain}", "{problem}")
    program = Program("Script", "neurosym", command, plans="plan*")
    call = partial(plan_program, program=program)
    script_planner = pddl_planner("script", "a script", call, (encoding,), missing=program.missing)
    return plan(TASK, grounding(), script_planner, time_limit=time_limit)


def writes(text: str) -> str:
    return f"open('plan', 'w').write({text!r})"


@pytest.mark.parametrize(
    ("script", "reason"),
    [
        ("raise SystemExit('no memory left')", "Script ended with code 1: no memory left"),
        ("import os; os.abort()", "Script ended with code -6: it said nothing"),
        ("import os; os.write(1, bytes(range(256)) * 1000)", "Script ended with code 0"),
        ("print('\\x1b[31m' + 'many words ' * 1000)", "[...]"),
        (writes(""), "Script ended with code 0"),
        (writes("(push-away-001-block item-01"), "line 1: '(push-away-001-block item-01' is not of the form"),
        (writes("(push-away-001-block item-77)"), "line 1: There is no object 'item-77'"),
        (writes("(push-left-000-block item-01)"), "mm from its goal"),
        ("open('plan', 'wb').write(b'(\\xff\\xfe\\x00')", "cannot be read"),
        ("import os; os.mkdir('plan')", "Script ended with code 0"),
        ("open('plan', 'w').write('(a b)\\n' * 1000000)", "Script ended with code 0"),
    ],
)
def test_bad_planner_is_a_result_in_one_sentence(scratch: Path, script: str, reason: str):
    found = solved_by(script)
    assert (found.status, found.steps) == (PlanStatus.FAILED, ())
    assert reason in found.reason
    assert len(found.reason) < 400
    assert "\n" not in found.reason
    assert found.reason.isprintable()
    assert list(scratch.iterdir()) == []


SLEEP = "import time; time.sleep(60)"
ORPHAN = """import os, subprocess, sys, tempfile, time
open(os.path.join(tempfile.gettempdir(), 'left'), 'w').write('x')
if os.fork() == 0:
    os.setsid()
    subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(60)', sys.argv[1]])
    os._exit(0)
"""


@pytest.mark.parametrize("knows", [True, False], ids=["", "the system does not tell of processes"])
@pytest.mark.parametrize("script", [SLEEP, "while True: print('rubbish')", ORPHAN + SLEEP])
def test_planner_that_never_ends_is_ended_with_all_its_children(scratch, script, knows, monkeypatch):
    if not knows:
        monkeypatch.setattr("neurosym.planners.keeper.marked", lambda _: [])
        script = SLEEP
    begin = time.perf_counter()
    found = solved_by(script, time_limit=1.0)
    assert found.status is PlanStatus.TIMEOUT
    assert time.perf_counter() - begin < 20.0, "not the minute that it sleeps, on a busy machine"
    assert alive(str(scratch)) == []
    assert list(scratch.iterdir()) == []


def test_a_script_can_be_a_planner_and_children_that_outlive_it_are_ended(scratch: Path, tmp_path: Path):
    """Without that they live, as the first lines show."""
    orphan = [sys.executable, "-c", ORPHAN.replace("60", "3"), str(tmp_path / "marked")]
    subprocess.run(orphan, cwd=tmp_path, check=True)
    assert any(alive(str(tmp_path / "marked")) or time.sleep(0.02) for _ in range(100))
    (scratch / "left").unlink(missing_ok=True)
    found = solved_by(ORPHAN + writes("0: (PUSH-AWAY-001-BLOCK ITEM-01) [1]\n; cost 16\n"))
    assert (found.status, len(found.steps)) == (PlanStatus.SOLVED, 1), found.reason
    assert alive(str(scratch)) == []
    assert list(scratch.iterdir()) == []


def test_what_is_killed_has_ended():
    code = "import os, time; [os.fork() for _ in range(3)]; print(flush=True); time.sleep(60)"
    started = {"env": {**os.environ, MARK: "slow"}, "stdout": subprocess.PIPE}
    with subprocess.Popen([sys.executable, "-c", code], **started) as process:
        assert process.stdout.read(8) == b"\n" * 8
        end_marked("slow")
        assert marked("slow") == []


def test_planner_that_is_not_here_and_encodings_it_does_not_take_are_refused_with_what_to_do():
    nowhere = Program("Nobody", "no_such_package", ("true",))
    nobody = pddl_planner("nobody", "", partial(plan_program, program=nowhere), missing=nowhere.missing)
    with pytest.raises(PlannerMissing, match="nobody is not installed; `pip install no-such-package`"):
        plan(TASK, grounding(), nobody)
    lacking = Program("Nobody", "neurosym", ("true",), needs=("no-such-command", "a shop"))
    assert lacking.missing() == "it needs no-such-command, which a shop brings"
    with pytest.raises(InvalidValue, match="encoding 'numeric'; valid: sas, strips"):
        plan(TASK, grounding(), "fast-downward", encoding="numeric")


@pytest.mark.parametrize("costs", [True, False])
@pytest.mark.parametrize("task", [TASK, toy_relations.tower()], ids=lambda one: one.name)
def test_program_that_reads_no_prices_is_given_the_plain_page(task: Problem, costs: bool):
    seen = []

    def call(domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
        seen.extend((domain.read_text(), problem.read_text()))
        return PlannerAnswer(PlanStatus.TIMEOUT)

    learned = grounding() if task is TASK else toy_relations.grounding()
    plan(task, learned, pddl_planner("mine", "mine", call, costs=costs))
    assert seen
    assert all((("total-cost" in text), ("(cost " in text)) == (costs, costs) for text in seen)


@pytest.mark.parametrize("name", sorted(planner.name for planner in PROGRAMS))
def test_every_planner_that_is_here_finds_the_way(name: str):
    if PLANNERS[name].missing():
        pytest.skip("not installed")
    found = plan(TASK, grounding(), name)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, TASK, grounding()).valid
    assert len(found.steps) == 1 or name == "lpg"  # which is soon there, with longer plans


def test_a_planner_gets_no_more_than_its_caller_may_have(tmp_path: Path):
    """Also where nobody may raise a limit: asking for more than that was an error."""
    code = f"""if True:
        import resource, sys
        from pathlib import Path
        from neurosym.planners import external
        for kind, most in ((resource.RLIMIT_AS, 3 << 30), (resource.RLIMIT_FSIZE, 1 << 20)):
            resource.setrlimit(kind, (most, most))
        asked = "import resource as r; print(r.getrlimit(r.RLIMIT_AS), r.getrlimit(r.RLIMIT_FSIZE))"
        print(external.run_limited([sys.executable, "-c", asked], Path({str(tmp_path)!r}), 10.0).last_words)
    """
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == f"{(3 << 30, 3 << 30)} {(1 << 20, 1 << 20)}"


def test_where_nothing_can_be_started_a_sentence_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def refused(*_: object, **__: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(subprocess, "Popen", refused)
    with pytest.raises(CannotStart, match="No planner can be started: Resource temporarily"):
        external.run_limited(["true"], tmp_path, 1.0)


def write(folder: Path, *, cell: float = 0.03, solvable: bool = True, domain: str = "") -> tuple[Path, Path]:
    task = problem_text(problem(), grounding(cell))
    (folder / "domain.pddl").write_text(domain or domain_text(grounding(cell)))
    unreachable = task.replace("(goal-on-table item-02 zone1)", "")
    assert unreachable != task
    (folder / "problem.pddl").write_text(task if solvable else unreachable)
    return folder / "domain.pddl", folder / "problem.pddl"


def test_plans_proofs_and_failures_are_results_and_nothing_is_left_behind(tmp_path: Path, scratch: Path):
    here = set(Path.cwd().iterdir())
    found = plan_fast_downward(*write(tmp_path), time_limit=60.0)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert "(lift item-01 m-010 " in found.text
    proved = plan_fast_downward(*write(tmp_path, solvable=False), time_limit=60.0)
    assert (proved.status, proved.text) == (PlanStatus.UNSOLVABLE, "")
    broken = plan_fast_downward(*write(tmp_path, domain="(define (domain tabletop)"), time_limit=60.0)
    assert broken.status is PlanStatus.FAILED
    assert len(broken.reason) > 40
    assert list(scratch.iterdir()) == []
    assert set(Path.cwd().iterdir()) == here


def test_unknown_search_fails_and_one_that_is_not_complete_proves_nothing(tmp_path: Path, monkeypatch):
    """Exit code 12: the search ended without a plan, and there may be one."""
    files = write(tmp_path, solvable=False)
    unknown = plan_fast_downward(*files, time_limit=20.0, searches=[external.Search("no-such-search()")])
    assert unknown.status is PlanStatus.FAILED
    assert "code 33" in unknown.reason
    monkeypatch.setattr(external, "run_limited", lambda *_, **__: external.Finished(12, "no solution!"))
    answer = plan_fast_downward(*files, time_limit=1.0)
    assert (answer.status, answer.text) == (PlanStatus.NOT_FOUND, "")
