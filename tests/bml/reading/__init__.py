"""BML files, ours and others', as schedules: `app/bml/reading`, including hostile and broken ones. Begin with
`test_reader.py`."""
