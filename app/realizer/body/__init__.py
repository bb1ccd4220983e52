"""The body: skeleton and forward kinematics, volume, joint limits, contacts, and the data model of motion. Imports
`geometry`. Begin with `skeleton.py` and `motion.py`."""
