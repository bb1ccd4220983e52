"""Scripts that make what lies in models/, from data outside the repository."""
