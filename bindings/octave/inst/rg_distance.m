% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_distance (A, Q, ...): by how much Q must be scaled about the origin until it touches A.
%
% A and Q are sets, made by rg_set, or matrices of points, one a column.
%
% r has the fields distance, lower and upper (certified bounds), status ('optimal', 'contains_origin', 'unreachable', or a limit),
% normal, of the plane that proves the lower bound, and contact_point; [] where there is none.
%
% Options are names and values: 'tolerance' (1e-6), the relative gap at which it stops; 'time_limit' in seconds;
% 'max_iterations'; 'method'; 'stop', a function that ends a long query when it returns true; 'pose_1' and 'pose_2', homogeneous
% matrices that move the sets.
function r = rg_distance (A, Q, varargin)
  r = raygauge_mex ('distance', A, Q, varargin{:});
end
