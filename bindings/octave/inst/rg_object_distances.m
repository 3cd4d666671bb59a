% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_object_distances (pairs, ...): the distances of many pairs of objects, on threads.
%
% pairs is a K x 2 cell array of sets. r has the fields distance, lower, upper and status, an entry a pair.
%
% Options are names and values: 'tolerance' (1e-6), 'threads' (1), 'metric'.
function r = rg_object_distances (pairs, varargin)
  r = raygauge_mex ('object_distances', pairs, varargin{:});
end
