"""The worker processes, separate from the process that answers HTTP: jobs can be stopped, have limited memory, and use
every core. Begin with `pool.py`, the service's side, then `worker.py`, the workers'.

The service starts one nursery (`nursery.py`), which loads everything once and forks the workers, so that they share its
memory. A worker does one job at a time (`answering.py`). A job is stopped by killing its worker; the nursery forks
another within milliseconds. All processes end with the service, however it ends.
"""
