# How everything of this project is compiled. Targets get it by linking to
# mpm_granular_flags after deal_ii_setup_target(): an interface comes after the
# target's own options on the command line, so -O3 here wins over deal.II's -O2.

add_library(mpm_granular_flags INTERFACE)
target_compile_features(mpm_granular_flags INTERFACE cxx_std_17)
target_include_directories(mpm_granular_flags INTERFACE
  ${PROJECT_SOURCE_DIR}/include
  ${PROJECT_BINARY_DIR}/include)
target_link_libraries(mpm_granular_flags INTERFACE
  Boost::program_options ZLIB::ZLIB)

# -fPIC for everything: a precompiled header serves only files that are compiled
# with the same setting. -fopenmp-simd makes the "omp simd" pragmas known, and
# needs no OpenMP library.
target_compile_options(mpm_granular_flags INTERFACE
  -Wall -Wextra -fPIC -fopenmp-simd)

# Without OpenMPI's classes of C++, which nothing here uses: each object would hold
# some hundred functions of theirs.
target_compile_definitions(mpm_granular_flags INTERFACE OMPI_SKIP_MPICXX)

if(MPM_WERROR)
  target_compile_options(mpm_granular_flags INTERFACE -Werror)
endif()

if(CMAKE_BUILD_TYPE STREQUAL Release)
  # Only what keeps IEEE results: no re-association, NaN stays NaN. -g1: line
  # numbers for backtraces and profilers; deal.II's -g takes longer to compile.
  target_compile_options(mpm_granular_flags INTERFACE
    -O3 -g1 -fno-math-errno -fno-trapping-math)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # deal.II compiles with -fPIC; without this, g++ may not inline a function
    # that another library could replace.
    target_compile_options(mpm_granular_flags INTERFACE
      -fno-semantic-interposition)
  endif()
endif()

# Apart from the others, for programs that must not have it.
add_library(mpm_granular_native INTERFACE)
if(CMAKE_BUILD_TYPE STREQUAL Release AND MPM_NATIVE)
  target_compile_options(mpm_granular_native INTERFACE -march=native)
endif()

if(CMAKE_BUILD_TYPE STREQUAL Debug AND NOT MPM_DEBUGGER)
  # deal.II's -O0 -ggdb, which a debugger needs, makes both the compiler and the
  # program slower. Assertions do not depend on it.
  target_compile_options(mpm_granular_flags INTERFACE -Og -g1)
endif()

if(MPM_SANITIZE)
  target_compile_options(mpm_granular_flags INTERFACE
    -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(mpm_granular_flags INTERFACE
    -fsanitize=address,undefined)
endif()

# The linker that Debian's deal.II asks for takes seconds for each test program,
# mold some hundredths.
find_program(MOLD_EXECUTABLE mold)
if(MOLD_EXECUTABLE AND NOT CMAKE_VERSION VERSION_LESS 3.18)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=mold MPM_LINKS_WITH_MOLD)
  if(MPM_LINKS_WITH_MOLD)
    target_link_options(mpm_granular_flags INTERFACE -fuse-ld=mold)
  endif()
endif()

if(MPM_PCH AND CMAKE_VERSION VERSION_LESS 3.16)
  message(STATUS "Precompiled headers: off (they need CMake 3.16)")
  set(MPM_PCH OFF)
endif()

if(MPM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(CCACHE_EXECUTABLE ccache)
  if(CCACHE_EXECUTABLE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_EXECUTABLE})
    if(MPM_PCH)
      # The first is what ccache asks for to cache files that use a precompiled
      # header; with the second it does not read that header, some 700 MB,
      # again for every file, and with the third it does not preprocess each file
      # before it is compiled.
      set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_INODECACHE=1
        CCACHE_DEPEND=1 ${CCACHE_EXECUTABLE})
      target_compile_options(mpm_granular_flags INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
  endif()
endif()

# set_up_target(TARGET): compile and link against deal.II with the flags above.
# The signature of target_link_libraries() without a keyword is the one that
# deal_ii_setup_target() uses, and CMake does not let them be mixed.
macro(set_up_target target)
  deal_ii_setup_target(${target})
  target_link_libraries(${target} mpm_granular_flags mpm_granular_native)
endmacro()
