"""Has jobs done: engines (processes here, a dask cluster, the service) and the one supervisor over all of them. An
engine is handed a job and a `Future` comes back; who died, what is tried again and what goes on the supervisor decides.
Begin with `supervising`."""
