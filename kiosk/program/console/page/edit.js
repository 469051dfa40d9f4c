// Changing a file: what was typed is checked by the kiosk's program as it is typed, and saved in one step.
"use strict";

const saveFirst = t("Save your changes first, or forget them.");
const RANGE = { useGrouping: false, maximumFractionDigits: 10 };
const WAIT = 200; // ms after the last letter until it is checked

/** "true_height_mm" as a label: "True height". */
const asLabel = (key) => {
  const words = key.replace(/_(mm|mb|px)$/, "").replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
};

/** The value at "idle.warn_after" of nested objects; names in quotes are one. */
function valueAt(values, key) {
  let value = values;
  for (const name of key.match(/"[^"]*"|[^.]+/g)) {
    if (value === null || typeof value !== "object") return undefined;
    const bare = name.replaceAll('"', "");
    // An element of a list is meant by its id.
    value = Array.isArray(value) ? value.find((one) => one?.id === bare) : value[bare];
  }
  return value;
}
const same = (a, b) => JSON.stringify(a ?? null) === JSON.stringify(b ?? null);

/**
 * One file as it is edited. `name`: "exhibit" or "vessel/ID". `place`: where words about it stand; `draw()` shows it anew
 * after it was loaded.
 */
class Edited {
  constructor(name, place, buttons, draw) {
    Object.assign(this, { name, place, buttons, draw, changes: new Map(), faults: [], seen: new Map(), turn: 0, rows: new Map() });
    this.file = null;
  }
  get dirty() { return this.changes.size > 0; }

  async load() {
    const file = await ask(this.address(""));
    if (this.gone) return; // another file is shown by now
    this.file = file;
    this.fields = file.fields.fields;
    // What somebody else wrote meanwhile is shown beside what was typed here.
    for (const [key, wanted] of this.changes) {
      if (same(valueAt(file.values, key), wanted)) this.changes.delete(key);
    }
    this.redraw();
  }
  /** What became of the file meanwhile, by a change that was put back; whoever types goes on typing. */
  async follow() {
    const { id, selectionStart } = document.activeElement ?? {};
    await this.load();
    this.say("");
    this.check();
    if (!id || !$(id)) return;
    $(id).focus({ preventScroll: true });
    if (typeof selectionStart === "number") $(id).selectionStart = $(id).selectionEnd = selectionStart;
  }
  /** Shows it anew, with what is known of its faults. */
  redraw() {
    this.rows.clear();
    this.draw(this);
    this.found(this.faults);
  }
  address(act) { return "/api/edit/" + this.name.split("/").map(encodeURIComponent).join("/") + (act ? "/" + act : ""); }
  was(key) { return valueAt(this.file.values, key); }
  now(key) { return this.changes.has(key) ? this.changes.get(key) ?? undefined : this.was(key); }

  /** Somebody wants `value` at `key`; null takes the key out. */
  want(key, value) {
    if (!this.dirty) this.say(""); // what was said of the last change
    if (same(value, this.was(key))) this.changes.delete(key);
    else {
      if (!this.changes.has(key)) this.seen.set(key, this.was(key));
      this.changes.set(key, value);
    }
    this.soon();
  }
  /** Adds the table `key` or takes it out, with all that was typed in it. */
  setTable(key, on) {
    for (const other of [...this.changes.keys()]) if (other.startsWith(key + ".")) this.changes.delete(other);
    if (on !== (this.was(key) !== undefined)) return this.want(key, on ? {} : null);
    this.changes.delete(key);
    this.soon();
  }
  /** It is checked in a moment, unless more is typed until then. */
  soon() {
    this.show();
    clearTimeout(this.later);
    this.later = setTimeout(() => this.check(), WAIT);
  }
  drop(key) {
    this.changes.delete(key);
    this.show();
  }
  list() { return [...this.changes]; }

