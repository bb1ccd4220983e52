"""Makes `models/alignment/` from the half of TIMIT that `benchmarks.alignment` does not report on."""
