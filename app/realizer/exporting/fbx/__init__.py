"""FBX by way of Blender, which is started as a program of its own. Begin with `conversion.py`."""
