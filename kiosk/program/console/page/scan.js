// A scan becomes a vessel: it is sent, read by the kiosk's program, and what is in doubt is asked by pictures.
"use strict";

const SVG = "http://www.w3.org/2000/svg";
const drawn = (tag, fields, ...inside) => {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(fields)) element.setAttribute(name, value);
  element.append(...inside);
  return element;
};
const megabytes = (bytes) => (bytes < 1e6 ? t("less than 1 MB") : `${Math.round(bytes / 1e6)} MB`);
let scan = null, scanChosen = null, sending = null;

// ---- Pictures

/** A path of [height, radius] points, from the foot to the rim on the right and back on the left; in mm. */
function outlinePath(points, turned, scale, x, y) {
  const tall = Math.max(...points.map(([height]) => height));
  const at = ([height, radius], side) => `${(x + side * radius * scale).toFixed(1)} ${(y - (turned ? tall - height : height) * scale).toFixed(1)}`;
  return "M" + [...points.map((point) => at(point, 1)), ...points.toReversed().map((point) => at(point, -1))].join("L") + "Z";
}
/** The vessel from the side, its wall cut open where it was read. */
function vesselPicture(vessel, turned, words) {
  const widest = Math.max(...vessel.outer.map(([, radius]) => radius)), scale = 150 / Math.max(vessel.height_m, 2 * widest), draw = drawn("svg", { viewBox: "0 0 170 170", role: "img", "aria-label": words });
  draw.append(drawn("path", { class: "pot", d: outlinePath(vessel.outer, turned, scale, 85, 160) }));
  if (vessel.inner_profile.length > 1) draw.append(drawn("path", { class: "hole", d: outlinePath(vessel.inner_profile.map(([h, r]) => [h, Math.max(r, 0)]), turned, scale, 85, 160) }));
  draw.append(drawn("line", { class: "ground", x1: 5, x2: 165, y1: 161, y2: 161 }));
  return draw;
}
/** A hand of 18 cm, its wrist on the ground at `x`. */
function handPicture(scale, x, y) {
  const mm = (value) => (value * scale).toFixed(1), finger = (left, top, long, wide = 0.018) => drawn("rect", { x: (x + left * scale).toFixed(1), y: (y - top * scale).toFixed(1), width: mm(wide), height: mm(long), rx: mm(wide / 2) });
  const thumb = finger(-0.062, 0.105, 0.07, 0.02);
  thumb.setAttribute("transform", `rotate(-32 ${(x - 0.045 * scale).toFixed(1)} ${(y - 0.05 * scale).toFixed(1)})`);
  return drawn("g", { class: "hand" }, drawn("rect", { x: (x - 0.041 * scale).toFixed(1), y: (y - 0.1 * scale).toFixed(1), width: mm(0.083), height: mm(0.1), rx: mm(0.022) }),
    finger(-0.041, 0.165, 0.09), finger(-0.019, 0.18, 0.1), finger(0.003, 0.172, 0.095), finger(0.025, 0.145, 0.07, 0.016), thumb);
}
/** The vessel `tall` metres high beside a hand. */
function sizePicture(vessel, tall, turned, words) {
  const grown = tall / vessel.height_m, widest = grown * Math.max(...vessel.outer.map(([, radius]) => radius)), room = 0.15;
  const scale = 150 / Math.max(tall, 0.2, 2 * widest + room), draw = drawn("svg", { viewBox: "0 0 240 170", role: "img", "aria-label": words });
  draw.append(drawn("path", { class: "pot", d: outlinePath(vessel.outer.map(([h, r]) => [h * grown, r * grown]), turned, scale, 10 + widest * scale, 160) }),
    handPicture(scale, 10 + 2 * widest * scale + 0.085 * scale, 160), drawn("line", { class: "ground", x1: 5, x2: 235, y1: 161, y2: 161 }));
  return draw;
}

// ---- Sending

/** The files of a drop, with the folders that they lie in. */
async function filesOf(transfer) {
  const out = [], walk = async (entry, path) => {
    if (entry.isFile) return out.push({ file: await new Promise((done, failed) => entry.file(done, failed)), name: path + entry.name });
    const reader = entry.createReader();
    for (;;) {
      const some = await new Promise((done, failed) => reader.readEntries(done, failed));
      if (some.length === 0) return;
      for (const one of some) await walk(one, path + entry.name + "/");
    }
  };
  // All entries are asked for at once: a drop is over after the first wait.
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  for (const entry of entries) await walk(entry, "");
  return out.length > 0 ? out : [...transfer.files].map((file) => ({ file, name: file.name }));
}

