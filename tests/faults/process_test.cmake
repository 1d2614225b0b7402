# sigmasweep_process_test(NAME LABEL label TIMEOUT seconds): a test that runs NAME.py of this folder, unittest cases
# that start the program as a user does. It uses the distribution's Python, which has h5py (python3-h5py). These tests
# mostly wait for MPI to begin, for mpirun to end a killed run, or for a time limit, so that two of them can run at a
# time. They run first, because they take the longest.
include_guard(DIRECTORY)
find_program(SIGMASWEEP_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

function(sigmasweep_process_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;TIMEOUT" "")
  add_test(NAME ${name} COMMAND ${SIGMASWEEP_SYSTEM_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/${name}.py)
  set(environment ${SIGMASWEEP_MPI_ENVIRONMENT} SIGMASWEEP=$<TARGET_FILE:sigmasweep>
    "MPIEXEC=${MPIEXEC_EXECUTABLE} --oversubscribe" FAILING_CALLS=$<TARGET_FILE:failing_calls>
    NO_LOCKS=$<TARGET_FILE:no_locks>)
  set_tests_properties(${name} PROPERTIES LABELS ${arg_LABEL} TIMEOUT ${arg_TIMEOUT} COST ${arg_TIMEOUT}
    SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")
endfunction()
