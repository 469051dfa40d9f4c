// Prints the postcard as soon as it is there.
"use strict";
const card = document.getElementById("card");
if (card.complete) print();
else card.addEventListener("load", () => print());
