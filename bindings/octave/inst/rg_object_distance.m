% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_object_distance (A1, A2, ...): the distance of two objects; 0 if they meet.
%
% r has the fields distance, lower and upper (certified bounds), status ('optimal', 'contains_origin', 'unreachable', or a limit),
% meet (true, false, or [] if it is not decided), normal, the points point_1 and point_2, and the gradients gradient_1 and
% gradient_2 for a translation of each object; [] where there is none.
%
% Options are names and values: 'tolerance' (1e-6), the relative gap at which it stops; 'time_limit' in seconds;
% 'max_iterations'; 'method'; 'stop', a function that ends a long query when it returns true; 'pose_1' and 'pose_2', homogeneous
% matrices that move the sets. 'metric' is the unit ball of another metric.
function r = rg_object_distance (A1, A2, varargin)
  r = raygauge_mex ('object_distance', A1, A2, varargin{:});
end
