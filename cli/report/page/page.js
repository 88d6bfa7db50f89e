// Draws the sections in order. A section that fails is left out and says so; the others stand.

function hide(id) {
  byId(id).hidden = true;
}

function drawPage() {
  const run = readRun();
  const view = makeView(run);
  byId('report').hidden = false;
  const sections = [drawHead, drawSlider, drawPick, drawTiles, drawAlerts, drawTradeoff, drawFits, drawSource, drawImages, drawTimes, drawPrediction, drawValidation, drawMetrics, drawAttempts,
    drawCandidates, drawFacts, drawStages];
  for (const draw of sections) {
    try {
      draw(run, view);
    } catch (problem) {
      console.error(`${draw.name}: ${problem.stack || problem}`);
      byId('alerts').append(html('div', { class: 'alert' }, `Part of this report could not be drawn (${draw.name}: ${problem.message}). The figures are in result.json.`));
    }
  }
  document.documentElement.dataset.drawn = 'yes';
}

const kMostPrintedRows = 24;

// Folded lists are unfolded on paper, unless they would fill pages: their heading says how many they are, result.json has them.
window.addEventListener('beforeprint', () => {
  for (const details of document.querySelectorAll('details')) details.open = details.querySelectorAll('.dropped tr').length <= kMostPrintedRows;
});

drawPage();
