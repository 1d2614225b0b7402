#include "store/hdf5/trial.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <new>

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/seal.hpp"
#include "store/table/read.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

class Trial : public testing::Test {
 protected:
  Trial() { samples::put_bytes(path_, "no seal"); }
  samples::Directory directory_;
  std::string path_ = directory_.file("unsealed.h5");
};

TEST_F(Trial, OfAFileWithoutASealIsInAnotherProcess) {
  int calls = 0;
  EXPECT_EQ(read_after_trial(path_, [&] { return ++calls; }), 1);
  seal(path_);
  EXPECT_EQ(read_after_trial(path_, [&] { return ++calls; }), 2);
}

TEST_F(Trial, ThatCrashesIsAnError) {
  EXPECT_THROW(try_unsealed(path_, [] { std::abort(); }), IoError);
  EXPECT_THROW(try_unsealed(path_, [] { ::raise(SIGSEGV); }), IoError);
  EXPECT_THROW(try_unsealed(path_, [] { throw std::bad_alloc(); }), IoError);
}

TEST_F(Trial, ThatDoesNotEndIsAnError) {
  volatile bool forever = true;
  EXPECT_THROW(try_unsealed(path_,
                            [&] {
                              while (forever) {
                              }
                            }),
               IoError);
}

TEST_F(Trial, ThatRefusesTheFileLeavesTheRefusalToTheCaller) {
  EXPECT_NO_THROW(try_unsealed(path_, [] { throw IoError("no table"); }));
}

TEST_F(Trial, WorksWhereTheSystemKeepsNoStatusOfChildren) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  EXPECT_NO_THROW(try_unsealed(path_, [] {}));
  EXPECT_THROW(try_unsealed(path_, [] { std::abort(); }), IoError);
  ::signal(SIGCHLD, before);
}

TEST_F(Trial, OfAFileThatIsNotThereIsLeftToTheCaller) {
  EXPECT_NO_THROW(try_unsealed(directory_.file("none.h5"), [] { std::abort(); }));
  std::filesystem::create_directory(directory_.file("directory.h5"));
  EXPECT_NO_THROW(try_unsealed(directory_.file("directory.h5"), [] { std::abort(); }));
}

/// Damaged tables without a seal, found by fuzzing: HDF5 1.10.8 crashes over the one in H5HG_read, and does not come to
/// an end with the other.
TEST_F(Trial, OfDamagedTablesThatHdf5DoesNotSurvive) {
  for (const char* name : {"crashes-hdf5.h5", "hangs-hdf5.h5"}) {
    const std::string table = std::string(SIGMASWEEP_TEST_DIRECTORY "/hdf5/") + name;
    const std::string message = samples::message_of<IoError>([&] { read_table(table); });
    EXPECT_NE(message.find("is not a whole table of sigmasweep: "), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace sigmasweep
