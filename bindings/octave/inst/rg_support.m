% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% [value, point, center] = rg_support (S, u): max u'x over S, a point that attains it, and a point deep inside S.
function [value, point, center] = rg_support (S, u)
  r = raygauge_mex ('support', S, u);
  value = r.value;
  point = r.point;
  center = r.center;
end
