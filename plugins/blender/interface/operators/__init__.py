"""The operators: for lines, BML, strips and takes, scripts, output, and armatures."""

from . import armatures, bml, lines, output, scripts, strips, takes, targets

CLASSES = (
    *lines.CLASSES,
    *bml.CLASSES,
    *strips.CLASSES,
    *takes.CLASSES,
    *scripts.CLASSES,
    *output.CLASSES,
    *armatures.CLASSES,
    *targets.CLASSES,
)
