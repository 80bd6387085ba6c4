"""Planners, interchangeable: each is a value that solves a problem, and returns a result."""

from neurosym.planners.catalogue import PLANNERS as PLANNERS
from neurosym.planners.counting import fewest_steps as fewest_steps
from neurosym.planners.counting import plan_counting as plan_counting
from neurosym.planners.counting import plan_nearest as plan_nearest
from neurosym.planners.planner import Planner as Planner
from neurosym.planners.refinement import pddl_planner as pddl_planner
from neurosym.planners.registry import plan as plan
from neurosym.planners.registry import planner_named as planner_named
from neurosym.planners.registry import register_planner as register_planner
from neurosym.planners.result import PlannerAnswer as PlannerAnswer
from neurosym.planners.result import PlanResult as PlanResult
from neurosym.planners.result import PlanStatus as PlanStatus
