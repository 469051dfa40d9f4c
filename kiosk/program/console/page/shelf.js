// Shelf: the order of the vessels, which of them visitors see, and their labels in all languages.
"use strict";

let vessels = [];
const shelfEdit = new Edited("exhibit", $("shelf-words"), [$("shelf-save"), $("shelf-forget")], drawShelf);
edits.push(shelfEdit);

const titleOf = ({ id, titles }) => {
  const languages = shelfEdit.file?.values.languages ?? ["en"];
  return titles[speech.code] || titles[languages[0]] || titles.en || Object.values(titles)[0] || id.replaceAll("_", " ");
};

const outlinePicture = ({ id }) => made("img", { src: "/outline/" + encodeURIComponent(id), alt: "", width: 56, height: 56, draggable: false });
function drawShelf() {
  const order = shelfEdit.now("order") ?? [], hidden = shelfEdit.now("hidden") ?? [];
  const place = ({ id }) => (order.includes(id) ? order.indexOf(id) : order.length);
  const sorted = [...vessels].sort((a, b) => place(a) - place(b) || (a.id < b.id ? -1 : 1));
  $("shelf-list").replaceChildren(...sorted.map((vessel) => {
    const title = titleOf(vessel), box = made("input", { type: "checkbox", checked: !hidden.includes(vessel.id), id: "seen-" + vessel.id, disabled: vessel.unfinished });
    box.addEventListener("change", () => {
      const now = shelfEdit.now("hidden") ?? [];
      shelfEdit.want("hidden", box.checked ? now.filter((id) => id !== vessel.id) : [...now, vessel.id]);
    });
    const label = made("button", { type: "button", className: "quiet" }, t("Label"));
    label.setAttribute("aria-label", t("Label") + ": " + title);
    label.addEventListener("click", () => openLabel(vessel));
    const picture = vessel.outline ? outlinePicture(vessel) : made("span", { className: "noimage" });
    const item = made("li", { draggable: true }, made("span", { className: "grip" }, "⠿"), picture,
      made("div", { className: "title" }, made("h3", { dir: "auto" }, title), made("p", { className: "small" },
        vessel.id + (vessel.unfinished ? `. ${t("Unfinished: visitors do not see it yet")}.` : ""))),
      made("div", { className: "seen" }, box, made("label", { htmlFor: box.id }, t("Shown"))), label, made("div", {}, ...wayButtons(title)));
    item.dataset.id = vessel.id;
    return item;
  }));
}
/** The first of `ids` that must be written: those behind them stand by the alphabet anyway, and a new vessel among them. */
function needed(ids) {
  let count = ids.length - 1;
  while (count > 0 && ids[count - 1] < ids[count]) --count;
  return ids.slice(0, Math.max(count, 0));
}
orderable($("shelf-list"), (ids) => shelfEdit.want("order", needed(ids)));

async function showShelf() {
  if (labelEdit) return;
  if (shelfEdit.file && shelfEdit.dirty) return;
  try {
    vessels = await reading($("shelf-words"), ask("/api/shelf"));
    await shelfEdit.load();
    if (!$("scan-body").firstChild) showScan(); // one that was begun
    showOutlines();
  } catch (error) {
    tell($("shelf-words"), error);
  }
}
/** The outlines of scans are drawn one after the other: asks for them for a while. */
async function showOutlines() {
  const shown = vessels;
  for (let n = 0; n < 30 && shown.some(({ outline }) => !outline); ++n) {
    await new Promise((done) => setTimeout(done, 2000));
    if (shown !== vessels || labelEdit || part() !== "shelf") return;
    const now = await ask("/api/shelf").catch(() => shown);
    for (const vessel of shown.filter(({ outline }) => !outline)) {
      vessel.outline = now.find(({ id }) => id === vessel.id)?.outline;
      const place = document.querySelector(`#shelf-list [data-id="${CSS.escape(vessel.id)}"] .noimage`);
      if (vessel.outline && place) place.replaceWith(outlinePicture(vessel));
    }
  }
}
$("shelf-form").addEventListener("submit", (event) => { event.preventDefault(); shelfEdit.save(wantsTrial(event)); });
$("shelf-forget").addEventListener("click", () => shelfEdit.forget());

// ---- A label

const LINES = { title: 2, culture: 2, made: 4, text: 9, credit: 3 };
const LABEL_WORDS = { title: t("Title"), what: t("What it is"), culture: t("Who made it"), date: t("When"), made: t("How it was made"), text: t("Text"), credit: t("Whole credit line, in place of the museum’s and the shape’s"), address: t("Page about it") };
const ABOUT = {
  institution: t("Who keeps it"), accession: t("Its number there"), source: t("Where shape and figures are from"), credit: t("Credit of the shape"),
  licence: t("Licence of the shape"), address: t("The museum’s page"), true_height_mm: t("Its true height"), true_diameter_mm: t("Its greatest diameter"),
  glazes: t("Glazes that stand first"), unfinished: t("Unfinished: visitors do not see it yet"), built: t("It was built of coils"),
  paddle: t("Face of its makers’ paddle"), way: t("How visitors decorate it"),
};
let labelEdit = null, labelVessel = null;

