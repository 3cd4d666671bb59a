# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT

# ---- Poses, warm starts, solvers ----

"A rigid motion x -> R x + t."
mutable struct Pose
    handle::Handle
    n::Int

    function Pose(R::AbstractMatrix, t::AbstractVector)
        n, out = length(t), Ref{Handle}(C_NULL)
        rotation = of_length(n * n, "R", R)
        check(ccall((:rg_pose_create, library), Int32, (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Ref{Handle}), n, rotation, numbers(t), out))
        pose = new(out[], n)
        finalizer(p -> ccall((:rg_pose_free, library), Cvoid, (Handle,), p.handle), pose)
        return pose
    end
end

"Other numbers for the same pose: a rotation R, or a quaternion (w, x, y, z), and t."
function assign!(pose::Pose, R::AbstractMatrix, t::AbstractVector)
    rotation, shift = of_length(length(t)^2, "R", R), of_length(pose.n, "t", t)
    GC.@preserve pose check(ccall((:rg_pose_assign, library), Int32, (Handle, Ptr{Cdouble}, Ptr{Cdouble}), pose.handle, rotation, shift))
end

function assign!(pose::Pose, wxyz::AbstractVector, t::AbstractVector)
    quaternion, shift = of_length(4, "wxyz", wxyz), of_length(3, "t", t)
    GC.@preserve pose check(ccall((:rg_pose_assign_quaternion, library), Int32, (Handle, Ptr{Cdouble}, Ptr{Cdouble}),
        pose.handle, quaternion, shift))
end

"What earlier solves of a pair, or of count pairs, have found: a hint for the next."
mutable struct Warm
    handle::Handle

    function Warm(count::Integer = 1)
        out = Ref{Handle}(C_NULL)
        check(ccall((:rg_warm_create, library), Int32, (Int64, Ref{Handle}), count, out))
        warm = new(out[])
        finalizer(w -> ccall((:rg_warm_free, library), Cvoid, (Handle,), w.handle), warm)
        return warm
    end
end

"Forgets what is known."
clear!(warm::Warm) = GC.@preserve warm check(ccall((:rg_warm_clear, library), Int32, (Handle,), warm.handle))

mutable struct Stop
    asked::Any
end

# The C function behind every `stop`. No exception may leave it; one ends the solve.
function ask_to_stop(data::Ptr{Cvoid})::Int32
    try
        return (unsafe_pointer_to_objref(data)::Stop).asked() ? Int32(1) : Int32(0)
    catch
        return Int32(1)
    end
end

"Options and workspace of queries, for one thread at a time. `stop` is a function that ends a long query when it returns true."
mutable struct Solver
    handle::Handle
    stop::Stop

    function Solver(; tolerance::Real = 1e-6, time_limit::Real = Inf, max_iterations::Integer = 0, method::String = "automatic",
            stop = nothing)
        out = Ref{Handle}(C_NULL)
        check(ccall((:rg_solver_create, library), Int32, (Ref{Handle},), out))
        solver = new(out[], Stop(stop))
        finalizer(s -> ccall((:rg_solver_free, library), Cvoid, (Handle,), s.handle), solver)
        GC.@preserve solver begin
            check(ccall((:rg_solver_set_tolerance, library), Int32, (Handle, Cdouble), solver.handle, tolerance))
            check(ccall((:rg_solver_set_time_limit, library), Int32, (Handle, Cdouble), solver.handle, time_limit))
            check(ccall((:rg_solver_set_max_iterations, library), Int32, (Handle, Int64), solver.handle, max_iterations))
            check(ccall((:rg_solver_set_method, library), Int32, (Handle, Cstring), solver.handle, method))
            asked = stop === nothing ? C_NULL : @cfunction(ask_to_stop, Int32, (Ptr{Cvoid},))
            check(ccall((:rg_solver_set_stop, library), Int32, (Handle, Ptr{Cvoid}, Ptr{Cvoid}),
                solver.handle, asked, pointer_from_objref(solver.stop)))
        end
        return solver
    end
end

# ---- Single queries ----

# What the C header calls rg_pair and rg_answer.
struct CPair
    first::Handle
    pose_first::Handle
    second::Handle
    pose_second::Handle
