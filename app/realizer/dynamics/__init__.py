"""The dynamics of arms and hands between poses: fast strokes, follow-through of hands and fingers, small beats at rest,
and the pace of the whole motion.
"""
