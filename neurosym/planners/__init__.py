"""Planners, interchangeable: each takes a problem and returns a result."""

from neurosym.planners.alternatives import alternatives as alternatives
from neurosym.planners.bfs import plan_bfs as plan_bfs
from neurosym.planners.branching import Branching as Branching
from neurosym.planners.branching import branching_of as branching_of
from neurosym.planners.branching import predicted_branching as predicted_branching
from neurosym.planners.catalogue import PDDL_PLANNERS as PDDL_PLANNERS
from neurosym.planners.counting import fewest_steps as fewest_steps
from neurosym.planners.counting import plan_counting as plan_counting
from neurosym.planners.no_plan import plan_nearest as plan_nearest
from neurosym.planners.refinement import plan_pddl as plan_pddl
from neurosym.planners.registry import PLANNERS as PLANNERS
from neurosym.planners.registry import check_options as check_options
from neurosym.planners.registry import plan as plan
from neurosym.planners.result import PlanResult as PlanResult
from neurosym.planners.result import PlanStatus as PlanStatus
