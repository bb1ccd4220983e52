"""Jobs that end, fail, and kill their workers."""
