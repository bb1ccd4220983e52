"""How arms and hands get from pose to pose: strokes that snap, beats of hands at rest, what drags."""
