"""The skeleton, its limits and contacts: `app/realizer/body`, on poses whose answer is plain. Begin with
`test_skeleton.py`.
"""
