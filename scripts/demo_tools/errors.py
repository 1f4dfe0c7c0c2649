"""What can go wrong in the demonstration."""


class DemoError(RuntimeError):
    """Ends the demonstration; the text is for a person."""
