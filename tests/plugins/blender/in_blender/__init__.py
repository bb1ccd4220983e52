"""Tests in Blender's own module (`bpy`): `make test-plugins`, which installs it apart; skipped without it."""
