"""Motion from data: begin with `tests/cli/test_motion_model.py`, which trains on a folder and performs by its model."""
