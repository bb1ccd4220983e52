/** A part of what the page knows, which one room owns (store.js). */

/**
 * @template Value
 * @typedef {Readonly<{ initial: Value }>} Slice
 */

/**
 * A slice of the store; each call makes another one.
 *
 * @template Value
 * @param {Value} initial
 * @returns {Slice<Value>}
 */
export function slice(initial) {
  return Object.freeze({ initial: frozen(initial) });
}

/**
 * Plain objects and arrays are frozen; files, clips and other objects with a class of their own are left alone.
 *
 * @template Value
 * @param {Value} value
 * @returns {Value}
 */
export function frozen(value) {
  const isPlain = Array.isArray(value) || Object.getPrototypeOf(value ?? 0) === Object.prototype;
  return isPlain ? Object.freeze(value) : value;
}
