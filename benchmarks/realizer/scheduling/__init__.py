"""How gestures are planned, and which of a schedule are played. Imports `benchmarks.realizer.motion`, which has the
lines."""
