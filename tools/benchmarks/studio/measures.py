"""What one user of the studio meets: the start, a run, drags, and a recorded run, in a real browser."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.choices import shipped_domain
from neurosym.stages.folder import DomainFolder
from neurosym.studio.library import Library
from neurosym.studio.messages import Seen
from neurosym.studio.server import PANELS, Studio
from neurosym.studio.session import Session
from neurosym.studio.view import film_of
from tools.benchmarks.studio.browser import FLAGS, SLOW, Window, browser_here, serious_violations, wait_for

STARTS, DRAGS = 3, 12


@contextmanager
def studio(problem: str) -> Iterator[Studio]:
    """Open a studio on the shipped domain, whose pages begin with a problem."""
    folder = shipped_domain("tabletop")
    assert folder is not None, "it is shipped"
    domain = Library(DomainFolder(folder), "tabletop", is_shipped=True)
    opened = Studio(domain, problem=domain.load_problem(problem))
    opened.start()
    try:
        yield opened
    finally:
        opened.close()


@contextmanager
def chromium() -> Iterator[Any]:
    """Start the browser of this machine."""
    from playwright.sync_api import sync_playwright  # an extra, which the tests of other parts do without

    with sync_playwright() as running:
        browser = running.chromium.launch(executable_path=browser_here(), args=list(FLAGS))
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def window(problem: str) -> Iterator[Window]:
    """Open a studio, and a window of a real browser that looks at it."""
    with studio(problem) as opened, chromium() as browser:
        yield Window(browser, opened)


def foreign(asked: list[str]) -> list[str]:
    """List the requests that went anywhere but to this machine."""
    return [url for url in asked if "//127.0.0.1:" not in url and not url.startswith(("data:", "blob:"))]


def cpu_seconds(process: int) -> float:
    """Return how long a process has computed so far [s]."""
    parts = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(parts[11]) + int(parts[12])) / os.sysconf("SC_CLK_TCK")


def memory(process: int) -> float:
    """Return how much memory is a process's own [MB]."""
    lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    own = [int(line.split()[1]) for line in lines if line.startswith(("Private_Clean", "Private_Dirty"))]
    return sum(own) / 1024


def measure_start() -> dict[str, Any]:
    """Start the command, and open its page in a browser that draws in software."""
    address, usable, asked = [], [], []
    command = [sys.executable, "-m", "neurosym", "studio", "--no-browser"]
    for _ in range(STARTS):
        began = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None, "it is a pipe"
        url = process.stdout.readline().split()[-1]
        address.append(time.monotonic() - began)
        with chromium() as browser:
            tab = browser.new_page(viewport={"width": 1400, "height": 900})
            tab.on("request", lambda request: asked.append(request.url))
            opened = time.monotonic()
            tab.goto(url)
            tab.locator("#cover").wait_for(state="detached", timeout=1000 * SLOW)
            usable.append(time.monotonic() - opened)
        process.send_signal(signal.SIGINT)
        process.wait(30)
    return {
        "seconds until the address is printed": _spread(address),
        "seconds until the page can be used, drawn in software": _spread(usable),
        "requests": len(asked),
        "requests to anywhere else": len(foreign(asked)),
    }


def barriers(opened: Window) -> list[str]:
    """Say which serious barriers any panel of a page has, with two plans and a run, light and dark."""
    found, session = list[str](), opened.page.session
    for planner in ("fast-downward", "bfs"):
        session.plan(planner)
        opened.wait(lambda: not session.planning)
    session.running.steer(speed=0.0)
    session.running.begin()
    opened.wait(lambda: not session.running.is_active)
    for is_dark in (False, True):
        opened.page.set_dark(is_dark)
        for label in filter(None, PANELS):
            opened.open(label)
            opened.tab.wait_for_timeout(700)
            found += serious_violations(opened.tab)
    opened.page.set_dark(False)
    return found


def measure_access() -> dict[str, Any]:
    """Look for barriers on every panel, light and dark, in a wide window and in a small one."""
    with studio("task-14") as opened, chromium() as browser:
        windows = [Window(browser, opened, *size, is_drawn=False) for size in ((1400, 900), (390, 844))]
        found = [barriers(window) for window in windows]
    return {"serious barriers on the studio": sum(map(len, found))}


def measure_run() -> dict[str, Any]:
    """Run a plan as fast as in reality, and count what the page is told."""
    with window("task-08") as opened:
        session = opened.page.session
        session.plan("fast-downward")
        opened.wait(lambda: session.plans and not session.planning)
        session.running.begin()
        opened.wait(lambda: session.running.seen)
        ticket = session.running.ticket
        worker = ticket.process if ticket else None
        assert worker is not None, "it runs"
        told = _poses(session)
        began, ours, theirs = time.monotonic(), cpu_seconds(os.getpid()), cpu_seconds(worker)
        drawn = opened.page.drawn
        opened.wait(lambda: not session.running.is_active or time.monotonic() > began + 10)
        seconds = time.monotonic() - began
        found = {
            "seconds": round(seconds, 1),
            "poses told a second": round(len(told) / seconds, 1),
            "poses drawn a second": round((opened.page.drawn - drawn) / seconds, 1),
            "CPU of the page's server [%]": round(100 * (cpu_seconds(os.getpid()) - ours) / seconds),
            "CPU of the simulator [%]": round(100 * (cpu_seconds(worker) - theirs) / seconds),
        }
        session.running.stop()
        wait_for(lambda: not session.running.is_active)
        return found | {"requests to anywhere else": len(foreign(opened.asked))}


def measure_drags() -> dict[str, Any]:
    """Drag a goal to places drawn at random, by mouse."""
    rng, errors = np.random.default_rng(0), []
    with window("task-01") as opened:
        session = opened.page.session
        for _ in range(DRAGS):
            x, y = rng.uniform([0.45, -0.2], [0.8, 0.2]).tolist()
            height = opened.knob("item-01")[2]
            opened.drag(opened.knob("item-01"), (x, y, height))
            goal = session.problem.goals["item-01"]
            errors.append(1000 * float(np.hypot(goal[0] - x, goal[1] - y)))
    return {
        "drags": DRAGS,
        "median error [mm]": round(float(np.median(errors)), 1),
        "greatest error [mm]": round(max(errors), 1),
    }


def measure_recording() -> dict[str, Any]:
    """Record a run as one file."""
    with studio("task-08") as opened:
        opened.open_page()
        session = opened.pages[0].session
        session.plan("fast-downward")
        wait_for(lambda: session.plans and not session.planning)
        seen = _poses(session)
        session.running.begin()
        wait_for(lambda: not session.running.is_active, 120)
        began = time.monotonic()
        running, problem = session.running, session.problem
        film = film_of(session.library, problem, seen, running.records)
        seconds = time.monotonic() - began
        return {
            "steps": len(running.records),
            "poses of the run": len(seen),
            "bytes of the file": len(film),
            "of these, the viewer": len(film_of(session.library, problem, seen[:1], running.records)),
            "seconds to make it": round(seconds, 1),
        }


def _poses(session: Session) -> list[Seen]:
    """Return a list to which each pose is added that a session is told from now on."""
    found: list[Seen] = []
    running = session.running
    session.listen(lambda topic: found.append(seen) if topic == "pose" and (seen := running.seen) else None)
    return found


def _spread(values: list[float]) -> str:
    return f"{min(values):.1f} to {max(values):.1f} ({len(values)} times)"
