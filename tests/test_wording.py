"""Words for paths, lengths and lists."""

from neurosym.errors import listed_briefly


def test_long_list_is_cut_and_says_how_many_more_there_are():
    assert listed_briefly(("a", "b")) == "a, b"
    assert listed_briefly(("a", "b", "c"), most=3) == "a, b, c"
    assert listed_briefly(("a", "b", "c", "d"), most=2) == "a, b and 2 more"
