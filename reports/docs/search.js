// The pages' own search. The script `site` writes places.js: [heading, page, address, text in small letters] of every heading.
// PAGE.html?search=WORDS opens with what is found; the key / goes to the field, Enter to the first place.
addEventListener("DOMContentLoaded", () => {
  const field = document.querySelector("nav input");
  const list = document.querySelector("nav ol");
  const most = 12;

  const load = () => {
    const script = document.createElement("script");
    script.src = "places.js";
    script.onload = show;
    document.head.append(script);
  };
  field.addEventListener("focus", load, { once: true });

  // plumb::Want, contact.normal and solve() are the words in them.
  const wordsOf = (typed) => typed.toLowerCase().split(/[\s:.(),]+/).filter(Boolean);
  const same = (a, b) => a.join(" ") === b.join(" ");

  // A word in the heading counts more than one in the text; a heading that begins with it more, one that is the words most.
  const worth = ([heading, page, , text], words) => {
    const head = heading.toLowerCase();
    let sum = same(wordsOf(head), words) || same(wordsOf(head), ["plumb", ...words]) ? 500 : 0;
    for (const word of words) {
      if (head.startsWith(word)) sum += 100;
      else if (head.includes(word)) sum += 30;
      else if (page.toLowerCase().includes(word)) sum += 5;
      else if (text.includes(word)) sum += 1;
      else return 0;
    }
    return sum;
  };

  const entry = ([heading, page, address]) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = address;
    link.textContent = heading === page ? heading : `${heading} · ${page}`;
    item.append(link);
    return item;
  };

  // Of a page's places with one heading the best.
  const isFirst = ([, [heading, page]], at, all) => all.findIndex(([, other]) => other[0] === heading && other[1] === page) === at;

  function show() {
    const words = wordsOf(field.value);
    const found = words.length && window.places ? window.places.map((place) => [worth(place, words), place]) : [];
    const best = found.filter(([sum]) => sum > 0).sort(([a], [b]) => b - a).filter(isFirst).slice(0, most);
    list.replaceChildren(...best.map(([, place]) => entry(place)));
    if (words.length && window.places && !best.length) list.textContent = "nothing found";
  }
  field.addEventListener("input", show);
  field.addEventListener("keydown", (event) => event.key === "Enter" && list.querySelector("a")?.click());
  addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.target === field) return;
    event.preventDefault();
    field.focus();
  });

  field.value = new URLSearchParams(location.search).get("search") ?? "";
  if (field.value) load();
});
