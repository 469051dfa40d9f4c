// What every part of the staff's page uses. What others wrote (names, labels, problems) is only ever text.
"use strict";

const $ = (id) => document.getElementById(id);
const edits = []; // every file that is being changed (edit.js)
/** An element: made("li", {className: "good"}, "text", otherElement). */
function made(tag, fields, ...inside) {
  const element = Object.assign(document.createElement(tag), fields);
  element.append(...inside);
  return element;
}

// ---- The page's language: English as it stands here, other languages' words by it (content/staff)

const speech = { code: "en", names: {}, words: new Map() }; // names: of the other languages that there are
let plurals = new Intl.PluralRules("en");
/** In words from right to left, "12 GB" stays as it is by marks around it. */
const isolated = (value) => (document.documentElement.dir === "rtl" ? `\u2068${value}\u2069` : value);
const filled = (words, values) => words.replace(/\{(\w+)\}/g, (braces, name) => (Object.hasOwn(values, name) ? isolated(values[name]) : braces));
/** `english` in the page's language, with `values` for what stands in braces. */
const t = (english, values = {}) => filled(speech.words.get(english) ?? english, values);
const listed = (names) => names.reduce((all, name) => (all ? t("{all}, {name}", { all, name }) : name), "");
/** 12345.6 as people write it here; `how`: {useGrouping: false} for a number that somebody types again. */
const numeral = (number, how = {}) => number.toLocaleString(speech.code + "-u-nu-latn", how);
/** The same for a number of things; a language may have more forms than `one` and `many`. {count} is the number. */
function tn(count, one, many, values = {}) {
  const forms = speech.words.get(many) ?? (count === 1 ? one : many);
  return filled(typeof forms === "string" ? forms : forms[plurals.select(count)] ?? forms.other, { count: numeral(count), ...values });
}
/** What the kiosk's program said: in the page's language where that has it, else in English, and marked so. */
const quoted = (words) => (speech.code === "en" || speech.words.has(words) ? t(words) : made("span", { lang: "en", dir: "ltr" }, words));

/** Puts the page's words in place of the English ones in `root`, but not in place of people's names. */
function translate(root) {
  if (speech.code === "en") return;
  const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT, (node) => (node.parentElement.closest("[translate='no']") ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT));
  while (texts.nextNode()) {
    const words = texts.currentNode.data.trim();
    if (words) texts.currentNode.data = texts.currentNode.data.replace(words, () => t(words));
  }
  for (const name of ["placeholder", "title", "aria-label"])
    for (const element of root.querySelectorAll(`[${name}]`)) element.setAttribute(name, t(element.getAttribute(name)));
}

const learn = (words) => { for (const [english, own] of Object.entries(words)) speech.words.set(english, own); };
// Late words are no reason to wait any longer: the page speaks English then.
const wordsAt = (address) => fetch(address, { signal: AbortSignal.timeout(5000) }).then((answer) => answer.json());
/** What this browser keeps under `key`, for good ("localStorage") or until the window is closed. A browser may forbid it. */
function kept(storage, key, value) {
  try {
    if (value !== undefined) window[storage].setItem(key, value);
    return window[storage].getItem(key);
  } catch {
    return null;
  }
}
/** The language that somebody chose here, else the first of the browser's that there is. */
async function speak() {
  speech.names = await wordsAt("/words");
  offerLanguages();
  const wanted = [kept("localStorage", "language"), ...navigator.languages.map((one) => one.split("-")[0])];
  const code = wanted.find((one) => one === "en" || Object.hasOwn(speech.names, one)) ?? "en";
  if (code !== "en") {
    const language = await wordsAt("/words/" + code);
    learn(language.page);
    speech.code = document.documentElement.lang = code;
    document.documentElement.dir = language.right_to_left ? "rtl" : "ltr";
    plurals = new Intl.PluralRules(code);
    document.title = t(document.title);
    translate(document.body);
  }
  $("speak").value = code;
}
function offerLanguages() {
  $("speak").replaceChildren(...Object.entries({ ...speech.names, en: "English" }).map(([value, name]) => made("option", { value, lang: value }, name)));
  $("speak").value = "en";
  $("speak").hidden = $("speak").options.length < 2;
  $("speak").addEventListener("change", () => {
    const dirty = edits.find((one) => one.dirty);
    if (!dirty) {
      kept("localStorage", "language", $("speak").value);
      return location.reload();
    }
    $("speak").value = speech.code;
    dirty.say(saveFirst);
  });
}
const languageName = (code) => {
  try {
    return new Intl.DisplayNames([speech.code], { type: "language" }).of(code) || code;
  } catch {
    return code;
  }
};
/** The words that editors alone need, and the parts of the page that say them. */
async function speakOfEditing() {
  if (speech.code === "en") return;
  learn((await wordsAt(`/words/${speech.code}/editors`)).editors);
  for (const root of document.querySelectorAll("[data-editors]")) translate(root);
}