  async check() {
    const turn = ++this.turn;
    try {
      const { faults } = this.dirty ? await ask(this.address("check"), { changes: this.list() }) : { faults: [] };
      if (turn === this.turn) this.found(faults);
    } catch (error) {
      if (turn === this.turn) tell(this.place, error);
    }
  }
  found(faults) {
    this.faults = faults;
    for (const [key, row] of this.rows) row.fault(faults.find((fault) => fault.key === key), this.conflict(key));
    const here = faults.filter(({ key }) => this.rows.has(key)), elsewhere = faults.filter(({ key }) => !this.rows.has(key));
    const lines = elsewhere.slice(0, 2).map(({ key, what, remedy }) =>
      made("p", {}, ...inWords({ place: key && !what.startsWith(key) ? key + ": " : "", message: what, remedy, theirs: true }), ...(key && this.reach ? [this.showButton(key)] : [])));
    if (elsewhere.length > 2) lines.push(made("p", {}, tn(elsewhere.length - 2, "And one more like these.", "And {count} more like these.")));
    if (here.length > 0) lines.unshift(this.wayTo(here[0].key, tn(here.length, "One field needs you", "{count} fields need you")));
    // What has no field in sight is chosen here.
    for (const key of this.conflicts()) if (!this.rows.get(key)?.chooses) lines.push(this.choice(key));
    // What has not changed is not written again: a screen reader would begin anew.
    const now = lines.map((line) => line.textContent).join("\n");
    if (now !== this.told) this.place.replaceChildren(...lines);
    this.told = now;
    this.show();
  }
  conflicts() { return [...this.changes.keys()].filter((key) => this.conflict(key)); }
  /** Both values of `key`, and which of them stays. */
  choice(key, called = key) {
    const take = made("button", { type: "button", className: "quiet" }, t("Take theirs"));
    take.addEventListener("click", () => { this.drop(key); this.redraw(); this.check(); });
    const keep = made("button", { type: "button", className: "quiet" }, t("Keep mine"));
    keep.addEventListener("click", () => { this.seen.set(key, this.was(key)); this.found(this.faults); });
    const mine = this.rows.get(key)?.chooses ? "" : t("{field}: mine is {value}.", { field: called, value: shown(this.changes.get(key)) }) + " ";
    return made("div", { className: "theirs" }, mine + t("Theirs: {value}", { value: shown(this.was(key)) }), take, keep);
  }
  /** A button that brings the field of `key` into sight; `reach` does that. */
  showButton(key) {
    const go = made("button", { type: "button", className: "quiet" }, t("Show it"));
    go.addEventListener("click", () => {
      this.reach(key);
      this.rows.get(key)?.show();
    });
    return go;
  }
  /** A button that leads to the field of `key`. */
  wayTo(key, words) {
    const go = made("button", { type: "button", className: "quiet" }, words);
    go.addEventListener("click", () => this.rows.get(key)?.show());
    return go;
  }
  /** What somebody else wrote at `key` since this page's own change of it began; undefined: nothing. */
  conflict(key) {
    return this.changes.has(key) && !same(this.seen.get(key), this.was(key)) ? { theirs: this.was(key) } : undefined;
  }

