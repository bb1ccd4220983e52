"""BML files of ours and others as schedules: `app/bml/reading`, hostile and broken ones too. Begin with
`test_reader.py`.
"""