/** Sends one file of the scan of that number, and gives the number; fetch tells nothing of how far it is. */
function sendFile({ file, name }, scan, told) {
  return new Promise((done, failed) => {
    const ask = (sending = new XMLHttpRequest());
    ask.open("POST", `/api/upload?name=${encodeURIComponent(name)}&${scan === undefined ? "first=1" : "scan=" + scan}`);
    ask.setRequestHeader("Content-Type", "application/octet-stream");
    ask.upload.addEventListener("progress", ({ loaded }) => told(loaded));
    ask.addEventListener("load", () => {
      let said = {};
      try { said = JSON.parse(ask.responseText); } catch { /* a page of the web server */ }
      ask.status < 300 ? done(said.scan) : failed(refusal({ what: "The file was not taken.", remedy: "Try again.", ...said }, { lost: ask.status === 401, out: ask.status === 401 }));
    });
    ask.addEventListener("error", () => failed(trouble(t("The file did not arrive."), t("Look whether the network is there, and try again."))));
    ask.addEventListener("abort", () => failed(trouble(t("Stopped."), "")));
    ask.send(file);
  });
}

async function sendScan(files) {
  if (sending || files.length === 0) return;
  const all = files.reduce((sum, { file }) => sum + file.size, 0), bar = made("progress", { max: Math.max(all, 1), value: 0 }), words = made("p", {});
  bar.setAttribute("aria-label", t("How much has arrived"));
  const stop = made("button", { type: "button", className: "quiet" }, t("Stop"));
  stop.addEventListener("click", () => sending?.abort());
  try {
    const room = await ask("/api/scan"), large = files.find(({ file }) => file.size > room.most);
    if (large) throw trouble(t("{file} has {size}. The kiosk takes files of at most {most}.", { file: large.name, size: megabytes(large.file.size), most: megabytes(room.most) }),
      t("Export the scan with fewer triangles, or without its largest pictures."));
    // What arrives is unpacked and written once more.
    if (2 * all > room.free) throw trouble(t("This is {size}, and the kiosk’s disk has {left} left.", { size: megabytes(all), left: megabytes(room.free) }), t("Ask whoever keeps the machine for room."));
    $("scan-body").replaceChildren(words, bar, made("div", { className: "actions" }, stop));
    let before = 0, number; // of the scan, once its first file is there
    for (const [n, one] of files.entries()) {
      const told = (loaded) => {
        bar.value = before + loaded;
        const how = { name: one.name, n: n + 1, count: files.length, sent: megabytes(before + loaded), all: megabytes(all) };
        words.textContent = files.length > 1 ? t("Sending file {n} of {count}: {sent} of {all}", how) : t("Sending {name}: {sent} of {all}", how);
      };
      told(0);
      number = await sendFile(one, number, told);
      before += one.file.size;
    }
    await ask("/api/scan/look", { scan: number });
    sending = null;
    scanChosen = null;
    showScan();
  } catch (error) {
    tell($("scan-body"), error);
  } finally {
    sending = null;
  }
}

// ---- Asking

/** Shows what became of the scan, and asks again while the kiosk's program works on it. */
async function showScan() {
  for (let seconds = 0; !sending; ++seconds) {
    try {
      scan = await ask("/api/scan");
    } catch (error) {
      return tell($("scan-body"), error);
    }
    if (sending) return;
    if (scan.doing) {
      const words = scan.doing === "looking" ? t("Reading the scan…") : t("Putting it on the shelf…");
      $("scan-body").replaceChildren(made("p", {}, words + since(seconds)));
      await new Promise((done) => setTimeout(done, 1000));
      continue;
    }
    if (scan.placed?.done) return onShelf(scan.id);
    if (scan.placed) {
      drawQuestions();
      return tell($("scan-wrong"), refusal(scan.placed));
    }
    if (!scan.found) return $("scan-body").replaceChildren();
    $("scan").open = true; // one that was begun
    if (!scan.found.done) return tell($("scan-body"), refusal(scan.found));
    return drawQuestions();
  }
}
/** It is there: its label comes next. */
async function onShelf(id) {
  $("scan-body").replaceChildren(made("p", {}, made("strong", {}, t("It is on the shelf.")), " ", t("Visitors see it when its label is written and “Unfinished” is not ticked any more.")));
  scanChosen = null;
  await ask("/api/scan/forget", { scan: scan.scan }).catch(() => {});
  await showShelf();
  const vessel = vessels.find((one) => one.id === id);
  if (vessel) openLabel(vessel);
}

