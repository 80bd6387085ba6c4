"""The compiler: from the table of operators to PDDL text, and from plan text back to steps."""

from neurosym.pddl.compiler import compile_domain as compile_domain
from neurosym.pddl.compiler import domain_text as domain_text
from neurosym.pddl.compiler import problem_text as problem_text
