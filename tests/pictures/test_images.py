"""GIFs and strips hold what they were given."""

import numpy as np
from PIL import Image

from neurosym.pictures.film import STRIP_SIZE, Row, save_gif, save_sheet

FRAMES = [np.full((480, 640, 3), shade, dtype=np.uint8) for shade in (0, 120, 250)]


def test_gif_shows_every_frame_and_pauses_on_the_last(tmp_path):
    save_gif(tmp_path / "run.gif", FRAMES)
    with Image.open(tmp_path / "run.gif") as image:
        assert image.n_frames == 3
        image.seek(2)
        assert image.info["duration"] > 1000
        assert image.convert("L").getpixel((10, 10)) == 250


def test_strip_sets_the_frames_side_by_side_with_captions(tmp_path):
    save_sheet(tmp_path / "run.png", [Row("", tuple(FRAMES), ("start", "one", "two"))])
    with Image.open(tmp_path / "run.png") as image:
        width, height = STRIP_SIZE
        assert image.size[0] == 3 * width
        assert [image.getpixel((width // 2 + width * k, 100))[0] for k in range(3)] == [0, 120, 250]
        caption = np.asarray(image.convert("L"))[height:, :width]
        assert caption.min() < 128 < caption.max()
