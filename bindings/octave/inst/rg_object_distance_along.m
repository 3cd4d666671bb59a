% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_object_distance_along (A1, A2, poses, ...): the distances of two objects while the second is on its way.
%
% poses are homogeneous matrices, (n + 1) x (n + 1) x K, or in R^3 a quaternion w, x, y, z and a translation a column, 7 x K. Each
% query starts from what the one before has found.
%
% r has the fields distance, lower and upper (certified bounds), status, an entry a pose, and point_1 and point_2, a column a
% pose; NaN where there is none.
%
% Options are names and values: those of rg_object_distance but 'pose_2', and 'warm' (true); false: no query knows of the others.
function r = rg_object_distance_along (A1, A2, poses, varargin)
  r = raygauge_mex ('object_distance_along', A1, A2, poses, varargin{:});
end
