# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""
raygauge through its C interface: distances of convex sets, with proven bounds. The shared library libraygauge_c.so.1 must be where
the system looks for libraries (LD_LIBRARY_PATH).

    using Raygauge
    r = distance(points([2 4 4; 0 -1 1]), ball([0, 0], 1))  # a point a column
    r.lower <= 2 <= r.upper
"""
module Raygauge

export Checker, ConvexSet, Pose, RaygaugeError, Robot, Solver, Warm
export affine_image, ball, box, capsule, cone, contact_wrenches, cylinder, difference, ellipsoid, h_polytope, minkowski_sum,
    p_norm_ball, points, prepared_points, simplex, support_mapping, union_hull, zonotope
export center, gauge, is_inside, support
export distance, growth_distance, growth_distances, object_distance, object_distances, separation, signed_distance
export add_body!, add_link!, add_obstacle!, assign!, clear!, forget!, ignore!, ignore_joined!, prove

const library = "libraygauge_c.so.1"
const Handle = Ptr{Cvoid}

"A refused call: the name of the error, \"RG_NON_FINITE\" and the like, and one line about it."
struct RaygaugeError <: Exception
    name::String
    message::String
end
Base.showerror(io::IO, error::RaygaugeError) = print(io, error.name, ": ", error.message)

function check(code::Int32)
    code == 0 && return nothing
    name = unsafe_string(ccall((:rg_error_name, library), Cstring, (Int32,), code))
    throw(RaygaugeError(name, unsafe_string(ccall((:rg_last_message, library), Cstring, ()))))
end

"The version of the library."
version() = unsafe_string(ccall((:rg_version, library), Cstring, ()))

# ---- Sets ----

"A nonempty compact convex set of R^n. Sets never change, and may be shared by threads."
mutable struct ConvexSet
    handle::Handle
    kept::Any  # what the set calls: functions of support mappings

    function ConvexSet(make::Function, kept = nothing)
        out = Ref{Handle}(C_NULL)
        check(make(out))
        set = new(out[], kept)
        finalizer(s -> ccall((:rg_set_free, library), Cvoid, (Handle,), s.handle), set)
        return set
    end
end

Base.ndims(set::ConvexSet) = Int(GC.@preserve set ccall((:rg_set_dimension, library), Int32, (Handle,), set.handle))
Base.show(io::IO, set::ConvexSet) = print(io, "ConvexSet(n = ", ndims(set), ")")

numbers(values::AbstractVector{<:Real}) = convert(Vector{Float64}, values)
numbers(values::AbstractMatrix{<:Real}) = convert(Matrix{Float64}, values)

# Vectors that must be as long as the first.
function of_length(n::Integer, name::String, values)
    length(values) == n || throw(RaygaugeError("RG_DIMENSION_MISMATCH", "$name: $n numbers are needed, got $(length(values))"))
    return numbers(values)
end

"The hull of the columns of P."
points(P::AbstractMatrix) = ConvexSet(out -> ccall((:rg_set_points, library), Int32,
    (Int32, Int64, Ptr{Cdouble}, Ref{Handle}), size(P, 1), size(P, 2), numbers(P), out))

"The same set, prepared for many queries."
prepared_points(P::AbstractMatrix) = ConvexSet(out -> ccall((:rg_set_prepared_points, library), Int32,
    (Int32, Int64, Ptr{Cdouble}, Ref{Handle}), size(P, 1), size(P, 2), numbers(P), out))

"{x : |x - center| <= radius}"
ball(center::AbstractVector, radius::Real) = ConvexSet(out -> ccall((:rg_set_ball, library), Int32,
    (Int32, Ptr{Cdouble}, Cdouble, Ref{Handle}), length(center), numbers(center), radius, out))

"{x : lower <= x <= upper}"
function box(lower::AbstractVector, upper::AbstractVector)
    n = length(lower)
    high = of_length(n, "upper", upper)
    return ConvexSet(out -> ccall((:rg_set_box, library), Int32, (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Ref{Handle}),
        n, numbers(lower), high, out))
end

"{center + L z : |z| <= 1}"
function ellipsoid(center::AbstractVector, L::AbstractMatrix)
    n, m = length(center), size(L, 2)
    factor = of_length(n * m, "L", L)
    return ConvexSet(out -> ccall((:rg_set_ellipsoid, library), Int32, (Int32, Ptr{Cdouble}, Int32, Ptr{Cdouble}, Ref{Handle}),
        n, numbers(center), m, factor, out))
end

"{center + diag(w) z : norm(z, p) <= 1}"
function p_norm_ball(center::AbstractVector, w::AbstractVector, p::Real)
    n = length(center)
    axes = of_length(n, "w", w)
    return ConvexSet(out -> ccall((:rg_set_p_norm_ball, library), Int32,
        (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Cdouble, Ref{Handle}), n, numbers(center), axes, p, out))
end

"The segment from p to q, thickened by a ball."
function capsule(p::AbstractVector, q::AbstractVector, radius::Real)
    n = length(p)
    last = of_length(n, "q", q)
    return ConvexSet(out -> ccall((:rg_set_capsule, library), Int32,
        (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Cdouble, Ref{Handle}), n, numbers(p), last, radius, out))
end

"The cylinder around the segment from p to q."
function cylinder(p::AbstractVector, q::AbstractVector, radius::Real)
    n = length(p)
    last = of_length(n, "q", q)
    return ConvexSet(out -> ccall((:rg_set_cylinder, library), Int32,
        (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Cdouble, Ref{Handle}), n, numbers(p), last, radius, out))
end

"The truncated cone between two discs across the axis from base to top."
function cone(base::AbstractVector, base_radius::Real, top::AbstractVector, top_radius::Real)
    n = length(base)
    last = of_length(n, "top", top)
    return ConvexSet(out -> ccall((:rg_set_cone, library), Int32,
        (Int32, Ptr{Cdouble}, Cdouble, Ptr{Cdouble}, Cdouble, Ref{Handle}), n, numbers(base), base_radius, last, top_radius, out))
end

"The hull of corner and corner + legs[k] e_k."
function simplex(corner::AbstractVector, legs::AbstractVector)
    n = length(corner)
    along = of_length(n, "legs", legs)
    return ConvexSet(out -> ccall((:rg_set_simplex, library), Int32, (Int32, Ptr{Cdouble}, Ptr{Cdouble}, Ref{Handle}),
        n, numbers(corner), along, out))
end

"{center + G t : |t_i| <= 1}"
function zonotope(center::AbstractVector, G::AbstractMatrix)
    n, m = length(center), size(G, 2)
    generators = of_length(n * m, "G", G)
    return ConvexSet(out -> ccall((:rg_set_zonotope, library), Int32, (Int32, Ptr{Cdouble}, Int32, Ptr{Cdouble}, Ref{Handle}),
        n, numbers(center), m, generators, out))
end

"{x : G x <= g}, bounded, with interior."
function h_polytope(G::AbstractMatrix, g::AbstractVector)
    m, n = size(G)
    offsets = of_length(m, "g", g)
    normals = numbers(permutedims(G))
    return ConvexSet(out -> ccall((:rg_set_h_polytope, library), Int32, (Int32, Int64, Ptr{Cdouble}, Ptr{Cdouble}, Ref{Handle}),
        n, m, normals, offsets, out))
end

"The wrenches in R^6 of one contact with friction."
function contact_wrenches(point::AbstractVector, normal::AbstractVector, friction::Real, facets::Integer = 0)
    at, along = of_length(3, "point", point), of_length(3, "normal", normal)
    return ConvexSet(out -> ccall((:rg_set_contact_wrenches, library), Int32,
        (Ptr{Cdouble}, Ptr{Cdouble}, Cdouble, Int32, Ref{Handle}), at, along, friction, facets, out))
end

mutable struct Mapping
    farthest::Any
end

# The C function behind every support mapping. No exception may leave it.
function ask_mapping(data::Ptr{Cvoid}, n::Int32, u::Ptr{Cdouble}, point::Ptr{Cdouble})::Int32
    try
        mapping = unsafe_pointer_to_objref(data)::Mapping
        answer = mapping.farthest(copy(unsafe_wrap(Array, u, Int(n))))
        length(answer) == n || return Int32(2)
        copyto!(unsafe_wrap(Array, point, Int(n)), answer)
        return Int32(0)
    catch
        return Int32(1)
    end
end

"The hull of all farthest(u), a point of the set that is farthest along u. To be asked by the thread of Julia that calls."
function support_mapping(farthest, center::AbstractVector)
    mapping = Mapping(farthest)
    asked = @cfunction(ask_mapping, Int32, (Ptr{Cvoid}, Int32, Ptr{Cdouble}, Ptr{Cdouble}))
    make(out) = ccall((:rg_set_support_mapping, library), Int32, (Int32, Ptr{Cdouble}, Ptr{Cvoid}, Ptr{Cvoid}, Ref{Handle}),
        length(center), numbers(center), asked, pointer_from_objref(mapping), out)
    return GC.@preserve mapping ConvexSet(make, mapping)
end

"{M x + t : x in S}"
function affine_image(S::ConvexSet, M::AbstractMatrix, t::AbstractVector)
    n = ndims(S)
    matrix, shift = of_length(n * n, "M", M), of_length(n, "t", t)
    return GC.@preserve S ConvexSet(out -> ccall((:rg_set_affine_image, library), Int32,
        (Handle, Ptr{Cdouble}, Ptr{Cdouble}, Ref{Handle}), S.handle, matrix, shift, out), S.kept)
end

"{a + b : a in A, b in B}"
minkowski_sum(A::ConvexSet, B::ConvexSet) = GC.@preserve A B ConvexSet(out -> ccall((:rg_set_sum, library), Int32,
    (Handle, Handle, Ref{Handle}), A.handle, B.handle, out), (A.kept, B.kept))

"{a2 - a1 : a2 in A2, a1 in A1}"
difference(A2::ConvexSet, A1::ConvexSet) = GC.@preserve A2 A1 ConvexSet(out -> ccall((:rg_set_difference, library), Int32,
    (Handle, Handle, Ref{Handle}), A2.handle, A1.handle, out), (A2.kept, A1.kept))

"The hull of the union of sets."
function union_hull(sets::ConvexSet...)
    handles = Handle[set.handle for set in sets]
    return GC.@preserve sets ConvexSet(out -> ccall((:rg_set_union_hull, library), Int32, (Int64, Ptr{Handle}, Ref{Handle}),
        length(handles), handles, out), map(set -> set.kept, sets))
end

"A point deep inside."
function center(S::ConvexSet)
    point = zeros(ndims(S))
    GC.@preserve S check(ccall((:rg_set_center, library), Int32, (Handle, Ptr{Cdouble}), S.handle, point))
    return point
end

"(h(u), a point of S that is farthest along u)"
function support(S::ConvexSet, u::AbstractVector)
    value, point = Ref(0.0), zeros(ndims(S))
    direction = of_length(ndims(S), "u", u)
    GC.@preserve S check(ccall((:rg_set_support, library), Int32, (Handle, Ptr{Cdouble}, Ref{Cdouble}, Ptr{Cdouble}),
        S.handle, direction, value, point))
    return value[], point
end

"Proven bounds (lower, upper) of min {t >= 0 : x in tS}."
function gauge(S::ConvexSet, x::AbstractVector, tolerance::Real = 1e-6)
    lower, upper = Ref(0.0), Ref(0.0)
    point = of_length(ndims(S), "x", x)
    GC.@preserve S check(ccall((:rg_gauge, library), Int32, (Handle, Ptr{Cdouble}, Cdouble, Ref{Cdouble}, Ref{Cdouble}),
        S.handle, point, tolerance, lower, upper))
    return lower[], upper[]
end

"Whether x lies in S: true or false, both proven, or missing near the boundary."
function is_inside(S::ConvexSet, x::AbstractVector, tolerance::Real = 1e-6)
    answer = Ref{Int32}(2)
    point = of_length(ndims(S), "x", x)
    GC.@preserve S check(ccall((:rg_contains, library), Int32, (Handle, Ptr{Cdouble}, Cdouble, Ref{Int32}),
        S.handle, point, tolerance, answer))
    return answer[] == 2 ? missing : answer[] == 0
end

include("queries.jl")
include("robots.jl")

end
