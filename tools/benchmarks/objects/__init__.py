"""Objects that nothing was learned of: shapes never seen, hidden properties, and sizes at an edge."""
