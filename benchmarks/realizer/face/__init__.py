"""The face: the lips of recorded lines and of hand-labelled closures. Imports `understudy.realizer.face`."""
