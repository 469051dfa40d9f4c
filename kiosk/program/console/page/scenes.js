// Scenes: how the clay behaves, effect by effect, and what each costs on this machine.
"use strict";

const EFFECTS = {
  moisture: t("Water"), walls: t("Walls"), propagation: t("Neighbours follow"), springback: t("Springback"), smoothing: t("Smoothing"), wobble: t("Off centre"),
  slump: t("Slumping"), volume: t("No clay is lost"), building: t("Built of coils"), beating: t("Paddle and anvil"), prints: t("The paddle’s prints"),
  friction: t("Friction"), kiln: t("Kiln"),
};
const SCENE_LABELS = {
  "clay.rows": t("Rows, over the height"), "clay.sectors": t("Sectors, round the axis"), "clay.height": t("Height of the lump"), "clay.outer_radius": t("Radius of the lump"),
  "clay.inner_radius": t("Radius of its hole"), "clay.floor_thickness": t("Its floor"), "clay.floor_min": t("Thinnest floor"), "clay.wall_min": t("Thinnest wall"),
  "clay.radius_min": t("Narrowest hole"), "clay.radius_max": t("Widest pot"), "clay.keep_undo": t("Strokes can be taken back"), "tool.to_hand": t("Tools beside the wheel"),
  "tool.radius": t("Radius of a fingertip"), "contact.stiffness": t("Push of the clay"), "wheel.max_speed": t("Fastest turn of the wheel"), quality: t("The grid"),
};
const SCENE_TABLES = [[t("The lump"), ["clay"]], [t("Touch"), ["contact", "tool"]], [t("The wheel"), ["wheel"]],
  [t("Sizes of the tools"), ["fingertip", "flat_rib", "curved_rib", "needle", "loop_trimmer", "sponge", "wire", "palm"]]];
