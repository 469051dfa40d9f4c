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

/** Which file of the exhibit a refusal is about: "missions.toml, line 3: ". */
function placeOf(said) {
  const file = (said.where ?? "").match(/(?:content|config)\/(.*?\.toml)(?::(\d+))?/);
  return file ? `${file[1]}${file[2] ? ", line " + file[2] : ""}: ` : "";
}

/** The JSON at `address`, or the answer to posting `post`. Throws what the kiosk's program says is wrong. */
async function ask(address, post) {
  const how = post ? { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(post) } : {};
  let answer;
  try {
    answer = await fetch(address, how);
  } catch {
    throw Object.assign(new Error("The program behind this page does not answer."),
      { remedy: "Start it: sudo systemctl start onggi-console. Elsewhere, start onggi-console again.", lost: true });
  }
  const said = await answer.json().catch(() => ({ what: "The answer cannot be read (" + answer.status + ").", remedy: "Wait a moment, and try again." }));
  if (!answer.ok) throw Object.assign(new Error(placeOf(said) + said.what),
    { remedy: said.remedy, said, status: answer.status, lost: answer.status === 401, out: answer.status === 401 });
  return said;
}

function tell(place, error) {
  place.replaceChildren(made("strong", {}, error.message), error.remedy ? " " + error.remedy : "");
  if (error.lost) lose(error);
}
function lose(error) {
  // What the last one saw is not for the next.
  if (error.out && edits.some((one) => one.dirty)) {
    $("lost").hidden = false;
    return $("lost").replaceChildren(made("strong", {}, "You are signed out, and what you typed is still here."), " ",
      made("a", { href: "/", target: "_blank", rel: "noopener" }, "Sign in again in another window"), ", then come back and save.");
  }
  if (error.out) {
    sessionStorage.setItem("why", "You were signed out: half an hour passed, this program was started anew, or an editor changed your name, role or passphrase.");
    return location.replace("/");
  }
  $("lost").hidden = false;
  $("lost").replaceChildren(made("strong", {}, error.message), " " + error.remedy);
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
