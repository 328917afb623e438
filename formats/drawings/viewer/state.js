"use strict";
// The viewer of ar3d. The build joins its modules into one script of one page, in the order of embed_viewer.cmake, and
// leaves the lines of import out; so names are unique over all modules. THREE is three.js.
import {drawFrame} from "./frame.js";

export const byId = id => document.getElementById(id);
export const stage = byId("stage");  // the canvas of the 3D picture
export const pageCount = document.querySelectorAll("script[id^='about-']").length;

/// Everything that the modules share.
export const view = {
  // What is shown.
  page: 0,  // which drawing of the page
  drawing: null,  // see data.js
  // Where its points are in the scene, see spaceOf in layers.js.
  space: {
    matrix: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], centre: [0, 0, 0], size: [1, 1, 1], unit: 1, radius: 1, flatness: 1,
  },
  grown: 0,  // how many vertices are shown, in the order of growth
  selected: null,  // {kind: "vertex" | "edge" | "bend", ...}, see pick.js
  violation: -1,  // which one of the list is shown
  steppedVertex: 0,  // whose edges the key e goes through
  followed: null,  // the edge along which the camera flies

  // How it is shown.
  colours: "role",
  stretch: false,
  names: false,
  dark: matchMedia("(prefers-color-scheme: dark)").matches,
  thickness: 0,
  palette: [],  // red, green, blue from 0 to 255 of each role or direction
  solidPalette: [],  // the same as colours of three.js
  markColour: null,  // of what is selected
  ballColour: null,  // of vertices

  // From where.
  renderer: null,
  camera: null,
  controls: null,
  flight: null,  // the camera's way to another place, see cameras.js
  height: 0,  // of the picture at the last resize, in pixels
  fitHeight: 0,  // of the scene seen when the whole drawing is, 0: not known yet
  meanLength: 0,  // of the drawing's segments in the scene
  boundSize: null,  // of the theorem's box
  boundRadius: 0,

  // The picture that is made.
  ready: 0,  // when the page was, 0: not yet
  settled: 0,  // when the resting picture was whole, 0: not yet
  moving: false,  // the camera moves: only what can be drawn in time is drawn
  fresh: true,  // the picture begins anew, nothing of the last one stays
  frames: null,  // times between frames while moving, in ms
  movingRatio: 0,  // pixels of the picture to one of the page while moving, 0: as many as there are
  level: "",  // of detail in the last frame: "tubes", "lines" or "density"
};

/// Shows clear words instead of a blank page.
export function tellProblem(text) {
  byId("problem").textContent = text;
  byId("problem").hidden = !text;
}

/// Asks for a frame; many calls give one.
let askedFrame = 0;
export function askForFrame() {
  if (askedFrame) return;
  askedFrame = requestAnimationFrame(time => {
    askedFrame = 0;
    drawFrame(time);
  });
}

/// A new picture is due.
export function redraw() {
  view.fresh = true;
  askForFrame();
}
