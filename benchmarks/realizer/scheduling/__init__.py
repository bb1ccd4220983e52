"""What of a schedule is played, and how it is planned. Imports `benchmarks.realizer.motion`, which has the lines."""
