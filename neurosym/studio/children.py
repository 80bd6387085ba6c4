"""What a process of the studio does: it plans, runs and draws tasks, one job after another.

A job calls the stages that the command line calls, in the folder of one page. While it works it sends what is
to be seen, and heeds what is said to it: another speed, pause, go on, a nudge, stop.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from neurosym.errors import NeurosymError
from neurosym.factories import told
from neurosym.poses import Posed
from neurosym.studio.messages import (
    Drawn,
    DrawTask,
    Failed,
    Job,
    Make,
    Perform,
    Performed,
    Planned,
    PlanNew,
    Ran,
    Recall,
    Replay,
    RunPlan,
)
from neurosym.studio.onlooker import Onlooker
from neurosym.worlds.children import parent

HOLD = 3.0
"""So long is the end of an interaction shown before the table is there again [s]."""
SETTING = "setting.json"
"""Where a page keeps the scene that it takes over, in its folder."""


def do(job: Job) -> Any:
    """Do a job, and return its answer."""
    try:
        return _WORK[type(job)](job)
    except NeurosymError as error:
        return Failed(_without_paths(str(error), job))
    except Exception as error:  # of a planner or a world of somebody's own: this job only is at its end
        return Failed(f"It failed: {told(error)}")


def _without_paths(sentence: str, job: Job) -> str:
    """Return a sentence without the folder of the page, which is nobody's business but the server's."""
    return sentence.replace(str(job.folder / SETTING), "The scene").replace(f"{job.folder}/", "")


def _make(job: Make) -> Any:
    """Take a scene over into the folder, under the name of the problem."""
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.scenes import scene_stage

    file = job.folder / SETTING
    job.problem.save(file)
    folder = DomainFolder(job.folder)
    folder.perform(scene_stage(folder, file, name=job.problem.name), again=True)
    return Drawn(job.problem)


def _plan(job: PlanNew) -> Any:
    from neurosym.planners.registry import planner_named
    from neurosym.reading import read_json
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import plan_files
    from neurosym.stages.plan_records import PlanRecord, written_steps
    from neurosym.stages.planning import plan_stage

    _make(Make(job.folder, job.problem))
    folder, name = DomainFolder(job.folder), job.problem.name
    chosen = planner_named(job.planner, job.folder)
    stage = plan_stage(
        folder,
        name,
        planner=job.planner,
        encoding=job.encoding,
        nearest=job.nearest,
        time_limit=job.time_limit,
    )
    folder.perform(stage, again=True)
    record = read_json(folder / plan_files(name, chosen.name)[1], PlanRecord)
    return Planned(record, written_steps(folder, name, chosen.name) or "")


def _run(job: RunPlan) -> Any:
    from neurosym.stages.executing import Showing, execute_stage, load_run
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import run_file

    folder, plan_file = DomainFolder(job.folder), job.folder / job.plan_file
    stage = execute_stage(
        folder,
        job.problem,
        plan_file,
        replanner=job.replanner,
        replans=job.replans,
        showing=Showing(audience=Onlooker(parent(), job.controls)),
    )
    folder.perform(stage, again=True)
    return Ran(load_run(folder, job.problem, plan_file), run_file(job.problem, plan_file))


def _replay(job: Replay) -> Any:
    from neurosym.stages.executing import Showing, replay_run
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import RECORD, RUNS

    folder, file = DomainFolder(job.folder), f"{RUNS}/{job.run}{RECORD}"
    showing = Showing(audience=Onlooker(parent(), job.controls))
    run, agreement = replay_run(folder, folder / file, showing)
    return Ran(run, file, agreement.course)


def _draw(job: DrawTask) -> Any:
    from neurosym.stages.folder import DomainFolder, load_scene
    from neurosym.stages.layout import scene_file
    from neurosym.stages.problem_making import Asked, problem_stage

    folder = DomainFolder(job.folder)
    asked = Asked(job.objects, seed=job.seed, task=job.task, tolerance=job.tolerance)
    folder.perform(problem_stage(folder, job.name, asked), again=True)
    return Drawn(load_scene(folder / scene_file(job.name)))


def _perform(job: Perform) -> Any:
    """Perform one action in a scene, and send its poses."""
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import WORLD
    from neurosym.world import relative_to
    from neurosym.worlds.world_file import read_world

    world = read_world(DomainFolder(job.folder).require(WORLD))()
    onlooker = Onlooker(parent(), job.controls)
    onlooker.begin(world, job.problem)
    target = job.problem.object_names.index(job.object)
    aim = relative_to(world, job.reference)
    outcome = world.interact(job.problem.scene(), np.array(job.action), target, **aim)
    onlooker.see_outcome(outcome)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end)


def _recall(job: Recall) -> Any:
    """Make an interaction of the data happen again."""
    from neurosym.data.interactions import Interactions
    from neurosym.pictures.motions import judge, recall_interaction
    from neurosym.stages.layout import WORLD
    from neurosym.worlds.world_file import read_world

    world = read_world(job.folder / WORLD)()
    interactions = Interactions.load(job.data)
    motion, is_same = recall_interaction(world, interactions, job.row)
    onlooker = Onlooker(parent(), job.controls)
    parent().send(motion.scene)
    if isinstance(world, Posed):
        world.on_pose = onlooker.see
    outcome = world.interact(motion.scene, motion.action, 0)
    onlooker.see_outcome(outcome)
    onlooker.hold(HOLD)
    said = judge(interactions, job.row, outcome, is_same)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end, said)


_WORK: dict[type[Job], Callable[[Any], Any]] = {
    Make: _make,
    PlanNew: _plan,
    RunPlan: _run,
    Replay: _replay,
    DrawTask: _draw,
    Perform: _perform,
    Recall: _recall,
}
