"""Speech that still goes on: how like its recording it is heard, at what cost."""
