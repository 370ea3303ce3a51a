// SPDX-License-Identifier: Apache-2.0
// Three kinds of shapes, discs with marks, thick lines and parallelograms; one call draws all shapes of a kind. Their rows are in a
// texture, and each of the four vertices of a shape reads its values from it. Without a graphics processor, instances
// would be as slow as one call for each shape.

const TEXELS = 3;              // of four numbers, for each shape
export const COLUMNS = 4 * TEXELS;
const SHAPES_A_LINE = 256;     // in the texture

/** u_scale is in device pixels per meter, u_size in device pixels, u_density in device pixels per pixel of CSS. */
const PLACE = `
uniform vec2 u_middle;
uniform vec2 u_size;
uniform float u_scale;
uniform float u_density;
uniform highp sampler2D u_rows;  // ${SHAPES_A_LINE} shapes a line, ${TEXELS} texels a shape
vec2 corner() { return vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1); }
vec4 texel(int k) {
  int shape = gl_VertexID >> 2;
  return texelFetch(u_rows, ivec2((shape % ${SHAPES_A_LINE}) * ${TEXELS} + k, shape / ${SHAPES_A_LINE}), 0);
}
vec2 clip(vec2 meters, vec2 pixels) { return ((meters - u_middle) * u_scale + pixels) * 2.0 / u_size; }
`;

/** A disc is never smaller than its least radius, at any scale; v_at is in pixels from its middle. */
const DISC_VERTEX = `#version 300 es
precision highp float;
${PLACE}
out vec2 v_at;
flat out float v_radius;
flat out vec4 v_color;
flat out vec4 v_look;
void main() {
  vec4 place = texel(0);  // x, y, radius (m), heading (rad)
  vec4 look = texel(2);   // form, mark, outline (pixels), least radius (pixels)
  v_radius = max(place.z * u_scale, look.w * u_density);
  v_look = vec4(look.xy, look.z * u_density, 0.0);
  vec2 reach = corner() * (v_radius + 1.5);
  vec2 ahead = vec2(cos(place.w), sin(place.w));
  v_at = vec2(dot(reach, ahead), dot(reach, vec2(-ahead.y, ahead.x)));
  v_color = texel(1);
  gl_Position = vec4(clip(place.xy, reach), 0.0, 1.0);
}`;

/** Forms: 0 disc, 1 ring, 2 dashed ring, 3 diamond ring, 4 cross, 5 ball. Marks: 1 wedge ahead, 2 dart, 3 dot, 4 bar. */
const DISC_FRAGMENT = `#version 300 es
precision highp float;
in vec2 v_at;
flat in float v_radius;
flat in vec4 v_color;
flat in vec4 v_look;
uniform vec4 u_ink;      // of marks on discs
out vec4 color;
float cover(float distance) { return clamp(0.5 - distance, 0.0, 1.0); }
void main() {
  float r = v_radius;
  float from = length(v_at);
  float form = v_look.x;
  float alpha;
  if (form < 0.5 || form > 4.5) alpha = cover(from - r);
  else if (form < 2.5) {
    float width = max(v_look.z, 1.0);
    alpha = cover(abs(from - r + width * 0.5) - width * 0.5);
    if (form > 1.5) alpha *= step(0.0, sin(atan(v_at.y, v_at.x) * max(6.0, floor(r * 0.35))));
  } else if (form < 3.5) {
    float d = (abs(v_at.x) + abs(v_at.y)) * 0.7071 - r * 0.7071;
    alpha = cover(abs(d) - max(v_look.z, 1.0) * 0.5);
  } else {
    vec2 a = abs(v_at);
    float d = max(abs(a.x - a.y) * 0.7071, max(a.x, a.y) - r);
    alpha = cover(d - max(v_look.z, 1.0) * 0.5);
  }
  vec4 paint = v_color;
  if (form > 4.5) paint.rgb *= 1.0 - 0.5 * smoothstep(0.2, 1.4, length(v_at / r - vec2(-0.35, 0.4)));  // lit from the upper left
  float mark = v_look.y;
  if (mark > 0.5 && r > 2.5) {
    float d;
    if (mark < 1.5) d = max(abs(v_at.y) - (r - v_at.x) * 0.42, r * 0.12 - v_at.x);
    else if (mark < 2.5) d = max(abs(v_at.y) - (r * 0.8 - v_at.x) * 0.5, -0.7 * r + abs(v_at.y) * 0.7 - v_at.x);
    else if (mark < 3.5) d = from - r * 0.4;
    else d = max(abs(v_at.y) - r * 0.18, abs(v_at.x) - r * 0.55);
    paint.rgb = mix(paint.rgb, u_ink.rgb, u_ink.a * cover(d));
  }
  color = vec4(paint.rgb, 1.0) * (paint.a * alpha);
}`;

