"""Words without a recording: when each is spoken, by how long its sounds usually last and by the marks of its text.
Begin with `word_times.py`; it and `phone_durations.py` read what authors may change. Imports only the ground
floor."""