/** Pictures to choose from; `chosen` is the one that is. */
function pictures(title, help, name, options, chosen, choose) {
  const group = made("fieldset", { className: "choice" }, made("legend", {}, title), made("p", { className: "small" }, help));
  const list = made("div", { className: "choices" });
  options.forEach(({ value, picture, words }, n) => {
    const radio = made("input", { type: "radio", name: "scan-" + name, id: `scan-${name}-${n}`, checked: value === chosen });
    radio.addEventListener("change", () => choose(value));
    list.append(made("label", { htmlFor: radio.id, className: "option" }, picture, made("span", {}, radio, words)));
  });
  group.append(list);
  return group;
}
const mm = (metres) => (metres >= 1 ? `${(metres).toFixed(2).replace(/\.?0+$/, "")} m` : metres >= 0.1 ? `${(100 * metres).toFixed(0)} cm` : `${(100 * metres).toFixed(1).replace(/\.0$/, "")} cm`);
const asId = (words) => words.toLowerCase().replace(/\.[a-z]+$/, "").replace(/[^a-z0-9]+/g, "_").replace(/^_+|_+$/g, "").slice(0, 60) || "vessel";

function drawQuestions() {
  const found = scan.found.vessels, single = found.length === 1;
  scanChosen ??= {};
  if (scanChosen.of !== scan.found && !scan.placed) Object.assign(scanChosen, { vessel: single ? 0 : undefined, turned: undefined, tall: undefined, id: undefined });
  scanChosen.of = scan.found;
  const parts = [made("p", {}, made("strong", { dir: "auto" }, scan.name), scan.files > 1 ? " " + tn(scan.files - 1, "and one more file", "and {count} more files") : "")], again = (change) => {
    Object.assign(scanChosen, change);
    const focused = document.activeElement?.id;
    drawQuestions();
    if (focused) $(focused)?.focus();
  };
  if (!single) {
    parts.push(pictures(t("Which of these?"), t("The scan holds several vessels. For another one of them, send it again."), "which",
      found.map((vessel, n) => ({ value: n, picture: vesselPicture(vessel, false, vessel.title), words: vessel.title })), scanChosen.vessel,
      (vessel) => {
        again({ vessel, turned: undefined, tall: undefined, id: undefined });
        document.querySelectorAll("#scan-body .choice")[1]?.scrollIntoView({ block: "start", behavior: "smooth" });
      }));
  }
  const vessel = found[scanChosen.vessel];
  if (vessel) {
    if (scanChosen.turned === undefined && vessel.up_is_sure) scanChosen.turned = false;
    if (!vessel.up_is_sure) {
      parts.push(pictures(t("Which way up?"), t("The shape alone does not tell."), "up", [false, true].map((value) => {
        const words = value ? t("The other way") : t("As in the file");
        return { value, picture: vesselPicture(vessel, value, words), words };
      }),
        scanChosen.turned, (turned) => again({ turned })));
    }
    parts.push(sizeQuestion(vessel, again), insideWords(vessel), placeForm(vessel));
  }
  const notes = (scan.found.notes ?? []).map((note) => made("p", { className: "small" }, note));
  const other = made("button", { type: "button", className: "quiet" }, t("Forget this scan"));
  other.addEventListener("click", async () => {
    await ask("/api/scan/forget", { scan: scan.scan }).catch(() => {});
    scanChosen = null;
    showScan();
  });
  $("scan-body").replaceChildren(...parts, ...notes, made("p", { id: "scan-wrong", className: "fault" }), made("div", { className: "actions" }, other));
  ready();
}
/** How tall it is, beside a hand. */
function sizeQuestion(vessel, again) {
  const raw = vessel.height_m / vessel.metres_per_unit, turned = scanChosen.turned === true;
  const units = vessel.size_is_sure ? [vessel.height_m] : [raw, raw / 100, raw / 1000].filter((tall) => tall >= 0.01 && tall <= 2);
  const options = units.map((tall) => ({ value: tall, picture: sizePicture(vessel, tall, turned, mm(tall)), words: t("{height} tall", { height: mm(tall) }) }));
  if (scanChosen.tall === undefined && vessel.size_is_sure) scanChosen.tall = units[0];
  const own = made("input", { id: "scan-tall", inputMode: "decimal", autocomplete: "off", placeholder: Math.round(1000 * vessel.height_m),
    value: scanChosen.tall !== undefined && !units.includes(scanChosen.tall) ? Math.round(1e5 * scanChosen.tall) / 100 : "" });
  own.addEventListener("change", () => {
    const typed_ = own.value.trim().match(/^(\d+(?:[.,]\d+)?)\s*(mm|cm|m)?$/i);
    if (own.value.trim() === "") return again({ tall: vessel.size_is_sure ? units[0] : undefined });
    if (!typed_) return tell($("scan-wrong"), trouble(t("This is no height."), t("Write a number of millimetres: 240.")));
    again({ tall: Number(typed_[1].replace(",", ".")) * { mm: 0.001, cm: 0.01, m: 1 }[(typed_[2] ?? "mm").toLowerCase()] });
  });
  if (scanChosen.tall !== undefined && !units.includes(scanChosen.tall) && scanChosen.tall >= 0.004 && scanChosen.tall <= 2)
    options.push({ value: scanChosen.tall, picture: sizePicture(vessel, scanChosen.tall, turned, mm(scanChosen.tall)), words: t("{height} tall", { height: mm(scanChosen.tall) }) });
  const group = pictures(vessel.size_is_sure ? t("How tall it is") : t("How tall is it?"), vessel.size_is_sure ? t("Beside a hand.") : t("The file does not say in which unit it is."), "size", options, scanChosen.tall, (tall) => again({ tall }));
  group.append(made("div", { className: "field" }, made("label", { htmlFor: own.id }, t("Another height")), made("div", { className: "value" }, own, made("span", { className: "unit" }, "mm"))));
  return group;
}
function insideWords(vessel) {
  const wall = `${(1000 * vessel.inferred_wall_m).toFixed(1)} mm`, seen = vessel.inner === "measured";
  return made("p", {}, made("strong", {}, seen ? t("The inside was measured.") : t("The inside was not seen.")), " ",
    !seen ? t("Its wall is taken as {wall}, and visitors throw it so.", { wall }) : vessel.inner_measured_share >= 0.99 ? ""
      : t("On {percent} % of the height both sides of the wall were there; the rest is inferred.", { percent: Math.round(100 * vessel.inner_measured_share) }));
}
function placeForm(vessel) {
  const name = scan.found.vessels.length === 1 ? scan.name.split("/")[0] : vessel.title;
  const id = made("input", { id: "scan-id", autocomplete: "off", maxLength: 80, value: scanChosen.id ?? asId(name) }), go = made("button", { type: "button", id: "scan-go" }, t("Put it on the shelf"));
  id.addEventListener("input", () => { scanChosen.id = id.value; ready(); });
  go.addEventListener("click", async () => {
    try {
      go.disabled = true;
      await ask("/api/scan/place", { scan: scan.scan, vessel: scanChosen.vessel, id: id.value.trim(), turned_over: scanChosen.turned === true,
        height_mm: Math.round(1e5 * scanChosen.tall) / 100 });
      showScan();
    } catch (error) {
      if (error.status === 412) {
        scanChosen = null;
        await showScan();
      } else go.disabled = false;
      tell($("scan-wrong") ?? $("scan-body"), error);
    }
  });
  return made("div", { className: "field" }, made("label", { htmlFor: id.id }, t("Its name in files; visitors do not see it")), made("div", { className: "value" }, id, go),
    made("p", { className: "small", id: "scan-need" }), made("p", { className: "small" }, [vessel.credit, vessel.licence].filter(Boolean).join(". ") || t("The file names neither credit nor licence: the label will ask for them.")));
}
/** The button works when everything is chosen. */
function ready() {
  const go = $("scan-go");
  if (!go) return;
  const need = scanChosen.turned === undefined ? t("Choose which way up it stands.") : !(scanChosen.tall >= 0.004 && scanChosen.tall <= 2) ? t("Choose how tall it is: 4 mm to 2 m.")
    : !/^[a-z0-9_-]+$/.test($("scan-id").value.trim()) ? t("Its name has small Latin letters, digits, _ and -.") : vessels.some(({ id }) => id === $("scan-id").value.trim()) ? t("There is a vessel of that name.") : "";
  go.disabled = need !== "";
  $("scan-need").textContent = need;
}

addEventListener("beforeunload", (event) => { if (sending) event.preventDefault(); });
const drop = $("scan-drop");
for (const name of ["dragenter", "dragover"]) drop.addEventListener(name, (event) => { event.preventDefault(); drop.classList.add("over"); });
for (const name of ["dragleave", "drop"]) drop.addEventListener(name, () => drop.classList.remove("over"));
drop.addEventListener("drop", async (event) => {
  event.preventDefault();
  sendScan(await filesOf(event.dataTransfer));
});
$("scan-files").addEventListener("change", () => {
  sendScan([...$("scan-files").files].map((file) => ({ file, name: file.webkitRelativePath || file.name })));
  $("scan-files").value = "";
});
