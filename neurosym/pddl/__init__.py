"""The compiler: from the table of operators to PDDL text, and from plan text back to steps."""
