"""How arms and hands get from pose to pose: `app/realizer/dynamics`. Begin with `test_snapping.py`."""
