"""Whole scripts: many lines and their recordings in, their performances out, on one machine or many.

The way of a batch, in order (`understudy.batch.batch`): read the script (`scripts`), join its lines with recordings
(`matching`), decide who performs them (`casting`), see in the manifest what is done already (`manifest`), have the
rest performed (`work` is the job, `running` who does it), tell what came of it (`reports`). A job is a pure function of
plain values; scheduling, retries and progress stand outside it.
"""
