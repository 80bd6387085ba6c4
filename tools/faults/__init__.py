"""A campaign of faults: kills, full disks, two at once, low limits and clocks that jump (`make faults`)."""
