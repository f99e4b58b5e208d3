// Search over the index that the build wraps as a script (file:// allows no fetch). Loaded when the box is first focused.
(() => {
  "use strict";
  const MOST = 20;
  const form = document.querySelector(".search");
  if (!form) return;
  const input = form.querySelector("input");
  const panel = form.querySelector(".search-panel");
  const status = form.querySelector(".search-status");
  const list = form.querySelector("ul");
  const base = document.documentElement.dataset.base;

  const plain = (text) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
  const words = (text) => plain(text).match(/[\p{L}\p{N}]+/gu) || [];

  let sections = null; // null: not asked for; []: on its way or empty

  // The index holds each page whole, and each of its sections again. A page's first heading repeats the page: it is left out.
  const prepare = (index) => {
    const pages = new Map(index.docs.filter((doc) => !doc.location.includes("#")).map((doc) => [doc.location, doc.title]));
    sections = index.docs.map((doc) => {
      const [path, anchor] = doc.location.split("#");
      const page = anchor ? pages.get(path) : null;
      return { ...doc, path, page, titleWords: words(doc.title), pageText: plain(page || ""), text: doc.text.replace(/\s+/g, " ").trim(), spaced: ` ${words(doc.text).join(" ")}` };
    }).filter(({ page, title }) => page !== title);
  };

  const load = () => {
    if (sections) return;
    sections = [];
    const script = document.createElement("script");
    script.src = form.dataset.index;
    script.addEventListener("load", () => { prepare(window.armillarySearchIndex); search(); });
    script.addEventListener("error", () => { sections = null; say("The search index is missing from this copy of the site."); });
    document.head.append(script);
  };

  // Every term must occur. A title counts more than text, a whole word more than its beginning and that more than its middle, a section's text more than its page's.
  const score = (section, terms) => {
    let total = 0;
    for (const term of terms) {
      let best = 0;
      for (const word of section.titleWords) {
        if (word === term) best = Math.max(best, 12);
        else if (word.startsWith(term)) best = Math.max(best, 7);
        else if (word.includes(term)) best = Math.max(best, 3);
      }
      const count = (part) => Math.min(section.spaced.split(part).length - 1, 4);
      best += (count(` ${term}`) + 0.2 * count(term)) * (section.page ? 1 : 0.4);
      if (section.pageText.includes(term)) best += 1;
      if (!best) return 0;
      total += best;
    }
    return total + (section.page ? 0 : 0.5);
  };

  // Best first. A page is named for its own title; else its sections stand for it, where they are found.
  const ranked = (terms) => {
    const hits = sections.map((section) => ({ section, value: score(section, terms) })).filter(({ value }) => value > 0);
    const told = new Set(hits.filter(({ section }) => section.page).map(({ section }) => section.path));
    const named = ({ titleWords }) => terms.some((term) => titleWords.some((word) => word.includes(term)));
    return hits
      .filter(({ section }) => section.page || named(section) || !told.has(section.path))
      .sort((a, b) => b.value - a.value);
  };

  const marked = (text, terms) => {
    const out = document.createDocumentFragment();
    const pattern = new RegExp(`(${terms.join("|")})`, "giu"); // terms are letters and digits
    text.split(pattern).forEach((part, i) => {
      if (i % 2 === 0) return out.append(part);
      const hit = document.createElement("mark");
      hit.textContent = part;
      out.append(hit);
    });
    return out;
  };
  const excerpt = (section, terms) => {
    const { text } = section;
    const found = terms.map((term) => plain(text).indexOf(term)).filter((at) => at >= 0);
    const from = Math.max(0, Math.min(...found, text.length) - 50);
    const start = from === 0 || !found.length ? 0 : text.indexOf(" ", from) + 1;
    return (start ? "… " : "") + text.slice(start, start + 150) + (text.length > start + 150 ? " …" : "");
  };
  const element = (tag, name, ...content) => {
    const made = document.createElement(tag);
    if (name) made.className = name;
    made.append(...content);
    return made;
  };
  const result = (section, terms) => {
    const link = element("a", "", element("span", "search-title", marked(section.title, terms)));
    if (section.page && section.page !== section.title) link.firstChild.append(element("span", "search-place", ` · ${section.page}`));
    link.append(element("span", "search-text", marked(excerpt(section, terms), terms)));
    link.href = `${base}/${section.location}`;
    return element("li", "", link);
  };

  const say = (text) => {
    status.textContent = text;
    panel.hidden = !text;
  };
  const search = () => {
    const terms = [...new Set(words(input.value))];
    list.replaceChildren();
    if (!terms.length || !sections) return say("");
    const found = ranked(terms);
    list.append(...found.slice(0, MOST).map(({ section }) => result(section, terms)));
    say(found.length > MOST ? `The best ${MOST} of ${found.length} places` : found.length === 1 ? "1 place" : found.length ? `${found.length} places` : "Nothing found");
  };

  input.addEventListener("focus", () => { load(); if (input.value) search(); });
  input.addEventListener("input", search);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = list.querySelector("a");
    if (first) first.click();
  });
  list.addEventListener("click", () => { panel.hidden = true; }); // the place may be on this very page
  form.addEventListener("keydown", (event) => {
    const stops = [input, ...list.querySelectorAll("a")];
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") {
      input.focus();
      panel.hidden = true;
    } else if (step) {
      event.preventDefault();
      const next = stops[stops.indexOf(document.activeElement) + step];
      if (next) next.focus();
    }
  });
  document.addEventListener("click", (event) => { if (!form.contains(event.target)) panel.hidden = true; });
  form.addEventListener("focusout", (event) => { if (event.relatedTarget && !form.contains(event.relatedTarget)) panel.hidden = true; });
  document.addEventListener("keydown", (event) => {
    const typing = /^(input|textarea|select)$/i.test(event.target.tagName) || event.target.isContentEditable;
    if (event.key !== "/" || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    input.focus();
  });
})();
