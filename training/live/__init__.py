"""Makes the model in models/live: `mouth`, which shape a mouth has from its sound. Imports `understudy.live`."""
