// Settings: the exhibit's own file as a form, and the changes that can be taken back.
"use strict";

// Labels where a key's own name is not the usual word.
const LABELS = {
  credit: t("The museum’s name"), build: t("Vessels may be built of coils"), decorate: t("Pots may be decorated"),
  "attract.scripts": t("What a passer-by sees"),
  "idle.warn_after": t("Ask whether somebody is there after"), "idle.countdown": t("End the visit after that in"),
  "idle.result_after": t("Ask after, where people read"),
  "keepsake.quota_mb": t("Disk for keepsakes"), "keepsake.days": t("Keep them for"), "keepsake.turning": t("Keep a turning picture"),
  "keepsake.gallery": t("Show today’s pots to visitors"), "store.count": t("Count visits"), "store.months": t("Keep counts for"),
  "screen.viewing_distance_mm": t("From the eye to the screen"), "screen.diagonal_mm": t("Screen, corner to corner"),
  "screen.lower_edge_mm": t("Its lower edge above the floor"), "screen.reduced_motion": t("Less motion"),
  "screen.one_switch": t("One switch"), "screen.scan_seconds": t("Each choice lit for"), "screen.spoken": t("Read aloud"),
  "screen.silent": t("No sound"), "screen.force": t("Strength of the hand device"), "access.hold_to_speak": t("Hold to be read to"),
  "hours.every_day": t("Every day"), "hours.screen_off": t("The monitor sleeps when closed"),
};
// What it does, where the list of keys says it for readers of the file.
const HELP = {
  build: t("Those that were built so, as Shelf says."), "idle.result_after": t("On the result and the keepsake."),
  "attract.scripts": t("“follow” throws a vessel, the others show the clay. Pot by pot, round and round."),
  "screen.silent": t("Whatever the volume is."), "hours.screen_off": t("Else it shows a black picture."),
};
const SECTIONS = [
  [t("The exhibit"), ["credit", "build", "decorate"]],
  [t("When visitors go"), ["idle."]],
  [t("Opening hours"), ["hours."]],
  [t("Sound"), ["sound."]],
  [t("Screen"), ["screen.viewing_distance_mm", "screen.diagonal_mm", "screen.lower_edge_mm"]],
  [t("How every visit begins"), ["screen.", "access."]],
  [t("Keepsakes and counts"), ["keepsake.", "store."]],
  [t("When nobody plays"), ["attract."]],
];

const settings = new Edited("exhibit", $("settings-words"), [$("settings-save"), $("settings-forget")], drawSettings);
edits.push(settings);

function section(title, ...rows) {
  return made("fieldset", {}, made("legend", {}, title), made("div", { className: "fields" }, ...rows));
}

function drawSettings() {
  const named = (field) => (field.table ? field.table + "." : "") + field.key;
  const left = settings.fields.filter((field) => !field.any_key && !["order", "hidden", "languages"].includes(named(field)));
  const sections = SECTIONS.map(([title, keys]) => {
    const mine = left.filter((field) => keys.some((key) => (key.endsWith(".") ? named(field).startsWith(key) : named(field) === key)));
    for (const field of mine) left.splice(left.indexOf(field), 1);
    if (title === t("Opening hours")) mine.unshift(...mine.splice(mine.findIndex((field) => field.key === "every_day"), 1));
    const rows = mine.map((field) => fieldRow(settings, named(field), field, settingHow(named(field))));
    if (title === t("The exhibit")) rows.push(titleRows(), languageList());
    if (title === t("Opening hours")) rows.push(exceptions());
    return section(title, ...rows);
  });
  $("settings-fields").replaceChildren(...sections);
}

function settingHow(key) {
  const how = { label: LABELS[key], help: HELP[key] };
  if (key === "attract.scripts") Object.assign(how, { allowed: t("Names with commas between them."), lines: 3 });
  if (key.startsWith("hours.") && key !== "hours.screen_off") {
    how.allowed = key === "hours.every_day" ? t("10:00-18:00, or 10:00-12:30, 14:00-18:00, or closed. Empty: always open.") : "";
    how.help = key === "hours.every_day" ? "" : t("Empty: as every day.");
  }
  return how;
}

/** A title in each language that is offered. */
function titleRows() {
  const field = settings.fields.find(({ table }) => table === "title");
  const languages = settings.now("languages") ?? ["en", "ko"];
  return made("div", { className: "wide fields" }, ...languages.map((code) => fieldRow(settings, "title." + code, field,
    { label: t("Title, {language}", { language: languageName(code) }), lang: code, help: "", allowed: "", usual: "" })));
}

