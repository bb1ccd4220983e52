"""The HTTP door: requests in, BML or JSON out."""
