"""Decides what the body does with a line: from functions, the voice and a reading of the words to a schedule of
behaviours in time (paper §3.4, §3.5).

`reading` says what each phrase could mean for the hands, head and face; `candidates` says which behaviours could show
it; `choice` decides among them; `timing` places phases on the words and resolves conflicts. `table` and `characters`
are what authors edit; `idle`, `listeners`, `speech` and `speaker_profiles` add what accompanies the line.
"""
