#include "mpi/world.hpp"

#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <boost/mpi/exception.hpp>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <type_traits>

#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

/// Open MPI's own settings, in force unless the user chose otherwise; other MPI libraries do not read them.
void guard_open_mpi() {
  const auto unless_set = [](const char* name, const char* value) { setenv(name, value, /*overwrite=*/0); };
  // Before 4.1.7 unlocked data sieving can corrupt HDF5 files written by several ranks.
  unless_set("OMPI_MCA_fs_ufs_lock_algorithm", "3");
  // The default collective write, vulcan, can hang at some numbers of ranks.
  unless_set("OMPI_MCA_fcoll", "dynamic_gen2");
  // For shared file pointers, which nobody uses, opening a file takes a semaphore of this machine that has the file's
  // base name. A rank that is killed there leaves it taken: every later run with a table of that name, anybody's, would
  // wait for ever.
  unless_set("OMPI_MCA_sharedfp", "^sm");
  // A rank that waits in a collective call lets others have the core. It costs a system call per empty poll, nothing
  // while computing, and more ranks than cores (often unknown to MPI: containers, quotas) do not starve each other.
  unless_set("OMPI_MCA_mpi_yield_when_idle", "1");
  // Direct copies between processes need ptrace rights that containers often deny, and then fail with noise. Our
  // messages are small; shared memory is as good.
  unless_set("OMPI_MCA_btl_vader_single_copy_mechanism", "none");
}

void check(int result, const char* routine) {
  if (result != MPI_SUCCESS) throw boost::mpi::exception(routine, result);
}

/// The MPI datatype of one Row: its bytes, so that counts are in rows and doubles stay what they are.
class RowType {
 public:
  RowType() {
    static_assert(std::is_trivially_copyable_v<Row>);
    check(MPI_Type_contiguous(sizeof(Row), MPI_BYTE, &type_), "MPI_Type_contiguous");
    check(MPI_Type_commit(&type_), "MPI_Type_commit");
  }
  ~RowType() { MPI_Type_free(&type_); }
  RowType(const RowType&) = delete;
  RowType& operator=(const RowType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

World::Block block_of(std::uint64_t total, std::uint64_t rank, std::uint64_t size) {
  const std::uint64_t share = total / size, rest = total % size;
  return {rank * share + std::min(rank, rest), share + (rank < rest ? 1 : 0)};
}

}  // namespace

World::World(int& argc, char**& argv) {
  guard_open_mpi();
  impl_ = std::make_unique<Impl>(argc, argv);
  if (boost::mpi::environment::thread_level() < boost::mpi::threading::funneled)
    throw std::runtime_error("this MPI library cannot be used beside threads (MPI_THREAD_FUNNELED)");
}

World::~World() = default;

int World::rank() const { return impl_->communicator.rank(); }
int World::size() const { return impl_->communicator.size(); }
void World::abort(int exit_code) const {
  boost::mpi::environment::abort(exit_code);
  std::abort();  // not reached: it tells the compiler so
}
void* World::native() const { return static_cast<MPI_Comm>(impl_->communicator); }

std::int64_t World::broadcast(std::int64_t number) const {
  check(MPI_Bcast(&number, 1, MPI_INT64_T, 0, impl_->communicator), "MPI_Bcast");
  return number;
}

double World::broadcast(double number) const {
  check(MPI_Bcast(&number, 1, MPI_DOUBLE, 0, impl_->communicator), "MPI_Bcast");
  return number;
}

double World::crowding() const {
  cpu_set_t cpus;  // that any rank of this machine may use; which of them each may use is a matter of binding
  CPU_ZERO(&cpus);
  if (sched_getaffinity(0, sizeof cpus, &cpus) != 0) CPU_ZERO(&cpus);  // more than 1024 processors
  MPI_Comm machine = MPI_COMM_NULL;
  check(MPI_Comm_split_type(impl_->communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine),
        "MPI_Comm_split_type");
  int ranks = 0;
  check(MPI_Comm_size(machine, &ranks), "MPI_Comm_size");
  check(MPI_Allreduce(MPI_IN_PLACE, &cpus, sizeof cpus, MPI_BYTE, MPI_BOR, machine), "MPI_Allreduce");
  check(MPI_Comm_free(&machine), "MPI_Comm_free");
  double crowding = CPU_COUNT(&cpus) == 0 ? 1.0 : std::max(1.0, double(ranks) / CPU_COUNT(&cpus));
  check(MPI_Allreduce(MPI_IN_PLACE, &crowding, 1, MPI_DOUBLE, MPI_MAX, impl_->communicator), "MPI_Allreduce");
  return crowding;
}

std::string World::broadcast(std::string text) const {
  text.resize(static_cast<std::size_t>(broadcast(static_cast<std::int64_t>(text.size()))));
  check(MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, impl_->communicator), "MPI_Bcast");
  return text;
}

// By collectives: these have a communication context of their own. A message of ours would meet a manager that still
// waits for the workers' last words in distribute(), and be taken for one of them.
std::vector<std::string> World::gather(const std::string& bytes) const {
  const auto ranks = static_cast<std::size_t>(size());
  const int mine = static_cast<int>(bytes.size());
  std::vector<int> counts(ranks), places(ranks);
  check(MPI_Gather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, impl_->communicator), "MPI_Gather");
  std::exclusive_scan(counts.begin(), counts.end(), places.begin(), 0);
  std::string together(static_cast<std::size_t>(places.back() + counts.back()), '\0');
  check(MPI_Gatherv(bytes.data(), mine, MPI_CHAR, together.data(), counts.data(), places.data(), MPI_CHAR, 0,
                    impl_->communicator),
        "MPI_Gatherv");
  std::vector<std::string> all;
  for (std::size_t rank = 0; is_manager() && rank < ranks; ++rank)
    all.push_back(together.substr(static_cast<std::size_t>(places[rank]), static_cast<std::size_t>(counts[rank])));
  return all;
}

World::Block World::block(std::uint64_t total) const {
  return block_of(total, static_cast<std::uint64_t>(rank()), static_cast<std::uint64_t>(size()));
}

std::vector<Row> World::scatter(const std::vector<Row>& rows, std::uint64_t total) const {
  const auto ranks = static_cast<std::uint64_t>(size());
  std::vector<int> counts, firsts;  // MPI-3 counts are int: 2^31 rows, far beyond the manager's memory
  for (std::uint64_t rank = 0; rank < ranks; ++rank) {
    const Block block = block_of(total, rank, ranks);
    counts.push_back(static_cast<int>(block.count));
    firsts.push_back(static_cast<int>(block.first));
  }
  const RowType type;
  std::vector<Row> mine(block(total).count);
  check(MPI_Scatterv(rows.data(), counts.data(), firsts.data(), type, mine.data(), static_cast<int>(mine.size()), type,
                     0, impl_->communicator),
        "MPI_Scatterv");
  return mine;
}

}  // namespace sigmasweep
