"""Chosen movements in, a timed schedule and its BML out (paper §3.5), and BML back into a schedule. The rooms are
`choice` (what is done, and when), `markup` (BML as values and as XML), `writing` (a schedule as a document) and
`reading` (a document as a schedule). Imports the ground floor and no other stage. Begin with `choice/scheduling.py`,
then `writing/writer.py`.
"""