/** A line from a to b; with flat ends its pieces join seamlessly. */
const LINE_VERTEX = `#version 300 es
precision highp float;
${PLACE}
out vec2 v_at;
flat out float v_half;
flat out float v_length;
flat out vec2 v_fade;
flat out vec4 v_color;
void main() {
  vec4 place = texel(0);  // a, b (m)
  vec4 width = texel(2);  // half of it (m), half of it at least (pixels), share of the color at a, flat ends
  vec2 line = (place.zw - place.xy) * u_scale;
  v_length = length(line);
  vec2 along = v_length > 0.0 ? line / v_length : vec2(1.0, 0.0);
  v_half = max(width.x * u_scale, width.y * u_density);
  float reach = v_half + 1.0;
  vec2 side = corner();
  v_at = vec2(side.x < 0.0 ? -reach : v_length + reach, side.y * reach);
  v_color = texel(1);  // at b
  v_fade = width.zw;
  gl_Position = vec4(clip(place.xy, along * v_at.x + vec2(-along.y, along.x) * v_at.y), 0.0, 1.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in vec2 v_at;
flat in float v_half;
flat in float v_length;
flat in vec2 v_fade;   // share of the color at a, flat ends
flat in vec4 v_color;
out vec4 color;
void main() {
  float along = clamp(v_at.x, 0.0, v_length);
  float d = length(v_at - vec2(along, 0.0)) - v_half;
  float beyond = max(-v_at.x, v_at.x - v_length);
  float ends = v_fade.y > 0.5 ? clamp(0.5 - beyond, 0.0, 1.0) : 1.0;
  float fade = mix(v_fade.x, 1.0, v_length > 0.0 ? along / v_length : 1.0);
  color = vec4(v_color.rgb, 1.0) * (v_color.a * fade * ends * clamp(0.5 - d, 0.0, 1.0));
}`;

/** A parallelogram with a corner and two sides. */
const FACE_VERTEX = `#version 300 es
precision highp float;
${PLACE}
flat out vec4 v_color;
void main() {
  vec4 place = texel(0);  // a corner, a side (m)
  vec2 share = 0.5 * corner() + 0.5;
  v_color = texel(1);
  gl_Position = vec4(clip(place.xy + share.x * place.zw + share.y * texel(2).xy, vec2(0.0)), 0.0, 1.0);
}`;

const FACE_FRAGMENT = `#version 300 es
precision highp float;
flat in vec4 v_color;
out vec4 color;
void main() { color = vec4(v_color.rgb, 1.0) * v_color.a; }`;

/** Rows of numbers, one for each shape. The memory grows when it is full. */
export class Rows {
  data = new Float32Array(COLUMNS * SHAPES_A_LINE);
  length = 0;
  clear(): void { this.length = 0; }
  push(...numbers: number[]): void {
    if (this.length + COLUMNS > this.data.length) {
      const longer = new Float32Array(2 * this.data.length);
      longer.set(this.data);
      this.data = longer;
    }
    this.data.set(numbers, this.length);
    this.length += COLUMNS;
  }
}

