"""Who may come in, and what every answer carries: API keys, allowed hosts, the operators' port, request ids, security
headers, the log of requests. Imports `problems` and the settings. Begin with `access.py`.
"""
