% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% r = rg_prove_motion (robot, q, margin, contact): whether a robot moves without contact through the columns of q, straight in the space
% of its joints from each to the next. One column is one configuration.
%
% robot is a struct: joints, their number; links, a struct array of parent (0: the base), kind ('fixed', 'revolute', 'prismatic'),
% joint, axis, pose (on the parent), scale, offset; bodies, of link, set, pose; obstacles, of set, pose; ignored, pairs of bodies, one a
% column. Bodies are counted from 1, obstacles after them. Bodies of links that a joint joins are ignored.
%
% r.outcome is 'free' (every distance is more than margin, always), 'contact' (at r.time one is at most margin + contact) or
% 'undecided', the first two proven. Of a contact: bodies, lower and upper, depth, point_1, point_2.
function r = rg_prove_motion (robot, q, varargin)
  r = raygauge_mex ('prove_motion', robot, q, varargin{:});
end
