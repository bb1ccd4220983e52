"""What an author changed in the performance of a line, kept as a small file and made again after the recording, the
words or the rules have changed (docs/edits.md). What cannot be made again as it was is told by a Notice.

`values.py` has the values. In the order of a performance: `words.py` finds words again and turns those marked into a
director's notes, `word_times.py` corrects when they are spoken; `finding.py` finds the behaviours that are meant,
`forms.py` changes what they are, `marks.py` moves their sync points, `room.py` has the others give way; `applying.py`
is the last three together. Imports the choice of BML (`understudy.bml.choice`), the words for directors and the ground
floor.
"""
