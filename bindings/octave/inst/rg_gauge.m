% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% [lower, upper] = rg_gauge (S, x, tolerance): proven bounds of min {t >= 0 : x in tS}.
function [lower, upper] = rg_gauge (S, x, varargin)
  bounds = raygauge_mex ('gauge', S, x, varargin{:});
  lower = bounds(1);
  upper = bounds(2);
end
