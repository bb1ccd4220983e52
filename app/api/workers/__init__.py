"""The processes in which lines are performed, apart from the one that answers HTTP: so that work can be stopped, cannot
take all memory, and uses every core. Begin with `pool.py`, the service's side, then `worker.py`, theirs.

The service starts one nursery (`nursery.py`), which loads everything once and forks the workers, so that they share
what is loaded. A worker does one job at a time (`answering.py`); to stop a job is to kill its worker, for the nursery
has another ready in some milliseconds. All of them end when the service does, however it ends.
"""
