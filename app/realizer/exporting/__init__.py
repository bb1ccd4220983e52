"""A motion as files of other tools: pure functions to bytes, one module a format (docs/motion-formats.md), and avatars
of others, read to wear it. Imports `geometry`, `body`, `face` and `mannequin`. Begin with `bvh.py`, the simplest, then
`gltf.py` and `glb.py`; `retargeting.py` has the joints' names in other rigs.
"""
