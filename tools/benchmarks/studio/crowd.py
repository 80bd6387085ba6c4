"""A class on one server: how soon a drag is answered, how smoothly others run, and what each page takes."""

import os
import threading
import time
from typing import Any

import numpy as np
import viser
from websockets.sync.client import connect

from tools.benchmarks.studio.browser import wait_for
from tools.benchmarks.studio.measures import cpu_seconds, memory, studio

STUDENTS, RUNNING, SECONDS, GAP = 30, 5, 20.0, 0.05
"""Pages that are looked at; of these so many run; how long it is measured, and between two drags [s]."""


class Looker:
    """A window that draws nothing: it takes in what a page sends, and notes when."""

    def __init__(self, address: str, page: str):
        url = f"{address.replace('http', 'ws', 1)}/page/{page}"
        self.way = connect(url, subprotocols=[f"viser-v{viser.__version__}"], max_size=None)
        self.heard: list[float] = []
        threading.Thread(target=self._listen, daemon=True).start()

    def first_after(self, moment: float) -> float:
        """Return when the first message after a moment came; never, if none did."""
        return next((heard for heard in self.heard if heard > moment), np.inf)

    def _listen(self) -> None:
        for _ in self.way:
            self.heard.append(time.monotonic())


def measure_crowd() -> dict[str, Any]:
    """Have a class look, some run, and the others drag goals, one after another."""
    with studio("task-08") as opened:
        before = memory(os.getpid())
        names = [opened.open_page() for _ in range(STUDENTS)]
        lookers = [Looker(opened.front.address, name) for name in names]
        wait_for(lambda: all(looker.heard for looker in lookers), 120)
        time.sleep(3.0)
        after = memory(os.getpid())
        pages = opened.pages
        running = [page.session for page in pages[:RUNNING]]
        for session in running:
            session.plan("fast-downward")
        wait_for(lambda: all(one.plans and not one.planning for one in running), 300)
        for session in running:
            session.running.begin()
        wait_for(lambda: all(one.running.seen for one in running), 120)
        workers = [worker for one in running if one.running.ticket and (worker := one.running.ticket.process)]
        drawn = [page.drawn for page in pages[:RUNNING]]
        began, cpu = time.monotonic(), cpu_seconds(os.getpid())
        theirs, answers = sum(map(cpu_seconds, workers)), []
        while time.monotonic() < began + SECONDS:
            number, moment = len(answers), time.monotonic()
            place = RUNNING + number % (STUDENTS - RUNNING)
            pages[place].session.aim("item-01", 0.5 + 0.001 * (number % 100), 0.0)
            time.sleep(GAP)
            answers.append((lookers[place], moment))
            for session in running:  # what came to its end begins again
                if not session.running.is_active and session.plan_shown:
                    session.running.begin()
        seconds, theirs = time.monotonic() - began, sum(map(cpu_seconds, workers)) - theirs
        rates = [(page.drawn - first) / seconds for page, first in zip(pages, drawn, strict=False)]
        waits = [looker.first_after(moment) - moment for looker, moment in answers]
        found = {
            "pages looked at": STUDENTS,
            "of these running": RUNNING,
            "drags": len(waits),
            "median answer to a drag [ms]": round(1000 * float(np.median(waits))),
            "95 % of drags are answered within [ms]": round(1000 * float(np.quantile(waits, 0.95))),
            "fewest poses drawn a second of a run": round(min(rates), 1),
            "CPU of the server [% of a core]": round(100 * (cpu_seconds(os.getpid()) - cpu) / seconds),
            "CPU of all simulators [% of a core]": round(100 * theirs / seconds),
            "memory of a page [MB]": round((after - before) / STUDENTS, 1),
            "memory of a process that runs [MB]": round(max(map(memory, workers))),
            "cores": os.cpu_count(),
        }
        for looker in lookers:
            looker.way.close()
        return found
