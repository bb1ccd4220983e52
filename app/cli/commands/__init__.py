"""One module a command; `app.cli.main` imports the one that is called."""
