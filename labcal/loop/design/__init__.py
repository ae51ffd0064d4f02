"""What to measure next: experiments, and how far each would separate two explanations."""
