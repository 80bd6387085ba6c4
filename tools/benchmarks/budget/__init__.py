"""What plans can do by how many interactions they cost in all (docs/results/budget.md)."""
