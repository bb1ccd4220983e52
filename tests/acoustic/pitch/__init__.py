"""f0 and voicing of `app/acoustic/pitch`, on tones and pulse trains whose f0 is known. Begin with
`test_tracking.py`."""
