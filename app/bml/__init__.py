"""Turns chosen movements into a timed schedule and its BML (paper §3.5), and BML back into a schedule. The rooms are
`choice` (which behaviours, and when), `markup` (BML as values and as XML), `writing` (a schedule as a document) and
`reading` (a document as a schedule). Imports the ground floor and no other stage. Begin with `choice/scheduling.py`,
then `writing/writer.py`."""
