"""Makes `models/alignment/` from the half of TIMIT that `benchmarks.acoustic.alignment` does not report on."""
