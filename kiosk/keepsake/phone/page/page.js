// A pot in a small window, turned by a finger and tilted and brought near by two: the GLB that the kiosk writes, by
// WebGL alone. Where there is no WebGL, or the file is none, the window stays hidden: the postcard is a picture of it.
"use strict";

// GLB 2.0, as the kiosk writes it: positions, normals, and colours or places in pictures that all primitives share, and
// of each its triangles, its colour and how rough it is. The pictures say colour, roughness, and where the surface faces.
async function readPot(bytes) {
  const head = new DataView(bytes);
  if (head.getUint32(0, true) !== 0x46546c67) throw new Error("no GLB");
  const length = head.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
  const bin = 20 + length + 8;
  const array = (index) => {
    const accessor = gltf.accessors[index], view = gltf.bufferViews[accessor.bufferView];
    const from = bin + (view.byteOffset || 0) + (accessor.byteOffset || 0);
    const count = accessor.count * { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[accessor.type];
    const Type = { 5126: Float32Array, 5125: Uint32Array, 5123: Uint16Array }[accessor.componentType];
    return new Type(bytes.slice(from, from + count * Type.BYTES_PER_ELEMENT));
  };
  const shapes = gltf.meshes[0].primitives, { POSITION, NORMAL, COLOR_0, TEXCOORD_0 } = shapes[0].attributes;
  const positions = array(POSITION), triangles = [];
  const coats = shapes.map((shape) => {
    const surface = gltf.materials ? gltf.materials[shape.material || 0].pbrMetallicRoughness : {};
    const own = array(shape.indices), first = triangles.length;
    for (const corner of own) triangles.push(corner);
    const plain = surface.baseColorTexture ? [1, 1, 1, 1] : [0.7, 0.6, 0.5, 1];
    const { baseColorFactor: color = plain, roughnessFactor: rough = 1 } = surface;
    return { first, count: own.length, color: color.slice(0, 3), rough };
  });
  const picture = (texture) => {
    if (!texture) return null;
    const { bufferView, mimeType: type } = gltf.images[gltf.textures[texture.index].source];
    const { byteOffset, byteLength } = gltf.bufferViews[bufferView];
    return createImageBitmap(new Blob([new Uint8Array(bytes, bin + byteOffset, byteLength)], { type }));
  };
  const { pbrMetallicRoughness: coat = {}, normalTexture } = gltf.materials ? gltf.materials[0] : {};
  return {
    positions,
    skin: await picture(coat.baseColorTexture),
    sheen: await picture(coat.metallicRoughnessTexture),
    relief: await picture(normalTexture),
    places: TEXCOORD_0 === undefined ? new Float32Array(positions.length / 3 * 2) : array(TEXCOORD_0),
    normals: array(NORMAL),
    colors: COLOR_0 === undefined ? new Uint16Array(positions.length / 3 * 4).fill(65535) : array(COLOR_0),
    triangles: Uint32Array.from(triangles),
    coats,
  };
}

// The middle of the box round it, and half of its longest side.
function boundsOf(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return {
    middle: low.map((l, k) => (l + high[k]) / 2),
    half: Math.max(...low.map((l, k) => high[k] - l)) / 2,
  };
}

const VERTEX = `
attribute vec3 at, normal, tint;
attribute vec2 lies;
varying vec2 spot;
uniform vec3 middle;
uniform float size, turn, tilt, near;
varying vec3 facing, own, place, round;
vec3 turned(vec3 p) {
  vec3 q = vec3(cos(turn) * p.x + sin(turn) * p.z, p.y, cos(turn) * p.z - sin(turn) * p.x);
  return vec3(q.x, cos(tilt) * q.y - sin(tilt) * q.z, sin(tilt) * q.y + cos(tilt) * q.z);
}
void main() {
  facing = turned(normal);
  own = tint;
  spot = lies;
  round = turned(vec3(-sin(6.2831853 * lies.x), 0.0, cos(6.2831853 * lies.x)));
  vec3 p = turned(at - middle) / size;
  place = p;
  gl_Position = vec4(p.xy * 1.4 * near, -0.5 * p.z, 1.7 - 0.35 * p.z);
}`;
const FRAGMENT = `
precision highp float;
uniform vec3 color;
uniform float rough;
uniform sampler2D skin, sheen, relief;
varying vec2 spot;
varying vec3 facing, own, place, round;
void main() {
  vec3 n = normalize(gl_FrontFacing ? facing : -facing), window = normalize(vec3(-0.5, 0.6, 0.8));
  // Red goes round the pot, green to the picture's top.
  vec3 bent = texture2D(relief, spot).rgb * 2.0 - 1.0;
  n = normalize(bent.x * round + bent.y * cross(n, round) + bent.z * n);
  float light = 0.25 + 0.15 * n.y + 0.6 * (0.5 + 0.5 * dot(n, window));
  // A window's light on the glass, as wide as the glaze is rough; glass gives back a twenty-fifth.
  float wide = max(rough * texture2D(sheen, spot).g, 0.3), sharp = 2.0 / (wide * wide * wide * wide) - 2.0;
  vec3 eye = normalize(vec3(0.0, 0.0, 4.86) - place);
  float shine = 0.04 * (sharp + 8.0) / 25.0 * pow(max(dot(n, normalize(window + eye)), 0.0), sharp);
  gl_FragColor = vec4(pow(min(color * own * pow(texture2D(skin, spot).rgb, vec3(2.2)) * light + shine, 1.0), vec3(0.4545)), 1.0);
}`;

function show(canvas, pot) {
  // What is not drawn anew stays.
  const kept = { preserveDrawingBuffer: true };
  const gl = canvas.getContext("webgl2", kept) || canvas.getContext("webgl", kept);
  if (!gl || !(gl instanceof WebGL2RenderingContext || gl.getExtension("OES_element_index_uint"))) return;
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return;
  gl.useProgram(program);
  for (const [name, values, wide] of [["at", pot.positions, 3], ["normal", pot.normals, 3], ["tint", pot.colors, 4],
    ["lies", pot.places, 2]]) {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    const place = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, wide, wide === 4 ? gl.UNSIGNED_SHORT : gl.FLOAT, wide === 4, 0, 0);
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, pot.triangles, gl.STATIC_DRAW);
  const uniform = (name) => gl.getUniformLocation(program, name);
  for (const [unit, name, plain] of [[0, "skin", [255, 255, 255, 255]], [1, "sheen", [255, 255, 255, 255]],
    [2, "relief", [128, 128, 255, 255]]]) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    const shown = [gl.TEXTURE_2D, 0, gl.RGBA];
    if (pot[name]) gl.texImage2D(...shown, gl.RGBA, gl.UNSIGNED_BYTE, pot[name]);
    else gl.texImage2D(...shown, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.from(plain));
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.uniform1i(uniform(name), unit);
  }
  const { middle, half } = boundsOf(pot.positions);
  gl.uniform3fv(uniform("middle"), middle);
  gl.uniform1f(uniform("size"), half);
  gl.enable(gl.DEPTH_TEST);
  canvas.parentElement.hidden = false;

  const look = hold(canvas);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  let before = null, drawn = "", gone = false;
  canvas.addEventListener("webglcontextlost", () => { gone = canvas.parentElement.hidden = true; });
  const frame = (now) => {
    if (gone) return;
    requestAnimationFrame(frame);
    if (!look.held() && before !== null && !still) look.turn += (now - before) * 0.0006;
    before = now;
    const side = Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2));
    const wanted = [side, look.turn, look.tilt, look.near].join();
    if (wanted === drawn) return; // a phone's battery is the visitor's
    drawn = wanted;
    if (canvas.width !== side) canvas.width = canvas.height = side;
    gl.viewport(0, 0, side, side);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const name of ["turn", "tilt", "near"]) gl.uniform1f(uniform(name), look[name]);
    for (const coat of pot.coats) {
      gl.uniform3fv(uniform("color"), coat.color);
      gl.uniform1f(uniform("rough"), coat.rough);
      gl.drawElements(gl.TRIANGLES, coat.count, gl.UNSIGNED_INT, 4 * coat.first);
    }
  };
  requestAnimationFrame(frame);
}

