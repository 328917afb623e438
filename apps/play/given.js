// What a reader gives: texts and files of graphs, links; and the command that draws the same.

/// The text of a file: unpacked if it is gzip, UTF-16 if its mark says so.
export async function textOf(file) {
  let bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes[0] === 0x1f && bytes[1] === 0x8b) {
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    bytes = new Uint8Array(await new Response(unpacked).arrayBuffer());
  }
  if (bytes[0] === 0xfd && bytes[1] === 0x37) throw new Error(`${file.name}: xz is not unpacked here`);
  const isUtf16 = bytes[0] + bytes[1] === 0xff + 0xfe;
  return new TextDecoder(isUtf16 ? bytes[0] === 0xff ? "utf-16le" : "utf-16be" : "utf-8").decode(bytes);
}

const childrenCalled = (element, name) => [...element.children].filter(child => child.localName === name);

/// GraphML as DOT, in which the program reads it: ids, labels and edges of each undirected graph. The browser reads the
/// XML, so messages name no line.
export function dotOfGraphml(text, name) {
  const fail = why => { throw new Error(`${name}: ${why}`); };
  const root = new DOMParser().parseFromString(text, "application/xml").documentElement;
  if (root.querySelector("parsererror") || root.localName === "parsererror") fail("this is no well-formed XML");
  const graphs = root.localName === "graphml" ? childrenCalled(root, "graph") : [];
  if (!graphs.length) fail("no <graph> element inside a <graphml> element");
  const isName = key => ["label", "name"].includes(key.getAttribute("attr.name"));
  const keys = new Set(childrenCalled(root, "key").filter(isName).map(key => key.id));
  const quoted = words => `"${words.replace(/"/g, "\\\"")}"`;
  return graphs.map(graph => {
    const kind = graph.getAttribute("edgedefault");
    if (kind !== "undirected") fail(`edgedefault is '${kind}': only undirected graphs are read`);
    if (graph.querySelector("graph, hyperedge")) fail("graphs inside nodes or edges, and hyperedges, are not read");
    const ids = new Set(), lines = [];
    for (const node of childrenCalled(graph, "node")) {
      const label = childrenCalled(node, "data").find(data => keys.has(data.getAttribute("key")));
      if (ids.has(node.id)) fail(`node '${node.id}' stands twice`);
      ids.add(node.id);
      lines.push(quoted(node.id) + (label && label.textContent ? ` [label=${quoted(label.textContent)}]` : ""));
    }
    for (const edge of childrenCalled(graph, "edge")) {
      if (["true", "1"].includes(edge.getAttribute("directed"))) fail("directed edges are not read");
      const ends = ["source", "target"].map(end => edge.getAttribute(end));
      for (const end of ends) if (!ids.has(end)) fail(`'${end}' is no node of this graph`);
      lines.push(ends.map(quoted).join(" -- "));
    }
    return `graph {\n${lines.join("\n")}\n}\n`;
  }).join("");
}

/// The text in a format that the program reads here.
export const readable = ({text, name}) => text.trimStart().startsWith("<") ? dotOfGraphml(text, name) : text;

/// What a link says (#g6=…&a=…&effort=…, or family, n and seed), or null.
export function linked(hash) {
  const words = new URLSearchParams(hash.replace(/^#/, "").replace(/\+/g, "%2B"));
  const family = words.get("family"), line = words.get("g6");
  if (!family && !line) return null;
  const size = words.has("n") ? {n: Number(words.get("n")), seed: Number(words.get("seed") || 1)} : {};
  return {
    given: family ? {family, ...size} : {text: line + "\n", name: "<stdin>"},
    algorithm: words.get("a") || "", effort: Number(words.get("effort") || 1),
  };
}

const kMostInLink = 2000;
export function linkOf({given, algorithm, effort}, line) {
  const size = given.n === undefined ? "" : `&n=${given.n}&seed=${given.seed}`;
  const graph = given.family ? `family=${given.family}${size}` : `g6=${encodeURIComponent(line)}`;
  if (graph.length > kMostInLink || (!given.family && !line)) return "";
  return `#${graph}&a=${algorithm}&effort=${effort}`;
}

/// The words of a shell that draw the same. A long text is taken from the file that it came from, or is to be saved in.
export function commandOf({given, algorithm, options}, line) {
  const quoted = word => /^[\w./][\w./-]*$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`;
  const settings = options ? options.split(";").map(option => `--set ${option} `).join("") : "";
  const draw = from => `ar3d draw ${from} --algorithm ${algorithm} \\\n  ${settings}-o drawing.html`;
  const size = given.n === undefined ? "" : ` -n ${given.n} --seed ${given.seed}`;
  if (given.family) return `ar3d generate ${given.family}${size} |\n  ${draw("-")}`;
  return line ? `printf '%s\\n' ${quoted(line)} |\n  ${draw("-")}`
    : draw(quoted(given.name === "<stdin>" ? "graph.txt" : given.name.replace(/^-/, "./-")));
}
