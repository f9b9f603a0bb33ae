/* tests/house/reference/search.js -- finds names and words in the pages of `make docs`, offline
 * SPDX-License-Identifier: MIT
 *
 * index.js gives `names`: [name, address, what it does] for each function, structure and recipe.
 */
"use strict";
const input = document.querySelector("input");
const list = document.querySelector("#found");
const MOST = 60;

const NOT = 20;

/* The less, the nearer: a name that is it, begins so, has it; a sentence that has it. */
function distance(name, text, word) {
    if (name === word || name === "loft_" + word) return 0;
    if (name.startsWith(word) || name.startsWith("loft_" + word)) return 1;
    if (name.split("_").includes(word)) return 2;
    if (name.includes(word)) return 3;
    if (text.split(/\W+/).includes(word)) return 5;
    return text.includes(word) ? 8 : NOT;
}

function found(query) {
    const words = query.toLowerCase().split(/[\s_]+/).filter((w) => w && w !== "loft");
    const rows = [];
    if (!words.length) return rows;
    for (const row of names) {
        const name = row[0].toLowerCase(), text = row[2].toLowerCase();
        let sum = 0;
        for (const word of words) sum += distance(name, text, word);
        if (sum < NOT * words.length) rows.push([sum, row]);
    }
    return rows.sort((a, b) => a[0] - b[0] || a[1][0].length - b[1][0].length).slice(0, MOST);
}

function show() {
    list.textContent = "";
    for (const [, [name, address, text]] of found(input.value)) {
        const item = list.appendChild(document.createElement("li"));
        const link = item.appendChild(document.createElement("a"));
        link.href = address;
        link.appendChild(document.createElement("code")).textContent = name;
        link.appendChild(document.createElement("small")).textContent = text;
    }
    if (!list.firstChild && input.value.trim())
        list.appendChild(document.createElement("li")).textContent = "nothing is named so";
}

input.addEventListener("input", show);
document.addEventListener("keydown", (event) => {
    const links = [...list.querySelectorAll("a")], at = links.indexOf(document.activeElement);
    if (event.key === "/" && document.activeElement !== input) {
        event.preventDefault();
        input.focus();
    } else if (event.key === "Escape") {
        input.value = "";
        show();
    } else if (event.key === "Enter" && document.activeElement === input && links.length) {
        event.preventDefault();
        links[0].click();
    } else if (links.length && (event.key === "ArrowDown" || event.key === "ArrowUp")) {
        event.preventDefault();
        (links[at + (event.key === "ArrowDown" ? 1 : -1)] || input).focus();
    }
});
document.addEventListener("click", (event) => {
    if (!event.target.closest("form") || event.target.closest("#found a")) list.textContent = "";
});