// How the pot is looked at, as fingers, a mouse and keys on `canvas` change it. One finger turns: up and down it moves
// the page. Two turn, tilt, and bring near as they part; a mouse turns and tilts.
function hold(canvas) {
  const look = { turn: 0, tilt: 0.35, near: 1 }, fingers = new Map();
  const middle = () => [0, 1].map((k) => [...fingers.values()].reduce((sum, at) => sum + at[k], 0) / fingers.size);
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  const between = (low, x, high) => Math.min(Math.max(x, low), high);
  const move = (across, down) => {
    look.turn += across * 0.01;
    look.tilt = between(-1.2, look.tilt + down * 0.01, 1.2);
  };
  look.held = () => fingers.size > 0;
  canvas.onpointerdown = (e) => {
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    canvas.setPointerCapture(e.pointerId);
  };
  canvas.onpointerup = canvas.onpointercancel = (e) => { fingers.delete(e.pointerId); };
  canvas.onpointermove = (e) => {
    if (!fingers.has(e.pointerId)) return;
    const was = middle(), width = apart();
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    const is = middle();
    move(is[0] - was[0], fingers.size > 1 || e.pointerType === "mouse" ? is[1] - was[1] : 0);
    if (width > 0) look.near = between(0.7, look.near * apart() / width, 3);
  };
  canvas.onkeydown = (e) => {
    const step = { ArrowLeft: [-15, 0], ArrowRight: [15, 0], ArrowUp: [0, -15], ArrowDown: [0, 15] }[e.key];
    if (step) move(...step), e.preventDefault();
  };
  // Two fingers are the pot's; the page goes by one.
  const ours = (e) => { if (e.touches.length > 1) e.preventDefault(); };
  for (const kind of ["touchstart", "touchmove"]) canvas.addEventListener(kind, ours, { passive: false });
  return look;
}

// The bytes of `address`. Where the way to the kiosk breaks, it goes on from where it stopped; after five breaks
// without a byte between them it gives up.
async function taken(address) {
  let parts = [], has = 0, tag = "", tries = 5;
  for (;;) {
    try {
      const answer = await fetch(address, has ? { headers: { Range: `bytes=${has}-`, "If-Range": tag } } : {});
      if (!answer.ok) throw new RangeError("not there");
      if (answer.status === 200) [parts, has] = [[], 0];
      tag = answer.headers.get("ETag");
      const reader = answer.body.getReader();
      for (let part; !(part = await reader.read()).done; tries = 5) {
        parts.push(part.value);
        has += part.value.length;
      }
      return new Blob(parts).arrayBuffer();
    } catch (broken) {
      if (broken instanceof RangeError || --tries === 0) throw broken;
      await new Promise((later) => setTimeout(later, 1000));
    }
  }
}

const canvas = document.getElementById("pot");
taken(canvas.dataset.glb)
  .then(readPot)
  .then((pot) => show(canvas, pot))
  .catch(() => { canvas.parentElement.hidden = true; });
