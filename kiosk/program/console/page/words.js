// Words: every text of the kiosk in one language, with the program's English beside it.
"use strict";

const MOST_FOUND = 60, MOST_CHANGES = 50; // that are checked at once
let wordsEdit = null;

async function showWords() {
  if (wordsEdit && wordsEdit.dirty) return;
  try {
    const exhibit = await ask("/api/edit/exhibit"), offered = exhibit.values.languages ?? ["en", "ko"];
    const codes = [...new Set([...offered, ...exhibit.languages])], chosen = $("words-which").value;
    $("words-which").replaceChildren(...codes.map((code) => made("option", { value: code }, languageName(code) + (offered.includes(code) ? "" : " (not offered yet)"))));
    $("words-which").value = codes.includes(chosen) ? chosen : codes.find((code) => code !== "en") ?? codes[0];
    await openWords();
  } catch (error) {
    tell($("words-words"), error);
  }
}
async function openWords() {
  if (wordsEdit) {
    wordsEdit.gone = true;
    edits.splice(edits.indexOf(wordsEdit), 1);
  }
  const edit = new Edited("language/" + $("words-which").value, $("words-words"), [$("words-save"), $("words-forget")], drawWords);
  const want = edit.want.bind(edit);
  edit.want = (key, value) => {
    if (edit.changes.size < MOST_CHANGES || edit.changes.has(key)) return want(key, value);
    edit.redraw();
    edit.say("These are many changes: save them first.");
  };
  edit.reach = (key) => {
    $("words-find").value = key.slice("text.".length);
    edit.redraw();
  };
  edits.push(wordsEdit = edit);
  edit.say("");
  try {
    await waiting($("words-words"), "Reading…", edit.load());
    if ($("words-words").textContent === "Reading…") edit.say("");
  } catch (error) {
    if (edit.gone) return;
    $("words-body").replaceChildren();
    if (error.status === 404) edit.say("This exhibit has no words of its own in this language: it uses the program’s.");
    else tell($("words-words"), error);
  }
}

function drawWords(edit) {
  const code = $("words-which").value, wanted = $("words-find").value.trim().toLowerCase();
  const key = (field) => `${field.table}.${field.key}`;
  const row = (field) => fieldRow(edit, key(field), field, { label: field.words, lang: code, help: key(field).slice(5), usual: "", lines: field.words.length > 45 ? 2 : 0 });
  if (wanted) {
    const found = edit.fields.filter((field) => [field.words, edit.now(key(field)) ?? "", key(field)].some((words) => words.toLowerCase().includes(wanted)));
    const count = found.length === 1 ? "One text" : `${found.length} texts`;
    $("words-body").replaceChildren(made("p", {}, found.length === 0 ? "Nothing is called so." : found.length > MOST_FOUND ? `${count}; the first ${MOST_FOUND} are shown.` : count + "."),
      made("div", { className: "fields" }, ...found.slice(0, MOST_FOUND).map(row)));
    return;
  }
  const groups = Map.groupBy ? Map.groupBy(edit.fields, ({ table }) => table) : edit.fields.reduce((all, field) => all.set(field.table, [...(all.get(field.table) ?? []), field]), new Map());
  $("words-body").replaceChildren(...[...groups].map(([table, fields]) => {
    const changed = fields.some((field) => edit.changes.has(key(field))), place = made("div", { className: "fields" });
    const details = made("details", { open: changed || unfolded.has(table) }, made("summary", {}, `${table === "text.all" ? "Everywhere" : asLabel(table.slice(5).replaceAll(".", " "))} (${fields.length})`), place);
    const fill = () => { if (details.open && !place.firstChild) place.append(...fields.map(row)); };
    fill();
    details.addEventListener("toggle", () => {
      details.open ? unfolded.add(table) : unfolded.delete(table);
      fill();
    });
    return details;
  }));
}

$("words-which").addEventListener("change", () => {
  if (wordsEdit?.dirty) {
    $("words-which").value = wordsEdit.name.slice("language/".length);
    wordsEdit.say("Save your changes first, or forget them.");
    return;
  }
  openWords();
});
$("words-find").addEventListener("input", () => { if (wordsEdit?.file) wordsEdit.redraw(); });
$("words-find").addEventListener("keydown", (event) => { if (event.key === "Enter") event.preventDefault(); });
$("words-form").addEventListener("submit", (event) => { event.preventDefault(); wordsEdit.save(wantsTrial(event)); });
$("words-forget").addEventListener("click", () => wordsEdit.forget());
