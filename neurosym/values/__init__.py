"""Domains of things whose named values actions change: data of anything, compiled and planned with."""
