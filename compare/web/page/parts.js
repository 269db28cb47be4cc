// SPDX-License-Identifier: MIT
// Where do the parts that only a live page has stand among those that all pages share?

/// The page as it came, before it drew anything.
const PAGE_AS_IT_CAME = document.documentElement.outerHTML;

byId("stage-column").before(byId("live-parts").content.cloneNode(true));
byId("files").after(element("p", {class: "tools", id: "gifts"}));
byId("gifts").append(byId("live-gifts").content.cloneNode(true));
// What is said of a run stands below it: a person looks at the stage while turning its numbers.
document.querySelector(".bench").after(byId("partings"), element("p", {class: "tools"},
    element("button", {type: "button", id: "look-closer", title: "Runs each engine with smaller steps, too"},
        "Why do they part?")),
    byId("unsupported"));
byId("controls").after(byId("scene-changed"));
