"""One line's work, wherever it is done: the job, its performance, the files that come of it. A job and its outcome are
plain values that travel between processes and machines. Begin with `jobs`."""
