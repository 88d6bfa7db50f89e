// Labels next to the points that they name, where they cover least of what is drawn.

const kLabelHeight = 15;
const labelWidth = (text) => text.length * 6.6 + 4;

const boxesOverlap = (a, b) => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;

const boxAt = (x, y, width) => ({ x0: x, x1: x + width, y0: y - kLabelHeight / 2, y1: y + kLabelHeight / 2 });

// anchors: [{x, y, text}]; obstacles: points {x, y} that a label had better not cover; bounds {x0, x1, y0, y1}; taken: boxes.
// Returns for each anchor the box of its label and whether it lies so far off that it needs a leader line.
function placeLabels(anchors, obstacles, bounds, taken) {
  const placed = [...taken];
  return anchors.map((anchor) => {
    const width = labelWidth(anchor.text);
    let best = null;
    for (const distance of [0, 14, 28, 44, 62, 84, 110, 140]) {
      for (const side of [-1, 1]) {
        for (const x of [anchor.x + 10, anchor.x - 10 - width, anchor.x - width / 2]) {
          const centred = x === anchor.x - width / 2;
          const y = anchor.y + side * (centred ? Math.max(distance, 16) : distance);
          const box = boxAt(x, y, width);
          if (box.x0 < bounds.x0 || box.x1 > bounds.x1 || box.y0 < bounds.y0 || box.y1 > bounds.y1) continue;
          const covered = obstacles.filter((point) => point.x > box.x0 - 3 && point.x < box.x1 + 3 && point.y > box.y0 - 2 && point.y < box.y1 + 2);
          const cost = distance * 0.12 + (centred ? 2 : 0) + covered.length * 4 +
            placed.filter((other) => boxesOverlap(box, other)).length * 200;
          if (!best || cost < best.cost) best = { cost, box, far: distance > 18 };
        }
      }
    }
    if (!best) best = { box: boxAt(Math.min(anchor.x + 10, bounds.x1 - width), anchor.y, width), far: false };
    placed.push(best.box);
    return best;
  });
}
