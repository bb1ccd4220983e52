"""Decides who performs a line, who listens to it, and what its speaker usually sounds like. Begin with `casting`."""
