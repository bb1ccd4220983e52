"""Makes the model in models/live: `mouth`, which estimates the mouth shape from the sound. Imports
`understudy.live`."""
