// SPDX-License-Identifier: Apache-2.0
// Short formulas on a canvas: "*v*^{pref}" is a bold italic v with raised letters; "_{x}" lowers them.

interface Piece {
  text: string;
  symbol: boolean;
  shift: -1 | 0 | 1;  // lowered, on the line, raised
}

function piecesOf(formula: string): Piece[] {
  const pieces: Piece[] = [];
  for (const [, symbol, raised, lowered, plain] of formula.matchAll(/\*([^*]+)\*|\^\{([^}]*)\}|_\{([^}]*)\}|([^*^_]+)/g)) {
    if (symbol !== undefined) pieces.push({ text: symbol, symbol: true, shift: 0 });
    else if (raised !== undefined) pieces.push({ text: raised, symbol: false, shift: 1 });
    else if (lowered !== undefined) pieces.push({ text: lowered, symbol: false, shift: -1 });
    else pieces.push({ text: plain!, symbol: false, shift: 0 });
  }
  return pieces;
}

const fontOf = (piece: Piece, size: number): string =>
  `${piece.symbol ? "italic bold " : ""}${piece.shift ? 0.78 * size : size}px system-ui, sans-serif`;

export function mathWidth(context: CanvasRenderingContext2D, formula: string, size: number): number {
  return piecesOf(formula).reduce((width, piece) => {
    context.font = fontOf(piece, size);
    return width + context.measureText(piece.text).width;
  }, 0);
}

/** Draws from x on, with y as the baseline; over a halo if one is given. */
export function drawMath(context: CanvasRenderingContext2D, formula: string, x: number, y: number, size: number,
                         color: string, halo?: string): void {
  context.save();
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.lineJoin = "round";
  const draw = (put: (text: string, x: number, y: number) => void): void => {
    let at = x;
    for (const piece of piecesOf(formula)) {
      context.font = fontOf(piece, size);
      put(piece.text, at, y - piece.shift * 0.34 * size + (piece.shift < 0 ? -0.12 * size : 0));
      at += context.measureText(piece.text).width;
    }
  };
  if (halo) {
    context.strokeStyle = halo, context.lineWidth = 3.5;
    draw((text, left, base) => context.strokeText(text, left, base));
  }
  context.fillStyle = color;
  draw((text, left, base) => context.fillText(text, left, base));
  context.restore();
}
