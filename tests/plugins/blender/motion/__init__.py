"""Tests of what needs no Blender."""
