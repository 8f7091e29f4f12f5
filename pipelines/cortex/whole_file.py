"""Text files that are there whole or not at all."""


def write_text(path, text):
    """Puts the text beside the file first, and then in its place."""
    partial = path.with_name(path.name + ".partial")
    partial.write_text(text, encoding="utf-8")
    partial.replace(path)
