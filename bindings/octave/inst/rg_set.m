% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% S = rg_set (KIND, ...): a convex set of R^n. It is checked when it is first asked.
%
%   rg_set ('points', P)                       the hull of the columns of P; P itself will do, too
%   rg_set ('prepared_points', P)              the same set, for many points
%   rg_set ('ball', center, radius)            {x : |x - center| <= radius}
%   rg_set ('box', lower, upper)               {x : lower <= x <= upper}
%   rg_set ('ellipsoid', center, L)            {center + L z : |z| <= 1}
%   rg_set ('p_norm_ball', center, w, p)       {center + diag (w) z : norm (z, p) <= 1}
%   rg_set ('capsule', p, q, radius)           a segment, thickened by a ball
%   rg_set ('cylinder', p, q, radius)
%   rg_set ('cone', base, base_radius, top, top_radius)
%   rg_set ('simplex', corner, legs)           the hull of corner and corner + legs(k) e_k
%   rg_set ('zonotope', center, G)             {center + G t : |t_i| <= 1}
%   rg_set ('h_polytope', G, g)                {x : G x <= g}, bounded, with interior
%   rg_set ('contact_wrenches', point, normal, friction, facets)
%   rg_set ('support_mapping', center, @s)     the hull of all s (u), a point farthest along u
%   rg_set ('affine_image', S, M, t)           {M x + t : x in S}
%   rg_set ('sum', A, B)                       {a + b}
%   rg_set ('difference', A2, A1)              {a2 - a1}
%   rg_set ('union_hull', S1, S2, ...)
function S = rg_set (kind, varargin)
  S = struct ('kind', kind, 'arguments', {varargin});
end
