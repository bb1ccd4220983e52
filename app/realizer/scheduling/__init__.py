"""The scheduler of the paper's §3.8: which clip plays each gesture, which give way, how neighbours flow into each
other, when arms rest, and how all of it is laid over the body. Imports all rooms before it but `face`. Begin with
`planning.py`, which plans, then `gesturing.py`, which plays the plan.
"""
