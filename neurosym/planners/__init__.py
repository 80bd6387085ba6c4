"""Planners, interchangeable: each is a value that solves a problem, and returns a result."""

from neurosym.planners.action_counts import plan_counting as plan_counting
from neurosym.planners.pddl_search import pddl_planner as pddl_planner
from neurosym.planners.planner import Planner as Planner
from neurosym.planners.planner import PlannerAnswer as PlannerAnswer
from neurosym.planners.planner import PlanResult as PlanResult
from neurosym.planners.planner import PlanStatus as PlanStatus
from neurosym.planners.registry import PLANNERS as PLANNERS
from neurosym.planners.registry import plan as plan
from neurosym.planners.registry import planner_named as planner_named
from neurosym.planners.registry import register_planner as register_planner
