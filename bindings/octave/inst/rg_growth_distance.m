% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_growth_distance (A1, A2, ...): by how much both must be scaled about their centres until they touch.
%
% r has the fields distance, lower and upper (certified bounds), status ('optimal', 'contains_origin', 'unreachable', or a limit),
% and normal.
%
% Options are names and values: 'tolerance' (1e-6), the relative gap at which it stops; 'time_limit' in seconds;
% 'max_iterations'; 'method'; 'stop', a function that ends a long query when it returns true; 'pose_1' and 'pose_2', homogeneous
% matrices that move the sets.
function r = rg_growth_distance (A1, A2, varargin)
  r = raygauge_mex ('growth_distance', A1, A2, varargin{:});
end