const sceneName = (file) => t(asLabel(file.replace(/^scenes\//, "").replace(/\.toml$/, "")));

let scenes = [], sceneEdit = null, sceneOpen = null, scenePrices = null;
const sceneChoice = new Edited("exhibit", $("scenes-words"), [$("scenes-save"), $("scenes-forget")], drawScenes);
edits.push(sceneChoice);

function drawScenes() {
  $("scenes-list").replaceChildren(...scenes.map((scene) => {
    const open = made("button", { type: "button", className: "quiet" }, t("Open"));
    open.setAttribute("aria-label", t("Open") + ": " + sceneName(scene.name));
    open.addEventListener("click", () => openScene(scene));
    const who = [scene.thrown && t("Visitors throw with it."), scene.built && t("Visitors build with it."),
      scene.vessels.length > 0 && t("Of its own for {vessels}.", { vessels: listed(scene.vessels) })].filter(Boolean).join(" ");
    const item = made("li", {}, made("div", { className: "title" }, made("h3", {}, sceneName(scene.name)), made("p", {}, quoted(scene.words)),
      made("p", { className: "small" }, listed(scene.effects.map((effect) => EFFECTS[effect] ?? effect)) || t("No effects.")),
      ...[who, scene.tick_us === undefined ? "" : tickWords(scene.tick_us)].filter(Boolean).map((words) => made("p", {}, made("strong", {}, words)))), open);
    item.dataset.id = scene.name;
    return item;
  }));
  const choose = (key, label, help) => {
    const field = sceneChoice.fields.find((one) => one.table === "" && one.key === key);
    return fieldRow(sceneChoice, key, field, { label, help, called: sceneName });
  };
  $("scenes-choice").replaceChildren(choose("scene", t("Visitors throw with"), t("How the clay behaves on the wheel.")),
    choose("built_scene", t("Visitors build with"), t("For vessels that were built of coils.")));
}

async function showScenes() {
  if (sceneEdit || (sceneChoice.file && sceneChoice.dirty)) return;
  try {
    scenes = await reading($("scenes-words"), ask("/api/scenes"));
    await sceneChoice.load();
    showTicks(scenes);
  } catch (error) {
    tell($("scenes-words"), error);
  }
}
/** Asks what each scene costs, so that what is not known is measured, one after the other. */
async function showTicks(shown) {
  for (const scene of shown.filter(({ tick_us }) => tick_us === undefined)) {
    for (;;) {
      if (sceneEdit || shown !== scenes || part() !== "scenes") return;
      const now = await ask("/api/prices/" + encodeURIComponent(scene.name)).catch(() => ({}));
      if (now.prices) {
        scene.tick_us = now.prices.whole_us;
        if (!sceneChoice.dirty && shown === scenes) sceneChoice.redraw();
      }
      if (!now.measuring) break;
      await new Promise((done) => setTimeout(done, 1000));
    }
  }
}
$("scenes-form").addEventListener("submit", async (event) => { event.preventDefault(); await sceneChoice.save(wantsTrial(event)); showScenes(); });
$("scenes-forget").addEventListener("click", () => sceneChoice.forget());

// ---- One scene

async function openScene(scene) {
  if (sceneEdit) return; // a second click
  const edit = new Edited("scene/" + scene.name, $("scene-words"), [$("scene-save"), $("scene-forget")], drawScene);
  sceneEdit = edit;
  sceneOpen = scene;
  scenePrices = null;
  $("scene-title").textContent = sceneName(scene.name);
  $("scene-about").replaceChildren(quoted(scene.words));
  edit.say("");
  try {
    await edit.load();
    edits.push(edit);
    $("scenes-form").hidden = true;
    $("scene").hidden = false;
    $("scene-title").focus();
    scrollTo(0, 0);
    showPrices();
  } catch (error) {
    sceneEdit = null;
    tell($("scenes-words"), error);
  }
}

/** What it costs, asked again until it is measured. */
async function showPrices() {
  const edit = sceneEdit;
  for (let seconds = 0; edit && edit === sceneEdit; ++seconds) {
    try {
      const now = await ask("/api/prices/" + encodeURIComponent(sceneOpen.name));
      if (edit !== sceneEdit) return;
      if (now.prices || !scenePrices?.prices) scenePrices = now;
      scenePrices.measuring = now.measuring;
      scenePrices.seconds = seconds;
      drawPrices(edit);
      if (!now.measuring) return;
    } catch (error) {
      return tell($("scene-time"), error);
    }
    await new Promise((done) => setTimeout(done, 1000));
  }
}

const us = (value) => value.toFixed(value < 10 ? 1 : 0).replace(/\.0$/, "") + " µs";
const tickWords = (value) => t("A tick takes {time} here, of 1,000.", { time: us(value) });
const inScene = (edit, effect) => edit.now(effect) !== undefined;
/** Of a price that is within what the machine's other work does to a measurement. */
const isSmall = (price, whole) => price < Math.max(0.3, 0.02 * whole);

function priceOf(effect) {
  const of = ({ effect: name, part_of }) => name === effect && part_of === "";
  return scenePrices?.prices?.effects.find(of) ?? scenePrices?.prices?.offers?.find(of);
}
function priceWords(edit, effect) {
  const price = priceOf(effect), whole = scenePrices?.prices?.whole_us;
  if (effect === "kiln") return t("It costs nothing at the wheel: it works after the visit’s last stroke.");
  if (!price) return "";
  const there = edit.was(effect) !== undefined;
  const time = us(price.us), shape = price.shape_mm_rms >= 0.0005, force = price.force_n_rms >= 0.0005;
  const cost = isSmall(price.us, whole) ? (there ? t("Costs hardly any time.") : t("Would cost hardly any time."))
    : there ? t("Costs {time} a tick.", { time }) : t("Would cost about {time} a tick.", { time });
  const by = { mm: price.shape_mm_rms.toPrecision(2), newtons: price.force_n_rms.toPrecision(2) };
  return cost + " " + (shape && force ? t("It changes the test’s pot by {mm} mm and the hand’s force by {newtons} N.", by)
    : shape ? t("It changes the test’s pot by {mm} mm.", by) : force ? t("It changes the hand’s force by {newtons} N.", by) : t("It changes nothing in the test."));
}

/** The words and bars of prices, in a form that is drawn. */
function drawPrices(edit) {
  const prices = scenePrices?.prices, again = $("scene-measure");
  again.disabled = scenePrices?.measuring === true;
  const lines = [];
  if (prices) {
    const more = Object.keys(EFFECTS).reduce((sum, effect) => {
      const price = Math.max(0, priceOf(effect)?.us ?? 0);
      return sum + (inScene(edit, effect) ? 1 : 0) * price - (edit.was(effect) !== undefined ? 1 : 0) * price;
    }, 0);
    const whole = prices.whole_us, most = 1000 * scenePrices.budget, times = most / (whole + more);
    const anew = ["quality", "clay.rows", "clay.sectors"].some((key) => edit.changes.has(key)) ? " " + t("Another grid is measured when it is saved.") : "";
    lines.push(made("p", {}, made("strong", {}, (scenePrices.measuring ? t("Before the last change:") + " " : "") + tickWords(whole)), anew,
      Math.abs(more) > 0.05 ? " " + t("With your changes about {time}.", { time: us(Math.max(whole + more, prices.contact_us)) }) : "",
      times < 1 ? "" : " " + (times >= 2 ? t("The clay may take {most} µs: it fits {times} times over.", { most, times: Math.floor(times) }) : t("The clay may take {most} µs: it fits well enough.", { most }))));
    if (times < 1) lines.push(made("p", { className: "fault" }, made("strong", {}, t("This is too much for this machine.")), " ", t("The clay may take {most} µs. Take an effect out, or choose a coarser grid.", { most })));
    lines.push(made("p", { className: "small" }, [t("On {rows} × {sectors} rows and sectors, with both hands at a wall; {machine}.", prices),
      t("A tick is a thousandth of a second: so often the clay moves, and a hand device is told its force. µs: a millionth of a second. The test below: a finger, both hands and a palm at a wall of 1 cm. Effects share work, so that their prices do not add up. Each bar is its share of the dearest."),
      !prices.times_hold && t("Something else kept the machine busy: measure again when it is quiet.")].filter(Boolean).join(" ")));
  }
  if (scenePrices?.grid) lines.push(made("p", { className: "small" }, t("What the machine chose:"), " ", quoted(scenePrices.grid)));
  if (scenePrices?.measuring) lines.push(made("p", {}, t("Measuring what it costs, while nothing else wants the machine…") + since(scenePrices.seconds)));
  if (scenePrices?.trouble) lines.push(made("p", { className: "fault" }, quoted(scenePrices.trouble)));
  $("scene-time").replaceChildren(...lines);
  const dearest = Math.max(...Object.keys(EFFECTS).map((effect) => priceOf(effect)?.us ?? 0), 1);
  for (const item of document.querySelectorAll("#scene-effects .effect")) {
    const effect = item.dataset.id, price = priceOf(effect);
    item.querySelector(".cost").textContent = priceWords(edit, effect);
    item.querySelector(".price span").style.width = `${Math.max(0, (100 * (price?.us ?? 0)) / dearest)}%`;
    item.querySelector(".price").hidden = !price;
  }
}
$("scene-measure").addEventListener("click", async () => {
  try {
    await ask("/api/prices/" + encodeURIComponent(sceneOpen.name), {});
    showPrices();
  } catch (error) {
    tell($("scene-time"), error);
  }
});

const unfolded = new Set(); // the effects whose figures are shown
function effectItem(edit, table) {
  const name = table.name, on = inScene(edit, name), id = "effect-" + name;
  const box = made("input", { type: "checkbox", id, checked: on }), fault = made("p", { className: "fault" });
  fault.setAttribute("role", "alert");
  box.setAttribute("aria-describedby", id + "-cost");
  box.addEventListener("change", () => {
    const brought = switchEffect(edit, table, box.checked);
    edit.redraw();
    if (brought) edit.say(t("“{effect}” is switched on with it, because it needs that.", { effect: EFFECTS[brought] }));
    $(id).focus();
  });
  edit.rows.set(name, {
    show: () => box.focus(),
    fault: (found) => {
      const needs = found?.what.match(/^(\w+) needs (\w+)\.$/);
      fault.replaceChildren(...(needs ? inWords(trouble(t("{effect} needs “{other}”.", { effect: EFFECTS[needs[1]], other: EFFECTS[needs[2]] }), t("Switch that on, or this off."))) : faultWords(found)));
    },
  });
  const fields = edit.fields.filter((field) => field.table === name), inside = [];
  if (on && fields.length > 0) {
    const details = made("details", { open: unfolded.has(name) }, made("summary", {}, t("Its figures")),
      made("div", { className: "fields" }, ...fields.map((field) => fieldRow(edit, `${name}.${field.key}`, field))));
    details.addEventListener("toggle", () => (details.open ? unfolded.add(name) : unfolded.delete(name)));
    inside.push(details);
  }
  const item = made("li", { className: "effect" + (on ? "" : " off") },
    made("div", { className: "field switch" }, box, made("label", { htmlFor: id }, EFFECTS[name] ?? t(asLabel(name))),
      made("p", {}, [table.words.replace(/([^.])$/, "$1."), table.gives].filter(Boolean).map((words) => t(words)).join(" ")), made("p", { className: "small cost", id: id + "-cost" }),
      made("div", { className: "price" }, made("span", {}))), fault, ...inside);
  item.dataset.id = name;
  return item;
}
/** Switches it, and what it needs with it: the name of that. */
function switchEffect(edit, table, on) {
  edit.setTable(table.name, on);
  const needed = on && table.needs ? edit.file.fields.tables.find(({ name }) => name === table.needs) : undefined;
  if (!needed || inScene(edit, needed.name)) return "";
  switchEffect(edit, needed, true);
  return needed.name;
}

function drawScene(edit) {
  const row = (field) => {
    const key = (field.table ? field.table + "." : "") + field.key;
    const how = { label: SCENE_LABELS[key] };
    if (key === "quality") Object.assign(how, { help: t("“auto”: this machine finds the finest that it can use, within minutes after a start; “fixed”: the rows and sectors below."), usual: "fixed" });
    if (key === "tool.to_hand") Object.assign(how, { help: t("Empty: all of them. Names with commas between them: palm, sponge, wire."), allowed: "" });
    return fieldRow(edit, key, field, how);
  };
  const grid = ["quality", "clay.rows", "clay.sectors"], named = (field) => (field.table ? field.table + "." : "") + field.key;
  $("scene-grid").replaceChildren(...edit.fields.filter((field) => grid.includes(named(field))).map(row));
  const tables = edit.file.fields.tables, order = Object.keys(EFFECTS), place = ({ name }) => (inScene(edit, name) ? 0 : 100) + order.indexOf(name);
  $("scene-effects").replaceChildren(...[...tables].sort((a, b) => place(a) - place(b)).map((table) => effectItem(edit, table)));
  $("scene-rest").replaceChildren(...SCENE_TABLES.map(([title, of]) => {
    const rows = edit.fields.filter((field) => of.includes(field.table) && !grid.includes(named(field)))
      .map((field) => (of.length > 2 ? fieldRow(edit, named(field), field, { label: `${t(asLabel(field.table))}: ${t(field.key)}`, help: "" }) : row(field)));
    const details = made("details", { open: unfolded.has(title) }, made("summary", {}, title), made("div", { className: "fields" }, ...rows));
    details.addEventListener("toggle", () => (details.open ? unfolded.add(title) : unfolded.delete(title)));
    return details;
  }));
  drawPrices(edit);
}
$("scene-form").addEventListener("submit", async (event) => {
  event.preventDefault();
  await sceneEdit.save(wantsTrial(event));
  showPrices();
});
$("scene-forget").addEventListener("click", () => sceneEdit.forget());
$("scene-close").addEventListener("click", () => {
  if (sceneEdit.dirty) return sceneEdit.say(saveFirst);
  edits.splice(edits.indexOf(sceneEdit), 1);
  sceneEdit = null;
  $("scene").hidden = true;
  $("scenes-form").hidden = false;
  showScenes().then(() => document.querySelector(`#scenes-list [data-id="${sceneOpen.name}"] button`)?.focus());
});
