// The staff's page: its parts, of which one is shown. base.js comes before it; what editors alone need is loaded for them.
"use strict";

const PARTS = ["now", "desk", "figures", "settings", "shelf", "scenes", "lists", "words", "files", "people"];
const FOR_EDITORS = ["settings", "shelf", "scenes", "lists", "words", "people"];
const EDITORS_FILES = ["edit", "settings", "shelf", "scan", "scenes", "lists", "words", "look"]; // in this order
const EVERY = 2000; // ms between two looks at the kiosk

// ---- Now

const MOODS = { good: t("Good"), look: t("Look"), wrong: t("Wrong") };
let state = null, shownLines = "", looks = 0;

/** What a thing is called, how it is, and what to do: elements and texts. */
function showLine(name, mood, says, remedy) {
  return made("li", { className: mood },
    made("span", { className: "mood" }, MOODS[mood]),
    made("div", {}, made("h3", {}, name), made("p", {}, ...says), ...(remedy ? [made("p", { className: "remedy" }, remedy)] : [])));
}
/** A sentence of the program (Sentence): English with names in braces, and what stands for them. */
function sentenceOf({ english, one, count, values }) {
  const own = { object: sentenceOf, number: numeral, string: (name) => name };
  const inside = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, own[typeof value](value)]));
  return one ? tn(count, one, english, inside) : t(english, inside);
}
const spoken = (sentence) => (sentence.theirs ? quoted(sentence.english) : sentenceOf(sentence));
const stateLine = ({ name, mood, says, remedy }) => showLine(t(name), mood, says.flatMap((one) => [spoken(one), " "]), remedy && spoken(remedy));

// A session ends half an hour after somebody last did something here: looking by itself does not count.
let lastTouch = Date.now();
for (const kind of ["pointerdown", "keydown", "scroll"]) addEventListener(kind, () => { lastTouch = Date.now(); }, { passive: true });
const isHere = () => Date.now() - lastTouch < 60000;

/** A change that is tried, and how long it still stands; every editor sees it. */
let tried = false;
function showTrial(trial) {
  $("trial").hidden = !trial;
  if (trial?.trouble) $("trial-what").replaceChildren(made("strong", {}, t("A change that was tried could not be put back.")), " ", trial.trouble, " ", t("Under Settings it can be taken back."));
  else if (trial?.left !== undefined) $("trial-what").replaceChildren(made("strong", {}, t("Tried for another {time}.", { time: `${Math.floor(trial.left / 60)}:${String(trial.left % 60).padStart(2, "0")}` })), " ", trial.what);
  if (trial?.put_back) $("trial-what").replaceChildren(t("The change that was tried has been put back."));
  $("trial-back").hidden = trial?.left === undefined;
  $("trial-keep").hidden = trial?.put_back === true;
  // It is over: what is shown may not be so any more.
  if (tried && trial?.left === undefined && loaded) for (const one of edits) if (one.file) one.follow().catch(() => {});
  tried = trial?.left !== undefined;
}

async function look() {
  try {
    const said = await ask("/api/state" + (isHere() ? "" : "?alone=1"));
    $("lost").hidden = true;
    const first = state === null;
    state = said;
    const title = said.titles[speech.code] ?? said.title;
    document.title = (said.mood === "wrong" ? "⚠ " : "") + title;
    $("title").textContent = title;
    $("credit").textContent = said.credit;
    // What has not changed is not written again: a screen reader would begin anew.
    const lines = JSON.stringify(said.lines);
    if (lines !== shownLines) $("lines").replaceChildren(...said.lines.map(stateLine));
    shownLines = lines;
    $("seen").textContent = t("Looked at {time}.", { time: new Date().toTimeString().slice(0, 8) }) + " " + said.exhibit;
    const wrong = said.lines.find(({ id, mood }) => id === "files" && mood !== "good");
    document.querySelector("nav a[href='#files']").textContent = t("Files") + (wrong ? " ⚠" : "");
    if (part() === "desk" && ++looks % 5 === 0 && !$("pot").open) showPots(true);
    $("who").textContent = said.who === "(code)" ? "" : said.who;
    $("own").hidden = said.who === "(code)";
    for (const one of FOR_EDITORS) document.querySelector(`nav a[href='#${one}']`).hidden = said.role !== "editor";
    showTrial(said.trial);
    if (first) begin();
  } catch (error) {
    lose(error);
  }
  if (!document.hidden) setTimeout(look, EVERY);
}
document.addEventListener("visibilitychange", () => { if (!document.hidden) look(); });

