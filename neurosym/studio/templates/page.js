// The page of the studio around viser's panels: names for controls, messages, the first visit, bounds, the map.
(() => {
  const match = window.matchMedia.bind(window);
  const NARROW = "(max-width: 699.98px)"; // below this width the panels are a sheet under the table
  window.matchMedia = (query) => match(query === "(max-width: 36em)" ? NARROW : query);
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const first = (selector) => document.querySelector(selector);
  const set = (node, name, value) => node.getAttribute(name) === value || node.setAttribute(name, value);
  const TYPED = "input:not([type=hidden])";
  const rowOf = (label) => label.parentElement.parentElement.parentElement;

  function nameFields() {
    for (const label of all("#root label[for]")) {
      const row = rowOf(label), text = label.textContent;
      const fields = all(`${TYPED}, textarea, [role=slider]`, row), axes = text.match(/\b[xyz]\b/g) || [];
      fields.forEach((field, number) => {
        const axis = axes[number] ? `${text.split(/ [xyz]\b/)[0]} ${axes[number]}` : text;
        if (field.id !== label.htmlFor || axes.length || field.getAttribute("role")) set(field, "aria-label", axis);
      });
      if (text === "Place on the map") row.parentElement.style.display = "none";
    }
    for (const icon of all(".tabler-icon-chevron-up, .tabler-icon-chevron-down", first("#root"))) {
      const fold = icon.parentElement;
      if (fold.closest("button, [data-dock-region-handle]")) continue;
      set(fold, "role", "button");
      set(fold, "tabindex", "0");
      set(fold, "aria-expanded", String(icon.classList.contains("tabler-icon-chevron-up")));
    }
    for (const button of all("button:not([aria-label])"))
      if (!button.textContent.trim()) set(button, "aria-label", "Close");
    for (const canvas of all("canvas")) {
      const told = first("[data-scene]");
      const isTable = Boolean(canvas.dataset.engine); // known a while after the canvas is there
      set(canvas, "aria-hidden", String(!isTable));
      if (!isTable) continue;
      set(canvas, "role", "img");
      set(canvas, "aria-label", told ? told.textContent : "The table");
    }
  }

  function announce() {
    const said = first("[data-said]"), text = said ? said.textContent : "", live = first("#live");
    if (live.textContent !== text) live.textContent = text;
  }

  let hasTabs = false;
  const isNew = !document.cookie.includes("neurosym-been=");

  function open() { // what viser shows of itself while it loads is covered until the panels are there
    if (hasTabs || !first("[data-scene]") || !first("#root [role=tab]")) return;
    hasTabs = true;
    document.cookie = "neurosym-been=1; path=/; max-age=31536000; SameSite=Strict";
    const uncover = (tries) => { // viser chooses a tab itself when it has laid out all
      const tour = all("#root [role=tab]").find((one) => one.textContent === "Tour");
      const isThere = !isNew || tour?.getAttribute("aria-selected") === "true";
      if (!isThere) { // tabs of the dock hear of keys, and those of the sheet of clicks
        tour?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
        tour?.click();
      }
      if (isThere && tries < 9 || !tries) first("#cover").remove();
      else setTimeout(uncover, 300, tries - 1);
    };
    setTimeout(uncover, 300, 9);
  }

  function checkBounds(field) {
    const label = field.closest("#root") && all("#root label[for]").find((one) => rowOf(one).contains(field));
    if (!label || field.tagName !== "INPUT") return;
    const row = rowOf(label), slider = row.querySelector("[role=slider]");
    const known = slider
      ? [["min", "max"].map((end) => Number(slider.getAttribute(`aria-value${end}`)))]
      : window.neurosymBounds[label.textContent] || [];
    const ends = known[all(TYPED, row).indexOf(field)], value = Number(field.value);
    const isOut = Boolean(ends) && field.value !== "" && !(value >= ends[0] && value <= ends[1]);
    set(field, "aria-invalid", String(isOut));
    row.parentElement.querySelector(".bound")?.remove();
    if (!isOut) return;
    const said = Object.assign(document.createElement("p"), { className: "bound" });
    said.setAttribute("role", "alert");
    said.textContent = `${field.getAttribute("aria-label") || label.textContent}: from ${ends[0]} to ${ends[1]}`;
    row.after(said);
  }

  let drag = null; // the map whose dot is dragged, and where its dot is [pixels of the view box]
  const clamp = (value, one, other) => Math.min(Math.max(value, Math.min(one, other)), Math.max(one, other));

  function drawDot(map) {
    const at = first("[data-map-at]");
    if (!at) return;
    let dot = map.querySelector("circle.item");
    if (!dot) {
      dot = document.createElementNS("http://www.w3.org/2000/svg", "circle");
      const looks = { class: "item", cy: 40, r: 7, fill: "#fff", stroke: "#000", "stroke-width": 3 };
      Object.entries(looks).forEach(([name, value]) => dot.setAttribute(name, value));
      map.append(dot);
    }
    const values = at.dataset.mapAt.split(" ").map(Number);
    JSON.parse(map.dataset.map).forEach((axis, number) => {
      const share = (values[axis.feature] - axis.low) / (axis.high - axis.low);
      const spot = drag ? drag.spots[number] : axis.from + share * (axis.to - axis.from);
      set(dot, number ? "cy" : "cx", clamp(spot, axis.from, axis.to).toFixed(1));
    });
  }
  const drawDots = () => all("svg.map").forEach(drawDot);

  function dragTo(event, panel) { // a map that changes is drawn anew below the pointer, in the same panel
    const map = panel.querySelector("svg.map");
    const label = all("#root label[for]").find((one) => one.textContent === "Place on the map");
    if (!map || !label) return;
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.getScreenCTM().inverse());
    const axes = JSON.parse(map.dataset.map);
    const spots = axes.map((axis, number) => clamp(number ? point.y : point.x, axis.from, axis.to));
    drag = { panel, spots };
    const values = axes.map((axis, number) =>
      axis.low + ((spots[number] - axis.from) / (axis.to - axis.from)) * (axis.high - axis.low));
    const field = rowOf(label).querySelector("input");
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set.call(field, values.join(" "));
    field.dispatchEvent(new Event("input", { bubbles: true }));
    drawDots();
  }

  document.addEventListener("pointerdown", (event) => {
    const map = event.target.closest("svg.map"); // its panel: all around it up to where another map is
    let panel = map?.parentElement;
    if (!map) return;
    while (panel.parentElement && all("svg.map", panel.parentElement).length === 1) panel = panel.parentElement;
    event.preventDefault();
    dragTo(event, panel);
  });
  document.addEventListener("pointermove", (event) => drag && dragTo(event, drag.panel));
  for (const end of ["pointerup", "pointercancel"]) document.addEventListener(end, () => { drag = null; });
  document.addEventListener("input", (event) => checkBounds(event.target), true);
  document.addEventListener("focusout", (event) => setTimeout(() => checkBounds(event.target)));
  document.addEventListener("keydown", (event) => {
    if (event.target.matches?.("[role=button][aria-expanded]") && [" ", "Enter"].includes(event.key)) {
      event.preventDefault();
      event.target.click();
    }
  });

  let isDue = false;
  const tidy = () => { isDue = false; nameFields(); announce(); drawDots(); open(); };
  document.addEventListener("DOMContentLoaded", () => {
    new MutationObserver(() => {
      if (!isDue) { isDue = true; requestAnimationFrame(tidy); }
    }).observe(first("#root"), { childList: true, subtree: true, characterData: true });
  });
})();
