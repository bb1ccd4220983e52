"""The work on one line, wherever it is done: the job, its performance, the resulting files. A job and its outcome are
plain values that can be sent between processes and machines. Begin with `jobs`."""
