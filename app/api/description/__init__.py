"""The service's OpenAPI document, from which clients are generated, and the page that shows it. Begin with
`document.py`.
"""
