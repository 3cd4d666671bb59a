% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT
% Example 2 of the paper: N points on each of two unit spheres of R^n; by raygauge, and as the linear program
%   minimize sum (beta)  subject to  A alpha - Q beta = 0,  sum (alpha) = 1,  alpha, beta >= 0  by glpk
n = 5; N = 500; randn ('twister', 1);
on_sphere = @(P) P ./ sqrt (sum (P .^ 2));
Q = on_sphere (randn (n, N));
A = on_sphere (randn (n, N)) + [3; zeros(n - 1, 1)];
tic; r = rg_distance (A, Q); ours = toc;
columns = [A, -Q; ones(1, N), zeros(1, N)];
right = [zeros(n, 1); 1];
tic; [~, d] = glpk ([zeros(N, 1); ones(N, 1)], columns, right); theirs = toc;
printf ('raygauge %.9f in [%.9f, %.9f], %.2f ms\n', r.distance, r.lower, r.upper, 1e3 * ours);
printf ('glpk     %.9f, %.2f ms\n', d, 1e3 * theirs);
