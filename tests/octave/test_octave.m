% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT
% Every function of bindings/octave with good and bad input. Ends with an error where one is wrong.
1;

function refused (code, words, call)
  try
    call ();
  catch problem
    assert (problem.identifier, ['raygauge:' code]);
    assert (isempty (words) || ! isempty (strfind (problem.message, words)), problem.message);
    return;
  end
  error ('not refused: %s', func2str (call));
end

% h (u) is as expected, and attained.
function has_support (S, u, expected)
  [value, point, center] = rg_support (S, u);
  assert (value, expected, 1e-12);
  assert (u' * point, expected, 1e-12);
  assert (u' * center <= value + 1e-12);
end

function bounds_hold (r, expected, tolerance)
  assert (r.lower <= expected + 1e-14 && expected - 1e-14 <= r.upper);
  assert (r.upper - r.lower <= tolerance * max (abs (r.upper), abs (r.lower)));
  assert (r.lower <= r.distance && r.distance <= r.upper);
end

o = [0; 0; 0]; x = [1; 0; 0]; one = [1; 1; 1]; y2 = [0; 2; 0]; u = [0; 3; 4];
ball = @(c, r) rg_set ('ball', c, r);

% Sets: closed forms of their support functions.
P = [1 -1; 2 0; 3 2];
has_support (P, u, 18);
has_support (rg_set ('points', P), u, 18);
has_support (rg_set ('prepared_points', P), u, 18);
has_support (ball (o, 2), u, 10);
has_support (rg_set ('box', o, one), u, 7);
has_support (rg_set ('ellipsoid', o, [0 0; 1 0; 0 2]), u, sqrt (73));
has_support (rg_set ('p_norm_ball', o, one, Inf), u, 7);
has_support (rg_set ('capsule', o, y2, 1), u, 11);
has_support (rg_set ('cylinder', o, y2, 1), u, 10);
has_support (rg_set ('cone', o, 2, y2, 0), u, 8);
has_support (rg_set ('simplex', o, one), u, 4);
has_support (rg_set ('zonotope', o, y2), u, 6);
has_support (rg_set ('h_polytope', [eye(3); -eye(3)], [1; 2; 3; 4; 5; 6]), u, 18);
has_support (rg_set ('contact_wrenches', o, x, 0.5, 0), [1; 0; 0; 0; 0; 0], 1);
has_support (rg_set ('support_mapping', o, @(v) v / max (norm (v), realmin)), u, 5);
has_support (rg_set ('affine_image', ball (o, 1), [2 0 0; 0 0 3; 0 1 0], one), u, 7 + norm ([4 9]));
has_support (rg_set ('sum', ball (o, 1), P), u, 5 + 18);
has_support (rg_set ('difference', P, ball (o, 1)), u, 18 + 5);
has_support (rg_set ('union_hull', P, ball (o, 1), ball (o, 4)), u, 20);
[lower, upper] = rg_gauge (ball (o, 2), u);
assert (lower <= 2.5 && 2.5 <= upper && upper - lower <= 1e-6 * upper);
assert (rg_contains (ball (o, 2), one) && ! rg_contains (ball (o, 2), u, 1e-9));

% Distances.
triangle = [2 4 4; 0 -1 1]; square = [1 -1 0 0; 0 0 1 -1];
r = rg_distance (triangle, square);
bounds_hold (r, 2, 1e-6);
assert (r.status, 'optimal');
assert (r.normal(1), -1, 1e-6);
assert (r.contact_point, [2; 0], 1e-6);
assert (rg_distance (square, square).status, 'contains_origin');
assert (isempty (rg_distance (square, square).contact_point) || norm (rg_distance (square, square).contact_point) < 1e-12);
r = rg_distance (triangle, [-1 -1 -1; 0 1 -1]);
assert (r.status, 'unreachable');
assert (r.distance, Inf);
left = ball (o, 1); right = ball ([5; 0; 0], 2);
r = rg_object_distance (left, right, 'tolerance', 1e-9);
bounds_hold (r, 2, 1e-9);
assert (r.meet, false);
assert (r.point_2 - r.point_1, [2; 0; 0], 1e-6);
assert (r.gradient_2, x, 1e-6);
bounds_hold (rg_object_distance (left, right, 'metric', ball (o, 2)), 1, 1e-6);
T = eye (4); T(1:3, 4) = [-2.5; 0; 0];
r = rg_signed_distance (left, right, 'pose_2', T);
bounds_hold (r, -0.5, 1e-6);
assert (r.meet, true);
assert (r.normal, -x, 1e-6);
turn = [0 -1 0 0; 1 0 0 0; 0 0 1 0; 0 0 0 1]; % e_1 to e_2
rod = rg_set ('capsule', o, [3; 0; 0], 0.5);
bounds_hold (rg_object_distance (rod, ball ([0; 5; 0], 1), 'pose_1', turn), 0.5, 1e-6);
r = rg_growth_distance (left, ball ([6; 0; 0], 2));
bounds_hold (r, 2, 1e-6);
assert (rows (r.normal), 3);
[outcome, normal] = rg_separation (left, right);
assert (outcome, 'separated');
assert (abs (normal(1)) > 0);
assert (rg_separation (left, left), 'intersecting');
assert (rg_distance (triangle, square, 'method', 'newton', 'time_limit', 10, 'max_iterations', 1000).distance, 2, 1e-5);

% One on its way: the same as frame by frame, whichever way the poses are given, and with hints within the bounds.
angles = linspace (0, 1, 20);
poses = zeros (4, 4, 20);
for k = 1:20
  c = cos (angles(k)); s = sin (angles(k));
  poses(:, :, k) = [c -s 0 0; s c 0 5; 0 0 1 1; 0 0 0 1];
end
quaternions = [cos(angles / 2); zeros(2, 20); sin(angles / 2); zeros(1, 20); 5 + zeros(1, 20); 1 + zeros(1, 20)];
cold = rg_object_distance_along (left, rod, poses, 'warm', false, 'tolerance', 1e-9);
warm = rg_object_distance_along (left, rod, quaternions, 'tolerance', 1e-9);
for k = 1:20
  r = rg_object_distance (left, rod, 'pose_2', poses(:, :, k), 'tolerance', 1e-9);
  assert ([cold.distance(k), cold.lower(k), cold.upper(k)], [r.distance, r.lower, r.upper]);
  assert (cold.point_2(:, k), r.point_2);
  assert (cold.status{k}, r.status);
  assert (warm.lower(k) <= r.upper + 1e-14 && r.lower <= warm.upper(k) + 1e-14);
end
assert (rg_object_distance_along (left, rod, poses(:, :, 3), 'pose_1', turn, 'metric', ball (o, 2)).distance, cold.distance(3) / 2, 1e-5);
assert (size (rg_object_distance_along (left, rod, zeros (4, 4, 0)).point_1), [3 0]);
refused ('RG_DIMENSION_MISMATCH', 'poses', @() rg_object_distance_along (left, rod, eye (3)));
refused ('RG_INVALID_PARAMETER', 'last row', @() rg_object_distance_along (left, rod, ones (4)));
refused ('RG_INVALID_PARAMETER', 'R', @() rg_object_distance_along (left, rod, diag ([2 1 1 1])));
refused ('RG_INVALID_PARAMETER', 'quaternion', @() rg_object_distance_along (left, rod, zeros (7, 2)));
refused ('RG_INVALID_PARAMETER', 'doubles', @() rg_object_distance_along (left, rod, 'there'));
refused ('RG_INVALID_PARAMETER', 'two sets', @() raygauge_mex ('object_distance_along', left, rod));
refused ('RG_INVALID_PARAMETER', 'warm', @() rg_object_distance_along (left, rod, poses, 'warm', 1));

% Long queries are stopped; the bounds hold.
rand ('twister', 1);
far_cloud = rand (40, 1500) + [3; zeros(39, 1)]; near_cloud = rand (40, 1500) - 0.5;
whole = rg_distance (far_cloud, near_cloud);
r = rg_distance (far_cloud, near_cloud, 'stop', @() true);
assert (r.status, 'time_limit');
assert (r.lower <= whole.upper && whole.lower <= r.upper);
assert (rg_distance (far_cloud, near_cloud, 'stop', @() false).distance, whole.distance);
assert (rg_distance (far_cloud, near_cloud, 'time_limit', 1e-9).status, 'time_limit');
assert (rg_distance (far_cloud, near_cloud, 'method', 'zheng_yamane', 'max_iterations', 3).status, 'iteration_limit');

% Batches: the same as one by one.
pairs = cell (50, 2);
for k = 1:50
  pairs(k, :) = {left, ball([2 + k; 0; 0], 1)};
end
r = rg_object_distances (pairs, 'threads', 2);
assert (r.distance, (1:50)', 1e-5);
assert (r.status{50}, 'optimal');
assert (r.distance(7), rg_object_distance (pairs{7, :}).distance);
r = rg_growth_distances (pairs, 'tolerance', 1e-9);
assert (r.lower <= (3:52)' / 2 & (3:52)' / 2 <= r.upper);

% A bar that turns about e_3 past a ball: at the angle q they are 0.8 cos q - 0.3 apart.
robot.joints = 1;
robot.links = struct ('kind', 'revolute', 'joint', 1, 'axis', [0; 0; 1]);
robot.bodies = struct ('link', 1, 'set', rg_set ('capsule', o, x, 0.1));
robot.obstacles = struct ('set', ball ([0; 0.8; 0], 0.2));
assert (rg_prove_motion (robot, [0 1.18]).outcome, 'free');
assert (rg_prove_motion (robot, [0 1.18], 0.01).outcome, 'contact');
r = rg_prove_motion (robot, [-1 0 1.5]);
assert (r.outcome, 'contact');
assert (r.bodies, [1 2]);
assert (r.time > 1.7 && r.time <= 2);
robot.ignored = [1; 2];
assert (rg_prove_motion (robot, [-1 0 1.5]).outcome, 'free');
refused ('RG_DIMENSION_MISMATCH', 'rows', @() rg_prove_motion (robot, [1; 2]));
refused ('RG_NON_FINITE', 'joint', @() rg_prove_motion (robot, [0 NaN]));
refused ('RG_INVALID_PARAMETER', 'margin', @() rg_prove_motion (robot, 0, -1));
robot.ignored = [1; 3];
refused ('RG_INVALID_PARAMETER', 'body_2', @() rg_prove_motion (robot, 0));
robot.ignored = [1 2];
refused ('RG_DIMENSION_MISMATCH', 'two rows', @() rg_prove_motion (robot, 0));
robot.ignored = [1; 1.5];
refused ('RG_INVALID_PARAMETER', 'whole', @() rg_prove_motion (robot, 0));
robot.ignored = [];
robot.bodies.link = 2;
refused ('RG_INVALID_PARAMETER', 'link', @() rg_prove_motion (robot, 0));
robot.links.axes = [];
refused ('RG_UNKNOWN_NAME', 'axes', @() rg_prove_motion (robot, 0));
robot.links = rmfield (robot.links, 'axes');
robot.links.kind = 'ball';
refused ('RG_UNKNOWN_NAME', 'revolute', @() rg_prove_motion (robot, 0));
refused ('RG_INVALID_PARAMETER', 'struct', @() rg_prove_motion (3, 0));
refused ('RG_INVALID_PARAMETER', 'joints: a whole number', @() rg_prove_motion (struct ('joints', NaN), 0));

% Mistakes.
own = rg_set ('support_mapping', o, @(v) error ('mine'));
refused ('RG_INVALID_PARAMETER', 'radius', @() rg_support (ball (o, -1), x));
refused ('RG_NON_FINITE', 'coordinate 1', @() rg_support (rg_set ('points', [1; NaN; 2]), x));
refused ('RG_NON_FINITE', 'coordinate 1', @() rg_support (rg_set ('prepared_points', [1; NaN; 2]), x));
refused ('RG_INVALID_PARAMETER', 'p', @() rg_support (rg_set ('p_norm_ball', o, x, 0.5), x));
refused ('RG_NON_FINITE', 'q', @() rg_support (rg_set ('capsule', o, [0; NaN; 0], 1), x));
refused ('RG_INVALID_PARAMETER', 'cylinder', @() rg_support (rg_set ('cylinder', o, o, 1), x));
refused ('RG_INVALID_PARAMETER', 'radius', @() rg_support (rg_set ('cone', o, 1, x, -1), x));
refused ('RG_DIMENSION_MISMATCH', 'legs', @() rg_support (rg_set ('simplex', o, [1 1]), x));
refused ('RG_DIMENSION_MISMATCH', 'rows', @() rg_support (rg_set ('zonotope', o, [1 1]), x));
refused ('RG_INVALID_PARAMETER', 'bounded', @() rg_support (rg_set ('h_polytope', [1 0 0], 1), x));
refused ('RG_INVALID_PARAMETER', 'normal', @() rg_support (rg_set ('contact_wrenches', o, o, 0.5, 0), ones (6, 1)));
refused ('RG_INVALID_PARAMETER', 'whole', @() rg_support (rg_set ('contact_wrenches', o, x, 0.5, 1.5), ones (6, 1)));
refused ('RG_INVALID_PARAMETER', 'singular', @() rg_support (rg_set ('affine_image', left, zeros (3), o), x));
refused ('RG_DIMENSION_MISMATCH', '', @() rg_support (rg_set ('sum', left, triangle), x));
refused ('RG_DIMENSION_MISMATCH', '', @() rg_support (rg_set ('difference', left, triangle), x));
refused ('RG_DIMENSION_MISMATCH', '', @() rg_support (rg_set ('union_hull', left, triangle), x));
refused ('RG_NON_FINITE', 'coordinate 1', @() rg_distance ([1; NaN], square));
refused ('RG_EMPTY_SET', '', @() rg_distance (zeros (2, 0), square));
refused ('RG_DIMENSION_MISMATCH', '', @() rg_object_distance (left, triangle));
refused ('RG_DIMENSION_MISMATCH', 'upper', @() rg_support (rg_set ('box', o, [1 2]), x));
refused ('RG_DIMENSION_MISMATCH', 'rows', @() rg_support (rg_set ('ellipsoid', o, eye (2)), x));
refused ('RG_UNKNOWN_NAME', 'bal', @() rg_support (rg_set ('bal', o, 1), x));
refused ('RG_INVALID_PARAMETER', 'ball: 2 arguments', @() rg_support (rg_set ('ball', o), x));
refused ('RG_INVALID_PARAMETER', 'a set is what', @() rg_distance ('triangle', square));
refused ('RG_INVALID_PARAMETER', 'real full', @() rg_distance (rg_set ('points', single (1)), square));
refused ('RG_INVALID_PARAMETER', 'real full', @() rg_gauge (left, 1i * x));
refused ('RG_INVALID_PARAMETER', 'function handle', @() rg_support (rg_set ('support_mapping', o, 3), x));
refused ('RG_CALLBACK_FAILED', 'support mapping', @() rg_support (own, x));
refused ('RG_CALLBACK_FAILED', '', @() rg_support (rg_set ('support_mapping', o, @(v) [1 2]), x));
refused ('RG_INVALID_PARAMETER', 'tolerance', @() rg_object_distance (left, right, 'tolerance', 2));
refused ('RG_UNKNOWN_NAME', 'no option', @() rg_object_distance (left, right, 'tolerence', 1e-9));
refused ('RG_INVALID_PARAMETER', 'names', @() rg_signed_distance (left, right, 'tolerance'));
refused ('RG_UNKNOWN_NAME', 'newton', @() rg_growth_distance (left, right, 'method', 'newtom'));
refused ('RG_INVALID_PARAMETER', 'metric', @() rg_growth_distance (left, right, 'metric', left));
refused ('RG_INVALID_PARAMETER', 'threads', @() rg_distance (triangle, square, 'threads', 2));
refused ('RG_INVALID_PARAMETER', 'time_limit', @() rg_object_distances (pairs, 'time_limit', 1));
refused ('RG_INVALID_PARAMETER', 'time_limit', @() rg_distance (triangle, square, 'time_limit', -1));
refused ('RG_INVALID_PARAMETER', 'max_iterations: a whole', @() rg_distance (triangle, square, 'max_iterations', NaN));
refused ('RG_INVALID_PARAMETER', 'function handle', @() rg_distance (triangle, square, 'stop', 3));
refused ('RG_CALLBACK_FAILED', 'stop', @() rg_distance (far_cloud, near_cloud, 'stop', @() error ('mine')));
refused ('RG_CALLBACK_FAILED', 'stop', @() rg_distance (far_cloud, near_cloud, 'stop', @() []));
refused ('RG_DIMENSION_MISMATCH', 'Q has dimension 2', @() rg_object_distance (left, right, 'metric', square));
refused ('RG_DIMENSION_MISMATCH', 'pose', @() rg_separation (left, right, 'pose_2', eye (3)));
refused ('RG_INVALID_PARAMETER', 'last row', @() rg_separation (left, right, 'pose_1', ones (4)));
refused ('RG_INVALID_PARAMETER', 'R', @() rg_separation (left, right, 'pose_1', [2 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]));
refused ('RG_DIMENSION_MISMATCH', 'pose', @() rg_separation (left, right, 'pose_1', eye (3)));
refused ('RG_INVALID_PARAMETER', 'two sets', @() raygauge_mex ('distance', left));
refused ('RG_UNKNOWN_NAME', 'query', @() raygauge_mex ('distence', left, right));
refused ('RG_INVALID_PARAMETER', 'two columns', @() rg_object_distances ({left}));
refused ('RG_INVALID_PARAMETER', 'n must lie in', @() rg_object_distances (cell (1, 2)));
refused ('RG_INVALID_PARAMETER', 'threads = 1', @() rg_object_distances ({own, left}, 'threads', 2));
refused ('RG_INVALID_PARAMETER', 'threads', @() rg_growth_distances (pairs, 'threads', 0));
refused ('RG_INVALID_PARAMETER', 'tolerance', @() rg_contains (left, x, 0));

% Calls, and refusals, leave nothing behind.
function pages = resident ()
  pages = str2double (strsplit (fileread ('/proc/self/statm')){2});
end
function work (count)
  S = rg_set ('sum', rg_set ('ball', [0; 0; 0], 1), rg_set ('box', -ones (3, 1), ones (3, 1)));
  for k = 1:count
    rg_contains (S, [3; 0; 0]);
    try, rg_contains (rg_set ('sum', S, 3), [3; 0; 0]); catch, end
  end
end
work (1000); before = resident (); work (5000);
% A leaked set a call would be 500 pages at least. The allocator of sanitizers keeps what is freed.
assert (resident () - before < 250 || ! isempty (getenv ('ASAN_OPTIONS')));

% Example 2 of the paper: glpk says the same.
source (getenv ('RAYGAUGE_EXAMPLE'));
assert (r.distance, d, 1e-6 * d);

assert (rg_version (), getenv ('RAYGAUGE_VERSION'));
disp ('all of Octave is as expected');
