(() => {
  "use strict";
  const all = (query) => [...document.querySelectorAll(query)];
  const one = (name) => document.getElementById(name);
  const folds = all("section > details");
  const chapters = all("section.checks");
  const articles = all("section.checks article");
  const equation = one("filter-equation");
  const chapter = one("filter-chapter");
  const status = one("filter-status");

  const setOpen = (open) => folds.forEach((fold) => { fold.open = open; });

  // A link leads to its target even if the chapter is closed or the target is filtered out.
  const reveal = () => {
    const target = one(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    for (let part = target; part; part = part.parentElement) {
      part.hidden = false;
      if (part.tagName === "DETAILS") part.open = true;
    }
    const own = target.querySelector(":scope > details");
    if (own) own.open = true;
    target.scrollIntoView();
  };

  const filter = () => {
    const number = equation.value.replace(/[^0-9A-Za-z.]/g, "");
    const wanted = (article) =>
      (!number || article.dataset.equations.split(" ").includes(number)) &&
      (!chapter.value || article.closest("section").id === chapter.value) &&
      (!status.value || article.dataset.status === status.value);
    const active = Boolean(number || chapter.value || status.value);
    let shown = 0;
    for (const article of articles) {
      article.hidden = !wanted(article);
      shown += article.hidden ? 0 : 1;
    }
    for (const section of chapters) {
      section.hidden = !section.querySelector("article:not([hidden])");
      if (active) section.querySelector("details").open = !section.hidden;
    }
    one("filter-count").textContent = active ? `${shown} of ${articles.length} checks` : "";
  };

  // Everything is printed, whatever is open and shown on the screen.
  let before = [];
  addEventListener("beforeprint", () => {
    before = [...folds.map((fold) => [fold, "open", fold.open]),
      ...[...articles, ...chapters].map((part) => [part, "hidden", part.hidden])];
    setOpen(true);
    for (const [part, key] of before) if (key === "hidden") part.hidden = false;
  });
  addEventListener("afterprint", () => {
    for (const [part, key, value] of before) part[key] = value;
  });

  for (const field of [equation, chapter, status]) field.addEventListener("input", filter);
  one("filters").addEventListener("submit", (event) => event.preventDefault());
  one("open-all").addEventListener("click", () => setOpen(true));
  one("close-all").addEventListener("click", () => setOpen(false));
  addEventListener("hashchange", reveal);
  one("filters").hidden = false;
  for (const fold of folds) fold.open = fold.querySelector("article[data-status='fail']") !== null;
  reveal();
})();
