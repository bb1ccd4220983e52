"""The clients of the service; those that are not Python have their own tests in `clients/`."""
