/** What a GLB says of itself, looked at before it is loaded: three.js allocates whatever an accessor claims. */

const JSON_AT = 20;
const MAGIC = "glTF";
const MOST_ELEMENTS = 50_000_000;

/** @typedef {{ accessors?: { count?: number, sparse?: { count?: number } }[], nodes?: { children?: number[] }[] }} Claims */

/**
 * Throws where it is no binary glTF, where accessors claim more elements than any body has, or where nodes are no trees,
 * which would never load.
 *
 * @param {ArrayBuffer} content
 */
export function checkClaims(content) {
  const { accessors = [], nodes = [] } = claimsOf(content);
  const elements = accessors.reduce((sum, each) => sum + Number(each.count ?? 0) + Number(each.sparse?.count ?? 0), 0);
  if (!(elements <= MOST_ELEMENTS)) {
    throw new Error(`it claims ${String(elements)} elements; ${String(MOST_ELEMENTS)} at most`);
  }
  const children = nodes.flatMap((node) => node.children ?? []);
  if (new Set(children).size < children.length || nodes.some((_, place) => isOwnAncestor(place, nodes))) {
    throw new Error("its nodes are no trees");
  }
}

/**
 * The JSON of a GLB, as it is in its first chunk.
 *
 * @param {ArrayBuffer} content
 * @returns {Claims}
 */
function claimsOf(content) {
  if (content.byteLength < JSON_AT || textOf(content, 0, MAGIC.length) !== MAGIC) {
    throw new Error(`it does not begin with “${MAGIC}”, as binary glTF does; save the body anew as .glb or .vrm`);
  }
  const length = new DataView(content).getUint32(JSON_AT - 8, true);
  if (JSON_AT + length > content.byteLength) {
    throw new Error(`it ends after ${String(content.byteLength)} bytes, within its first part; copy or save it anew`);
  }
  return /** @type {Claims} */ (JSON.parse(textOf(content, JSON_AT, length)));
}

/**
 * @param {ArrayBuffer} content
 * @param {number} from
 * @param {number} length
 */
function textOf(content, from, length) {
  return new TextDecoder().decode(content.slice(from, from + length));
}

/**
 * Whether a node comes again below itself; each has one parent at most.
 *
 * @param {number} place
 * @param {readonly { children?: number[] }[]} nodes
 */
function isOwnAncestor(place, nodes) {
  const seen = new Set();
  const rest = [...(nodes[place]?.children ?? [])];
  for (let next = rest.pop(); next !== undefined; next = rest.pop()) {
    if (next === place) {
      return true;
    }
    if (!seen.has(next)) {
      seen.add(next);
      rest.push(...(nodes[next]?.children ?? []));
    }
  }
  return false;
}
