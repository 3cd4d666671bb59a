% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% answer = rg_contains (S, x, tolerance): true or false, both proven, or [] near the boundary.
function answer = rg_contains (S, x, varargin)
  answer = raygauge_mex ('contains', S, x, varargin{:});
end
