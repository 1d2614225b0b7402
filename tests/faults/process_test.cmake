# sigmasweep_process_test(NAME LABEL label TIMEOUT seconds [CASES]): a test that runs NAME.py of this folder, unittest
# cases that start the program as a user does. With CASES each of them is a CTest test of its own, NAME.test_..., so that
# long ones run at the same time. It uses the distribution's Python, which has h5py (python3-h5py). These tests mostly
# wait for MPI to begin, for mpirun to end a killed run, or for a time limit, so that two of them can run on a core. They
# run first, because they take the longest.
include_guard(DIRECTORY)
find_program(SIGMASWEEP_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

function(sigmasweep_process_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "CASES" "LABEL;TIMEOUT" "")
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/${name}.py)
  set(tests ${name})
  if(arg_CASES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
    file(STRINGS ${script} tests REGEX "^    def test_")
    list(TRANSFORM tests REPLACE "^    def (test_[a-z0-9_]+).*" "${name}.\\1")
    list(REMOVE_DUPLICATES tests)  # the same name in two classes: both are run
  endif()
  set(environment ${SIGMASWEEP_MPI_ENVIRONMENT} SIGMASWEEP=$<TARGET_FILE:sigmasweep>
    "MPIEXEC=${MPIEXEC_EXECUTABLE} --oversubscribe" FAILING_CALLS=$<TARGET_FILE:failing_calls>
    NO_LOCKS=$<TARGET_FILE:no_locks>)
  foreach(test IN LISTS tests)
    set(only)
    if(arg_CASES)
      string(REPLACE "${name}." "*." case ${test})
      set(only -k ${case})
    endif()
    add_test(NAME ${test} COMMAND ${SIGMASWEEP_SYSTEM_PYTHON} -B ${script} ${only})
    set_tests_properties(${test} PROPERTIES LABELS ${arg_LABEL} TIMEOUT ${arg_TIMEOUT} COST ${arg_TIMEOUT}
      SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")
  endforeach()
endfunction()
