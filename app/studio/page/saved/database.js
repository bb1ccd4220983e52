/** The browser's own database (IndexedDB), as promises: one table of projects, one of their versions. */

const NAME = "understudy-studio";
const VERSION = 1;

/** @typedef {"projects" | "versions"} Table */

/** @type {Promise<IDBDatabase> | null} */
let opened = null;

/** Rejects where the browser keeps nothing, as in some private windows. */
function database() {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, VERSION);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("projects", { keyPath: "id" });
      request.result.createObjectStore("versions", { keyPath: "id", autoIncrement: true }).createIndex("project", "project");
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser keeps no database"));
  });
  return opened;
}

/**
 * Does something with a table, and resolves with its result when it is done for good.
 *
 * @template Value
 * @param {Table} table
 * @param {IDBTransactionMode} mode
 * @param {(store: IDBObjectStore) => IDBRequest<Value>} act
 * @returns {Promise<Value>}
 */
export async function within(table, mode, act) {
  const transaction = (await database()).transaction(table, mode);
  const request = act(transaction.objectStore(table));
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve(request.result);
    transaction.onabort = () => reject(transaction.error ?? new Error("the browser could not write to its database"));
  });
}