// ---- Desk

let asked = 0, shownPots = "";
/** `alone`: by itself, because something may have come. A name is looked for on all days, a time on that day. */
async function showPots(alone) {
  const turn = ++asked, name = $("name").value.trim(), day = /^[\d:]*$/.test(name) ? $("day").value : "";
  const query = new URLSearchParams({ ...(name ? { name } : {}), ...(day ? { day } : {}), ...(alone ? { alone: 1 } : {}) });
  try {
    const work = ask("/api/keepsakes?" + query);
    const pots = await (alone ? work : waiting($("found"), t("Looking…"), work));
    if (turn !== asked) return;
    const now = JSON.stringify([pots, name, day]);
    if (alone && now === shownPots) return;
    shownPots = now;
    const days = !day ? t("All days") : day === state.today ? t("Today") : day, of = name ? t("{days}, “{name}”", { days, name }) : days;
    const count = pots.length === 200 ? t("the newest 200 keepsakes.") : tn(pots.length, "one keepsake.", "{count} keepsakes, the newest first.");
    $("found").textContent = `${of}: ` + (pots.length > 0 ? count : t("nothing was kept.") + (name ? " " + t("Try one of its three words, the time as 14:15, or the vessel.") : ""));
    $("pots").replaceChildren(...pots.map((pot) => showPot(pot, !day)));
  } catch (error) {
    if (turn === asked) tell($("found"), error);
  }
}

/** What its label calls it, else its name in files. */
const vesselOf = ({ titles, vessel }) => titles[speech.code] ?? titles.en ?? Object.values(titles)[0] ?? vessel;
function showPot(pot, withDay) {
  const picture = made("img", {
    src: `/keepsake/${pot.visit}/${pot.small ? "small" : "postcard"}.jpg`, alt: "", loading: "lazy", width: 200, height: 200,
  });
  picture.addEventListener("error", () => { picture.style.visibility = "hidden"; });
  const button = made("button", { className: "pot" }, picture,
    made("span", { className: "name", dir: "auto" }, pot.name || t("(no name)")),
    made("span", { className: "small" }, `${withDay ? pot.day + " " : ""}${pot.time}, ${vesselOf(pot)}`));
  button.addEventListener("click", () => openPot(pot));
  return made("li", {}, button);
}

let opened = null;
function openPot(pot) {
  opened = pot;
  $("pot-title").textContent = pot.name || t("(no name)");
  $("pot-facts").textContent = `${vesselOf(pot)}, ${pot.day} ${pot.time}`;
  const files = ["postcard.jpg", ...(pot.turning ? ["turning.gif"] : []), ...(pot.sheet ? ["sheet.jpg"] : []),
    ...(pot.rollout ? ["rollout.jpg"] : [])];
  const what = { "postcard.jpg": t("The postcard"), "turning.gif": t("The pot, turning"), "sheet.jpg": t("The pot, drawn"), "rollout.jpg": t("The outside, unrolled") };
  $("pot-pictures").replaceChildren(...files.map((file) => made("img", { src: `/keepsake/${pot.visit}/${file}`, alt: what[file] })));
  $("pot-print").href = "/print/" + pot.visit;
  $("pot-words").replaceChildren();
  $("pot-code").replaceChildren();
  $("pot-pass").disabled = !state.phones;
  if (!state.phones) $("pot-words").textContent = t("No pages for phones just now: Now says why, or phones have none here.");
  $("pot-pictures").hidden = false;
  $("pot-sure").hidden = true;
  $("pot").showModal();
  $("pot").scrollTop = 0;
}
$("pot-close").addEventListener("click", () => $("pot").close());

/** A code for a phone's camera, dark on light whatever the page's colours. */
function codeOf(rows) {
  const side = rows.length + 8, svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", `0 0 ${side} ${side}`);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", t("Code for a phone’s camera"));
  svg.setAttribute("class", "code");
  const path = document.createElementNS(svg.namespaceURI, "path");
  let way = "";
  rows.forEach((row, y) => [...row].forEach((dark, x) => { if (dark === "1") way += `M${x + 4} ${y + 4}h1v1h-1z`; }));
  path.setAttribute("d", way);
  svg.append(path);
  return svg;
}

