"""The mannequin's surfaces and face: `app/realizer/mannequin`. Begin with `test_skinning.py`."""