  /** Writes it; `trying`: for five minutes, after which it is put back by itself. */
  async save(trying = false) {
    if (this.conflicts().length > 0) return;
    const sent = new Map(this.changes);
    this.stopChecking();
    try {
      this.busy = true;
      this.show();
      const begun = await ask(this.address("save"), { tag: this.file.tag, changes: [...sent], try: trying });
      const said = await outcome(begun.number, this.place, t("Looking at the whole exhibit, then saving…"));
      this.told = null;
      if (said.another_file) return await this.meanwhile();
      if (!said.done) return tell(this.place, refusal(said));
      // What was typed meanwhile stays.
      for (const [key, value] of sent) if (same(this.changes.get(key), value)) this.changes.delete(key);
      await this.load();
      if (trying) return this.say(`${t("It is tried for five minutes.")} ${t("The kiosk takes it up when no visitor is there.")}`);
      this.say([tn(said.changes.length, "Saved.", "Saved, {count} values."), t("The kiosk takes it up when no visitor is there."), t("You can take it back at the end of Settings.")].join(" "));
    } catch (error) {
      this.told = null;
      if (error.status === 412) return await this.meanwhile();
      if (error.status === 409 && error.said.faults) return this.found(error.said.faults);
      tell(this.place, error);
    } finally {
      this.busy = false;
      this.show();
    }
  }
  say(words) {
    this.told = null;
    this.place.replaceChildren(words);
  }
  /** No answer to an earlier question counts any more. */
  stopChecking() {
    clearTimeout(this.later);
    ++this.turn;
  }
  async meanwhile() {
    await this.load();
    const both = this.conflicts();
    const words = made("p", {}, made("strong", {}, t("Somebody else has changed this file meanwhile.")), " ", !this.dirty
      ? t("It says what you wanted: there is nothing left to save.")
      : both.length > 0 ? t("Where you both changed the same, choose whose value stays, then save.") : t("Theirs is shown, and yours still stands in its field: save again."));
    const first = both.find((key) => this.rows.get(key)?.chooses);
    this.place.prepend(words, ...(first ? [this.wayTo(first, t("Choose"))] : []));
    this.told = null;
    this.show();
  }
  forget() {
    this.stopChecking();
    this.changes.clear();
    this.faults = [];
    this.redraw();
  }
  show() {
    const [save, forget] = this.buttons, busy = this.busy === true;
    save.disabled = !this.dirty || this.faults.length > 0 || this.conflicts().length > 0 || busy;
    save.textContent = this.changes.size > 1 ? tn(this.changes.size, "Save one change", "Save {count} changes") : t("Save");
    const attempt = save.nextElementSibling;
    attempt.hidden = !this.dirty;
    attempt.disabled = save.disabled;
    forget.hidden = !this.dirty;
    forget.disabled = busy;
  }
}

/** Waits for what came of the change `number`. */
async function outcome(number, place, words) {
  const began = Date.now();
  for (;;) {
    const now = await ask("/api/saved?number=" + number);
    if (!now.under_way) return now.said;
    const seconds = Math.round((Date.now() - began) / 1000);
    place.replaceChildren(words + since(seconds));
    await new Promise((done) => setTimeout(done, 400));
  }
}

const since = (seconds) => (seconds > 0 ? ` (${t("{seconds} s", { seconds })})` : "");

const shown = (value) => value === undefined || value === null ? t("nothing") : typeof value === "object" && !Array.isArray(value) ? t("what stands there now") : Array.isArray(value) ? value.join(", ") : String(value);

/**
 * A row of a form: the label, an input for the field's kind, what it does, what is allowed, and what is wrong with it.
 * `how`: {label, labelIn: {lang, dir} of another language, lines: of a longer text, lang, help, called: what a choice is called}.
 */
function fieldRow(edited, key, field, how = {}) {
  const id = "field-" + edited.name.replace(/\W/g, "-") + "-" + key.replace(/\W/g, "-");
  const start = edited.now(key), usual = how.usual ?? plainDefault(field);
  let input;
  if (field.kind === "boolean") {
    input = made("input", { type: "checkbox", checked: start === undefined ? usual === "true" : start === true });
    input.addEventListener("change", () => edited.want(key, input.checked));
  } else if (field.choices) {
    const called = how.called ?? ((one) => t(one));
    input = made("select", {}, made("option", { value: "" }, usual ? t("{choice} (usual)", { choice: called(usual) }) : t("(none)")),
      ...field.choices.map((one) => made("option", { value: one }, called(one))));
    input.value = start ?? "";
    input.addEventListener("change", () => edited.want(key, input.value === "" ? null : input.value));
  } else {
    input = made(how.lines ? "textarea" : "input", { value: Array.isArray(start) ? start.join(", ") : start ?? "", placeholder: t(usual), autocomplete: "off" });
    if (how.lines) input.rows = how.lines;
    input.dir = "auto";
    if (how.lang) input.lang = how.lang;
    if (["number", "whole"].includes(field.kind)) input.inputMode = "decimal";
    input.addEventListener("input", () => edited.want(key, typed(input.value, field)));
  }
  Object.assign(input, { id });
  input.setAttribute("aria-describedby", `${id}-said ${id}-fault`);
  const fault = made("p", { className: "fault", id: id + "-fault" });
  fault.setAttribute("role", "alert");
  const called = how.label ?? t(asLabel(field.key)), words = how.help ?? t(sentence(field.words));
  const help = [words.replace(/[.。]$/, "") === called ? "" : words, how.allowed ?? allowedWords(field)].filter(Boolean).join(" ");
  const label = made("label", { htmlFor: id, ...how.labelIn }, called);
  const color = (field.allowed ?? "").includes("#RRGGBB") ? colorBeside(input) : "";
  const unit = field.unit && field.kind !== "boolean" ? made("span", { className: "unit" }, t(field.unit)) : "";
  const row = made("div", { className: "field " + (field.kind === "boolean" ? "switch" : "") },
    ...(field.kind === "boolean" ? [input, label] : [label, made("div", { className: "value" }, input, color, unit)]),
    made("p", { className: "small", id: id + "-said" }, help), fault);
  const theirs = made("div", {});
  row.append(theirs);
  edited.rows.set(key, {
    chooses: true,
    show() {
      input.scrollIntoView({ block: "center" });
      input.focus({ preventScroll: true });
    },
    fault(found, conflict) {
      const [what, remedy] = found ? atItsField(found) : ["", ""], own = ownWords(what);
      if (`${what} ${remedy}` !== fault.dataset.told) fault.replaceChildren(...(!found ? [] : own ? inWords({ message: own }) : inWords({ message: what, remedy, theirs: true })));
      fault.dataset.told = `${what} ${remedy}`;
      if (found) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
      theirs.replaceChildren(...(conflict ? [edited.choice(key)] : []));
    },
  });
  return row;
}

