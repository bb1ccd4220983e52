"""Speaker profiles: learns a speaker's gesture style from annotated gestures, and generates new gestures in that style
(Neff, Kipp et al. 2007, called NGS in this package).

    annotation   reads and checks manual annotations of recordings, in the formats of annotation tools
    proposing    proposes an annotation from motion, for manual correction
    learning     learns a profile from annotations (§3.2)
    profile …    the profile, its file, and mixtures of profiles
    generation   generates a gesture script from a profile and words (§3.3)
"""
