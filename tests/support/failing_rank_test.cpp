// Fails on rank 1 and nowhere else: with two ranks this program must fail, with one it must not. If it does not, no
// failure on another rank than 0 is ever seen.
#include <gtest/gtest.h>
#include <mpi.h>

TEST(FailingRank, FailsOnRank1) {
  int rank = 0;
  ASSERT_EQ(MPI_Comm_rank(MPI_COMM_WORLD, &rank), MPI_SUCCESS);
  EXPECT_NE(rank, 1) << "on purpose";
}
