// Sends the microphone to WS /live and shows what comes back: the body as sticks, and a line for each behaviour.
import { draw } from "./skeleton.js";

const MOST_LINES = 20;
const element = (id) => document.getElementById(id);
let socket = null;
let sound = null;
let ready = null;

function say(text) {
  element("state").textContent = text;
}

function shownLine(told) {
  const line = document.createElement("li");
  line.textContent = `${told.start_s.toFixed(2)} s  ${told.type}  ${told.lexeme}  ${told.reason ?? told.rule ?? ""}`;
  element("told").prepend(line);
  while (element("told").children.length > MOST_LINES) element("told").lastChild.remove();
}

const ANSWERS = {
  ready: (told) => { ready = told; say("listening"); },
  frame: (told) => draw(element("body"), ready.joints, told, told.shapes[ready.shapes.indexOf("jawOpen")]),
  error: (told) => say(`${told.code}: ${told.detail}`),
  frames_skipped: (told) => say(`${told.count} frames were left out`),
  done: (told) => say(`done after ${told.duration_s.toFixed(1)} s`),
};

function heard({ data }) {
  const told = JSON.parse(data);
  if (told.lexeme && !told.revised) shownLine(told);
  ANSWERS[told.type]?.(told);
}

// Browsers cannot give a WebSocket headers, so the key goes as a protocol that it offers, as base64url.
function protocols(key) {
  const coded = btoa(String.fromCharCode(...new TextEncoder().encode(key)));
  return key ? ["understudy", `understudy.key.${coded.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`] : [];
}

async function microphone() {
  const stream = await navigator.mediaDevices.getUserMedia({ audio: { channelCount: 1 } });
  const context = new AudioContext();
  await context.audioWorklet.addModule("capture.js");
  const capture = new AudioWorkletNode(context, "capture", { numberOfOutputs: 0 });
  context.createMediaStreamSource(stream).connect(capture);
  return { stream, context, capture };
}

async function talk(event) {
  event.preventDefault();
  try {
    sound = await microphone();
  } catch (error) {
    say(`no microphone: ${error.message}`);
    return;
  }
  socket = new WebSocket(element("address").value, protocols(element("key").value));
  socket.onmessage = heard;
  socket.onerror = () => say("the service cannot be reached, or asks for another key");
  socket.onclose = stop;
  socket.onopen = () => {
    const rate = sound.context.sampleRate;
    const character = element("character").value;
    socket.send(JSON.stringify({ type: "start", sample_rate_hz: rate, character, frames: 30 }));
    sound.capture.port.onmessage = ({ data }) => socket.readyState === WebSocket.OPEN && socket.send(data);
  };
  buttons(true);
}

function stop() {
  sound?.stream.getTracks().forEach((track) => track.stop());
  sound?.context.close();
  sound = null;
  buttons(false);
}

function buttons(isOpen) {
  element("talk").disabled = isOpen;
  element("interrupt").disabled = element("end").disabled = !isOpen;
}

element("start").addEventListener("submit", talk);
for (const type of ["interrupt", "end"]) {
  element(type).addEventListener("click", () => socket.send(JSON.stringify({ type })));
}
