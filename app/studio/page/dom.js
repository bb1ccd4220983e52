/** Builds elements. Texts are always text: nothing that comes from elsewhere becomes markup. */

/**
 * An element with attributes (a function is a listener of that event: `click`) and children; `false` leaves an attribute
 * out, `true` sets it without a value.
 *
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string | number | boolean | ((event: any) => void)>} [attributes]
 * @param {readonly (Node | string)[]} [children]
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function el(tag, attributes = {}, children = []) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      made.addEventListener(name, value);
    } else if (value !== false) {
      made.setAttribute(name, value === true ? "" : String(value));
    }
  }
  made.append(...children);
  return made;
}

/**
 * The element that a selector finds. Throws a TypeError where there is none of that kind.
 *
 * @template {Element} Kind
 * @param {ParentNode} root
 * @param {string} selector
 * @param {new () => Kind} kind
 */
export function found(root, selector, kind) {
  const element = root.querySelector(selector);
  if (!(element instanceof kind)) {
    throw new TypeError(`there is no ${kind.name} ${selector}`);
  }
  return element;
}

/**
 * A labelled control.
 *
 * @param {string} label
 * @param {HTMLElement} control
 */
export function labelled(label, control) {
  return el("label", {}, [el("span", {}, [label]), control]);
}

/**
 * A button that has the browser choose files; each choice is told, also the same one again.
 *
 * @param {string} label
 * @param {Record<string, string | boolean>} attributes of the field; `class` is the button's
 * @param {(files: File[]) => void} taken
 */
export function fileButton(label, { class: kind = "", ...attributes }, taken) {
  const field = el("input", { type: "file", ...attributes });
  field.addEventListener("change", () => {
    const files = [...(field.files ?? [])];
    field.value = "";
    taken(files);
  });
  return el("label", { class: `file ${String(kind)}` }, [el("span", {}, [label]), field]);
}

/**
 * A place whose content is read out by screen readers when it changes. Lists need one around them: as one, they would be
 * none.
 *
 * @param {HTMLElement} content
 */
export function readOut(content) {
  return el("div", { role: "status" }, [content]);
}

/**
 * A part of the page under its title, which folds it away.
 *
 * @param {string} title
 * @param {readonly Node[]} parts
 */
export function foldable(title, parts) {
  return el("details", { open: true, class: "part" }, [el("summary", {}, [el("h2", {}, [title])]), ...parts]);
}

/**
 * A selection from values.
 *
 * @param {readonly (readonly [value: string, text: string])[]} options
 * @param {string} value
 * @param {(value: string) => void} chosen
 */
export function choice(options, value, chosen) {
  const made = el("select", { change: () => chosen(made.value) });
  made.append(...options.map(([name, text]) => el("option", { value: name, selected: name === value }, [text])));
  return made;
}
