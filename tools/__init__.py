"""What a maintainer types, and the benchmarks."""
