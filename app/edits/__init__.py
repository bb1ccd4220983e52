"""An author's changes to the performance of a line, kept in a small file and applied again after the recording, the
words or the rules have changed (docs/edits.md). A Notice reports each change that can no longer be applied.

`understudy.model.edits` has the values. In the order of a performance: `words.py` finds words, turns marked ones into a
director's notes and corrects word times; `applying.py` finds the behaviours and has them changed by `forms.py`,
their sync points moved and room made for them by `timing.py`. Imports the choice of behaviours
(`understudy.behavior`), the directing vocabulary and the ground floor.
"""
