// Light or dark: the system's choice until the reader makes another, which is kept. Runs in the head, before anything is drawn.
(() => {
  "use strict";
  const KEY = "armillary-scheme";
  const root = document.documentElement;
  const system = window.matchMedia("(prefers-color-scheme: dark)");

  root.classList.add("js");

  // A browser may refuse storage, most likely for file://; then the choice lasts for the page.
  const kept = () => {
    try { return localStorage.getItem(KEY); } catch { return null; }
  };
  const keep = (scheme) => {
    try { scheme ? localStorage.setItem(KEY, scheme) : localStorage.removeItem(KEY); } catch { /* see above */ }
  };
  const apply = (scheme) => {
    if (scheme === "light" || scheme === "dark") root.dataset.scheme = scheme;
    else delete root.dataset.scheme;
  };
  const isDark = () => (root.dataset.scheme ? root.dataset.scheme === "dark" : system.matches);

  apply(kept());

  document.addEventListener("DOMContentLoaded", () => {
    const button = document.querySelector(".scheme-switch");
    if (!button) return;
    const show = () => button.setAttribute("aria-pressed", String(isDark()));
    show();
    system.addEventListener("change", show);
    button.addEventListener("click", () => {
      const wanted = isDark() ? "light" : "dark";
      const own = wanted === (system.matches ? "dark" : "light") ? null : wanted;
      keep(own);
      apply(own);
      show();
    });
  });
})();
