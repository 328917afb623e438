// What ./run-tests --lint asks of the scripts: in the viewer every name is declared in its module or imported.
const browser = ["Blob", "DecompressionStream", "HTMLButtonElement", "HTMLCanvasElement", "HTMLInputElement", "HTMLSelectElement", "IntersectionObserver",
  "DOMParser", "HTMLTextAreaElement", "Option", "Response", "THREE", "TextDecoder", "TextEncoder", "URL", "URLSearchParams", "WebAssembly", "Worker",
  "ar3dCore", "history", "location", "navigator", "self", "addEventListener", "atob", "cancelAnimationFrame", "clearTimeout", "devicePixelRatio", "document",
  "getComputedStyle", "getSelection", "innerHeight", "innerWidth", "matchMedia", "performance", "requestAnimationFrame", "scrollTo", "setTimeout", "window"];
const node = ["Buffer", "ClipboardEvent", "DataTransfer", "DragEvent", "File", "SVGElement", "setInterval", "console", "process", "structuredClone"];
const known = names => Object.fromEntries(names.map(name => [name, "readonly"]));

const rules = {
  "eqeqeq": "error", "no-shadow": "error", "no-undef": "error", "no-unused-expressions": "error", "no-unused-vars": "error",
  "no-use-before-define": ["error", {functions: false, classes: false, variables: false}], "no-var": "error", "prefer-const": "error",
};

export default [
  {
    files: ["formats/drawings/viewer/*.js", "apps/play/*.js"],
    languageOptions: {globals: known(browser)},
    rules: {
      ...rules, "consistent-return": "error", "complexity": ["error", 15], "max-depth": ["error", 3],
      "max-len": ["error", {code: 120, ignoreTemplateLiterals: false}], "max-lines-per-function": ["error", 60], "max-params": ["error", 5],
      "no-import-assign": "error",
    },
  },
  {
    files: ["analysis/page/*.js"],
    languageOptions: {globals: known([...browser, "CustomEvent", "Plot", "XMLSerializer", "innerWidth", "location"])},
    rules: {...rules, "complexity": ["error", 15], "max-depth": ["error", 3], "max-len": ["error", {code: 240}], "max-params": ["error", 5]},
  },
  {files: ["**/*.mjs"], languageOptions: {globals: known([...browser, ...node])}, rules: {...rules, "no-shadow": "off"}},
];
