"""Executes jobs: engines (processes on this machine, a dask cluster, the service) and one supervisor for all of them.
An engine takes a job and returns a `Future`; the supervisor finds out which job killed a worker and what is tried
again. Begin with `engine`."""
