# cmake -D BUILD_DIR=... -D KEEP_GOING=... -P build_test_programs.cmake
# Builds what the tests run; fails if the program or the library of the tests
# does not build (a test program that does not build fails by itself).
# It also makes every test run again: deal.II's macros
# keep the output of a test and only look at it again when its program is
# unchanged, although a parameter file or a mesh may have changed.
#
# deal.II 9.4 marks interrupted tests by a file interrupt_guard.cc in the test's
# program; a file that is present when a test starts makes it link again. Put
# aside as "_bck", as after a test that ran to its end, it does not.

file(GLOB put_aside ${BUILD_DIR}/tests/*/*/interrupt_guard.cc_bck)
foreach(file ${put_aside})
  string(REGEX REPLACE "_bck$" "" guard ${file})
  file(RENAME ${file} ${guard})
endforeach()

file(GLOB_RECURSE outputs ${BUILD_DIR}/tests/output)
if(outputs)
  file(REMOVE ${outputs})
endif()

execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIR}
  --target tested_programs RESULT_VARIABLE failed)
if(NOT failed)
  separate_arguments(KEEP_GOING)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIR}
    --target test_programs -- ${KEEP_GOING})
endif()

file(GLOB guards ${BUILD_DIR}/tests/*/*/interrupt_guard.cc)
foreach(guard ${guards})
  file(RENAME ${guard} ${guard}_bck)
endforeach()

if(failed)
  message(FATAL_ERROR "The program could not be built.")
endif()
