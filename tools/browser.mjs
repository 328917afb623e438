// Chromium for the tools that open pages: imported by them, it ends them with one line where it or playwright-core is missing.
import {existsSync} from "node:fs";
import {basename} from "node:path";

const driver = new URL("../tests/browser/node_modules/playwright-core/index.mjs", import.meta.url);
if (!existsSync("/usr/bin/chromium") || !existsSync(driver)) {
  console.error(`tools/${basename(process.argv[1])}: it needs Debian's chromium npm: apt install chromium npm && tests/browser/run --install`);
  process.exit(2);
}
export const {chromium} = await import(driver.href);