$("pot-pass").addEventListener("click", async () => {
  try {
    const pass = await waiting($("pot-words"), t("Making a page…"), ask(`/api/keepsakes/${opened.visit}/pass`, {}));
    $("pot-words").textContent = t("The visitor’s phone can open this until {time}:", { time: pass.until });
    $("pot-code").replaceChildren(codeOf(pass.code), made("p", { className: "address" }, pass.address));
    $("pot-pictures").hidden = true;
    $("pot").scrollTop = 0;
  } catch (error) {
    tell($("pot-words"), error);
  }
});
$("pot-delete").addEventListener("click", () => {
  $("pot-sure").hidden = false;
  $("pot-no").focus();
  $("pot-sure").scrollIntoView();
});
$("pot-no").addEventListener("click", () => {
  $("pot-sure").hidden = true;
  $("pot-delete").focus();
});
$("pot-yes").addEventListener("click", async () => {
  try {
    await waiting($("pot-words"), t("Deleting…"), ask(`/api/keepsakes/${opened.visit}/delete`, {}));
    $("pot").close();
    await showPots();
    $("found").textContent = t("Deleted: {name}.", { name: opened.name || t("(no name)") });
    $("content").focus({ preventScroll: true });
  } catch (error) {
    tell($("pot-words"), error);
  }
});
$("find").addEventListener("submit", (event) => { event.preventDefault(); showPots(); });
$("day").addEventListener("change", () => { $("name").value = ""; showPots(); });
$("today").addEventListener("click", () => {
  $("name").value = "";
  $("day").value = state.today;
  showPots();
});

// ---- Figures

const TABLES = {
  vessel: t("Vessels"), mission: t("Missions"), way: t("How they played"), language: t("Languages"), left: t("Where visits ended"),
  reached: t("How far they came"), ended: t("How they ended"), hour: t("Hours of the day"),
};

const NAMES = {
  "": t("(none)"), back: t("went back"), idle: t("walked away"), finished: t("finished"), closed: t("the program ended"), fault: t("a fault"),
  choose: t("choosing a vessel"), clay: t("touching the clay"), throw: t("at the wheel"), result: t("the result"), kiln: t("the kiln"),
  decorate: t("decorating"), keepsake: t("the keepsake"), touch: t("touch"), mouse: t("mouse"), keys: t("keys"),
};
function nameIn(table, name, titles) {
  if (table === "vessel" && Object.hasOwn(titles ?? {}, name)) return vesselOf({ titles: titles[name], vessel: name.replaceAll("_", " ") });
  if (table === "language") return languageName(name);
  if (table === "hour") return name + (String(name).includes(":") ? "" : ":00");
  return NAMES[name] || String(name).replaceAll("_", " ");
}

function daysBefore(day, count) {
  const date = new Date(day + "T12:00:00Z");
  date.setUTCDate(date.getUTCDate() - count);
  return date.toISOString().slice(0, 10);
}

/** What the figures tell, in sentences; null is not shown, because it would be about fewer than five people. */
function figuresInWords({ from, to, visits, keepsakes, active_minutes, throwing_minutes, median_minutes, pots, fetched_by_phone, likeness, brief }) {
  if (from === undefined) return t("No visit has been counted here yet.");
  const days = from ? t("From {from} to {to}:", { from, to }) : t("All days") + ":", number = (value) => (value === null ? "–" : numeral(value));
  if (visits === null) return `${days} ${t("fewer than five people played.")}`;
  if (visits === 0) return `${days} ${t("nobody played.")}`;
  return [days, tn(visits, "one person played.", "{count} people played."),
    t("Half of them played for more than {minutes} minutes.", { minutes: number(median_minutes) }),
    t("All together they played for {minutes} minutes, {wheel} of them at the wheel.", { minutes: number(active_minutes), wheel: number(throwing_minutes) }),
    pots !== null && tn(pots, "They began one pot.", "They began {count} pots."),
    keepsakes === null ? t("How many pots they kept is not shown: fewer than five were kept, or all but so few.") : tn(keepsakes, "They kept one pot.", "They kept {count} pots."),
    fetched_by_phone === null ? t("How many were opened on a phone is not shown: it would be about fewer than five people.")
      : fetched_by_phone > 0 && tn(fetched_by_phone, "Phones opened one keepsake.", "Phones opened {count} keepsakes."),
    likeness !== null && t("Their pots reached {points} of 100 points on average.", { points: numeral(likeness) }),
    brief === null ? t("Fewer than five more only touched the screen in passing.")
      : brief > 0 && tn(brief, "One more only touched the screen in passing.", "{count} more only touched the screen in passing."),
  ].filter(Boolean).join(" ");
}

