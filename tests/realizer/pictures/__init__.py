"""Contact sheets, speeds and the rasterizer: `app/realizer/pictures`, by what can be seen in the pixels. Begin with
`test_contact_sheet.py`.
"""
