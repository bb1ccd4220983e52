"""One line performed by the job that a worker is given."""
