# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
# Every function with good and bad input.
using Raygauge
using Test

const o, x, y2, u = zeros(3), [1, 0, 0], [0, 2, 0], [0, 3, 4]

function refused(call, name, words)
    try
        call()
    catch problem
        return problem isa RaygaugeError && problem.name == name && occursin(words, problem.message)
    end
    return false
end

has_support(S, along, expected) = isapprox(support(S, along)[1], expected; atol = 1e-12) &&
    isapprox(sum(support(S, along)[2] .* along), expected; atol = 1e-12)
holds(r, expected, tolerance) = r.lower <= expected + 1e-14 && expected - 1e-14 <= r.upper &&
    r.upper - r.lower <= tolerance * max(abs(r.upper), abs(r.lower))

@testset "sets" begin
    P = [1 -1; 2 0; 3 2]
    @test has_support(points(P), u, 18)
    @test has_support(prepared_points(P), u, 18)
    @test has_support(ball(o, 2), u, 10)
    @test has_support(box(o, ones(3)), u, 7)
    @test has_support(ellipsoid(o, [0 0; 1 0; 0 2]), u, sqrt(73))
    @test has_support(p_norm_ball(o, ones(3), Inf), u, 7)
    @test has_support(capsule(o, y2, 1), u, 11)
    @test has_support(cylinder(o, y2, 1), u, 10)
    @test has_support(cone(o, 2, y2, 0), u, 8)
    @test has_support(simplex(o, ones(3)), u, 4)
    @test has_support(zonotope(o, reshape(y2, 3, 1)), u, 6)
    @test has_support(h_polytope([1 0 0; 0 1 0; 0 0 1; -1 0 0; 0 -1 0; 0 0 -1], 1:6), u, 18)
    @test has_support(contact_wrenches(o, x, 0.5), [1, 0, 0, 0, 0, 0], 1)
    @test has_support(support_mapping(v -> any(!iszero, v) ? v / sqrt(sum(abs2, v)) : v, o), u, 5)
    @test has_support(affine_image(ball(o, 1), [2 0 0; 0 0 3; 0 1 0], ones(3)), u, 7 + sqrt(97))
    @test has_support(minkowski_sum(ball(o, 1), points(P)), u, 23)
    @test has_support(difference(points(P), ball(o, 1)), u, 23)
    @test has_support(union_hull(points(P), ball(o, 1), ball(o, 4)), u, 20)
    lower, upper = gauge(ball(o, 2), u)
    @test lower <= 2.5 <= upper
    @test is_inside(ball(o, 2), ones(3)) && !is_inside(ball(o, 2), u)
    @test center(ball(x, 2)) == x
    @test ndims(ball(o, 1)) == 3
end

@testset "queries" begin
    triangle, square = points([2 4 4; 0 -1 1]), points([1 -1 0 0; 0 0 1 -1])
    r = distance(triangle, square)
    @test holds(r, 2, 1e-6) && r.status == :optimal
    @test isapprox(r.contact_point, [2, 0]; atol = 1e-6)
    @test distance(square, square).status == :contains_origin
    left, right = ball(o, 1), ball([5, 0, 0], 2)
    solver, warm = Solver(tolerance = 1e-9, time_limit = 10, max_iterations = 1000, method = "automatic"), Warm()
    r = object_distance(left, right; solver = solver, warm = warm)
    @test holds(r, 2, 1e-9) && r.meet === false
    @test isapprox(r.point_2 - r.point_1, [2, 0, 0]; atol = 1e-6)
    clear!(warm)
    @test holds(object_distance(left, right; solver = solver, warm = warm), 2, 1e-9)
    @test holds(object_distance(left, right; metric = ball(o, 2)), 1, 1e-6)
    closer = Pose([1 0 0; 0 1 0; 0 0 1], [-2.5, 0, 0])
    r = signed_distance(left, right; pose_2 = closer)
    @test holds(r, -0.5, 1e-6) && r.meet === true
    @test isapprox(r.normal, [-1, 0, 0]; atol = 1e-6)
    assign!(closer, [0 -1 0; 1 0 0; 0 0 1], [0, -2.5, 0])
    @test holds(signed_distance(left, right; pose_2 = closer), -0.5, 1e-6)
    assign!(closer, [1, 0, 0, 0], [-1, 0, 0])
    @test holds(signed_distance(left, right; pose_2 = closer), 1, 1e-6)
    far_cloud, near_cloud = points(rand(40, 1500) .+ [3; zeros(39)]), points(rand(40, 1500) .- 0.5)
    @test distance(far_cloud, near_cloud; solver = Solver(stop = () -> true)).status == :time_limit
    @test distance(far_cloud, near_cloud; solver = Solver(stop = () -> error("mine"))).status == :time_limit
    @test distance(far_cloud, near_cloud; solver = Solver(stop = () -> false)).status == :optimal
    @test holds(growth_distance(left, ball([6, 0, 0], 2)), 2, 1e-6)
    @test separation(left, right)[1] == :separated
    @test separation(left, left) == (:intersecting, nothing)
    pairs = [(left, ball([2.0 + k, 0, 0], 1)) for k in 1:50]
    r = object_distances(pairs; threads = 2)
    @test isapprox(r.distance, 1:50; atol = 1e-5) && r.status[50] == :optimal
    @test r.distance[7] == object_distance(pairs[7]...).distance
    @test isapprox(growth_distances(pairs; tolerance = 1e-9).distance, (3:52) / 2; atol = 1e-7)