interface Shape { program: WebGLProgram; uniform: Record<string, WebGLUniformLocation | null> }

export interface Painter {
  gl: WebGL2RenderingContext;
  discs: Shape;
  lines: Shape;
  faces: Shape;
  textures: Map<Rows, { texture: WebGLTexture; lines: number }>;
  corners: number;  // number of shapes with corners in the index buffer
}

export function makePainter(gl: WebGL2RenderingContext): Painter {
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  gl.bindVertexArray(gl.createVertexArray());  // without attributes: a vertex is identified by its number
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  const [discs, lines] = [makeShape(gl, DISC_VERTEX, DISC_FRAGMENT), makeShape(gl, LINE_VERTEX, LINE_FRAGMENT)];
  const faces = makeShape(gl, FACE_VERTEX, FACE_FRAGMENT);
  return { gl, discs, lines, faces, textures: new Map(), corners: 0 };
}

/** The transform of all later drawing: meters in the middle, device pixels per meter and per pixel of CSS. */
export function look({ gl, discs, lines, faces }: Painter, x: number, y: number, scale: number, density: number, ink: number[]): void {
  for (const { program, uniform } of [lines, faces, discs]) {
    gl.useProgram(program);
    gl.uniform2f(uniform["u_middle"]!, x, y);
    gl.uniform2f(uniform["u_size"]!, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.uniform1f(uniform["u_scale"]!, scale);
    gl.uniform1f(uniform["u_density"]!, density);
  }
  gl.uniform4fv(discs.uniform["u_ink"]!, ink);
}

/** `isNew`: the rows have changed since the last drawing. */
export function paint(painter: Painter, shape: Shape, rows: Rows, isNew = true): void {
  if (rows.length === 0) return;
  const { gl } = painter;
  gl.useProgram(shape.program);
  upload(painter, rows, isNew);
  const count = rows.length / COLUMNS;
  if (count > painter.corners) makeCorners(painter, rows.data.length / COLUMNS);
  gl.drawElements(gl.TRIANGLES, 6 * count, gl.UNSIGNED_INT, 0);
}

/** Draws two triangles each for `count` shapes. */
function makeCorners(painter: Painter, count: number): void {
  const corners = new Uint32Array(6 * count);
  for (let shape = 0; shape < count; ++shape) corners.set([0, 1, 2, 2, 1, 3].map((corner) => 4 * shape + corner), 6 * shape);
  painter.gl.bufferData(painter.gl.ELEMENT_ARRAY_BUFFER, corners, painter.gl.STATIC_DRAW);
  painter.corners = count;
}

/** Leaves the texture of `rows` bound. */
function upload({ gl, textures }: Painter, rows: Rows, isNew: boolean): void {
  let known = textures.get(rows);
  if (!known) {
    textures.set(rows, known = { texture: gl.createTexture()!, lines: 0 });
    gl.bindTexture(gl.TEXTURE_2D, known.texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  }
  gl.bindTexture(gl.TEXTURE_2D, known.texture);
  const width = TEXELS * SHAPES_A_LINE;
  const room = rows.data.length / (COLUMNS * SHAPES_A_LINE);
  if (known.lines !== room) {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, room, 0, gl.RGBA, gl.FLOAT, rows.data);
    known.lines = room;
  } else if (isNew) {
    const lines = Math.ceil(rows.length / (COLUMNS * SHAPES_A_LINE));
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, lines, gl.RGBA, gl.FLOAT, rows.data);
  }
}

function makeShape(gl: WebGL2RenderingContext, vertex: string, fragment: string): Shape {
  const program = link(gl, vertex, fragment);
  const names = ["u_middle", "u_size", "u_scale", "u_density", "u_ink"];
  return { program, uniform: Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)])) };
}

function link(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram()!;
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error(`the shader does not build: ${gl.getProgramInfoLog(program)}`);
  }
  return program;
}
