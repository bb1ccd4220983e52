"""Tests of the Blender extension. `in_blender/` runs it in Blender's own module (`make test-plugins`)."""