async function showFigures() {
  const span = $("span").value;
  const query = new URLSearchParams(span === "" ? {} : { from: daysBefore(state.today, Number(span)), to: state.today });
  try {
    const told = await waiting($("figures-words"), t("Counting…"), ask("/api/figures?" + query));
    $("figures-words").textContent = figuresInWords(told);
    const tables = Object.entries(TABLES).filter(([key]) => (told.tables[key] || []).length > 0).map(([key, title]) =>
      made("table", {}, made("caption", {}, title),
        made("thead", {}, made("tr", {}, ...["", t("Visits"), t("Keepsakes"), t("Likeness")].map((head) => made("th", { scope: "col" }, head)))),
        made("tbody", {}, ...told.tables[key].map((line) => made("tr", {},
          made("th", { scope: "row" }, nameIn(key, line.name, told.titles)),
          ...[line.visits, line.keepsakes, line.likeness].map((value) => made("td", {}, value === null ? "–" : numeral(value))))))));
    if (told.visits === 0) return $("figures-body").replaceChildren();
    $("figures-body").replaceChildren(
      made("img", { className: "plot", src: `/figures.svg?${query}&now=${Date.now()}`, alt: t("Visits by day, drawn. The same counts stand in the tables.") }),
      ...tables, made("p", { className: "small" }, t("–: nothing to tell, fewer than five, or left out so that nobody can be worked out from the rest.")));
  } catch (error) {
    $("figures-body").replaceChildren();
    tell($("figures-words"), error);
  }
}
$("span").addEventListener("change", showFigures);

// ---- Files

let filesAgain = 0;
async function showFiles() {
  clearTimeout(filesAgain);
  try {
    const said = await ask("/api/files" + (isHere() ? "" : "?alone=1")), report = said.report;
    const checking = said.checking ? t("The files are being checked…") + " " : "";
    if (said.trouble) {
      $("files-words").replaceChildren(checking, quoted(said.trouble));
      $("problems").replaceChildren();
      $("files-list").replaceChildren();
    } else $("files-words").replaceChildren(checking, report ? quoted(report.summary) : "");
    if (report) {
      const line = (mood) => (p) => showLine(placeIn(p.file, p.line), mood, [quoted(p.what)], quoted(p.remedy));
      $("problems").replaceChildren(...report.problems.map(line("wrong")), ...report.notes.map(line("look")));
      $("files-list").replaceChildren(...report.files.map((file) => made("li", {}, file)));
    }
    if (part() === "files") filesAgain = setTimeout(showFiles, said.checking ? 500 : 5000);
  } catch (error) {
    tell($("files-words"), error);
  }
}

// ---- People

async function showPeople() {
  try {
    const people = await ask("/api/people");
    $("people-list").replaceChildren(...people.map(showPerson));
    if (people.length === 0)
      $("people-words").textContent = t("Nobody has a name yet. The first one should be an editor, and you.");
    $("person-role").value = people.length === 0 ? "editor" : $("person-role").value;
    const changes = await ask("/api/changes");
    $("changes-list").replaceChildren(...changes.map(({ at, who, did, what }) =>
      made("li", {}, `${new Date(at * 1000).toLocaleString(speech.code)}  ${who}  ${DID[did] ?? did}: `, made("bdi", { dir: "ltr" }, what))));
  } catch (error) {
    tell($("people-words"), error);
  }
}

