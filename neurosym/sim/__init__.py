"""The PyBullet world; nothing outside this folder imports PyBullet."""