end

# A bar that turns about e_3 past a ball: at the angle q they are 0.8 cos q - 0.3 apart.
function turning_bar()
    robot = Robot(1)
    link = add_link!(robot, :revolute; joint = 1)
    @test add_body!(robot, link, capsule(o, x, 0.1)) == 1
    @test add_obstacle!(robot, ball([0, 0.8, 0], 0.2)) == 2
    ignore_joined!(robot)
    return robot
end

@testset "motions" begin
    robot = turning_bar()
    checker = Checker(robot)
    @test prove(checker, [0 1.18]).outcome == :free
    forget!(checker)
    r = prove(checker, [-1 0 1.5])
    @test r.outcome == :contact && r.bodies == (1, 2) && 1.7 < r.time <= 2
    @test prove(Checker(robot; margin = 0.01), [0 1.18]).outcome == :contact
    ignore!(robot, 1, 2)
    @test prove(Checker(robot), [-1 0 1.5]).outcome == :free
    @test refused(() -> Robot(-1), "RG_INVALID_PARAMETER", "joints")
    @test refused(() -> add_link!(robot, :ball), "RG_UNKNOWN_NAME", "revolute")
    @test refused(() -> add_link!(robot, :revolute; joint = 2), "RG_INVALID_PARAMETER", "joint")
    @test refused(() -> add_body!(turning_bar(), 7, ball(o, 1)), "RG_INVALID_PARAMETER", "link")
    @test refused(() -> add_obstacle!(robot, ball(zeros(2), 1)), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> ignore!(robot, 1, 3), "RG_INVALID_PARAMETER", "body_2")
    @test refused(() -> Checker(robot; margin = -1), "RG_INVALID_PARAMETER", "margin")
    @test refused(() -> prove(checker, [NaN 0]), "RG_NON_FINITE", "joint")
    @test refused(() -> prove(checker, reshape([0, 1], 2, 1)), "RG_DIMENSION_MISMATCH", "rows")
end

@testset "mistakes" begin
    left, flat = ball(o, 1), ball(zeros(2), 1)
    @test refused(() -> ball(o, -1), "RG_INVALID_PARAMETER", "radius")
    @test refused(() -> points(reshape([NaN, 1], 2, 1)), "RG_NON_FINITE", "coordinate 0")
    @test refused(() -> prepared_points(reshape([NaN, 1], 2, 1)), "RG_NON_FINITE", "coordinate 0")
    @test refused(() -> box(o, ones(2)), "RG_DIMENSION_MISMATCH", "upper")
    @test refused(() -> ellipsoid(o, ones(2, 2)), "RG_DIMENSION_MISMATCH", "L")
    @test refused(() -> p_norm_ball(o, x, 0.5), "RG_INVALID_PARAMETER", "p")
    @test refused(() -> capsule(o, [0, NaN, 0], 1), "RG_NON_FINITE", "q")
    @test refused(() -> cylinder(o, o, 1), "RG_INVALID_PARAMETER", "cylinder")
    @test refused(() -> cone(o, 1, x, -1), "RG_INVALID_PARAMETER", "radius")
    @test refused(() -> simplex(o, ones(2)), "RG_DIMENSION_MISMATCH", "legs")
    @test refused(() -> zonotope(o, ones(2, 2)), "RG_DIMENSION_MISMATCH", "G")
    @test refused(() -> h_polytope([1 0 0], [1]), "RG_INVALID_PARAMETER", "bounded")
    @test refused(() -> contact_wrenches(o, o, 0.5), "RG_INVALID_PARAMETER", "normal")
    @test refused(() -> affine_image(left, zeros(3, 3), o), "RG_INVALID_PARAMETER", "singular")
    @test refused(() -> difference(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> support(left, ones(2)), "RG_DIMENSION_MISMATCH", "u")
    @test refused(() -> gauge(left, [NaN, 0, 0]), "RG_NON_FINITE", "")
    @test refused(() -> distance(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> signed_distance(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> growth_distance(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> separation(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> growth_distances([(left, flat)]), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> assign!(Pose([1 0; 0 1], zeros(2)), [2 0; 0 1], zeros(2)), "RG_INVALID_PARAMETER", "R")
    @test refused(() -> union_hull(), "RG_EMPTY_SET", "")
    @test refused(() -> minkowski_sum(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> object_distance(left, flat), "RG_DIMENSION_MISMATCH", "")
    @test refused(() -> support_mapping(v -> error("mine"), o), "RG_CALLBACK_FAILED", "support mapping")
    @test refused(() -> Solver(tolerance = 2), "RG_INVALID_PARAMETER", "tolerance")
    @test refused(() -> Solver(method = "newtom"), "RG_UNKNOWN_NAME", "newton")
    @test refused(() -> Pose([2 0; 0 1], zeros(2)), "RG_INVALID_PARAMETER", "R")
    @test refused(() -> Warm(0), "RG_INVALID_PARAMETER", "count")
    @test refused(() -> object_distances([(left, left)]; threads = 0), "RG_INVALID_PARAMETER", "threads")
    @test refused(() -> is_inside(left, x, 0), "RG_INVALID_PARAMETER", "tolerance")
end

@testset "version" begin
    @test Raygauge.version() == ENV["RAYGAUGE_VERSION"]
end