const DID = {
  changed: t("changed"), tried: t("tried"), "put back": t("put back"), "took back": t("took back"), forgot: t("forgot"), "added vessel": t("added vessel"),
  "changed passphrase": t("changed passphrase"), "gave a pass": t("gave a pass"), "deleted keepsake": t("deleted keepsake"),
  "removed person": t("removed person"), "added person": t("added person"), "gave a role": t("gave a role"), "gave a passphrase": t("gave a passphrase"),
};
const ROLES = { desk: t("Desk"), editor: t("Editor") };
let changing = ""; // whose Change was chosen
function showPerson({ name, role }) {
  const change = made("button", { className: "quiet" }, t("Change")), remove = made("button", { className: "danger" }, t("Remove"));
  change.addEventListener("click", () => {
    changing = name;
    $("person-name").value = name;
    $("person").scrollIntoView();
    $("person-role").value = role;
    $("person-passphrase").focus();
    $("people-words").textContent = t("Choose what {name} may do. Without a new passphrase the old one stays.", { name });
  });
  remove.addEventListener("click", async () => {
    if (remove.textContent === t("Remove")) {
      remove.textContent = t("Really remove {name}?", { name });
      setTimeout(() => { remove.textContent = t("Remove"); }, 5000);
      return;
    }
    await savePeople(`/api/people/${name}/remove`, {}, t("{name} is removed, and signed out.", { name }));
  });
  return made("li", {}, made("div", {}, made("h3", {}, name), made("p", { className: "small" }, ROLES[role] ?? role)),
    made("div", { className: "actions" }, change, remove));
}

async function savePeople(address, post, words) {
  try {
    await waiting($("people-words"), t("Saving…"), ask(address, post));
    $("person").reset();
    changing = "";
    await showPeople();
    $("people-words").textContent = words;
  } catch (error) {
    tell($("people-words"), error);
  }
}
$("person").addEventListener("submit", (event) => {
  event.preventDefault();
  const name = $("person-name").value.trim();
  const role = $("person-role").value, add = name === changing ? "no" : "yes";
  savePeople("/api/people", { name, role, passphrase: $("person-passphrase").value, add },
    role === "editor" ? t("{name} may do everything on this page.", { name }) : t("{name} may do the desk’s work on this page.", { name }));
});

$("own").addEventListener("click", () => {
  $("passphrase-form").reset();
  $("passphrase-words").replaceChildren();
  $("passphrase").showModal();
});
$("passphrase-close").addEventListener("click", () => $("passphrase").close());
$("passphrase-form").addEventListener("submit", async (event) => {
  event.preventDefault();
  try {
    await ask("/api/passphrase", { old: $("passphrase-old").value, new: $("passphrase-new").value });
    $("passphrase-form").reset();
    $("passphrase-words").textContent = t("It is changed.");
  } catch (error) {
    tell($("passphrase-words"), error);
  }
});

// ---- Which part is shown

const part = () => {
  const wanted = location.hash.slice(1);
  const open = PARTS.includes(wanted) && (!FOR_EDITORS.includes(wanted) || state === null || state.role === "editor");
  return open ? wanted : "now";
};

let loaded = false; // what editors need
async function loadForEditors() {
  await speakOfEditing().catch(() => {}); // in English then
  for (const file of EDITORS_FILES) await run(file);
  loaded = true;
}

function showPart() {
  for (const section of document.querySelectorAll("[data-part]")) section.hidden = section.dataset.part !== part();
  for (const link of document.querySelectorAll("nav a")) {
    if (link.hash === "#" + part()) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  if (state === null) return;
  if (part() === "desk") showPots();
  if (part() === "figures") showFigures();
  if (part() === "files") showFiles();
  if (part() === "people") showPeople();
  if (!loaded) return;
  if (part() === "settings") showSettings();
  if (part() === "shelf") showShelf();
  if (part() === "scenes") showScenes();
  if (part() === "lists") showLists();
  if (part() === "words") showWords();
}
async function begin() {
  $("day").value = state.today;
  showPart();
  if (state.role !== "editor") return;
  await loadForEditors().catch(lose);
  // What is shown already stays as it is.
  if (["settings", "shelf", "scenes", "lists", "words"].includes(part())) showPart();
}
addEventListener("hashchange", () => { showPart(); $("content").focus({ preventScroll: true }); scrollTo(0, 0); });

$("leave").addEventListener("click", async () => {
  try {
    kept("sessionStorage", "why", "");
    await ask("/api/leave", {});
  } finally {
    location.replace("/");
  }
});

showPart();
look();
