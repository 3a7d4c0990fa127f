"""``python -m silpose`` is the command ``silpose``."""

from silpose.app.main import main

if __name__ == "__main__":
    main()
