# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT

# ---- Motions of a robot ----

# What the C header calls rg_link, rg_checker_options and rg_verdict.
struct CLink
    parent::Int32
    kind::Int32
    joint::Int32
    origin::Handle
    axis::NTuple{3,Cdouble}
    scale::Cdouble
    offset::Cdouble
end

struct CCheckerOptions
    margin::Cdouble
    contact::Cdouble
    max_looks::Int64
    witness::Int32
end

struct CVerdict
    outcome::Int32
    body_1::Int32
    body_2::Int32
    part_1::Int32
    part_2::Int32
    time::Cdouble
    lower::Cdouble
    upper::Cdouble
    depth::Cdouble
    point_1::NTuple{3,Cdouble}
    point_2::NTuple{3,Cdouble}
end

"""
A robot in R^3 with so many joints. Links, bodies and obstacles are added to it, and get the numbers 1, 2, 3, …; obstacles are counted
after bodies.
"""
mutable struct Robot
    handle::Handle
    joints::Int
    kept::Vector{Any}  # what its sets call

    function Robot(joints::Integer)
        out = Ref{Handle}(C_NULL)
        check(ccall((:rg_robot_create, library), Int32, (Int32, Ref{Handle}), joints, out))
        robot = new(out[], joints, Any[])
        finalizer(r -> ccall((:rg_robot_free, library), Cvoid, (Handle,), r.handle), robot)
        return robot
    end
end

const kinds = (fixed = 0, revolute = 1, prismatic = 2)

"""
    add_link!(robot, kind; parent, joint, origin, axis, scale, offset)

kind is :fixed, :revolute or :prismatic. The frame of the link is that of `parent` (0: the base), moved by the pose `origin`, then turned
about, or shifted along, `axis` by scale * (value of `joint`) + offset.
"""
function add_link!(robot::Robot, kind::Symbol; parent::Integer = 0, joint::Integer = 0, origin = nothing,
        axis::AbstractVector = [0, 0, 1], scale::Real = 1, offset::Real = 0)
    haskey(kinds, kind) || throw(RaygaugeError("RG_UNKNOWN_NAME", "link: its kind is :fixed, :revolute or :prismatic"))
    along, number = of_length(3, "axis", axis), Ref{Int32}(-1)
    GC.@preserve robot origin begin
        link = CLink(parent - 1, kinds[kind], joint - 1, handle_of(origin), (along[1], along[2], along[3]), scale, offset)
        check(ccall((:rg_robot_add_link, library), Int32, (Handle, Ref{CLink}, Ref{Int32}), robot.handle, Ref(link), number))
    end
    return number[] + 1
end

"A rigid body, the union of sets, on a link, moved by the pose `origin` there."
function add_body!(robot::Robot, link::Integer, sets::ConvexSet...; origin = nothing)
    handles, number = Handle[set.handle for set in sets], Ref{Int32}(-1)
    GC.@preserve robot sets origin check(ccall((:rg_robot_add_body, library), Int32,
        (Handle, Int32, Int64, Ptr{Handle}, Handle, Ref{Int32}), robot.handle, link - 1, length(handles), handles, handle_of(origin), number))
    push!(robot.kept, map(set -> set.kept, sets))
    return number[] + 1
end

"A body that stands still. The robot has got all of its bodies before."
function add_obstacle!(robot::Robot, sets::ConvexSet...; pose = nothing)
    handles, number = Handle[set.handle for set in sets], Ref{Int32}(-1)
    GC.@preserve robot sets pose check(ccall((:rg_robot_add_obstacle, library), Int32,
        (Handle, Int64, Ptr{Handle}, Handle, Ref{Int32}), robot.handle, length(handles), handles, handle_of(pose), number))
    push!(robot.kept, map(set -> set.kept, sets))
    return number[] + 1
end

"These two bodies never count."
ignore!(robot::Robot, body_1::Integer, body_2::Integer) = GC.@preserve robot check(ccall((:rg_robot_ignore, library), Int32,
    (Handle, Int32, Int32), robot.handle, body_1 - 1, body_2 - 1))

"Nor do bodies of one link, and of links that a joint joins."
ignore_joined!(robot::Robot) = GC.@preserve robot check(ccall((:rg_robot_ignore_joined, library), Int32, (Handle,), robot.handle))

"Proves motions of a robot as it is now: free, if no distance is ever `margin` or less."
mutable struct Checker
    handle::Handle
    joints::Int
    kept::Any

    function Checker(robot::Robot; margin::Real = 0, contact::Real = 0, max_looks::Integer = 0, witness::Bool = true)
        out, options = Ref{Handle}(C_NULL), Ref(CCheckerOptions(margin, contact, max_looks, witness))
        GC.@preserve robot check(ccall((:rg_checker_create, library), Int32, (Handle, Ref{CCheckerOptions}, Ref{Handle}),
            robot.handle, options, out))
        checker = new(out[], robot.joints, copy(robot.kept))
        finalizer(c -> ccall((:rg_checker_free, library), Cvoid, (Handle,), c.handle), checker)
        return checker
    end
end

"Forgets what is kept from earlier motions: answers are then those of a new checker."
forget!(checker::Checker) = GC.@preserve checker check(ccall((:rg_checker_forget, library), Int32, (Handle,), checker.handle))

"""
    prove(checker, q)

Whether the robot moves without contact through the columns of q, straight in the space of its joints from each to the next: outcome is
:free or :contact, both proven, or :undecided. Of a contact: time (1.5 is halfway between columns 1 and 2, counted from 0), bodies, lower
and upper, depth, point_1, point_2.
"""
function prove(checker::Checker, q::AbstractMatrix)
    size(q, 1) == checker.joints ||
        throw(RaygaugeError("RG_DIMENSION_MISMATCH", "configurations: as many rows as joints are needed"))
    out = Ref(CVerdict(2, -1, -1, -1, -1, NaN, NaN, NaN, NaN, (NaN, NaN, NaN), (NaN, NaN, NaN)))
    configurations = numbers(q)
    GC.@preserve checker check(ccall((:rg_checker_prove, library), Int32, (Handle, Int64, Ptr{Cdouble}, Ref{CVerdict}),
        checker.handle, size(q, 2), configurations, out))
    v = out[]
    return (outcome = (:free, :contact, :undecided)[v.outcome + 1], time = v.time, bodies = (v.body_1 + 1, v.body_2 + 1),
        lower = v.lower, upper = v.upper, depth = v.depth, point_1 = collect(v.point_1), point_2 = collect(v.point_2))
end
