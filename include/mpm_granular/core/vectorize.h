#ifndef mpm_granular_core_vectorize_h
#define mpm_granular_core_vectorize_h

/**
 * Stands before a for loop whose iterations neither read nor write what another
 * one writes, so that the compiler may run several at once (SIMD). It needs no
 * compiler option, and unlike "omp simd" it does not keep g++ from vectorizing
 * loops with small arrays of their own, say the components of a tensor. Sums
 * over the iterations are not allowed.
 */
#if defined(__clang__)
#  define MPM_INDEPENDENT_ITERATIONS \
    _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#  define MPM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#  define MPM_INDEPENDENT_ITERATIONS
#endif

/**
 * Stands before a for loop that mostly has one iteration or two, so that the
 * compiler does not unroll it.
 */
#if defined(__clang__)
#  define MPM_FEW_ITERATIONS _Pragma("clang loop unroll(disable)")
#elif defined(__GNUC__)
#  define MPM_FEW_ITERATIONS _Pragma("GCC unroll 1")
#else
#  define MPM_FEW_ITERATIONS
#endif

#endif
