% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% [outcome, normal] = rg_separation (A1, A2, ...): 'separated', 'intersecting', both proven, or 'undecided'.
%
% normal is that of a plane between the objects; [] where there is none.
%
% Options are names and values: 'tolerance' (1e-6), the relative gap at which it stops; 'time_limit' in seconds;
% 'max_iterations'; 'method'; 'stop', a function that ends a long query when it returns true; 'pose_1' and 'pose_2', homogeneous
% matrices that move the sets.
function [outcome, normal] = rg_separation (A1, A2, varargin)
  r = raygauge_mex ('separation', A1, A2, varargin{:});
  outcome = r.outcome;
  normal = r.normal;
end
