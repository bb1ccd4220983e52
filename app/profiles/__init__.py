"""Speaker profiles: annotated gestures in, a profile of how the speaker gestures, new gestures in that style out
(Neff, Kipp et al. 2007, called NGS in this package).

    annotation   manual annotation of a recording, read from the formats of their tools and checked
    proposing    a first annotation of a motion, for people to correct
    learning     from annotation to profile (§3.2)
    profile …    the profile itself, its file, and profiles mixed
    generation   from profile and words to a gesture script (§3.3)
"""
