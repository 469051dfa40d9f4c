// Seen first: a screen as visitors would see it, with what is typed and not saved yet. The kiosk's own program draws it.
"use strict";

const SCREENS = {
  attract: t("The first screen"), language: t("The choice of language"), choose: t("The shelf"), comfort: t("Accessibility"), label: t("A label"),
  throw: t("At the wheel"), help: t("Help at the wheel"), result: t("The result"), decorate: t("Decorating"), kiln: t("The kiln"), keepsake: t("The keepsake"),
};
const COMFORTS = {
  larger_text: t("Larger text"), high_contrast: t("High contrast"), low_reach: t("Low reach"), left_handed: t("Left hand"), reduced_motion: t("Less motion"), one_switch: t("One switch"),
};
const SECONDS = { throw: 8, help: 7, result: 11, decorate: 12, kiln: 12, keepsake: 15 }; // on a quiet machine without a graphics card; others 6
let looking = null; // {edit, turn}: the form whose changes are seen

/** The screen that shows best what a file is about. */
function screenFor(edit) {
  if (edit === shelfEdit || edit.name === "missions") return "choose";
  if (edit.name.startsWith("vessel/")) return "label";
  if (edit.name === "glazes") return "kiln";
  return edit === sceneChoice || edit.name.startsWith("scene/") || LISTS[edit.name] ? "throw" : "attract";
}
const chosen = (place, all, now) => {
  place.replaceChildren(...all.map(([value, words]) => made("option", { value }, words)));
  if (all.some(([value]) => value === now)) place.value = now;
};

async function openLook(edit) {
  if (looking) return; // a second click
  looking = { edit, turn: 0 };
  $("look-words").replaceChildren();
  $("look-pictures").replaceChildren();
  $("look").showModal();
  try {
    const [exhibit, shelf] = await Promise.all([ask("/api/edit/exhibit"), ask("/api/shelf")]);
    if (looking?.edit !== edit) return;
    const of = edit.name === "exhibit" ? (key) => edit.now(key) : (key) => exhibit.values[key];
    const languages = of("languages") ?? ["en", "ko"], hidden = of("hidden") ?? [];
    const own = edit.name.startsWith("vessel/") ? edit.name.slice(7) : undefined; // which visitors need not see yet
    const seen = shelf.filter(({ id, unfinished }) => id === own || (!hidden.includes(id) && !unfinished));
    const title = ({ id, titles }) => titles[speech.code] || titles[languages[0]] || titles.en || id.replaceAll("_", " ");
    chosen($("look-screen"), Object.entries(SCREENS), screenFor(edit));
    chosen($("look-language"), languages.map((code) => [code, languageName(code)]), edit.name.startsWith("language/") ? edit.name.slice(9) : languages.includes(speech.code) ? speech.code : languages[0]);
    chosen($("look-vessel"), seen.map((vessel) => [vessel.id, title(vessel)]), own);
    chosen($("look-comfort"), [["", t("As every visit begins")], ...Object.entries(COMFORTS)], "");
    drawLook();
  } catch (error) {
    tell($("look-words"), error);
  }
}

/** Draws what is chosen, and again when a visitor has gone who came between. */
async function drawLook() {
  const at = looking, turn = ++at.turn, current = () => looking === at && at.turn === turn;
  const place = $("look-words"), screen = $("look-screen").value;
  $("look-vessel").disabled = ["attract", "language", "choose", "comfort"].includes(screen);
  $("look-pictures").classList.add("old");
  const file = at.edit.file ? { file: at.edit.name, changes: at.edit.list() } : {};
  while (current()) {
    try {
      await ask("/api/screen/stop", {});
      const { number } = await ask("/api/screen", { screen, language: $("look-language").value, comfort: $("look-comfort").value,
        vessel: $("look-vessel").disabled ? "" : $("look-vessel").value, ...file });
      const drawn = await drawnLook(number, SECONDS[screen] ?? 6, current);
      if (!current()) return;
      if (drawn.what) return tell(place, refusal(drawn));
      if (drawn.pictures.length > 0) return showLook(drawn.pictures);
    } catch (error) {
      if (!current()) return;
      if (error.said?.faults) return tell(place, refusal(error.said.faults[0]));
      if (error.status === 409 && error.said.visitor) tell(place, error);
      else if (error.status !== 503) return tell(place, error);
    }
    await new Promise((done) => setTimeout(done, 1000));
  }
}
async function drawnLook(number, usual, current) {
  for (let half = 0; ; ++half) {
    const now = await ask("/api/screen?number=" + number);
    if (!now.drawing || !current()) return now;
    const seconds = Math.floor(half / 2);
    if (half > 0) $("look-words").replaceChildren(seconds > 2 * usual ? t("The kiosk’s program draws it… {seconds} s, more than usual: the machine is busy", { seconds })
      : t("The kiosk’s program draws it… {seconds} s of about {usual}", { seconds, usual }));
    await new Promise((done) => setTimeout(done, 500));
  }
}
function showLook(pictures) {
  const changed = looking.edit.dirty ? t("With what is not saved yet. Nothing is changed.") : t("As it is now.");
  $("look-words").replaceChildren(changed);
  $("look-pictures").classList.remove("old");
  $("look-pictures").replaceChildren(...pictures.map(({ at, width, height }) => {
    const words = `${width > height ? t("Landscape") : t("Portrait")}, ${width} × ${height}`;
    const link = made("a", { href: at, target: "_blank", rel: "noopener" }, made("img", { src: at, alt: `${$("look-screen").selectedOptions[0].textContent}, ${words}`, width, height }));
    return made("figure", { className: width > height ? "landscape" : "portrait" }, link, made("figcaption", { className: "small" }, words));
  }));
}
function closeLook() {
  if (!looking) return;
  looking = null;
  ask("/api/screen/stop", {}).catch(() => {});
}

for (const one of ["screen", "language", "vessel", "comfort"]) $("look-" + one).addEventListener("change", drawLook);
$("look-close").addEventListener("click", () => $("look").close());
$("look").addEventListener("close", closeLook);
for (const button of document.querySelectorAll(".bar .see"))
  button.addEventListener("click", () => {
    const edit = edits.find((one) => button.parentElement.contains(one.buttons[0]) && !one.gone);
    if (edit?.file) openLook(edit);
  });
