"""Blender's data: armatures, actions, strips, sounds and shape keys, read and written. Everything here needs bpy."""
