"""Benchmarks of the plugins, each run in the Python of the program it is for."""
