"""Studies: what is shown to whom, and what answers say. Imports `understudy.study`."""
