"""From BML and performances to motion and its files: `app/realization`."""
