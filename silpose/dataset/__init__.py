"""What is learnt from and tested on: sequences and their split."""
