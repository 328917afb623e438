// Drawings in real types: what predicts their misses, from which n on misses pass a limit, and what accuracy costs.

const kRealTypes = [["float", 24], ["double", 53], ["binary80", 64], ["binary128", 113], ["237 bits", 237]];
const kLimits = [-12, -9, -6, -3, 0];  // decimal logarithms of degrees
const kWithin = ["1e_12", "1e_9", "1e_6", "1e_3"];
const kUsable = 0.1;  // degrees that a drawing may miss before one sees it
const kMostSizes = 4;  // of the comparison of types
const kLogDegrees = Math.log10(180 / Math.PI), kLog2 = Math.log10(2);

/** "float" of 24 bits, … for two-bend-paper with its option type; another setting's name, whose bits (0) are unknown. */
export const realType = ({algorithm, options}) => {
  const own = options.replace(/(^|;)level=.*$/, ""), known = /^type=([0-4])$/.exec(own);
  if (algorithm === "two-bend-paper" && known) return {type: kRealTypes[known[1]][0], bits: kRealTypes[known[1]][1]};
  return {type: own ? `${algorithm} (${own})` : algorithm, bits: 0};
};
const familyLabel = curve => curve.parameters ? `${curve.family} (${curve.parameters})` : curve.family;
const orNull = value => Number.isFinite(value) ? value : null;
/** log10 of the degrees in 2^-bits radians. */
const logRounding = bits => kLogDegrees - bits * kLog2;

const inOrder = values => values.filter(value => !Number.isNaN(value)).sort((a, b) => a - b);
/** Interpolates between order statistics; NaN of nothing. */
const quantileOf = (values, share) => {
  const sorted = inOrder(values), place = share * (sorted.length - 1), below = Math.floor(place);
  if (!sorted.length) return NaN;
  return place === below ? sorted[below] : sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]);
};
const medianOf = values => quantileOf(values, 0.5);
/** The median, infinities among the values; of two middle ones that are not both finite the larger. */
const middleOf = values => {
  const sorted = inOrder(values), low = sorted[(sorted.length - 1) >> 1], high = sorted[sorted.length >> 1];
  return Number.isFinite(low) ? (low + high) / 2 : high;
};
/** [key, what `use` makes of its rows] of every key of the rows, in order. */
const byKey = (rows, key, use) => {
  const groups = new Map();
  for (const row of rows) {
    if (!groups.has(row[key])) groups.set(row[key], []);
    groups.get(row[key]).push(row);
  }
  return [...groups].sort(([a], [b]) => a < b ? -1 : 1).map(([at, those]) => [at, use(those)]);
};
const medianMisses = rows => byKey(rows, "n", those => middleOf(those.map(row => row.logMiss)));

/** What predicts the misses: kappa and C of the drawings in the type of most bits. A miss is kappa 2^-bits C radians. */
const missModel = (rows, types) => {
  const known = types.filter(type => type.bits > 0).length, type = Math.max(0, known - 1), bits = types[type]?.bits ?? 0;
  const own = known ? rows.filter(row => row.type === type && Number.isFinite(row.logCondition))
    .map(row => ({...row, kappa: row.logMiss - row.logCondition - logRounding(bits)})) : [];
  const finite = own.filter(row => Number.isFinite(row.kappa)), kappas = those => those.map(row => row.kappa);
  return {type, drawings: finite.length, kappa: [0.1, 0.5, 0.9].map(share => quantileOf(kappas(finite), share)),
    familyKappa: byKey(finite, "family", those => medianOf(kappas(those))),
    conditions: new Map(byKey(own, "family", those => byKey(those, "n", of => medianOf(of.map(row => row.logCondition)))))};
};

/** log10 of the first n at which [n, value] pass the limit, by interpolation; -Infinity: the first one, Infinity: none. */
const firstBeyond = (values, limit) => {
  const at = values.findIndex(([, value]) => value > limit);
  if (at <= 0) return at === 0 ? -Infinity : Infinity;
  const [[n0, low], [n1, high]] = values.slice(at - 1, at + 1), part = Number.isFinite(low) ? (limit - low) / (high - low) : 1;
  return Math.log10(n0) + part * (Math.log10(n1) - Math.log10(n0));
};

/**
 * Confirmed: both passes, decimal logarithms of n, are within a factor of 2. Refuted: they are further apart, or at least so far,
 * one of them being beyond the sizes drawn. Open: what is beyond may be either.
 */
