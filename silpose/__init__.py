"""silpose: a person's 3D pose from silhouettes alone, by regression, watched step by step."""
