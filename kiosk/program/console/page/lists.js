// Missions, glazes and lessons: files that are a list of things, each with words in every language.
"use strict";

const LISTS = {
  missions: { table: "mission", title: "title", what: "What else visitors may be asked to do. One that is on stands before the shelf." },
  glazes: { table: "glaze", title: "name", what: "What visitors may choose in the kiln." },
  lesson: { table: "step", title: "words", what: "What the first minute at the wheel teaches, step by step." },
  build_lesson: { table: "step", title: "words", what: "The same for who builds a vessel of coils." },
};
const LIST_LABELS = {
  on: "Visitors see it", kind: "What visitors do", after: "Steps aside after", until: "Over when", hands: "Drawn hands", words: "What it says",
  about: "About it", glass: "Colour of the glass", body: "Colour of the fired clay", slip: "Colour of the slip", band: "Colour of a painted band",
  height_mm: "The pot’s height", mouth_mm: "Its diameter at the rim",
};
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
    if (error.status === 404) edit.say("This exhibit has none.");
    else tell($("list-words"), error);
  }
}

function drawList(edit) {
  const { table, title } = LISTS[edit.name], codes = [$("list-beside").dataset.first, $("list-beside").value];
  const fields = edit.fields.filter((field) => field.table === table), words = edit.fields.filter((field) => field.any_key);
  $("list-body").replaceChildren(...(edit.file.values[table] ?? []).map((one) => {
    const key = `${table}.${one.id}`, of = one[title] ?? {}, called = of[codes[0]] || of.en || one.id.replaceAll("_", " ");
    const plain = fields.filter(({ key: name }) => applies(edit, one, name));
    const label = (field) => LIST_LABELS[field.key];
    const texts = words.flatMap((field) => {
      const name = field.table.split(".")[1];
      return codes.map((code) => fieldRow(edit, `${key}.${name}.${code}`, field,
        { label: `${LIST_LABELS[name] ?? asLabel(name)}, ${languageName(code)}`, lang: code, help: "", usual: "", lines: name === "about" || name === "words" ? 3 : 0 }));
    });
    return section(called, ...texts, ...plain.map((field) => fieldRow(edit, `${key}.${field.key}`, field, { label: label(field) })));
  }));
}

/** A mission has only the figures of its kind. */
function applies(edit, one, key) {
  const of = { vessels: ["today"], litres: ["describe"], height_mm: ["describe"], mouth_mm: ["describe"], vessel: ["eyes_closed", "two_hands"], second: ["two_hands"] };
  return edit.name !== "missions" || !of[key] || of[key].includes(one.kind);
}

$("list-which").addEventListener("change", () => {
  if (listEdit.dirty) {
    $("list-which").value = listEdit.name;
    listEdit.say("Save your changes first, or forget them.");
    return;
  }
  showLists();
});
$("list-beside").addEventListener("change", () => { listEdit.redraw(); listEdit.check(); });
$("list-form").addEventListener("submit", (event) => { event.preventDefault(); listEdit.save(); });
$("list-forget").addEventListener("click", () => listEdit.forget());
