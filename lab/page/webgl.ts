// SPDX-License-Identifier: Apache-2.0
// Two kinds of shapes, each drawn in one call for as many as there are: discs with marks, and thick lines.

const QUAD = new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]);

/** u_scale is in device pixels a meter, u_size in device pixels, u_density in device pixels a pixel of CSS. */
const PLACE = `
uniform vec2 u_middle;
uniform vec2 u_size;
uniform float u_scale;
uniform float u_density;
vec2 clip(vec2 meters, vec2 pixels) { return ((meters - u_middle) * u_scale + pixels) * 2.0 / u_size; }
`;

/** A disc is never smaller than a_least pixels, whatever the scale; v_at is in pixels from its middle. */
const DISC_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec2 a_corner;
layout(location = 1) in vec4 a_place;   // x, y, radius (m), heading (rad)
layout(location = 2) in vec4 a_color;
layout(location = 3) in vec4 a_look;    // form, mark, outline (pixels), least radius (pixels)
${PLACE}
out vec2 v_at;
flat out float v_radius;
flat out vec4 v_color;
flat out vec4 v_look;
void main() {
  v_radius = max(a_place.z * u_scale, a_look.w * u_density);
  v_look = vec4(a_look.xy, a_look.z * u_density, 0.0);
  vec2 corner = a_corner * (v_radius + v_look.z + 1.5);
  vec2 ahead = vec2(cos(a_place.w), sin(a_place.w));
  v_at = vec2(dot(corner, ahead), dot(corner, vec2(-ahead.y, ahead.x)));
  v_color = a_color;
  gl_Position = vec4(clip(a_place.xy, corner), 0.0, 1.0);
}`;

/** Forms: 0 disc, 1 ring, 2 dashed ring, 3 diamond ring, 4 cross. Marks: 1 wedge ahead, 2 dart, 3 dot, 4 bar. */
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
  if (form < 0.5) alpha = cover(from - r);
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

/** A line from a to b with round ends, at least a_width.y pixels wide. */
const LINE_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec2 a_corner;
layout(location = 1) in vec4 a_place;   // a, b (m)
layout(location = 2) in vec4 a_color;   // at b
layout(location = 3) in vec3 a_width;   // half of it (m), half of it at least (pixels), share of the color at a
${PLACE}
out vec2 v_at;
flat out float v_half;
flat out float v_length;
flat out float v_fade;
flat out vec4 v_color;
void main() {
  vec2 way = (a_place.zw - a_place.xy) * u_scale;
  v_length = length(way);
  vec2 along = v_length > 0.0 ? way / v_length : vec2(1.0, 0.0);
  v_half = max(a_width.x * u_scale, a_width.y * u_density);
  float reach = v_half + 1.0;
  v_at = vec2(a_corner.x < 0.0 ? -reach : v_length + reach, a_corner.y * reach);
  v_color = a_color;
  v_fade = a_width.z;
  gl_Position = vec4(clip(a_place.xy, along * v_at.x + vec2(-along.y, along.x) * v_at.y), 0.0, 1.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in vec2 v_at;
flat in float v_half;
flat in float v_length;
flat in float v_fade;
flat in vec4 v_color;
out vec4 color;
void main() {
  float along = clamp(v_at.x, 0.0, v_length);
  float d = length(v_at - vec2(along, 0.0)) - v_half;
  float fade = mix(v_fade, 1.0, v_length > 0.0 ? along / v_length : 1.0);
  color = vec4(v_color.rgb, 1.0) * (v_color.a * fade * clamp(0.5 - d, 0.0, 1.0));
}`;

/** Rows of numbers that grow as they are filled. */
export class Rows {
  data = new Float32Array(1024);
  length = 0;
  constructor(readonly columns: number) {}
  clear(): void { this.length = 0; }
  push(...numbers: number[]): void {
    if (this.length + this.columns > this.data.length) {
      const longer = new Float32Array(2 * this.data.length);
      longer.set(this.data);
      this.data = longer;
    }
    this.data.set(numbers, this.length);
    this.length += this.columns;
  }
}

export const DISC_COLUMNS = 12;
export const LINE_COLUMNS = 11;

interface Shape { program: WebGLProgram; array: WebGLVertexArrayObject; buffer: WebGLBuffer; columns: number; room: number }

export interface Painter {
  gl: WebGL2RenderingContext;
  discs: Shape;
  lines: Shape;
}

export function makePainter(gl: WebGL2RenderingContext): Painter {
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  const discs = makeShape(gl, DISC_VERTEX, DISC_FRAGMENT, [4, 4, 4]);
  const lines = makeShape(gl, LINE_VERTEX, LINE_FRAGMENT, [4, 4, 3]);
  return { gl, discs, lines };
}

/** Where all that is drawn next stands: meters in the middle, device pixels a meter and a pixel of CSS. */
export function look(painter: Painter, x: number, y: number, scale: number, density: number, ink: number[]): void {
  const { gl } = painter;
  for (const { program } of [painter.discs, painter.lines]) {
    gl.useProgram(program);
    gl.uniform2f(gl.getUniformLocation(program, "u_middle"), x, y);
    gl.uniform2f(gl.getUniformLocation(program, "u_size"), gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.uniform1f(gl.getUniformLocation(program, "u_scale"), scale);
    gl.uniform1f(gl.getUniformLocation(program, "u_density"), density);
  }
  gl.useProgram(painter.discs.program);
  gl.uniform4fv(gl.getUniformLocation(painter.discs.program, "u_ink"), ink);
}

export function paint(gl: WebGL2RenderingContext, shape: Shape, rows: Rows): void {
  if (rows.length === 0) return;
  gl.useProgram(shape.program);
  gl.bindVertexArray(shape.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, shape.buffer);
  if (rows.length > shape.room) {
    shape.room = rows.data.length;
    gl.bufferData(gl.ARRAY_BUFFER, 4 * shape.room, gl.DYNAMIC_DRAW);
  }
  gl.bufferSubData(gl.ARRAY_BUFFER, 0, rows.data, 0, rows.length);
  gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, rows.length / shape.columns);
}

function makeShape(gl: WebGL2RenderingContext, vertex: string, fragment: string, widths: number[]): Shape {
  const program = link(gl, vertex, fragment);
  const array = gl.createVertexArray()!;
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, QUAD, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  const buffer = gl.createBuffer()!;
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  const columns = widths.reduce((sum, width) => sum + width, 0);
  widths.reduce((offset, width, k) => {
    gl.enableVertexAttribArray(k + 1);
    gl.vertexAttribPointer(k + 1, width, gl.FLOAT, false, 4 * columns, 4 * offset);
    gl.vertexAttribDivisor(k + 1, 1);
    return offset + width;
  }, 0);
  return { program, array, buffer, columns, room: 0 };
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
