// A run to be turned: names for the controls of viser's player.
(() => {
  const NAMES = {
    "button:not([aria-label])": "Play or pause",
    ".mantine-Notification-closeButton": "Close",
    ".mantine-NumberInput-input": "Time [s]",
    ".mantine-Select-input": "Pace",
    "[role=slider]": "Time [s]",
    "canvas[data-engine]": "The table",
  };
  const tidy = () => {
    for (const [selector, name] of Object.entries(NAMES).reverse())
      for (const node of document.querySelectorAll(selector))
        if (!node.getAttribute("aria-label")) node.setAttribute("aria-label", name);
  };
  document.addEventListener("DOMContentLoaded", () =>
    new MutationObserver(tidy).observe(document.body, {
      childList: true, subtree: true, attributeFilter: ["data-engine"], // known a while after the canvas is there
    }));
})();
