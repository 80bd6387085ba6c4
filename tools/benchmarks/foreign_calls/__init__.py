"""What `tools.benchmarks.foreign` calls planners with: who they are, how each is called, and small tasks."""
