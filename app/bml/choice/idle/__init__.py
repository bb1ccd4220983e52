"""What eyes, lids, chest and weight do by themselves, asked or not: when, as draws by seed. Imports the table's
directions. Begin with `idle_behaviors.py`.
"""