end

struct CAnswer
    distance::Cdouble
    lower::Cdouble
    upper::Cdouble
    status::Int32
    meet::Int32
end

const WITNESS, CLOSEST_POINTS, GRADIENT = UInt32(1), UInt32(2), UInt32(4)

handle_of(::Nothing) = C_NULL
handle_of(object) = object.handle
pair_of(A, pose_1, B, pose_2) = CPair(A.handle, handle_of(pose_1), B.handle, handle_of(pose_2))
status_of(number) = Symbol(unsafe_string(ccall((:rg_status_name, library), Cstring, (Int32,), number)))

# The vector of the last query; nothing where it has none.
function vector_of(solver::Solver, which::Integer, n::Integer)
    values = zeros(n)
    check(ccall((:rg_solver_vector, library), Int32, (Handle, Int32, Int32, Ptr{Cdouble}), solver.handle, which, n, values))
    return isnan(values[1]) ? nothing : values
end

bounds_of(answer::CAnswer) =
    (distance = answer.distance, lower = answer.lower, upper = answer.upper, status = status_of(answer.status))

"""
    distance(A, Q; solver, pose_1, pose_2, warm)

By how much Q must be scaled about the origin until it touches A: distance, certified lower and upper, status, normal and
contact_point (nothing where there is none).
"""
function distance(A::ConvexSet, Q::ConvexSet; solver::Solver = Solver(), pose_1 = nothing, pose_2 = nothing, warm = nothing)
    out = Ref(CAnswer(NaN, NaN, NaN, 0, 0))
    return GC.@preserve A Q pose_1 pose_2 warm solver begin
        check(ccall((:rg_distance, library), Int32, (Handle, Ref{CPair}, UInt32, Handle, Ref{CAnswer}),
            solver.handle, Ref(pair_of(A, pose_1, Q, pose_2)), WITNESS, handle_of(warm), out))
        merge(bounds_of(out[]), (normal = vector_of(solver, 0, ndims(A)), contact_point = vector_of(solver, 1, ndims(A))))
    end
end

# What object_distance and signed_distance say.
function objects_answer(solver::Solver, answer::CAnswer, n::Integer)
    return merge(bounds_of(answer), (meet = answer.meet < 0 ? missing : answer.meet == 1, normal = vector_of(solver, 0, n),
        point_1 = vector_of(solver, 2, n), point_2 = vector_of(solver, 3, n),
        gradient_1 = vector_of(solver, 4, n), gradient_2 = vector_of(solver, 5, n)))
end

"""
    object_distance(A1, A2; metric, solver, pose_1, pose_2, warm)

The distance of two objects, Euclidean or in the metric with that unit ball; 0 if they meet.
"""
function object_distance(A1::ConvexSet, A2::ConvexSet; metric = nothing, solver::Solver = Solver(), pose_1 = nothing,
        pose_2 = nothing, warm = nothing)
    out = Ref(CAnswer(NaN, NaN, NaN, 0, 0))
    return GC.@preserve A1 A2 metric pose_1 pose_2 warm solver begin
        check(ccall((:rg_object_distance, library), Int32, (Handle, Ref{CPair}, Handle, UInt32, Handle, Ref{CAnswer}),
            solver.handle, Ref(pair_of(A1, pose_1, A2, pose_2)), handle_of(metric), CLOSEST_POINTS | GRADIENT, handle_of(warm), out))
        objects_answer(solver, out[], ndims(A1))
    end
end

"""
    signed_distance(A1, A2; metric, solver, pose_1, pose_2, warm)

The distance of two objects; of objects that meet, minus the length of the shortest translation that separates their interiors.
"""
function signed_distance(A1::ConvexSet, A2::ConvexSet; metric = nothing, solver::Solver = Solver(), pose_1 = nothing,
        pose_2 = nothing, warm = nothing)
    out = Ref(CAnswer(NaN, NaN, NaN, 0, 0))
    return GC.@preserve A1 A2 metric pose_1 pose_2 warm solver begin
        check(ccall((:rg_signed_distance, library), Int32, (Handle, Ref{CPair}, Handle, UInt32, Handle, Ref{CAnswer}),
            solver.handle, Ref(pair_of(A1, pose_1, A2, pose_2)), handle_of(metric), CLOSEST_POINTS | GRADIENT, handle_of(warm), out))
        objects_answer(solver, out[], ndims(A1))
    end
