"""What brings performances into other programs: a folder for each, independent of the package and of the others."""
