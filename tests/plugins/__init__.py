"""Tests of the plugins. What needs the program itself is in a folder of its own, and skipped where it is not there."""
