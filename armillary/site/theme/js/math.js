// Renders [data-tex] with KaTeX: what is near the window at once, the rest when the browser is idle, all before print.
// window.armillaryMath.add(element) takes formulas that a script put into the page later.
// <html data-math="done"> says that nothing is waiting.
(() => {
  "use strict";
  const root = document.documentElement;
  const waiting = new Set();

  if (typeof katex === "undefined") {
    console.error("math.js: KaTeX is missing, formulas are shown as LaTeX");
    root.classList.add("no-katex");
    return;
  }

  const render = (element) => {
    waiting.delete(element);
    near.unobserve(element);
    try {
      katex.render(element.dataset.tex, element, {
        displayMode: element.tagName === "DIV",
        throwOnError: true,
        strict: "error",
        trust: false,
        output: "htmlAndMathml",
      });
    } catch (error) {
      element.classList.add("math-error");
      console.error(`math.js: ${error.message} in ${element.dataset.tex}`);
    }
  };
  const renderAll = () => {
    waiting.forEach(render);
    root.dataset.math = "done";
  };

  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) render(entry.target);
  }, { rootMargin: "600px 0px" });

  const whenIdle = window.requestIdleCallback || ((work) => setTimeout(() => {
    const end = performance.now() + 10;
    work({ timeRemaining: () => end - performance.now() });
  }, 30));
  const renderIdly = (deadline) => {
    for (const element of waiting) {
      if (deadline.timeRemaining() < 2) break;
      render(element);
    }
    if (waiting.size) whenIdle(renderIdly);
    else root.dataset.math = "done";
  };

  const add = (scope) => {
    scope.querySelectorAll("[data-tex]").forEach((element) => {
      if (element.hasChildNodes() || element.classList.contains("math-error")) return;
      waiting.add(element);
      near.observe(element);
    });
    root.dataset.math = "waiting";
    whenIdle(renderIdly);
  };

  window.armillaryMath = { add, renderAll };
  window.addEventListener("beforeprint", renderAll);
  add(document);
})();
