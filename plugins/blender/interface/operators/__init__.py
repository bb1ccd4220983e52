"""What can be pressed: lines, BML, strips, and what belongs to an armature."""

from . import armatures, bml, lines, strips, targets

CLASSES = (*lines.CLASSES, *bml.CLASSES, *strips.CLASSES, *armatures.CLASSES, *targets.CLASSES)
