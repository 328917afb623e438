// The parts of Observable Plot that pages use.
export {areaY, axisX, axisY, barY, dot, gridX, gridY, line, link, plot, text} from "@observablehq/plot";
