// <editor-view src="…">: a scene or a character in somebody's page, to be turned, posed and reset.
// The files named in `src`, apart from each other by commas, belong together: a scene with its models,
// or `man.obj,man.skel,man.attach`. `builtin:NAME` is one of the editor's own.
const EDITOR = new URL(".", import.meta.url);

class EditorView extends HTMLElement {
  static observedAttributes = ["src"];

  #frame = document.createElement("iframe");

  constructor() {
    super();
    const style = document.createElement("style");
    style.textContent = `
      :host { display: block; aspect-ratio: 4 / 3; }
      iframe { display: block; width: 100%; height: 100%; border: 0; }`;
    this.#frame.title = "A scene to be turned and posed";
    this.#frame.loading = "lazy";
    // The program takes the keyboard when it starts, as is right for a page of its own.
    this.#frame.addEventListener("load", () => {
      const before = document.activeElement;
      const giveBack = () => {
        if (document.activeElement !== this) return;
        this.#frame.blur();
        before?.focus({ preventScroll: true });
      };
      // There is none where the editor is of another site, whose frames cannot take the keyboard.
      this.#frame.contentDocument?.defaultView.addEventListener("editor-shown", giveBack, { once: true });
    });
    this.attachShadow({ mode: "open" }).append(style, this.#frame);
  }

  attributeChangedCallback() {
    const names = (this.getAttribute("src") ?? "").split(",").map((name) => name.trim()).filter(Boolean);
    const inEditor = (name) => {
      if (name.startsWith("builtin:")) return name;
      const url = new URL(name, document.baseURI);
      // The editor opens files of its own site alone, and says so.
      return url.origin === EDITOR.origin ? decodeURI(url.pathname) : url.href;
    };
    const address = new URL("index.html", EDITOR);
    address.search = new URLSearchParams({ view: "", open: names.map(inEditor).join(",") });
    this.#frame.src = address;
  }
}

customElements.define("editor-view", EditorView);
