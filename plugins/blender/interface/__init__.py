"""What is seen and pressed: panels, operators, settings and preferences."""
