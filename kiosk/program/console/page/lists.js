// Missions, glazes and lessons: files that are a list of things, each with words in every language.
"use strict";

const LISTS = {
  missions: { table: "mission", title: "title", what: t("What else visitors may be asked to do. One that is on stands before the shelf.") },
  glazes: { table: "glaze", title: "name", what: t("What visitors may choose in the kiln.") },
  lesson: { table: "step", title: "words", what: t("What the first minute at the wheel teaches, step by step.") },
  build_lesson: { table: "step", title: "words", what: t("The same for who builds a vessel of coils.") },
};
const LIST_LABELS = {
  on: t("Visitors see it"), kind: t("What visitors do"), after: t("Steps aside after"), until: t("Over when"), hands: t("Drawn hands"), words: t("What it says"),
  about: t("About it"), glass: t("Colour of the glass"), body: t("Colour of the fired clay"), slip: t("Colour of the slip"), band: t("Colour of a painted band"),
  height_mm: t("The pot’s height"), mouth_mm: t("Its diameter at the rim"),
};
const KINDS = { today: t("Today’s vessel"), describe: t("A pot that is described"), eyes_closed: t("With eyes closed"), two_hands: t("Two at one wheel") };
const UNTIL = { rim: t("the rim is smoothed") }; // as hands it is another word
let listEdit = null;

async function showLists() {
  if (listEdit && listEdit.dirty) return;
  const name = $("list-which").value;
  if (listEdit) {
    listEdit.gone = true;
    edits.splice(edits.indexOf(listEdit), 1);
  }
  const edit = new Edited(name, $("list-words"), [$("list-save"), $("list-forget")], drawList);
  edits.push(listEdit = edit);
  $("list-what").textContent = LISTS[name].what;
  edit.say("");
  try {
    const exhibit = await ask("/api/edit/exhibit");
    if (edit.gone) return;
    const offered = exhibit.values.languages ?? ["en", "ko"];
    const others = [...new Set([...offered, ...exhibit.languages])].slice(1), chosen = $("list-beside").value;
    $("list-beside").replaceChildren(...others.map((code) => made("option", { value: code }, languageName(code))));
    if (others.includes(chosen)) $("list-beside").value = chosen;
    $("list-beside").dataset.first = offered[0];
    await edit.load();
  } catch (error) {
    if (edit.gone) return;
    $("list-body").replaceChildren();
    if (error.status === 404) edit.say(t("This exhibit has none."));
    else tell($("list-words"), error);
  }
}

/** Those that the file has and those that are to be added; {id} of each. */
function elementsOf(edit, table) {
  const there = edit.file.values[table] ?? [];
  const added = [...edit.changes].filter(([key, value]) => key.startsWith(table + ".") && same(value, {})).map(([key]) => ({ id: key.slice(table.length + 1) }));
  return [...there, ...added.filter(({ id }) => !there.some((one) => one.id === id))];
}

function drawList(edit) {
  const { table, title } = LISTS[edit.name], codes = [$("list-beside").dataset.first, $("list-beside").value];
  const fields = edit.fields.filter((field) => field.table === table), words = edit.fields.filter((field) => field.any_key);
  $("list-body").replaceChildren(...elementsOf(edit, table).map((one) => {
    const key = `${table}.${one.id}`, of = (code) => edit.now(`${key}.${title}.${code}`), called = of(speech.code) || of(codes[0]) || of("en") || one.id.replaceAll("_", " ");
    const out = edit.changes.get(key) === null, remove = made("button", { type: "button", className: "quiet" }, out ? t("Keep it") : t("Take it out"));
    remove.setAttribute("aria-label", `${remove.textContent}: ${called}`);
    remove.addEventListener("click", () => {
      edit.setTable(key, out);
      edit.redraw();
    });
    const fault = made("p", { className: "fault" });
    fault.setAttribute("role", "alert");
    edit.rows.set(key, { show: () => remove.focus(), fault: (found) => fault.replaceChildren(...faultWords(found)) });
    const foot = made("div", { className: "wide actions" }, ...(out ? [made("p", {}, made("strong", {}, t("It is taken out when you save.")))] : []), remove);
    if (out) return section(called, foot, fault);
    const plain = fields.filter(({ key: name }) => applies(edit, key, name));
    const label = (field) => LIST_LABELS[field.key];
    const texts = words.flatMap((field) => {
      const name = field.table.split(".")[1];
      return codes.map((code) => fieldRow(edit, `${key}.${name}.${code}`, field,
        { label: `${LIST_LABELS[name] ?? t(asLabel(name))}, ${languageName(code)}`, lang: code, help: "", usual: "", lines: name === "about" || name === "words" ? 3 : 0 }));
    });
    const rows = plain.map((field) => {
      const row = fieldRow(edit, `${key}.${field.key}`, field, { label: label(field), called: (choice) => (field.key === "until" && UNTIL[choice]) || KINDS[choice] || t(choice.replaceAll("_", " ")) });
      // Other figures belong to another kind.
      if (field.key === "kind") row.addEventListener("change", () => { edit.redraw(); $(row.querySelector("select").id).focus(); });
      return row;
    });
    return section(called, ...texts, ...rows, foot, fault);
  }), ...(table === "step" ? [] : [adding(edit, table)]));
}

/** A field for the name of one more, and a button. */
function adding(edit, table) {
  const id = made("input", { id: "list-new", autocomplete: "off", maxLength: 40, placeholder: table === "mission" ? "cup_of_the_day" : "sky_blue" });
  const add = made("button", { type: "button", className: "quiet" }, table === "mission" ? t("Add a mission") : t("Add a glaze")), wrong = made("p", { className: "fault" });
  wrong.setAttribute("role", "alert");
  id.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    add.click();
  });
  add.addEventListener("click", () => {
    const name = id.value.trim();
    const good = /^[a-z0-9_]+$/.test(name), taken = elementsOf(edit, table).some((one) => one.id === name);
    wrong.textContent = !good ? t("Write small Latin letters, digits and _.") : taken ? t("There is one of that name.") : "";
    if (!good || taken) return id.focus();
    edit.setTable(`${table}.${name}`, true);
    if (table === "mission") edit.want(`mission.${name}.on`, false); // until it is finished
    edit.redraw();
    [...edit.rows].find(([key]) => key.startsWith(`${table}.${name}.`))?.[1].show();
  });
  return section(table === "mission" ? t("One more mission") : t("One more glaze"), made("div", { className: "field wide" }, made("label", { htmlFor: id.id }, t("Its name in files; visitors do not see it")),
    made("div", { className: "value" }, id, add), wrong));
}

/** A mission has only the figures of its kind. */
function applies(edit, element, key) {
  const of = { vessels: ["today"], litres: ["describe"], height_mm: ["describe"], mouth_mm: ["describe"], vessel: ["eyes_closed", "two_hands"], second: ["two_hands"] };
  return edit.name !== "missions" || !of[key] || of[key].includes(edit.now(element + ".kind"));
}

$("list-which").addEventListener("change", () => {
  if (listEdit.dirty) {
    $("list-which").value = listEdit.name;
    listEdit.say(saveFirst);
    return;
  }
  showLists();
});
$("list-beside").addEventListener("change", () => { listEdit.redraw(); listEdit.check(); });
$("list-form").addEventListener("submit", (event) => { event.preventDefault(); listEdit.save(wantsTrial(event)); });
$("list-forget").addEventListener("click", () => listEdit.forget());
