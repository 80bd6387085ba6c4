"""What people ask for: how things lie, and what shall hold of them."""