/** Runs /NAME.js. */
const run = (name) => new Promise((done, failed) => {
  const script = made("script", { src: `/${name}.js` });
  script.addEventListener("load", done);
  script.addEventListener("error", () => failed(trouble(t("A part of this page did not come."), t("Load it again."))));
  document.head.append(script);
});
const { first } = document.currentScript.dataset;
// In English, where the words do not come.
speak().catch(() => {}).then(() => run(first)).catch(lose);

const placeIn = (file, line) => (line ? t("{file}, line {line}", { file, line }) : file);
/** Which file of the exhibit a refusal is about: "missions.toml, line 3: ". */
function placeOf(said) {
  const file = (said.where ?? "").match(/(?:content|config)\/(.*?\.toml)(?::(\d+))?/);
  return file ? placeIn(file[1], file[2]) + ": " : "";
}

/** The JSON at `address`, or the answer to posting `post`. Throws what the kiosk's program says is wrong. */
async function ask(address, post) {
  const how = post ? { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(post) } : {};
  let answer;
  try {
    answer = await fetch(address, how);
  } catch {
    throw trouble(t("The program behind this page does not answer."),
      t("Start it: sudo systemctl start onggi-console. Elsewhere, start onggi-console again."), { lost: true });
  }
  const said = await answer.json().catch(() => ({ what: "The answer cannot be read.", remedy: "Wait a moment, and try again." }));
  if (!answer.ok) throw refusal(said, { said, status: answer.status, lost: answer.status === 401, out: answer.status === 401 });
  return said;
}

/** Something that is wrong, and what to do about it. `more`: lost (no answer, or none to this browser), out (signed out). */
const trouble = (what, remedy, more = {}) => Object.assign(new Error(what), { remedy, ...more });
/** What the kiosk's program refused, and why. */
const refusal = (said, more = {}) => trouble(said.what, said.remedy, { place: placeOf(said), theirs: true, ...more });
function inWords({ place = "", message, remedy, theirs }) {
  const known = (words) => !theirs || speech.code === "en" || speech.words.has(words), say = theirs ? quoted : (words) => words;
  const words = (of) => [made("strong", {}, place, of(message)), ...(remedy ? [" ", of(remedy)] : [])];
  // Both in English: they stand in its order, also on a page from right to left.
  return known(message) || known(remedy) ? words(say) : [made("span", { lang: "en", dir: "ltr" }, ...words((english) => english))];
}
const faultWords = (found) => (found ? inWords(refusal(found)) : []);
function tell(place, error) {
  place.replaceChildren(...inWords(error));
  if (error.lost) lose(error);
}
function lose(error) {
  // What the last one saw is not for the next.
  if (error.out && edits.some((one) => one.dirty)) {
    $("lost").hidden = false;
    return $("lost").replaceChildren(made("strong", {}, t("You are signed out, and what you typed is still here.")), " ",
      made("a", { href: "/", target: "_blank", rel: "noopener" }, t("Sign in again in another window, then come back and save.")));
  }
  if (error.out) {
    kept("sessionStorage", "why", t("You were signed out: half an hour passed, this program was started anew, or an editor changed your name, role or passphrase."));
    return location.replace("/");
  }
  $("lost").hidden = false;
  $("lost").replaceChildren(...inWords(error));
}

/** Says that it is being read, until it is. */
async function reading(place, work) {
  const words = t("Reading…"), read = await waiting(place, words, work);
  if (place.textContent === words) place.replaceChildren();
  return read;
}
/** Waits of more than a moment are said. */
async function waiting(place, words, work) {
  const late = setTimeout(() => place.replaceChildren(words), 300);
  try {
    return await work;
  } finally {
    clearTimeout(late);
  }
}
