// Signs in; base.js comes before it. Where nobody has a name yet, the other way in is open.
"use strict";

if (location.search.includes("code=")) {
  $("said").textContent = t("This code is not good any more: it opens once, and within an hour.");
  $("other").open = true;
} else {
  $("said").textContent = sessionStorage.getItem("why") || "";
}
sessionStorage.removeItem("why");

$("enter").addEventListener("submit", async (event) => {
  event.preventDefault();
  const body = JSON.stringify({ name: $("name").value.trim().toLowerCase(), passphrase: $("passphrase").value });
  $("said").textContent = "";
  let answer, said;
  try {
    answer = await fetch("/api/enter", { method: "POST", headers: { "Content-Type": "application/json" }, body });
    said = await answer.json();
  } catch {
    $("said").textContent = t("The program behind this page does not answer.");
    return;
  }
  if (answer.ok) return location.replace("/");
  tell($("said"), refusal(said));
  $("passphrase").value = "";
  $("passphrase").focus();
});
// Not before: the browser itself would send the form, with the passphrase in the address.
fetch("/api/door").then((answer) => answer.json()).then(({ names }) => {
  $("enter").hidden = !names;
  if (!names) $("other").open = true;
});
