"""Where poses come from: a statistical walker, or motion capture files."""
