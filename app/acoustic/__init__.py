"""Audio in; words and phones in time, spectra, energy, pitch, stress and agitation out (paper §3.1)."""
