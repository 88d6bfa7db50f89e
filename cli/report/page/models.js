// The fitted models as functions, with the formulas of fitting/models; parameters stand in the order of the formula.

const kErrorModels = {
  exponential: ([alpha, lambda], n) => alpha * (1 - Math.exp(-lambda * (n - 1))),
  power: ([a, p], n) => (n > 1 ? a * (n - 1) ** p : 0),
  logarithm: ([a], n) => a * Math.log(n),
  constant: ([a], n) => (n > 1 ? a : 0),
};

// null where there is no usable model.
function modelledError(model, period) {
  const formula = model && kErrorModels[model.family];
  if (!formula || !model.parameters.length) return null;
  const value = formula(model.parameters.map((parameter) => parameter.value), period);
  return isNumber(value) ? value : null;
}

// Eq. 5: frame time in ms of so many fragments that hit and that miss.
function modelledMs(configuration, hits, misses) {
  const { hit_ns: hit, miss_ns: miss, overhead_ms: overhead } = configuration;
  return isNumber(hit) && isNumber(miss) && isNumber(overhead) ? overhead + (hits * hit + misses * miss) * 1e-6 : null;
}
