"""From our skeleton to any humanoid armature: bones found by name, rest poses compared, rotations carried over."""
