"""Exporters: pure functions from a motion to the bytes of a file, one module per format (docs/motion-formats.md), and
the reader of avatars to which a motion is applied. Imports `geometry`, `body`, `face` and `mannequin`. Begin with
`bvh.py`, the simplest, then `gltf.py` and `glb.py`; `retargeting.py` has the joint names of other rigs."""
