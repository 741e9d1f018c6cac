"use strict";
// The report's behaviour. The table stands in the page already; pictures lie in it as base64 text and are decoded
// when their pair is chosen.
(() => {
  const pairs = JSON.parse(document.getElementById("data").textContent);
  const one = (selector) => document.querySelector(selector);
  const all = (selector) => [...document.querySelectorAll(selector)];
  const kKinds = ["expected", "actual", "difference", "flip"];
  const kLensPixels = 11;  // A side, around the one looked at; odd, so that it is in the middle.
  const rows = all("tr[data-pair]");
  const stage = one(".stage"), scroller = one(".scroller"), gallery = one(".gallery"), handle = one(".handle");

  let pair = null;      // The one shown.
  let pictures = {};    // Of the pair, by kind: bitmaps.
  let mode = "all";
  let zoom = 0;         // Screen pixels for one of the picture; 0 fits.
  let split = 0.5;
  let side = "expected";  // Of blinking.
  let blinker = 0;
  let spot = {x: 0, y: 0};

  // ---- pictures

  function bytesOf(id) {
    const text = atob(document.getElementById(id).textContent);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return bytes;
  }

  async function decode(chosen) {
    const decoded = {};
    for (const kind of kKinds) {
      if (!chosen.pictures[kind]) continue;
      decoded[kind] = await createImageBitmap(new Blob([bytesOf(chosen.pictures[kind])], {type: "image/png"}));
    }
    return decoded;
  }

  function release() {
    Object.values(pictures).forEach((picture) => picture.close());
    pictures = {};
  }

  /// A picture as an element: at its own size, to be scaled by style.
  function canvasOf(kind) {
    const canvas = document.createElement("canvas");
    canvas.width = pictures[kind].width;
    canvas.height = pictures[kind].height;
    canvas.getContext("2d").drawImage(pictures[kind], 0, 0);
    canvas.className = "layer backed";
    canvas.dataset.kind = kind;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${captions()[kind]}: ${pair.name}`);
    return canvas;
  }

  function pixelOf(kind, x, y) {
    const picture = pictures[kind];
    if (!picture || x >= picture.width || y >= picture.height) return null;
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 1;
    const context = canvas.getContext("2d", {willReadFrequently: true});
    context.drawImage(picture, -x, -y);
    return [...context.getImageData(0, 0, 1, 1).data];
  }

  // ---- choosing a pair

  async function choose(index, focus) {
    const chosen = pairs[index];
    if (!chosen || chosen === pair) return;
    pair = chosen;
    rows.forEach((row) => {
      const selected = Number(row.dataset.pair) === index;
      row.setAttribute("aria-selected", selected);
      row.tabIndex = selected ? 0 : -1;
      if (selected && focus) row.focus();
      if (selected) row.scrollIntoView({block: "nearest"});
    });
    history.replaceState(null, "", "#" + encodeURIComponent(chosen.name));
    const decoded = await decode(chosen);
    if (pair !== chosen) return;  // Another was chosen meanwhile.
    release();
    pictures = decoded;
    spot = chosen.worst ? {x: chosen.worst.x, y: chosen.worst.y} : {x: 0, y: 0};
    split = 0.5;
    side = "expected";
    showPair();
  }

  function showPair() {
    one("#name").textContent = pair.name;
    one("#facts").textContent = pair.facts;
    one(".note").textContent = pair.note;
    one(".note").hidden = !pair.note;
    const any = Object.keys(pictures).length > 0;
    const both = pictures.expected && pictures.actual;
    one(".bar.tools").hidden = one(".work").hidden = !any;
    one(".empty").hidden = any;
    one(".empty").textContent = pair.outcome === "error" ? "No picture to show." :
        "Nothing differs; pictures that are the same are not kept in the report.";
    all("button[data-mode]").forEach((button) => {
      const kind = button.dataset.mode;
      button.hidden = kKinds.includes(kind) ? !pictures[kind] : kind !== "all" && !both;
    });
    const figures = one(".figures");
    figures.replaceChildren();
    for (const [term, value] of pair.figures) {
      figures.append(Object.assign(document.createElement("dt"), {textContent: term}),
                     Object.assign(document.createElement("dd"), {textContent: value}));
    }
    buildPictures();
    const button = one(`button[data-mode="${mode}"]`);
    setMode(button && !button.hidden ? mode : "all");
  }

  const size = () => ({
    width: Math.max(1, ...Object.values(pictures).map((picture) => picture.width)),
    height: Math.max(1, ...Object.values(pictures).map((picture) => picture.height)),
  });

  const captions = () => ({
    expected: "expected", actual: "actual", difference: `difference × ${pair.amplification}`,
    flip: "FLIP: what a person sees of it",
  });

  /// The elements of all pictures: in the gallery each in its frame, on the stage on each other.
  function buildPictures() {
    gallery.replaceChildren();
    all(".stage canvas").forEach((canvas) => canvas.remove());
    const whole = size();
    for (const kind of kKinds.filter((k) => pictures[k])) {
      const figure = document.createElement("figure");
      const frame = Object.assign(document.createElement("div"), {className: "frame"});
      const caption = Object.assign(document.createElement("figcaption"), {textContent: captions()[kind]});
      const canvas = canvasOf(kind);
      canvas.style.width = `${100 * canvas.width / whole.width}%`;
      canvas.style.height = `${100 * canvas.height / whole.height}%`;
      if (kind === "flip") caption.append(Object.assign(document.createElement("span"), {className: "scale"}));
      frame.append(canvas, Object.assign(document.createElement("div"), {className: "marker"}));
      frame.addEventListener("pointermove", (event) => pointAt(event, frame));
      figure.append(caption, frame);
      gallery.append(figure);
      stage.prepend(canvasOf(kind));  // Expected comes to lie on actual.
    }
    stage.prepend(...["actual", "expected"].flatMap((k) => all(`.stage canvas[data-kind="${k}"]`)));
  }

  // ---- how it is shown

  function setMode(next) {
    mode = next;
    all("button[data-mode]").forEach((b) => b.setAttribute("aria-pressed", b.dataset.mode === mode));
    gallery.hidden = mode !== "all";
    stage.hidden = mode === "all";
    one(".zoom").hidden = mode === "all";
    one(".blinking").hidden = mode !== "blink";
    if (mode !== "blink") stopBlinking();
    draw();
  }

  function visibleKinds() {
    if (mode === "slider") return ["actual", "expected"];
    return mode === "blink" ? [side] : [mode];
  }

  /// Whole pixels where there is room for them.
  const snapped = (factor) => factor >= 1 ? Math.floor(factor) : factor;

  function scale() {
    if (zoom > 0) return zoom;
    const whole = size();
    return snapped(Math.min((scroller.clientWidth - 32) / whole.width, (scroller.clientHeight - 32) / whole.height));
  }

  /// As many columns as make the pictures largest.
  function layGallery() {
    const whole = size(), count = gallery.children.length, gap = 14, captionHeight = 24;
    const width = scroller.clientWidth - 32, height = scroller.clientHeight - 32;
    let best = 0, columns = 1;
    for (let tried = 1; tried <= count; ++tried) {
      const lines = Math.ceil(count / tried);
      const factor = Math.min((width - gap * (tried - 1)) / tried / whole.width,
                              ((height - gap * (lines - 1)) / lines - captionHeight) / whole.height);
      if (factor > best) [best, columns] = [factor, tried];
    }
    best = snapped(Math.max(best, 120 / whole.width));
    gallery.classList.toggle("shrunk", best < 1);
    gallery.style.gridTemplateColumns = `repeat(${columns}, ${whole.width * best}px)`;
    all(".frame").forEach((frame) => { frame.style.height = `${whole.height * best}px`; });
  }

  /// Lays out what is shown: layers, handle, labels, marker.
  function draw() {
    if (mode === "all") layGallery();
    const whole = size(), factor = scale();
    stage.style.width = `${whole.width * factor}px`;
    stage.style.height = `${whole.height * factor}px`;
    stage.classList.toggle("shrunk", factor < 1);
    one("#zoom").textContent = `${Math.round(factor * 100)} %`;
    all(".stage canvas").forEach((canvas) => layLayer(canvas, factor));
    handle.hidden = mode !== "slider";
    handle.style.left = `${split * 100}%`;
    handle.setAttribute("aria-valuenow", Math.round(split * 100));
    one(".stage > .tags").hidden = mode === "slider";
    one("#shown").textContent = captions()[visibleKinds()[0]];
    drawMarkers();
    drawLens();
  }

  function layLayer(canvas, factor) {
    const kind = canvas.dataset.kind;
    canvas.hidden = !visibleKinds().includes(kind);
    canvas.style.width = `${canvas.width * factor}px`;
    canvas.style.height = `${canvas.height * factor}px`;
    const hidden = (canvas.width - size().width * split) * factor;
    canvas.style.clipPath = mode === "slider" && kind === "expected" ? `inset(0 ${Math.max(0, hidden)}px 0 0)` : "";
  }

  function setSplit(value) {
    split = Math.min(1, Math.max(0, value));
    draw();
  }

  function swapSides() {
    side = side === "expected" ? "actual" : "expected";
    draw();
  }

  function stopBlinking() {
    clearInterval(blinker);
    blinker = 0;
    one("#auto").setAttribute("aria-pressed", "false");
  }

  function toggleBlinking() {
    if (blinker) return stopBlinking();
    blinker = setInterval(swapSides, 500);
    one("#auto").setAttribute("aria-pressed", "true");
  }

  function setZoom(next) {
    zoom = next;
    draw();
    if (zoom > 0) showSpot();
  }

  function zoomBy(direction) {
    const steps = [0.125, 0.25, 0.5, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32];
    const now = scale();
    const next = direction > 0 ? steps.find((s) => s > now * 1.001) : steps.filter((s) => s < now * 0.999).pop();
    if (next) setZoom(next);
  }

  function showSpot() {
    const factor = scale();
    scroller.scrollTo(stage.offsetLeft + spot.x * factor - scroller.clientWidth / 2,
                      stage.offsetTop + spot.y * factor - scroller.clientHeight / 2);
  }

  // ---- the lens

  function drawMarkers() {
    const whole = size();
    for (const marker of all(".marker")) {
      // At least so large that it can be seen; the pixel is its middle.
      const box = marker.parentElement, pixel = box.clientWidth / whole.width, edge = Math.max(pixel, 7);
      marker.style.width = marker.style.height = `${edge}px`;
      marker.style.left = `${(spot.x + 0.5) * pixel - edge / 2}px`;
      marker.style.top = `${(spot.y + 0.5) * pixel - edge / 2}px`;
    }
  }

  function drawLens() {
    one("#spot").textContent = `(${spot.x}, ${spot.y})`;
    for (const kind of kKinds) {
      const figure = one(`.lens figure[data-kind="${kind}"]`);
      const picture = pictures[kind];
      figure.hidden = !picture;
      if (!picture) continue;
      figure.querySelector("figcaption").textContent = captions()[kind].split(":")[0];
      const canvas = figure.querySelector("canvas"), pixel = 10, reach = (kLensPixels - 1) / 2;
      canvas.width = canvas.height = kLensPixels * pixel;
      const context = canvas.getContext("2d");
      context.imageSmoothingEnabled = false;
      context.drawImage(picture, spot.x - reach, spot.y - reach, kLensPixels, kLensPixels, 0, 0, canvas.width, canvas.height);
      context.lineWidth = 1;
      const x = reach * pixel, y = reach * pixel;
      context.strokeStyle = "#000";
      context.strokeRect(x - 1.5, y - 1.5, pixel + 3, pixel + 3);
      context.strokeStyle = "#fff";
      context.strokeRect(x - 0.5, y - 0.5, pixel + 1, pixel + 1);
    }
    drawValues();
  }

  function drawValues() {
    const worst = pair.worst && pair.worst.x === spot.x && pair.worst.y === spot.y;
    const shown = (kind) => pixelOf(kind, spot.x, spot.y);
    const exact = worst && pair.worst.exact ? pair.worst : null;
    one("#which").textContent = worst ? "the greatest difference" : "";
    for (const kind of ["expected", "actual"]) {
      const cells = one(`.values tr[data-kind="${kind}"]`).querySelectorAll("td");
      const bytes = shown(kind);
      cells.forEach((cell, c) => { cell.textContent = bytes ? bytes[c] : "–"; });
    }
    one("#exact").textContent = exact ? `${exact.expected}\nagainst\n${exact.actual}` : "";
  }

  function moveTo(x, y) {
    const whole = size();
    spot = {x: Math.min(whole.width - 1, Math.max(0, x)), y: Math.min(whole.height - 1, Math.max(0, y))};
    drawMarkers();
    drawLens();
  }

  function pointAt(event, box) {
    const bounds = box.getBoundingClientRect(), whole = size();
    moveTo(Math.floor((event.clientX - bounds.left) / bounds.width * whole.width),
           Math.floor((event.clientY - bounds.top) / bounds.height * whole.height));
  }

  function goToWorst() {
    if (!pair || !pair.worst) return;
    moveTo(pair.worst.x, pair.worst.y);
    split = (spot.x + 0.5) / size().width;
    if (mode !== "all") {
      setZoom(Math.max(8, scale()));
    }
  }

  // ---- what people do

  handle.addEventListener("pointerdown", (event) => handle.setPointerCapture(event.pointerId));
  handle.addEventListener("pointermove", (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const bounds = stage.getBoundingClientRect();
    setSplit((event.clientX - bounds.left) / bounds.width);
  });
  stage.addEventListener("pointermove", (event) => event.buttons || pointAt(event, stage));
  rows.forEach((row) => row.addEventListener("click", () => choose(Number(row.dataset.pair))));
  all("button[data-mode]").forEach((b) => b.addEventListener("click", () => setMode(b.dataset.mode)));
  one("#swap").addEventListener("click", swapSides);
  one("#auto").addEventListener("click", toggleBlinking);
  one("#fit").addEventListener("click", () => setZoom(0));
  one("#in").addEventListener("click", () => zoomBy(1));
  one("#out").addEventListener("click", () => zoomBy(-1));
  one("#worst").addEventListener("click", goToWorst);
  new ResizeObserver(() => pair && draw()).observe(scroller);

  const shownRows = () => rows.filter((row) => !row.hidden);
  function step(direction) {
    const visible = shownRows();
    const index = visible.findIndex((row) => row.getAttribute("aria-selected") === "true");
    const next = visible[Math.min(visible.length - 1, Math.max(0, index + direction))];
    if (next) choose(Number(next.dataset.pair), true);
  }

  const kModes = ["all", "slider", "blink", "difference", "flip"];
  const keys = {
    j: () => step(1), k: () => step(-1),
    b: () => { mode === "blink" ? swapSides() : pictures.expected && pictures.actual && setMode("blink"); },
    a: () => mode === "blink" && toggleBlinking(),
    w: goToWorst, "+": () => zoomBy(1), "=": () => zoomBy(1), "-": () => zoomBy(-1), 0: () => setZoom(0),
  };
  kModes.forEach((name, i) => {
    keys[i + 1] = () => { if (!one(`button[data-mode="${name}"]`).hidden) setMode(name); };
  });

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "INPUT") return;
    const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (arrow && event.target === handle) {
      setSplit(split + (arrow[0] - arrow[1]) * (event.shiftKey ? 0.1 : 0.01));
    } else if (arrow && event.target.matches("tr[data-pair]")) {
      if (arrow[1]) step(arrow[1]);
    } else if (arrow && pair) {
      moveTo(spot.x + arrow[0] * (event.shiftKey ? 10 : 1), spot.y + arrow[1] * (event.shiftKey ? 10 : 1));
    } else if (event.key === " " && mode === "blink" && event.target.tagName !== "BUTTON") {
      swapSides();
    } else if (keys[event.key]) {
      keys[event.key]();
    } else {
      return;
    }
    event.preventDefault();
  });

  function filter() {
    const text = one("#search").value.toLowerCase();
    const wanted = new Set(all(".filters button[aria-pressed='true']").map((b) => b.dataset.outcome));
    for (const row of rows) {
      const {name, outcome} = pairs[Number(row.dataset.pair)];
      row.hidden = (wanted.size > 0 && !wanted.has(outcome)) || !name.toLowerCase().includes(text);
    }
  }
  one("#search").addEventListener("input", filter);
  all(".filters button").forEach((button) => button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", button.getAttribute("aria-pressed") !== "true");
    filter();
  }));

  // A link to a pair ends in "#" and its name.
  const first = Math.max(0, pairs.findIndex(({name}) => "#" + encodeURIComponent(name) === location.hash || "#" + name === location.hash));
  choose(first);
})();
