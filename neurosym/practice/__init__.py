"""Practice: where plans fail in the world, more is learned of the operators that broke them."""
