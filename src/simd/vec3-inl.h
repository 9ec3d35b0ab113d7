// A triple of numbers of any kind (double, long double, lanes), for the formulas of geometry and lighting.
#if defined(GLINT_SIMD_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_VEC3_INL_H_
#undef GLINT_SIMD_VEC3_INL_H_
#else
#define GLINT_SIMD_VEC3_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

template <class T> struct Triple {
    T x, y, z;
    friend HWY_INLINE Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend HWY_INLINE Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend HWY_INLINE Triple operator-(Triple a) { return {-a.x, -a.y, -a.z}; }
    friend HWY_INLINE Triple operator*(Triple a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend HWY_INLINE Triple operator/(Triple a, T s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class T> HWY_INLINE T dot(Triple<T> a, Triple<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> HWY_INLINE Triple<T> cross(Triple<T> a, Triple<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> HWY_INLINE T length(Triple<T> a) { return sqrt(dot(a, a)); }
template <class T> HWY_INLINE Triple<T> normalize(Triple<T> a) { return a / length(a); }

template <class T, class M> HWY_INLINE Triple<T> select_triple(M m, Triple<T> yes, Triple<T> no) {
    return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

/// Three consecutive parameters as a point or direction.
template <class T> HWY_INLINE Triple<T> triple(const T* p) { return {p[0], p[1], p[2]}; }

/// The largest magnitude of the three.
template <class T> HWY_INLINE T max_abs(Triple<T> a) { return max(max(abs(a.x), abs(a.y)), abs(a.z)); }

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
