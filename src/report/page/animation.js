// Plays the run: the particles over the ground, from the data in #report-data.
"use strict";
const runAnimation = (() => {
  const data = reportData.animation;
  if (data === null || !document.getElementById("stage")) return null;

  const stage = document.getElementById("stage");
  const pen = stage.getContext("2d");
  const element = (name) => document.getElementById("animation-" + name);
  const playButton = element("play"), slider = element("time"), clock = element("clock"), field = element("field"),
        pace = element("pace");

  // ---- particles

  const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const wordsOf = (text) => new Uint16Array(bytesOf(text).buffer);
  const frames = data.frames.map((frame) => ({
    time: frame.time, x: wordsOf(frame.x), y: wordsOf(frame.y), speed: bytesOf(frame.speed),
    pressure: bytesOf(frame.pressure),
  }));
  const end = frames[frames.length - 1].time, start = frames[0].time;
  const steps = 500, step = (end - start) / steps || 1;  // of the slider

  // Layers of equal content, by height above the ends of the source's bed at the start.
  const layers = (() => {
    const first = frames[0], order = Array.from(first.y.keys()).sort((a, b) => first.y[a] - first.y[b]);
    const layer = new Uint8Array(first.y.length);
    order.forEach((particle, rank) => { layer[particle] = Math.floor((5 * rank) / order.length); });
    return layer;
  })();

  // Cividis, from dark to light: the order survives without colour.
  const stops = [[0, 34, 78], [39, 63, 108], [75, 84, 108], [107, 109, 114], [139, 134, 120], [176, 160, 112], [214, 190, 91], [253, 231, 55]];
  const shades = Array.from({ length: 256 }, (_, code) => {
    const at = (code / 255) * (stops.length - 1), low = Math.min(Math.floor(at), stops.length - 2), part = at - low;
    const mix = stops[low].map((from, i) => Math.round(from + part * (stops[low + 1][i] - from)));
    return `rgb(${mix[0]},${mix[1]},${mix[2]})`;
  });
  const codeOf = {
    speed: (frame, i) => frame.speed[i],
    pressure: (frame, i) => frame.pressure[i],
    layer: (frame, i) => (i < layers.length ? 28 + 50 * layers[i] : 255),
  };
  const scaleText = {
    speed: [data.speed[0], data.speed[0] + 255 * data.speed[1], "m/s"],
    pressure: [data.pressure[0] / 1000, (data.pressure[0] + 255 * data.pressure[1]) / 1000, "kPa"],
    layer: [0, 0, ""],
  };

  // ---- drawing

  const view = data.view;  // [low x, low y, high x, high y], m
  let pixelsPerMetre = 1, ratio = 2;

  function fit() {
    const width = stage.parentElement.clientWidth || 800;
    const metres = view[2] - view[0], high = view[3] - view[1];
    const height = Math.max(120, Math.min((width * high) / metres, 520));
    ratio = Math.max(2, window.devicePixelRatio || 1);
    stage.width = Math.round(width * ratio);
    stage.height = Math.round(height * ratio);
    stage.style.height = height + "px";
    pixelsPerMetre = Math.min(stage.width / metres, stage.height / high);
  }
  const left = () => (stage.width - pixelsPerMetre * (view[2] - view[0])) / 2;
  const atX = (x) => left() + (x - view[0]) * pixelsPerMetre;
  const atY = (y) => stage.height - (y - view[1]) * pixelsPerMetre;

  function path(points, closed) {
    pen.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(atX(x), atY(y)) : pen.lineTo(atX(x), atY(y))));
    if (closed) pen.closePath();
  }

  function drawGround() {
    path(data.bed);
    const last = data.bed[data.bed.length - 1], first = data.bed[0];
    pen.lineTo(atX(last[0]), stage.height + 9);
    pen.lineTo(atX(first[0]), stage.height + 9);
    pen.closePath();
    pen.fillStyle = "#e6e3dc";
    pen.fill();
    path(data.bed);
    pen.setLineDash([]);
    pen.lineWidth = 1.2 * ratio;
    pen.strokeStyle = "#161616";
    pen.stroke();
  }

  function drawOutline(points, dash, closed) {
    path(points, closed);
    pen.setLineDash(dash.map((part) => part * ratio));
    pen.lineWidth = 1.2 * ratio;
    pen.strokeStyle = "#161616";
    pen.stroke();
    pen.setLineDash([]);
  }

  function drawPlace(place) {
    drawOutline(place.posts, [], false);
    const top = place.posts[1], middle = (place.posts[0][0] + place.posts[place.posts.length - 1][0]) / 2;
    pen.fillStyle = "#161616";
    pen.font = `${12 * ratio}px sans-serif`;
    pen.textAlign = "center";
    pen.fillText(place.name, atX(middle), atY(top[1]) - 4 * ratio);
    pen.textAlign = "start";
  }

  // A round length near a fifth of the picture.
  function drawScaleBar() {
    const wanted = (0.2 * stage.width) / pixelsPerMetre, power = 10 ** Math.floor(Math.log10(wanted));
    const length = power * [5, 2, 1].find((digit) => digit * power <= wanted);
    const x = stage.width - 14 * ratio - length * pixelsPerMetre, y = 20 * ratio;
    pen.lineWidth = 2 * ratio;
    pen.strokeStyle = "#161616";
    pen.beginPath();
    pen.moveTo(x, y - 4 * ratio); pen.lineTo(x, y); pen.lineTo(x + length * pixelsPerMetre, y); pen.lineTo(x + length * pixelsPerMetre, y - 4 * ratio);
    pen.stroke();
    pen.fillStyle = "#161616";
    pen.font = `${12 * ratio}px sans-serif`;
    pen.textAlign = "center";
    pen.fillText(`${parseFloat(length.toPrecision(1))} m`, x + 0.5 * length * pixelsPerMetre, y - 7 * ratio);
    pen.textAlign = "start";
  }

  /// Frames around an instant, and the share of the later one.
  function around(time) {
    let k = frames.findIndex((frame) => frame.time >= time);
    if (k < 0) k = frames.length - 1;
    if (k === 0) return [frames[0], frames[0], 0];
    const before = frames[k - 1], after = frames[k];
    return [before, after, (time - before.time) / (after.time - before.time)];
  }

  function drawParticles(time) {
    const [before, after, part] = around(time);
    const size = Math.max(1.2 * ratio, 1.04 * data.size * pixelsPerMetre), half = size / 2;
    const code = codeOf[field.value], nearer = part < 0.5 ? before : after;
    for (let i = 0; i < before.x.length; ++i) {
      const x = data.x[0] + data.x[1] * (before.x[i] + part * (after.x[i] - before.x[i]));
      const y = data.y[0] + data.y[1] * (before.y[i] + part * (after.y[i] - before.y[i]));
      pen.fillStyle = shades[code(nearer, i)];
      pen.fillRect(atX(x) - half, atY(y) - half, size, size);
    }
  }

  let time = start;

  function draw() {
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, stage.width, stage.height);
    drawGround();
    drawParticles(time);
    drawOutline(data.source, [5, 4], true);
    if (data.deposit.length > 0) drawOutline(data.deposit, [], false);
    data.places.forEach(drawPlace);
    drawScaleBar();
    clock.textContent = `${time.toFixed(2)} s of ${end.toFixed(2)} s`;
    slider.value = Math.round((time - start) / step);
    slider.setAttribute("aria-valuetext", `${time.toFixed(2)} seconds`);
    stage.dataset.time = time;
  }

  function drawScale() {
    const bar = element("scale"), ink = bar.getContext("2d");
    const [low, high, unit] = scaleText[field.value];
    for (let i = 0; i < 256; ++i) {
      ink.fillStyle = field.value === "layer" ? shades[28 + 50 * Math.min(4, Math.floor((5 * i) / 256))] : shades[i];
      ink.fillRect((i * bar.width) / 256, 0, bar.width / 256 + 1, bar.height);
    }
    element("low").textContent = field.value === "layer" ? "lowest fifth" : `${parseFloat(low.toPrecision(3))} ${unit}`;
    element("high").textContent = field.value === "layer" ? "highest fifth" : `${parseFloat(high.toPrecision(3))} ${unit}`;
  }

  // ---- playing

  let playing = false, last = 0;

  function tick(now) {
    if (!playing) return;
    time = Math.min(end, time + ((now - last) / 1000) * parseFloat(pace.value));
    last = now;
    draw();
    if (time >= end) return pause();
    requestAnimationFrame(tick);
  }
  function play() {
    if (time >= end) time = start;
    playing = true;
    playButton.textContent = "Pause";
    last = performance.now();
    requestAnimationFrame(tick);
  }
  function pause() {
    playing = false;
    playButton.textContent = "Play";
  }
  function seek(to) {
    time = Math.max(start, Math.min(end, to));
    draw();
  }

  // Whole steps: the last one is the end, which a fraction would miss by its rounding.
  slider.min = 0;
  slider.max = steps;
  slider.step = 1;
  playButton.addEventListener("click", () => (playing ? pause() : play()));
  slider.addEventListener("input", () => { pause(); seek(slider.value < steps ? start + slider.value * step : end); });
  field.addEventListener("change", () => { drawScale(); draw(); });
  const refit = () => { fit(); draw(); };
  window.addEventListener("resize", refit);
  // A page on paper shows the end.
  window.addEventListener("beforeprint", () => { pause(); time = end; refit(); });
  window.addEventListener("afterprint", refit);
  fit();
  drawScale();
  draw();
  return { play, pause, seek, now: () => time, start, end, playing: () => playing };
})();
