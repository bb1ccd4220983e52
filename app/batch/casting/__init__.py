"""Who performs a line, who listens to it, and how its speaker usually sounds. Begin with `casting`."""