/** A fault as it is said at its own field: without the key's name, and without how a file would have it. */
function atItsField({ key, what, remedy }) {
  for (const name of [key, key.split(".").pop()]) if (what.startsWith(name + " ")) what = "This" + what.slice(name.length);
  return [what, remedy.replace(", without quotes", "")];
}

/** The faults that people make most, which the program puts together of figures: what they are, and what may be, in a sentence. */
const COMMON_FAULTS = [
  [/^This is (?<value>.+), but the smallest allowed value is (?<least>.+)\.$/, t("{value} is too little: at least {least}.")],
  [/^This is (?<value>.+), but the largest allowed value is (?<most>.+)\.$/, t("{value} is too much: at most {most}.")],
  [/^"(?<value>.*)" is not a (whole )?number\.$/, t("“{value}” is no number.")],
  [/^This has (?<count>\d+) letters, but there is room for only (?<most>\d+)\.$/, t("{count} letters are too many: at most {most}. A Chinese, Japanese or Korean letter may count as two.")],
  [/^This is "(?<value>.*)", which cannot be read as opening hours\.$/, t("“{value}” cannot be read as opening hours.")],
  [/^This is empty\.$/, t("This is empty.")],
  [/^This is missing\.$/, t("This is missing.")],
];
function ownWords(what) {
  if (speech.code === "en") return "";
  for (const [fault, words] of COMMON_FAULTS) {
    const found = what.match(fault);
    if (found) return filled(words, found.groups ?? {});
  }
  return "";
}

