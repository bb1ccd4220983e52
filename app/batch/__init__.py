"""Whole scripts: many lines and their recordings in, their performances out, on one machine or many.

The steps of a batch, in order (`understudy.batch.whole_run`): read the script (`scripts`), match its lines with
recordings (`matching`), decide who performs them (`casting`), look up in the manifest what is done already
(`manifest`), have the rest performed (`work` is the job, `running` executes it), write the reports (`reports`). A job
is a pure function of plain values; scheduling, retries and progress are kept apart from it.
"""
