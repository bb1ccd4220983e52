"""Our own body to look at: skinned surfaces around the skeleton, drawn by code, with a face that moves. Imports
`geometry`, `body` and the tables of `face`. Begin with `mannequin.py`.
"""
