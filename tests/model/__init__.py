"""Values with rules of their own: limits and targets."""
