(() => {
  "use strict";
  const motion = JSON.parse(document.getElementById("motion-data").textContent);
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const { grains, times, size, extent, sides = [] } = motion;
  const data = bytes(motion.samples);
  const pairs = bytes(motion.radii);
  const radii = Array.from({ length: grains }, (_, i) => pairs[2 * i] + 256 * pairs[2 * i + 1]);
  const LAST = 65534, OUTSIDE = 65535, SINGLE = 250, DRIVEN = 251, FIXED = 252;

  const figure = document.getElementById("motion");
  const canvas = figure.querySelector("canvas");
  const [button, slider, output, select, scale] =
    ["button", "input", "output", "select", ".scale"].map((name) => figure.querySelector(name));
  const context = canvas.getContext("2d");

  // Colours between anchors, which are equally spaced along the scale.
  const ramp = (anchors) => Array.from({ length: 256 }, (_, byte) => {
    const at = byte / 255 * (anchors.length - 1);
    const k = Math.min(Math.floor(at), anchors.length - 2);
    return `rgb(${anchors[k].map((from, c) => Math.round(from + (anchors[k + 1][c] - from) * (at - k)))})`;
  });
  const speeds = ramp([[240, 240, 240], [86, 180, 233], [0, 114, 178], [20, 30, 80]]);
  const pressures = ramp([[0, 114, 178], [160, 200, 225], [250, 250, 250], [240, 170, 120], [180, 60, 0]]);
  const kinds = Array.from({ length: 256 }, (_, label) =>
    label === SINGLE ? "#fff" : label === DRIVEN ? "#aaa" : label === FIXED ? "#777"
      : `hsl(${(label * 137.507764) % 360} 60% 75%)`);
  const isScale = motion.scale === true;
  const fragments = isScale ? ramp([[205, 214, 222], [245, 200, 66], [213, 94, 0], [90, 0, 30]]) : kinds;

  const engineering = (value, unit) => {
    if (value === 0) return `0 ${unit}`;
    const power = Math.max(-4, Math.min(4, Math.floor(Math.log10(Math.abs(value)) / 3)));
    const prefix = ["p", "n", "µ", "m", "", "k", "M", "G", "T"][power + 4];
    return `${(value / 10 ** (3 * power)).toPrecision(3)} ${prefix}${unit}`;
  };

  const draw = () => {
    const sample = Number(slider.value), start = 8 * grains * sample;
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = Math.max(1, width * size[1] / size[0]);
    canvas.style.height = `${height}px`;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const unit = canvas.width / size[0] * extent / LAST;
    const kind = select.value;
    const [palette, column] = kind === "speed" ? [speeds, 6] : kind === "pressure" ? [pressures, 7] : [fragments, 5];
    context.lineWidth = Math.max(0.5, 0.6 * ratio);
    context.strokeStyle = "#222";
    for (let i = 0; i < grains; i += 1) {
      const word = (at) => data[at] + 256 * data[at + 1];
      const x = word(start + 2 * i), y = word(start + 2 * (grains + i));
      if (x === OUTSIDE) continue;
      const r = Math.max(radii[i] * unit, 0.5);
      const [cx, cy] = [x * unit, canvas.height - y * unit];
      const angle = data[start + 4 * grains + i] / 256 * 2 * Math.PI;
      context.fillStyle = palette[data[start + column * grains + i]];
      context.beginPath();
      if (sides[i] > 0) {
        for (let k = 0; k < sides[i]; k += 1) {
          const at = angle + 2 * Math.PI * k / sides[i];
          context.lineTo(cx + r * Math.cos(at), cy - r * Math.sin(at));
        }
        context.closePath();
      } else {
        context.arc(cx, cy, r, 0, 7);
      }
      context.fill();
      if (r > 2 && !isScale) context.stroke();
      if (r > 4 && !isScale) {
        context.beginPath();
        context.moveTo(cx, cy);
        context.lineTo(cx + r * Math.cos(angle), cy - r * Math.sin(angle));
        context.stroke();
      }
    }
    output.textContent = `t = ${engineering(times[sample], "s")}`;
  };

  const show = () => {
    const kind = select.value;
    scale.hidden = kind === "fragment" && !isScale;
    const [from, to, palette] = kind === "fragment"
      ? ["0", "1", fragments]
      : kind === "speed"
      ? ["0 m/s", engineering(motion.speed, "m/s"), speeds]
      : [engineering(-motion.pressure, "Pa"), engineering(motion.pressure, "Pa"), pressures];
    const [low, bar, high] = scale.children;
    [low.textContent, high.textContent] = [from, to];
    const stops = [0, 51, 102, 153, 204, 255].map((byte) => palette[byte]);
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    draw();
  };

  let timer = 0;
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    button.textContent = "Play";
  };
  const play = () => {
    if (Number(slider.value) === times.length - 1) slider.value = 0;
    button.textContent = "Pause";
    // All samples take about ten seconds.
    timer = setInterval(() => {
      slider.value = Number(slider.value) + 1;
      draw();
      if (Number(slider.value) === times.length - 1) stop();
    }, Math.max(30, Math.min(200, 10000 / times.length)));
  };
  button.addEventListener("click", () => (timer ? stop() : play()));
  slider.addEventListener("input", () => { stop(); draw(); });
  select.addEventListener("change", show);
  addEventListener("resize", draw);
  show();
})();
