/**
 * The service that this page came from. Requests carry the key that the user typed, which is kept for this tab alone.
 *
 * `client` has a method for each request (clients/typescript); `fetch` is for paths that it has none for.
 */

import { ServiceProblemError, UnderstudyClient } from "understudy-client";

/** @import { Problem } from "../state/performed.js" */

const KEY = "understudy-key";

export class Service {
  /** Where the service is. */
  baseUrl = new URL(".", document.baseURI).href;

  /** A client with the key that was typed last. */
  get client() {
    return new UnderstudyClient({ baseUrl: this.baseUrl, apiKey: this.key ?? undefined });
  }

  get key() {
    return sessionStorage.getItem(KEY);
  }

  set key(typed) {
    if (typed) {
      sessionStorage.setItem(KEY, typed);
    } else {
      sessionStorage.removeItem(KEY);
    }
  }

  /**
   * The answer to a request, which is one without a problem.
   *
   * @param {string} path without a slash before it
   * @param {RequestInit} [request]
   */
  async fetch(path, request = {}) {
    const headers = new Headers(request.headers);
    if (this.key) {
      headers.set("authorization", `Bearer ${this.key}`);
    }
    const answer = await fetch(this.baseUrl + path, { ...request, headers });
    if (!answer.ok) {
      const isProblem = answer.headers.get("content-type")?.startsWith("application/problem+json");
      throw isProblem
        ? new ServiceProblemError(await answer.json())
        : new Error(`${path}: the service answered ${String(answer.status)} ${answer.statusText}`);
    }
    return answer;
  }
}

/**
 * What went wrong, as it is shown.
 *
 * @param {unknown} error
 * @returns {Problem}
 */
export function problemOf(error) {
  if (error instanceof ServiceProblemError) {
    return { code: error.code, detail: error.detail, field: error.field };
  }
  return { code: "page", detail: error instanceof Error ? error.message : String(error) };
}
