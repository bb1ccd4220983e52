"""Writing and reading BML, room by room as in `app/bml`."""
