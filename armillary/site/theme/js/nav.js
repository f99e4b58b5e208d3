// The menu of narrow windows, and the mark beside the heading that is being read.
(() => {
  "use strict";
  const menu = document.querySelector(".menu-switch");
  const nav = document.getElementById("site-nav");
  if (menu && nav) {
    const show = (open) => {
      nav.classList.toggle("open", open);
      menu.setAttribute("aria-expanded", String(open));
    };
    menu.addEventListener("click", () => show(!nav.classList.contains("open")));
    nav.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !nav.classList.contains("open")) return;
      show(false);
      menu.focus();
    });
    const here = nav.querySelector("[aria-current]");
    if (here && nav.scrollHeight > nav.clientHeight) nav.scrollTop = here.offsetTop - nav.clientHeight / 2;
  }

  const toc = document.querySelector(".toc");
  if (!toc) return;
  if (!window.matchMedia("(min-width: 80rem)").matches) toc.open = false;

  const links = [...toc.querySelectorAll("a")];
  const headings = links.map((link) => document.getElementById(decodeURIComponent(link.hash.slice(1))));
  let asked = false;
  const mark = () => {
    asked = false;
    let current = -1;
    headings.forEach((heading, i) => {
      if (heading && heading.getBoundingClientRect().top < 140) current = i;
    });
    links.forEach((link, i) => {
      if (i === current) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
  };
  const ask = () => {
    if (!asked) requestAnimationFrame(mark);
    asked = true;
  };
  window.addEventListener("scroll", ask, { passive: true });
  ask();
})();