end

"By how much both objects must be scaled, each about its centre, until they touch."
function growth_distance(A1::ConvexSet, A2::ConvexSet; solver::Solver = Solver(), pose_1 = nothing, pose_2 = nothing, warm = nothing)
    out = Ref(CAnswer(NaN, NaN, NaN, 0, 0))
    return GC.@preserve A1 A2 pose_1 pose_2 warm solver begin
        check(ccall((:rg_growth_distance, library), Int32, (Handle, Ref{CPair}, Handle, Ref{CAnswer}),
            solver.handle, Ref(pair_of(A1, pose_1, A2, pose_2)), handle_of(warm), out))
        merge(bounds_of(out[]), (normal = vector_of(solver, 0, ndims(A1)),))
    end
end

"(:separated, normal), (:intersecting, nothing), both proven, or (:undecided, nothing)."
function separation(A1::ConvexSet, A2::ConvexSet; solver::Solver = Solver(), pose_1 = nothing, pose_2 = nothing, warm = nothing)
    outcome = Ref{Int32}(2)
    return GC.@preserve A1 A2 pose_1 pose_2 warm solver begin
        check(ccall((:rg_separation, library), Int32, (Handle, Ref{CPair}, Handle, Ref{Int32}),
            solver.handle, Ref(pair_of(A1, pose_1, A2, pose_2)), handle_of(warm), outcome))
        (:separated, :intersecting, :undecided)[outcome[] + 1], vector_of(solver, 0, ndims(A1))
    end
end

# ---- Many queries ----

struct CBatchAnswers
    distance::Ptr{Cdouble}
    lower::Ptr{Cdouble}
    upper::Ptr{Cdouble}
    status::Ptr{UInt8}
    normal::Ptr{Cdouble}
    closest_points_1::Ptr{Cdouble}
    closest_points_2::Ptr{Cdouble}
end

# Makes a batch, lets `ask` fill arrays of `count` answers, and frees the batch.
function many(ask, count::Integer, threads::Integer, tolerance::Real)
    batch = Ref{Handle}(C_NULL)
    check(ccall((:rg_batch_create, library), Int32, (Int32, Cdouble, Ref{Handle}), threads, tolerance, batch))
    distance, lower, upper, status = zeros(count), zeros(count), zeros(count), zeros(UInt8, count)
    try
        GC.@preserve distance lower upper status begin
            answers = CBatchAnswers(pointer(distance), pointer(lower), pointer(upper), pointer(status), C_NULL, C_NULL, C_NULL)
            check(ask(batch[], Ref(answers)))
        end
    finally
        ccall((:rg_batch_free, library), Cvoid, (Handle,), batch[])
    end
    return (distance = distance, lower = lower, upper = upper, status = map(status_of, status))
end

list_of(pairs) = CPair[pair_of(A, nothing, B, nothing) for (A, B) in pairs]

"The distances of many pairs of objects, (A1, A2) each, on threads: vectors distance, lower, upper and status."
function object_distances(pairs::AbstractVector; metric = nothing, threads::Integer = 1, tolerance::Real = 1e-6)
    list = list_of(pairs)
    ask(batch, answers) = ccall((:rg_batch_object_distances, library), Int32,
        (Handle, Int64, Ptr{CPair}, Handle, Handle, Ref{CBatchAnswers}), batch, length(list), list, handle_of(metric), C_NULL, answers)
    return GC.@preserve pairs metric many(ask, length(list), threads, tolerance)
end

"The growth distances of many pairs of objects, on threads."
function growth_distances(pairs::AbstractVector; threads::Integer = 1, tolerance::Real = 1e-6)
    list = list_of(pairs)
    ask(batch, answers) = ccall((:rg_batch_growth_distances, library), Int32,
        (Handle, Int64, Ptr{CPair}, Handle, Ref{CBatchAnswers}), batch, length(list), list, C_NULL, answers)
    return GC.@preserve pairs many(ask, length(list), threads, tolerance)
end