export const judgeOnset = (predicted, seen, first, last) => {
  const factor = kLog2 + 1e-9, isInside = Number.isFinite(predicted), isSeen = Number.isFinite(seen);
  const atLeast = (known, beyond) => beyond > 0 ? last - known : known - first;
  if (isInside && isSeen) return Math.abs(predicted - seen) <= factor ? "confirmed" : "refuted";
  let apart = predicted === seen ? 0 : last - first;
  if (isInside) apart = atLeast(predicted, seen);
  if (isSeen) apart = atLeast(seen, predicted);
  return apart > factor ? "refuted" : "open";
};

const wholeN = logN => Number.isFinite(logN) ? Math.round(10 ** logN) : null;
const side = logN => Number.isFinite(logN) ? "inside" : logN > 0 ? "beyond" : "least";
/** Where medians of one type pass the limits, predicted and seen; those that neither passes, or both at once, are left out. */
const onsetsOf = (logKappa, predicted, seen) => {
  const [first, last] = [Math.log10(seen[0][0]), Math.log10(seen.at(-1)[0])], predictedAt = new Map(predicted);
  return kLimits.map(limit => {
    const [at, seenAt] = [firstBeyond(predicted, limit), firstBeyond(seen, limit)];
    const both = seen.filter(([n]) => predictedAt.has(n)), [n, miss] = both.find(([, value]) => value > limit) ?? both.at(-1) ?? [];
    return at === seenAt && !Number.isFinite(at) ? null : {limit: 10 ** limit, predicted: wholeN(at), seen: wholeN(seenAt),
      predicted_at: side(at), seen_at: side(seenAt), first_n: seen[0][0], last_n: seen.at(-1)[0],
      verdict: judgeOnset(at, seenAt, first, last), kappa: 10 ** logKappa, kappa_seen: orNull(10 ** (logKappa + miss - predictedAt.get(n)))};
  }).filter(Boolean);
};
const allOnsets = (rows, types, model) => model.familyKappa.flatMap(([family, logKappa]) => types.flatMap(({bits}, type) => {
  const seen = medianMisses(rows.filter(row => row.family === family && row.type === type));
  if (type === model.type || bits === 0 || seen.length < 2) return [];
  const predicted = model.conditions.get(family).map(([n, logC]) => [n, logKappa + logC + logRounding(bits)]);
  return onsetsOf(logKappa, predicted, seen).map(onset => ({family, type, ...onset}));
}));

/** By n and type: means of the shares of angles within so many degrees, and shares of drawings that are within in all. */
const shareRows = rows => byKey(rows, "n", of => byKey(of, "type", those => those)).flatMap(([n, types]) => types.map(([type, those]) => {
  const mean = value => those.reduce((sum, row) => sum + Number(value(row)), 0) / those.length;
  const made = {n, type, drawings: those.length, broken: those.filter(row => row.broken).length};
  for (const within of kWithin) {  // no angles: none misses
    made["within_" + within] = mean(row => row["within_" + within] ?? 1);
    made["all_" + within] = mean(row => (row["within_" + within] ?? 1) === 1);
  }
  return made;
}));

/** By family: how many bits the condition costs at its largest n. */
const bitsLost = (rows, model) => new Map(byKey(rows, "family", those => {
  const n = Math.max(...those.map(row => row.n));
  return orNull(medianOf(those.filter(row => row.n === n && row.type === model.type).map(row => row.logCondition)) / kLog2);
}));

/** At most so many of the items, evenly, the first and the last among them. */
const evenly = (items, most) => items.length <= most ? items
  : Array.from({length: most}, (_, i) => items[Math.floor(i * (items.length - 1) / (most - 1))]);
/** Of the rows of one n, by type: median and largest miss, and times a vertex. */
const typesAt = (n, rows, times) => byKey(rows, "type", of => ({n, miss: 10 ** medianMisses(of)[0][1], largest: Math.max(...of.map(row => row.miss)), drawings: of.length,
  cpu: orNull(medianOf(of.map(row => (row.cpu ?? NaN) / row.vertices))), time: orNull(medianOf(of.map(row => times.get(`${row.curve} ${row.vertices}`) ?? NaN)))})).map(([type, point]) => ({type, ...point}));

/** On the front if no other type is faster and more accurate at that n. */
const accuracies = (rows, times) => evenly(byKey(rows, "n", those => those), kMostSizes).flatMap(([n, those]) => {
  const points = typesAt(n, those, times);
  const beats = (one, other) => one.time <= other.time && one.miss <= other.miss && (one.time < other.time || one.miss < other.miss);
  return points.map(point => ({...point, front: point.time !== null && !points.some(other => other.time !== null && beats(other, point))}));
});