async function openLabel(vessel) {
  if (labelEdit) return; // a second click
  const edit = new Edited("vessel/" + vessel.id, $("label-words"), [$("label-save"), $("label-forget")], drawLabel);
  edit.reach = (key) => {
    const code = key.split(".")[1];
    if (!key.startsWith("label.") || ![...$("label-beside").options].some(({ value }) => value === code)) return;
    $("label-beside").value = code;
    edit.redraw();
  };
  labelVessel = vessel;
  labelEdit = edit;
  $("label-title").textContent = titleOf(vessel);
  $("label-sheet").open = false;
  edit.say("");
  const offered = shelfEdit.file.values.languages ?? ["en", "ko"];
  // A label comes before its language is offered, too.
  const others = [...new Set([...offered, ...shelfEdit.file.languages])].slice(1);
  $("label-beside").replaceChildren(...others.map((code) => made("option", { value: code },
    languageName(code) + (offered.includes(code) ? "" : ` (${t("not offered yet")})`))));
  try {
    await edit.load();
    edits.push(edit);
    $("shelf-all").hidden = true;
    $("label").hidden = false;
    $("label-title").focus();
    scrollTo(0, 0);
  } catch (error) {
    labelEdit = null;
    tell($("shelf-words"), error);
  }
}

/** What a visitor will read, beside the fields. */
function preview(edit, code) {
  const of = (key) => edit.now(`label.${code}.${key}`) ?? "";
  const card = made("div", { className: "card", lang: code, dir: "auto" });
  if (!of("title")) {
    card.append(made("p", { className: "small", dir: document.documentElement.dir, lang: speech.code }, t("No label in {language}: visitors read another language’s.", { language: languageName(code) })));
    return card;
  }
  card.append(made("h4", {}, of("title")), made("p", { className: "small" }, [of("culture"), of("date")].filter(Boolean).join(", ")),
    ...[of("text"), of("made")].filter(Boolean).map((words) => made("p", {}, words)), made("p", { className: "small" }, of("credit")));
  return card;
}

function drawLabel(edit) {
  $("label-title").textContent = edit.was(`label.${speech.code}.title`) || edit.was(`label.${(shelfEdit.file.values.languages ?? ["en"])[0]}.title`) || titleOf(labelVessel);
  const languages = shelfEdit.file.values.languages ?? ["en", "ko"];
  const codes = [languages[0], $("label-beside").value];
  const fields = edit.fields.filter(({ table }) => table === "label.LANGUAGE");
  $("label-languages").replaceChildren(...codes.map((code) => {
    const seen = made("div", {}, preview(edit, code));
    const rows = fields.map((field) => fieldRow(edit, `label.${code}.${field.key}`, field,
      { label: LABEL_WORDS[field.key], lang: code, lines: LINES[field.key], help: "", usual: "" }));
    const column = section(languageName(code), ...rows, made("div", { className: "wide" }, made("h3", {}, t("What a visitor reads")), seen));
    column.addEventListener("input", () => seen.replaceChildren(preview(edit, code)));
    return column;
  }));
  const about = Object.keys(ABOUT).map((key) => edit.fields.find((field) => field.table === "" && field.key === key)).filter(Boolean);
  $("label-about").replaceChildren(...about.map((field) => fieldRow(edit, field.key, field, { label: ABOUT[field.key], help: "", lines: { source: 4, credit: 2, licence: 2, institution: 2, glazes: 2 }[field.key] ?? 0 })));
  showGaps(edit);
}
/** What a whole label has besides, said at its fields until something is typed there. */
function showGaps(edit) {
  for (const { key, what } of edit.file.gaps ?? []) {
    const row = document.getElementById(`field-${edit.name.replace(/\W/g, "-")}-${key.replace(/\W/g, "-")}-said`);
    row?.querySelector(".gap")?.remove();
    if (row && (edit.changes.get(key) ?? null) === null) row.prepend(made("strong", { className: "gap" }, gapWords(key, what), " "));
  }
  const gaps = (shelfEdit.file.values.languages ?? ["en"]).filter((code) => !edit.now(`label.${code}.title`));
  $("label-gaps").textContent = gaps.length === 0 ? "" : t("Still without a label: {languages}.", { languages: listed(gaps.map(languageName)) });
}
$("label-form").addEventListener("input", () => { if (labelEdit?.file) showGaps(labelEdit); });
/** What is still to be written, said at its field. */
function gapWords(key, what) {
  const words = atItsField({ key, what, remedy: "" })[0].replace(/^./, (first) => first.toUpperCase());
  return words.startsWith("This is missing") ? t("Still to be written.") : quoted(words);
}
/** The drawn sheet, when somebody wants to see it; it takes a moment. */
async function showSheet() {
  const edit = labelEdit, of = labelVessel.id, place = $("label-sheet-body");
  place.replaceChildren();
  for (let seconds = 0; $("label-sheet").open && edit === labelEdit; ++seconds) {
    try {
      const answer = await fetch("/sheet/" + encodeURIComponent(of));
      if (answer.status === 200) return place.replaceChildren(made("img", { src: answer.url, alt: t("Section and view of the vessel, with its figures"), className: "plot" }));
      const said = await answer.json();
      if (!said.drawing) return tell(place, refusal(said));
    } catch {
      return place.replaceChildren(t("It cannot be shown."));
    }
    place.replaceChildren(t("Drawing it…") + since(seconds));
    await new Promise((done) => setTimeout(done, 1000));
  }
}
$("label-sheet").addEventListener("toggle", () => { if ($("label-sheet").open && labelEdit) showSheet(); });
$("label-beside").addEventListener("change", () => { labelEdit.redraw(); labelEdit.check(); });
$("label-form").addEventListener("submit", (event) => { event.preventDefault(); labelEdit.save(wantsTrial(event)); });
$("label-forget").addEventListener("click", () => labelEdit.forget());
$("label-close").addEventListener("click", () => {
  if (labelEdit.dirty) {
    labelEdit.say(saveFirst);
    return;
  }
  edits.splice(edits.indexOf(labelEdit), 1);
  labelEdit = null;
  if (!scan?.found) $("scan-body").replaceChildren();
  $("label").hidden = true;
  $("shelf-all").hidden = false;
  showShelf().then(() => document.querySelector(`#shelf-list [data-id="${labelVessel.id}"] button`)?.focus());
});
