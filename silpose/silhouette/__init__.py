"""Where masks come from: a posed body before a camera, or image files."""
