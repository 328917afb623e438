"use strict";
// The viewer of ar3d. Its scripts are one after the other in one page and share their names; three.js is THREE.

const byId = id => document.getElementById(id);
const pageCount = document.querySelectorAll("script[id^='about-']").length;

/// Everything that the parts of the viewer share: the drawing shown, what is selected, how it is shown.
const view = {
  page: 0,           // which drawing of the page
  drawing: null,     // see data.js
  space: null,       // where its points are in the scene, see layers.js
  grown: 0,          // how many vertices are shown, in the order of growth
  selected: null,    // {kind: "vertex" | "edge" | "bend", ...}, see pick.js
  violation: -1,     // which one of the list is shown
  colours: "role",
  stretch: false,
  names: false,
  dark: matchMedia("(prefers-color-scheme: dark)").matches,
  thickness: 0,
  moving: false,     // the camera moves: draw only what can be drawn in time
  frames: null,      // times between frames while moving, in ms
};

/// Clear words instead of a blank page.
function tellProblem(text) {
  byId("problem").textContent = text;
  byId("problem").hidden = !text;
}

/// A picture is due; many calls give one.
let asked = 0;
function redraw() {
  view.fresh = true;
  if (!asked) asked = requestAnimationFrame(time => { asked = 0; drawFrame(time); });
}
