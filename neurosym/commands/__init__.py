"""The command line: one file a command, which reads options, performs a stage, and says what came of it."""
