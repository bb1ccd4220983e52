"""Whose gestures these are: a speaker's annotated gestures in, a profile of how they gesture, gestures in their way out
(Neff, Kipp et al. 2007, called NGS in this package).

    annotation   what people marked in a recording, read from the formats of their tools and checked
    proposing    a first annotation of a motion, for people to correct
    learning     from annotation to profile (§3.2)
    profile …    the profile itself, its file, and profiles mixed
    generation   from profile and words to a gesture script (§3.3)
"""
