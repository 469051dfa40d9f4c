// Words: every text of the kiosk in one language, with the program's English beside it.
"use strict";

const MOST_FOUND = 60, MOST_CHANGES = 50; // that are checked at once
/** What each table of a language's file is about. */
const GROUPS = {
  all: t("Everywhere"), attract: t("The first screen"), clay: t("Touching the clay"), choose: t("The shelf"), tool: t("Tools"), throw: t("At the wheel"),
  lesson_keys: t("The first minute, by keys"), show: t("Shown by drawn hands"), stroke: t("Strokes by buttons"), off: t("How far off a pot is"),
  access: t("Read aloud"), hint: t("Hints at the wheel"), place: t("Places on the wall"), result: t("The result"), mission: t("Missions"),
  decorate: t("Decorating"), kiln: t("The kiln"), keepsake: t("The keepsake"), phone: t("On the phone"), gallery: t("Today’s pots"),
  postcard: t("The postcard"), sheet: t("The drawn sheet"), leaving: t("Leaving a pot"), idle: t("Are you still there?"), fault: t("When something fails"),
  help: t("Help"), comfort: t("Accessibility"), alike: t("What is alike"), plain: t("What to do next time"), remark: t("What to mend, in millimetres"),
  difference: t("What differs, in millimetres"), remark_part: t("What to mend, in parts"), difference_part: t("What differs, in parts"),
  part: t("Parts"), month: t("Months"), staff: t("For the staff"), opening: t("When the kiosk starts"),
};
const groupName = (table) => GROUPS[table.slice("text.".length)] ?? t(asLabel(table.slice("text.".length).replaceAll(".", " ")));
let wordsEdit = null;

async function showWords() {
  if (wordsEdit && wordsEdit.dirty) return;
  try {
    const exhibit = await ask("/api/edit/exhibit"), offered = exhibit.values.languages ?? ["en", "ko"];
    const codes = [...new Set([...offered, ...exhibit.languages])], chosen = $("words-which").value;
    $("words-which").replaceChildren(...codes.map((code) => made("option", { value: code }, languageName(code) + (offered.includes(code) ? "" : ` (${t("not offered yet")})`))));
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
    edit.say(t("These are many changes: save them first."));
  };
  edit.reach = (key) => {
    $("words-find").value = key.slice("text.".length);
    edit.redraw();
  };
  edits.push(wordsEdit = edit);
  edit.say("");
  try {
    await reading($("words-words"), edit.load());
  } catch (error) {
    if (edit.gone) return;
    $("words-body").replaceChildren();
    if (error.status === 404) edit.say(t("This exhibit has no words of its own in this language: it uses the program’s."));
    else tell($("words-words"), error);
  }
}

function drawWords(edit) {
  const code = $("words-which").value, wanted = $("words-find").value.trim().toLowerCase();
  const key = (field) => `${field.table}.${field.key}`;
  const row = (field) => fieldRow(edit, key(field), field, { label: field.words, labelIn: { lang: "en", dir: "ltr" }, lang: code, help: key(field).slice(5), usual: "", lines: field.words.length > 45 ? 2 : 0 });
  if (wanted) {
    const found = edit.fields.filter((field) => [field.words, edit.now(key(field)) ?? "", key(field)].some((words) => words.toLowerCase().includes(wanted)));
    const count = found.length === 0 ? t("Nothing is called so.") : tn(found.length, "One text.", "{count} texts.");
    $("words-body").replaceChildren(made("p", {}, count + (found.length > MOST_FOUND ? " " + t("The first {count} are shown.", { count: MOST_FOUND }) : "")),
      made("div", { className: "fields" }, ...found.slice(0, MOST_FOUND).map(row)));
    return;
  }
  const groups = Map.groupBy ? Map.groupBy(edit.fields, ({ table }) => table) : edit.fields.reduce((all, field) => all.set(field.table, [...(all.get(field.table) ?? []), field]), new Map());
  $("words-body").replaceChildren(...[...groups].map(([table, fields]) => {
    const changed = fields.some((field) => edit.changes.has(key(field))), place = made("div", { className: "fields" });
    const details = made("details", { open: changed || unfolded.has(table) }, made("summary", {}, `${groupName(table)} (${fields.length})`), place);
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
    wordsEdit.say(saveFirst);
    return;
  }
  openWords();
});
$("words-find").addEventListener("input", () => { if (wordsEdit?.file) wordsEdit.redraw(); });
$("words-find").addEventListener("keydown", (event) => { if (event.key === "Enter") event.preventDefault(); });
$("words-form").addEventListener("submit", (event) => { event.preventDefault(); wordsEdit.save(wantsTrial(event)); });
$("words-forget").addEventListener("click", () => wordsEdit.forget());
