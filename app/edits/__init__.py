"""An author's changes to the performance of a line, kept in a small file and applied again after the recording, the
words or the rules have changed (docs/edits.md). A Notice reports each change that can no longer be applied.

`values.py` has the values. In the order of a performance: `words.py` finds words, turns marked ones into a director's
notes and corrects word times; `finding.py` finds the behaviours, `forms.py` changes them, `marks.py` moves their sync
points, `room.py` makes room for them; `applying.py` runs these four. Imports the choice of behaviours
(`understudy.behavior`), the directing vocabulary and the ground floor.
"""
