"""Jobs for workers: a short one, and one that takes long enough to be stopped in the middle (some seconds)."""

from understudy.api.workers.messages import Job, Task

SHORT = Job(Task.FUNCTIONS, "application/json", None)
SHORT_TEXT = b'{"text": "No."}'

LONG = Job(Task.REALIZE, "application/xml", None)
_BEATS = (
    f'<gesture id="g{n}" lexeme="BEAT" start="{1.5 * n}" stroke="{1.5 * n + 0.7}" end="{1.5 * n + 1.4}"/>'
    for n in range(90)
)
LONG_BML = (
    '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b1" characterId="default">' + "".join(_BEATS) + "</bml>"
).encode()
