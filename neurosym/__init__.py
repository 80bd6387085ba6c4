"""neurosym: from a curious robot's interactions to a PDDL domain, and back to motions."""
