"""The built-in mannequin: procedural skinned surfaces around the skeleton, with blendshapes of the face. Imports
`geometry`, `body` and the tables of `face`. Begin with `skinning.py`."""
