"""Those spoken to: where they stand, whom a movement addresses, and what they do meanwhile. Imports `scheduling` and
what it imports. Begin with `listening.py`.
"""
