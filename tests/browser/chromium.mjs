// What the page tests share: headless Chromium, which draws in software, and what pages complain of and ask for.
// AR3D_PROGRAM names the program; screenshots go to AR3D_SCREENSHOTS if that is set.
import {mkdirSync} from "node:fs";
import {join} from "node:path";
import {chromium} from "playwright-core";

export const program = process.env.AR3D_PROGRAM;
export const complaints = [], requests = [];
const shots = process.env.AR3D_SCREENSHOTS;
const flags = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];

/** A browser whose pages are waited for up to two minutes: other tests may keep both cores busy. */
export const launch = async () => {
  const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: flags});
  const open = browser.newContext.bind(browser);
  browser.newContext = async options => {
    const context = await open(options);
    context.setDefaultTimeout(120000);
    return context;
  };
  return browser;
};
export const newPage = async (browser, options) => {
  const page = await browser.newPage({viewport: {width: 1280, height: 900}, ...options});
  page.on("console", message => { if (["error", "warning"].includes(message.type())) complaints.push(message.text()); });
  page.on("pageerror", error => complaints.push(String(error)));
  page.on("request", request => requests.push(request.url()));
  return page;
};
export const shot = async (page, name) => {
  if (!shots) return;
  mkdirSync(shots, {recursive: true});
  await page.screenshot({path: join(shots, name + ".png")});
};

const kRoles = ["button", "checkbox", "combobox", "slider", "spinbutton", "textbox"];
/// Roles of a page's or frame's controls of which some have no name with a letter in it.
export const nameless = async of => {
  const counts = await Promise.all(kRoles.map(role => Promise.all([{}, {name: /\p{L}/u}].map(named => of.getByRole(role, {includeHidden: true, ...named}).count()))));
  return kRoles.filter((_, i) => counts[i][0] !== counts[i][1]);
};
/// What reaches beyond the sides of the window, but what scrolls by itself.
export const cutOff = (page, css = "body *", scrolls = ".scroll, pre, code") => page.evaluate(([parts, scrolling]) =>
  [...(document.documentElement.scrollWidth > innerWidth ? [document.documentElement] : []), ...document.querySelectorAll(parts)].filter(e => {
    const box = e.getBoundingClientRect();
    return box.width > 0 && (box.left < -1 || box.right > innerWidth + 1 || e === document.documentElement) && !e.closest(scrolling);
  }).map(e => e.outerHTML.slice(0, 80)), [css, scrolls]);
/// Texts whose contrast with what is behind them is less than 4.5 (WCAG AA).
export const paleTexts = (page, css = "body *") => page.evaluate(parts => {
  const context = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
  const over = colours => {  // from the lowest
    context.clearRect(0, 0, 1, 1);
    for (const colour of colours) {
      context.fillStyle = colour;
      context.fillRect(0, 0, 1, 1);
    }
    return [...context.getImageData(0, 0, 1, 1).data];
  };
  const light = ([r, g, b]) => [r, g, b].map(value => value / 255).map(share => share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4)
    .reduce((sum, share, i) => sum + share * [0.2126, 0.7152, 0.0722][i], 0.05);
  const isText = e => [...e.childNodes].some(node => node.nodeType === 3 && node.data.trim()) && e.checkVisibility({checkVisibilityCSS: true}) && !e.closest("script, style, [disabled]");
  return [...document.querySelectorAll(parts)].filter(isText).flatMap(e => {
    const behind = [], style = getComputedStyle(e);
    for (let at = e; at; at = at.parentElement) behind.unshift(getComputedStyle(at).backgroundColor);
    const [back, ink] = [behind, [...behind, e instanceof SVGElement ? style.fill : style.color]].map(colours => light(over(colours)));
    const contrast = Math.max(back, ink) / Math.min(back, ink);
    return contrast < 4.5 ? [`${contrast.toFixed(2)} ${e.outerHTML.slice(0, 120)}`] : [];
  });
}, css);
