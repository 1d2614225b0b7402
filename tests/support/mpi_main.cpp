// main() of GoogleTest programs that run under mpirun: a failure on any rank fails the program, on every rank.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdio>
#include <cstdlib>

#ifdef SIGMASWEEP_SANITIZED
/// Open MPI closes its plugins at the end; the leak check after that could not tell any more whose leaks they are.
extern "C" int dlclose(void*) { return 0; }
#endif

namespace {

/// Rank 0 prints as usual; the other ranks print only what fails there, and say where.
class FailuresOfRank : public testing::EmptyTestEventListener {
 public:
  explicit FailuresOfRank(int rank) : rank_(rank) {}

 private:
  void OnTestStart(const testing::TestInfo& test) override { test_ = &test; }
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "[rank %d] %s.%s: %s:%d: Failure\n%s\n", rank_, test_ ? test_->test_suite_name() : "",
                 test_ ? test_->name() : "", result.file_name() ? result.file_name() : "", result.line_number(),
                 result.message());
  }
  const testing::TestInfo* test_ = nullptr;  // asking UnitTest for it would wait for a lock that is held here
  int rank_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The guards that the program sets too: Open MPI before 4.1.7 can corrupt files that ranks write together, its
  // default collective write can hang, and so does opening a file where another process was killed at it.
  setenv("OMPI_MCA_fs_ufs_lock_algorithm", "3", /*replace=*/0);
  setenv("OMPI_MCA_fcoll", "dynamic_gen2", /*replace=*/0);
  setenv("OMPI_MCA_sharedfp", "^sm", /*replace=*/0);
  int provided = 0;
  if (MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) return EXIT_FAILURE;
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailuresOfRank(rank));
  }
  int failed = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed;
}