/** By family and n: the types, and the settings that draw the same graphs in exact integers with their times a vertex. */
const comparisons = (rows, curves, times) => {
  const inRealTypes = new Set(rows.map(row => curves[row.curve].setting)), exact = new Map();
  for (const [place, curve] of curves.entries()) if (curve.ok > 0 && !inRealTypes.has(curve.setting)) exact.set(`${familyLabel(curve)} ${curve.setting}`, place);
  const settings = [...new Set(curves.map(curve => curve.setting))].filter(setting => setting !== null && setting !== undefined);
  return byKey(rows, "family", those => byKey(those, "n", of => of)).flatMap(([family, sizes]) => sizes.map(([n, of]) => ({family, n, types: typesAt(n, of, times),
    exact: settings.map(setting => ({setting, time: times.get(`${exact.get(`${family} ${setting}`)} ${of[0].vertices}`) ?? null})).filter(one => one.time !== null)})));
};

/** What follows, for each type: the largest miss of all drawings and where, the largest n, and how much longer it takes than exact integers. */
const conclusions = (rows, compared, types) => types.map((_, type) => {
  const own = rows.filter(row => row.type === type), worst = own.reduce((a, b) => a.miss >= b.miss ? a : b), beside = compared.flatMap(at => {
    const mine = at.types.find(one => one.type === type), fastest = at.exact.reduce((a, b) => a && a.time <= b.time ? a : b, null);
    return mine?.time && fastest ? [{n: at.n, family: at.family, ratio: mine.time / fastest.time, setting: fastest.setting}] : [];
  });
  const sizes = byKey(own, "vertices", those => Math.max(...those.map(row => row.miss))), until = sizes.findIndex(([, miss]) => !(miss <= kUsable));
  const held = until < 0 ? sizes : sizes.slice(0, until);
  return {type, drawings: own.length, held_n: held.at(-1)?.[0] ?? null, held_miss: Math.max(...held.map(([, miss]) => miss)),
    broken: own.filter(row => row.broken).length, miss: worst.miss, worst_family: worst.family, worst_n: worst.vertices,
    last_n: Math.max(...own.map(row => row.vertices)),
    beside: beside.sort((a, b) => a.n - b.n).at(-1) ?? null};
});

/**
 * All that the page says of the drawings.
 * @param stored  rows of the table real_drawings. @param curves  of bounds. @param lines  of curves, which hold drawing times over n.
 */
export const realStudy = (stored, curves, lines) => {
  const settings = new Map(stored.map(row => realType(curves[row.curve])).map(type => [type.type, type]));
  const types = [...settings.values()].sort((a, b) => (a.bits || Infinity) - (b.bits || Infinity) || 0);
  const placeOf = new Map(types.map((type, i) => [type.type, i]));
  const rows = stored.map(row => ({...row, type: placeOf.get(realType(curves[row.curve]).type), family: familyLabel(curves[row.curve]),
    miss: row.miss ?? Infinity, logMiss: Math.log10(row.miss ?? Infinity), logCondition: Math.log10(row.condition ?? Infinity)}));
  const families = byKey(rows, "family", those => those.length), most = Math.max(...families.map(([, size]) => size));
  const family = families.find(([, size]) => size === most)?.[0], shown = rows.filter(row => row.family === family);
  const model = missModel(rows, types), onsets = allOnsets(rows, types, model), [low, middle, high] = model.kappa;
  const roundings = (logMiss, type) => types[type].bits ? 10 ** (logMiss - logRounding(types[type].bits)) : null;
  const conditions = model.drawings ? model.conditions.get(family) ?? [] : [];
  const times = new Map(lines.filter(line => line.quantity === "drawing time").map(line => [`${line.curve} ${line.n}`, line.median * line.divisor / line.n]));
  const compared = comparisons(rows, curves, times);
  const count = verdict => onsets.filter(onset => onset.verdict === verdict).length;
  return {types, onsets, drawings: rows.length, broken: rows.filter(row => row.broken).length, family, model: types[model.type]?.type,
    predictors: model.drawings, kappa: 10 ** middle, kappa_low: 10 ** low, kappa_high: 10 ** high,
    confirmed: count("confirmed"), refuted: count("refuted"), open: count("open"),
    misses: shown.map(row => ({...row, n: row.vertices, roundings: roundings(row.logMiss, row.type)})),
    medians: byKey(shown, "type", medianMisses).flatMap(([type, values]) =>
      values.map(([n, miss]) => ({type, n, miss: 10 ** miss, roundings: roundings(miss, type)}))),
    predicted: conditions.map(([n, c]) => ({n, low: 10 ** (low + c), median: 10 ** (middle + c), high: 10 ** (high + c)})),
    shares: shareRows(rows), compared, conclusions: conclusions(rows, compared, types), bits_lost: bitsLost(rows, model), accuracies: accuracies(shown, times)};
};
