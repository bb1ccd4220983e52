"""BML in, motion out (paper §3.8): gestures, controllers, face, exporters."""
