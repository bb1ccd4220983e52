"""A first annotation of a recorded motion: phases by the wrists' speed, phrases and units, for people to correct."""
