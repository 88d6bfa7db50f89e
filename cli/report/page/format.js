'use strict';

// Numbers and names as text. null, undefined and NaN are "n/a" everywhere.

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

function formatNumber(value, digits = 3) {
  if (!isNumber(value)) return 'n/a';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e7) return value.toExponential(digits - 1);
  const rounded = Number(value.toPrecision(digits));
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(rounded))));
  return rounded.toFixed(decimals);
}

const formatMs = (value) => (isNumber(value) ? `${formatNumber(value)} ms` : 'n/a');
const formatSpeedup = (value) => (isNumber(value) ? `${formatNumber(value)}×` : 'n/a');
const formatPercent = (value) => (isNumber(value) ? `${formatNumber(100 * value, Math.abs(value) < 0.1 ? 2 : 3)}%` : 'n/a');
const formatInterval = (ci) => (ci ? `${formatNumber(ci[0])} to ${formatNumber(ci[1])}` : '');
const formatPeriod = (period) => (period === null ? 'never' : String(period));
const formatPeriodLong = (period) => (period === null ? 'never refreshed' : `period ${period}`);

// Ticks and what the user gave: no digits beyond those that it has.
const formatTick = (value) => (isNumber(value) ? String(Number(value.toPrecision(6))) : 'n/a');

function formatSeconds(seconds) {
  if (!isNumber(seconds)) return 'n/a';
  if (seconds < 100) return `${formatNumber(seconds, 2)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}

function formatPlace(item) {
  if (!item.file) return '';
  if (!item.line) return item.file;
  return `${item.file}:${item.line}${item.column ? `:${item.column}` : ''}`;
}

// The place without the folders of its file.
const formatShortPlace = (item) => formatPlace(item).replace(/^.*\//, '');

function formatPattern(configuration) {
  const block = configuration.block_pixels;
  return block ? `${configuration.pattern} ${block}×${block}` : configuration.pattern;
}

const formatStorage = (configuration) => [formatPattern(configuration), configuration.filter, configuration.encoding].join(', ');
const formatVariant = (configuration) => `${configuration.strategy}, ${formatStorage(configuration)}`;

const kClockNames = { process_cpu: 'process CPU time', timestamps: 'GPU timestamps' };
const formatClock = (clock) => kClockNames[clock] || clock;
