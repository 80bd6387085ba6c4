"""The stage that takes over a scene that somebody wrote: checked, copied, and printed as PDDL."""

from pathlib import Path

import msgspec

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.pddl.grid import check_on_table
from neurosym.problems import Problem
from neurosym.reading import digest
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, WORLD, problem_files, scene_file
from neurosym.stages.manifest import Stage
from neurosym.stages.planning import check_scene
from neurosym.stages.problem_printing import put_problem
from neurosym.stages.remarks import tell_remarks
from neurosym.stages.task_drawing import networks_of_pairs, sight_of_pairs


def scene_stage(folder: DomainFolder, file: Path, *, name: str, tolerance: float | None = None) -> Stage:
    """Take over a scene: a file and grounding -> `problems/NAME.pddl`, `.numeric.pddl`, `.scene.json`.

    Args:
        folder: The domain folder.
        file: The scene, as `neurosym.problems.Problem` reads it.
        name: What the problem is called in the folder, whatever it is called in the file.
        tolerance: How near objects must come to their goals [m], if not as the file says.
    """

    def work() -> None:
        grounding = Grounding.load(folder.require(GROUNDING))
        problem = msgspec.structs.replace(Problem.load(file), name=name).within(tolerance)
        problem = with_pairs(problem, grounding.relations, sight_of_pairs(folder))
        check_scene(folder, problem, file)
        try:
            for item in problem.objects:  # only what a run saw may be a little off
                check_on_table(item, grounding)
        except InvalidValue as error:
            raise InvalidFile(file, str(error).rstrip(".")) from error
        tell_remarks(folder, problem, grounding)
        put_problem(folder, problem, grounding)

    options = {"scene": digest(file)} | ({} if tolerance is None else {"tolerance": tolerance})
    outputs = (*problem_files(name), scene_file(name))
    inputs = (WORLD, GROUNDING, *networks_of_pairs(folder))
    return Stage(f"new-problem {name}", inputs, outputs, work, options)
