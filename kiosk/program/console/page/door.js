// Signs in; base.js comes before it. Where nobody has a name yet, the other way in is open.
"use strict";

if (location.search.includes("code=")) {
  $("said").textContent = t("This code is not good any more: it opens once, and within an hour.");
  $("other").open = true;
} else {
  $("said").textContent = kept("sessionStorage", "why") ?? "";
}
kept("sessionStorage", "why", "");

$("enter").addEventListener("submit", async (event) => {
  event.preventDefault();
  const body = { name: $("name").value.trim().toLowerCase(), passphrase: $("passphrase").value };
  $("said").textContent = "";
  try {
    await ask("/api/enter", body);
    return location.replace("/");
  } catch (error) {
    $("said").replaceChildren(...inWords(error));
  }
  $("passphrase").value = "";
  $("passphrase").focus();
});
// Not before: the browser itself would send the form, with the passphrase in the address.
ask("/api/door").then(({ names }) => {
  $("enter").hidden = !names;
  if (!names) $("other").open = true;
}).catch((error) => $("said").replaceChildren(...inWords(error)));
