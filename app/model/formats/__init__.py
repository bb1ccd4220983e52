"""The forms in which results are written: BML, and files of motion."""
