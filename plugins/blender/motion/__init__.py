"""Motion as numbers: rotations, and the clips that Understudy answers with."""
