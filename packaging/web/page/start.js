// Loads the program with a bar that shows how far it is, or says kindly why it cannot run here.

import init from "./lightfall.js";

// The bytes of the program after decompression: a server that compresses says another number.
const PROGRAM_BYTES = Number("@PROGRAM_BYTES@");
const REPORTS = "lightfall/reports/";

// Keys that scroll a page.
const SCROLLING = [" ", "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "PageUp", "PageDown", "Home", "End"];

const root = document.documentElement;
const canvas = document.getElementById("lightfall");
const message = document.getElementById("message");
const progress = document.getElementById("progress");

function say(state, text) {
  message.textContent = text;
  root.dataset.state = state;
}

/** Why the program cannot run in this browser; empty if it can. */
async function obstacle() {
  const advice =
    "Use a current Chrome, Edge, Safari or Firefox, or download the program, which needs no browser.";
  if (!window.isSecureContext) {
    return "Browsers offer their graphics only to pages loaded by https. " + advice;
  }
  if (!navigator.gpu) {
    return "Lightfall draws with WebGPU, which this browser does not have. " + advice;
  }
  const adapter = await navigator.gpu.requestAdapter().catch(() => null);
  return adapter ? "" : "This browser has WebGPU but no graphics adapter for it. " + advice;
}

/** The program's bytes as a response, counted while they arrive. */
async function program() {
  const url = new URL("lightfall_bg.wasm", import.meta.url);
  const response = await fetch(url);
  if (!response.ok) {
    throw new Error(`${url.pathname}: the server answers ${response.status}`);
  }
  let loaded = 0;
  const counter = new TransformStream({
    transform(part, controller) {
      loaded += part.byteLength;
      progress.value = loaded / PROGRAM_BYTES;
      controller.enqueue(part);
    },
    flush() {
      message.textContent = "Starting";
    },
  });
  // Browsers compile while they load only what has this type.
  return new Response(response.body.pipeThrough(counter), {
    headers: { "Content-Type": "application/wasm" },
  });
}

/** Hands over the report of the last crash. */
function saveReport() {
  let name;
  try {
    name = Object.keys(localStorage).filter((key) => key.startsWith(REPORTS)).sort().pop();
  } catch {
    // The browser gives this page no storage.
  }
  if (!name) {
    message.textContent += " There is no report to save.";
    return;
  }
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([localStorage.getItem(name)], { type: "text/plain" }));
  link.download = name.slice(REPORTS.length);
  link.click();
}

async function start() {
  const reason = await obstacle();
  if (reason) {
    say("unsupported", reason);
    return;
  }
  await init({ module_or_path: program() });
}

// The program hears keys while its canvas has the focus. A click on the canvas gives it the focus; a click on
// the loading screen over it must, too, above all where this page is part of another one.
document.getElementById("loading").addEventListener("click", (event) => {
  if (!(event.target instanceof HTMLButtonElement)) canvas.focus();
});

// What scrolls here would scroll the page around this one. Buttons, and the field that the program makes for
// the keyboards of phones, keep their keys.
addEventListener("wheel", (event) => event.preventDefault(), { passive: false });
addEventListener("keydown", (event) => {
  const isPicture = [canvas, document.body].includes(event.target);
  if (isPicture && SCROLLING.includes(event.key)) event.preventDefault();
});

// Ctrl flies down and W flies ahead; together they close the tab, and no page may forbid it. While Ctrl is
// held, the browser asks first.
let controlIsHeld = false;
const watchControl = (event) => (controlIsHeld = event.ctrlKey);
addEventListener("keydown", watchControl, true);
addEventListener("keyup", watchControl, true);
addEventListener("beforeunload", (event) => {
  if (controlIsHeld && root.dataset.state === "running") event.preventDefault();
});

document.getElementById("save").addEventListener("click", saveReport);
document.getElementById("again").addEventListener("click", () => location.reload());

start().catch((error) => {
  // The window system leaves the start of the program by an exception that is no fault.
  if (String(error).includes("Using exceptions for control flow")) return;
  if (root.dataset.state !== "failed") {
    say("failed", `Lightfall cannot start: ${error.message ?? error}`);
  }
});
