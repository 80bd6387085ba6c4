"""The page: what a domain folder holds, as one HTML file that needs neither a network nor scripts."""
