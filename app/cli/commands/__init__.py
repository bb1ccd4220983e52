"""One module a command; `understudy.cli.main` imports the one that is called."""
