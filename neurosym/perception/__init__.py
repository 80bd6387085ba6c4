"""What is seen of objects: regions of a depth image, and the numbers that an eye tells of them."""
