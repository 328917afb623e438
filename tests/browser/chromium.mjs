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

export const launch = () => chromium.launch({executablePath: "/usr/bin/chromium", args: flags});
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
