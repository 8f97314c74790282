// The pages' own search. The script `site` writes places.js: [heading, page, address, text in small letters] of every heading.
addEventListener("DOMContentLoaded", () => {
  const field = document.querySelector("nav input");
  const list = document.querySelector("nav ol");
  const most = 12;

  field.addEventListener("focus", () => {
    const script = document.createElement("script");
    script.src = "places.js";
    script.onload = show;
    document.head.append(script);
  }, { once: true });

  // A word in the heading counts more than one in the text; a heading that begins with it most.
  const worth = ([heading, page, , text], words) => {
    const head = heading.toLowerCase();
    let sum = 0;
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

  function show() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length && window.places ? window.places.map((place) => [worth(place, words), place]) : [];
    const best = found.filter(([sum]) => sum > 0).sort(([a], [b]) => b - a).slice(0, most);
    list.replaceChildren(...best.map(([, place]) => entry(place)));
    if (words.length && window.places && !best.length) list.textContent = "nothing found";
  }
  field.addEventListener("input", show);
});
