// SPDX-License-Identifier: Apache-2.0
// A vector of three numbers of any type (double, long double, lanes), for geometry and lighting.
#if defined(GLINT_SIMD_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_VEC3_INL_H_
#undef GLINT_SIMD_VEC3_INL_H_
#else
#define GLINT_SIMD_VEC3_INL_H_
#endif

#include "glint/vec.h"
#include "simd/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

template <class T> struct Vector3 {
    T x, y, z;
    friend HWY_INLINE Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend HWY_INLINE Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend HWY_INLINE Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
    friend HWY_INLINE Vector3 operator*(Vector3 a, Vector3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend HWY_INLINE Vector3 operator*(Vector3 a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend HWY_INLINE Vector3 operator/(Vector3 a, T s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class T> HWY_INLINE T dot(Vector3<T> a, Vector3<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> HWY_INLINE Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> HWY_INLINE T length(Vector3<T> a) { return sqrt(dot(a, a)); }
template <class T> HWY_INLINE Vector3<T> normalize(Vector3<T> a) { return a / length(a); }

template <class T, class M> HWY_INLINE Vector3<T> select_vector3(M m, Vector3<T> yes, Vector3<T> no) {
    return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

HWY_INLINE Vector3<Doubles> lanes_of(Vec3 v) { return {Doubles(v.x), Doubles(v.y), Doubles(v.z)}; }
HWY_INLINE Vector3<Doubles> lanes_of(Color c) { return {Doubles(c.r), Doubles(c.g), Doubles(c.b)}; }

/// Loads three columns from entry i on. Columns are arrays or pointers.
template <class Column> HWY_INLINE Vector3<Doubles> load_vector3(const Column* from, int i) {
    return {load(&from[0][0] + i), load(&from[1][0] + i), load(&from[2][0] + i)};
}
template <class Column> HWY_INLINE void store_vector3(const Vector3<Doubles>& v, Column* to, int i) {
    store(v.x, &to[0][0] + i);
    store(v.y, &to[1][0] + i);
    store(v.z, &to[2][0] + i);
}
template <class Column>
HWY_INLINE void compress_vector3(const Vector3<Doubles>& v, LaneMask<double> m, Column* to, int i) {
    compress_store(v.x, m, &to[0][0] + i);
    compress_store(v.y, m, &to[1][0] + i);
    compress_store(v.z, m, &to[2][0] + i);
}

/// Three consecutive values as a point or direction.
template <class T> HWY_INLINE Vector3<T> vector3(const T* p) { return {p[0], p[1], p[2]}; }

/// The largest magnitude of the three.
template <class T> HWY_INLINE T max_abs(Vector3<T> a) { return max(max(abs(a.x), abs(a.y)), abs(a.z)); }

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
