"""What a worker has found out about the lines it was asked about last.

An author changes a line again and again. While its recording and its words stay, so does all that is heard and meant in
them, which is most of the work. An analysis is a pure function of what it is kept by, so answers are the same with and
without. Of a recording there are only its digest and what was measured; of one longer than a minute nothing is kept,
since the memory is the next job's.
"""

from collections import OrderedDict
from collections.abc import Hashable
from dataclasses import replace
from hashlib import sha256

from ...authoring.rule_edits import Edits
from ...library.performing import PerformedLine, perform_line
from ...model import Analysis, Line
from ...models import Understudy
from ...options import Options

LONGEST_S = 60.0
MOST_LINES = 2
"""A line and the one it is compared with."""


class KnownLines:
    """The analyses of the last lines, of one set of models. Belongs to one worker."""

    def __init__(self) -> None:
        self._analyses: OrderedDict[Hashable, Analysis] = OrderedDict()

    def performed(self, understudy: Understudy, line: Line, options: Options, edits: Edits) -> PerformedLine:
        """The line's performance; raises as `perform_line` does. `edits` are those of the rules, already in the models
        given here."""
        key = _key(line, options, edits)
        known = self._analyses.get(key) if key else None
        performed = perform_line(understudy, line, options, analysis=known)
        duration_s = performed.analysis.utterance.duration_s
        if key and duration_s is not None and duration_s <= LONGEST_S:
            self._keep(key, performed.analysis)
        return performed

    def _keep(self, key: Hashable, analysis: Analysis) -> None:
        self._analyses[key] = analysis
        self._analyses.move_to_end(key)
        if len(self._analyses) > MOST_LINES:
            self._analyses.popitem(last=False)


def _key(line: Line, options: Options, edits: Edits) -> Hashable:
    """All that an analysis depends on; None with a speaker's reference, which is compared with difficulty and sent by
    nobody who changes a line by hand."""
    if options.reference is not None:
        return None
    audio = None if line.audio is None else sha256(line.audio).digest()
    said = replace(line, audio=None, direction=None)
    return audio, said, options.agitation, options.affect, options.edits.words, tuple(sorted(edits.items()))
