"""Motion as files: `app/realizer/exporting`, read again by readers of the test's own (`support.gltf_reading`). Begin
with `test_exporting.py`.
"""