/** A colour to choose beside the one that is typed. */
function colorBeside(input) {
  const choose = made("input", { type: "color", className: "color" }), follow = () => {
    if (/^#[0-9a-f]{6}$/i.test(input.value)) choose.value = input.value;
    choose.classList.toggle("none", input.value === "");
  };
  choose.setAttribute("aria-label", t("Choose the colour"));
  follow();
  input.addEventListener("input", follow);
  choose.addEventListener("input", () => {
    input.value = choose.value.toUpperCase();
    input.dispatchEvent(new Event("input"));
  });
  return choose;
}

/** "٠٫٧" and "０．７" are 0.7. */
const westernDigits = (words) => words.replace(/[٠-٩]/g, (digit) => digit.charCodeAt(0) - 0x660).replace(/[０-９]/g, (digit) => digit.charCodeAt(0) - 0xff10).replace(/[٫．]/g, ".").replaceAll("：", ":");
/** What was typed, as the file has it; null for nothing. What is no number goes as it is, to be told so. */
function typed(words, field) {
  let text = words.trim();
  if (["number", "whole", "list"].includes(field.kind) || field.table.startsWith("hours")) text = westernDigits(text);
  if (text === "") return null;
  if (["number", "whole"].includes(field.kind)) return /^-?(\d+([.,]\d*)?|[.,]\d+)$/.test(text) ? Number(text.replace(",", ".")) : text;
  if (/one line/.test(field.allowed)) text = text.replace(/\s*\n\s*/g, " ");
  if (field.table.startsWith("hours")) text = (text.toLowerCase() === t("closed").toLowerCase() ? "closed" : text.replace(/\s*(uhr|h)\b/gi, "").replace(/(^|[-–—,\s])(\d{1,2})(?=\s*([-–—,]|$))/g, "$1$2:00"))
    .replace(/\s*[-–—]\s*/g, "-").replace(/\s*[，、،]\s*/g, ", ").replace(/(^|[-, ])(\d:)/g, "$10$2");
  if (field.kind === "texts") return text.split(/[,，、،]/).map((one) => one.trim()).filter(Boolean);
  if (field.kind === "list") return text.startsWith("[") ? text : `[${text}]`;
  return text;
}
function plainDefault(field) {
  const usual = field.default ?? "";
  return /[`\[:]/.test(usual) ? "" : usual.replaceAll('"', "");
}
const sentence = (words) => {
  const plain = words.replaceAll("`", "");
  return (/^(m,|http)/.test(plain) ? plain : plain.charAt(0).toUpperCase() + plain.slice(1)) + ".";
};
function allowedWords(field) {
  if (field.kind === "boolean" || field.choices) return "";
  if (field.least !== undefined) return t("{least} to {most}.", { least: numeral(field.least, RANGE), most: numeral(field.most, RANGE) });
  return field.allowed ? t(sentence(field.allowed)) : "";
}

/** Buttons and dragging for the order of a list. `changed` gets the ids in their new order. */
function orderable(list, changed) {
  let held = null;
  const ids = () => [...list.children].map((item) => item.dataset.id);
  list.addEventListener("click", (event) => {
    const way = event.target.dataset?.way;
    if (!way) return;
    const item = event.target.closest("li"), other = way === "up" ? item.previousElementSibling : item.nextElementSibling;
    if (!other) return;
    way === "up" ? other.before(item) : other.after(item);
    changed(ids(), item);
    // It may be drawn anew.
    list.querySelector(`[data-id="${CSS.escape(item.dataset.id)}"] [data-way="${way}"]`)?.focus();
  });
  list.addEventListener("dragstart", (event) => {
    held = event.target.closest("li");
    held.classList.add("held");
    event.dataTransfer.effectAllowed = "move";
    event.dataTransfer.setData("text/plain", held.dataset.id);
  });
  list.addEventListener("dragover", (event) => {
    const over = event.target.closest("li");
    if (!held || !over || over === held) return;
    event.preventDefault();
    const box = over.getBoundingClientRect();
    event.clientY > box.top + box.height / 2 ? over.after(held) : over.before(held);
  });
  list.addEventListener("drop", (event) => event.preventDefault());
  list.addEventListener("dragend", () => {
    if (!held) return;
    held.classList.remove("held");
    changed(ids(), held);
    held = null;
  });
}
function wayButtons(name) {
  const button = (way, sign, words) => {
    const made_ = made("button", { type: "button", className: "quiet way" }, sign);
    made_.dataset.way = way;
    made_.setAttribute("aria-label", `${words}: ${name}`);
    return made_;
  };
  return [button("up", "↑", t("Further up")), button("down", "↓", t("Further down"))];
}

addEventListener("beforeunload", (event) => { if (edits.some((one) => one.dirty)) event.preventDefault(); });

/** What was pressed: Save, or to try it. */
const wantsTrial = (event) => event.submitter?.value === "try";

for (const act of ["keep", "back"])
  $("trial-" + act).addEventListener("click", async () => {
    $("trial-keep").disabled = $("trial-back").disabled = true;
    try {
      const begun = await ask("/api/trial/" + act, {});
      if (begun.number === undefined) return $("trial-words").replaceChildren();
      const said = await outcome(begun.number, $("trial-words"), t("Looking at the whole exhibit, then putting it back…"));
      if (!said.done) tell($("trial-words"), refusal(said));
      else $("trial-words").replaceChildren();
    } catch (error) {
      tell($("trial-words"), error);
    } finally {
      $("trial-keep").disabled = $("trial-back").disabled = false;
    }
  });