/** The languages: which, and in which order. */
function languageList() {
  const chosen = settings.now("languages") ?? ["en", "ko"];
  const list = made("ul", { className: "order" });
  const show = (codes) => {
    const rest = settings.file.languages.filter((code) => !codes.includes(code));
    list.replaceChildren(...[...codes, ...rest].map((code) => {
      const on = codes.includes(code), box = made("input", { type: "checkbox", checked: on, id: "language-" + code });
      box.addEventListener("change", () => {
        const next = box.checked ? [...codes, code] : codes.filter((one) => one !== code);
        settings.want("languages", next);
        // Its title goes and comes with it.
        if (settings.was("title." + code) !== undefined) settings.want("title." + code, box.checked ? settings.was("title." + code) : null);
        else if (!box.checked) settings.drop("title." + code);
        settings.redraw();
        $("language-" + code).focus();
      });
      const item = made("li", { draggable: on }, box, made("label", { htmlFor: box.id }, languageName(code)),
        ...(code === codes[0] ? [made("span", { className: "small" }, t("at the start"))] : []), ...(on ? [made("div", {}, ...wayButtons(languageName(code)))] : []));
      item.dataset.id = code;
      return item;
    }));
  };
  show(chosen);
  orderable(list, (ids) => {
    const codes = settings.now("languages") ?? ["en", "ko"], next = ids.filter((id) => codes.includes(id));
    settings.want("languages", next);
    show(next);
  });
  const fault = made("p", { className: "fault" });
  settings.rows.set("languages", { show: () => list.querySelector("input").focus(), fault: (found) => fault.replaceChildren(...faultWords(found)) });
  return made("div", { className: "field wide" }, made("h3", {}, t("Languages")), list, fault);
}

/** Days with hours of their own. */
function exceptions() {
  const field = settings.fields.find(({ table }) => table === "hours.exceptions");
  const key = (day) => "hours.exceptions." + (/^[\w-]+$/.test(day) ? day : JSON.stringify(day));
  const days = new Set(Object.keys(settings.was("hours.exceptions") ?? {}));
  for (const [name] of settings.changes) if (name.startsWith("hours.exceptions.")) days.add(name.slice(17).replaceAll('"', ""));
  const place = made("div", { className: "fields" });
  const row = (day) => fieldRow(settings, key(day), field, { label: day, help: t("Empty: no exception."), allowed: "", usual: "" });
  place.append(...[...days].sort().map(row));
  const day = made("input", { id: "exception-day", placeholder: "12-25", autocomplete: "off" });
  const add = made("button", { type: "button", className: "quiet" }, t("Add this day")), wrong = made("p", { className: "fault" });
  wrong.setAttribute("role", "alert");
  day.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    add.click();
  });
  add.addEventListener("click", () => {
    // 24.12.2026 and 24.12. are dates, too.
    const name = westernDigits(day.value.trim()).replace(/^(\d\d?)\.\s*(\d\d?)\.\s*(\d{4})?$/, (_, on, month, year) => [year, month.padStart(2, "0"), on.padStart(2, "0")].filter(Boolean).join("-")), good = /^(\d{4}-)?\d\d-\d\d$/.test(name);
    wrong.textContent = good ? "" : t("Write year, month and day (2026-12-24), or month and day (12-24).");
    if (!good || days.has(name)) return day.focus();
    days.add(name);
    settings.want(key(name), "closed");
    place.append(row(name));
    day.value = "";
  });
  return made("div", { className: "field wide" }, made("h3", {}, t("Days that are different")), place,
    made("label", { htmlFor: "exception-day" }, t("A date (2026-12-24), or a day of every year (12-24)")),
    made("div", { className: "value" }, day, add), wrong);
}

async function showSettings() {
  showRevisions();
  if (settings.file && settings.dirty) return;
  try {
    await reading($("settings-words"), settings.load());
  } catch (error) {
    tell($("settings-words"), error);
  }
}
let newest = null; // the change that can be taken back
async function showRevisions() {
  try {
    const all = await ask("/api/revisions");
    newest = all[0] ?? null;
    $("undo").hidden = newest === null;
    $("undo-forget").hidden = true;
    const words = ({ file, words: of }) => `${file}: ${of.replaceAll("\n", "; ")}`;
    $("revisions").replaceChildren(...all.map((one) => made("li", {}, `${one.when}  ${words(one)}`)));
    $("undo-what").textContent = newest === null ? t("Nothing was changed yet.") : t("The newest, of {time}: {change}.", { time: newest.when, change: words(newest) });
  } catch (error) {
    tell($("undo-words"), error);
  }
}

$("settings-form").addEventListener("submit", async (event) => {
  event.preventDefault();
  await settings.save(wantsTrial(event));
  showRevisions();
});
$("settings-forget").addEventListener("click", () => settings.forget());

/** Takes the newest change back, or only forgets it: the one that is shown, and no other that came meanwhile. */
async function takeBack(forget) {
  $("undo").disabled = $("undo-forget").disabled = true;
  try {
    const begun = await ask("/api/undo", { id: newest.id, forget });
    const said = await outcome(begun.number, $("undo-words"), t("Looking at the whole exhibit, then taking it back…"));
    await showRevisions();
    if (!said.done) {
      $("undo-forget").hidden = said.another_file === true;
      return tell($("undo-words"), refusal(said));
    }
    // It is done, even where the file cannot be shown then.
    if (!settings.dirty) await settings.load().catch((error) => tell($("settings-words"), error));
    $("undo-words").textContent = (forget ? t("Forgotten, and the file stays as it is:") : t("Taken back:")) + " " + said.words.join(" ");
  } catch (error) {
    tell($("undo-words"), error);
  } finally {
    $("undo").disabled = $("undo-forget").disabled = false;
  }
}
$("undo").addEventListener("click", () => takeBack(false));
$("undo-forget").addEventListener("click", () => takeBack(true));
