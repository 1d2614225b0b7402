#include "mpi/world.hpp"

#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "mpi/broadcast.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

/// Started alone, the program needs no daemon beside it, which Open MPI would start and wait for at the end. Without
/// the daemon all such processes of a machine would have the same directory for temporary files, which the first that
/// ends takes away from the others; so they get none.
void need_no_daemon() {
  const bool is_launched = std::getenv("PMIX_NAMESPACE") != nullptr || std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
  if (is_launched || std::getenv("OMPI_MCA_ess_singleton_isolated") != nullptr) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", /*overwrite=*/1);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", /*overwrite=*/0);
}

/// Sets Open MPI's parameters unless the user chose otherwise. Other MPI libraries do not read them.
void guard_open_mpi() {
  const auto unless_set = [](const char* name, const char* value) { setenv(name, value, /*overwrite=*/0); };
  // Before 4.1.7 unlocked data sieving can corrupt HDF5 files written by several ranks.
  unless_set("OMPI_MCA_fs_ufs_lock_algorithm", "3");
  // The default collective write, vulcan, can hang at some numbers of ranks.
  unless_set("OMPI_MCA_fcoll", "dynamic_gen2");
  // For shared file pointers, which nobody uses, opening a file takes a semaphore of this machine that has the file's
  // base name. A rank that is killed there leaves the semaphore taken: every later run with a table of that name,
  // anybody's, would wait for ever.
  unless_set("OMPI_MCA_sharedfp", "^sm");
  // A rank that waits in a collective call lets others have the core. It costs a system call per empty poll, nothing
  // while computing, and more ranks than cores (often unknown to MPI: containers, quotas) do not starve each other.
  unless_set("OMPI_MCA_mpi_yield_when_idle", "1");
  // Direct copies between processes need ptrace rights that containers often deny, and then fail with noise. Our
  // messages are small; shared memory is as good.
  unless_set("OMPI_MCA_btl_vader_single_copy_mechanism", "none");
}

/// The MPI datatype of one item of `size` bytes, so that counts are in items and doubles stay what they are.
class ItemType {
 public:
  explicit ItemType(std::size_t size) {
    check_mpi(MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type_), "cannot make a datatype");
    check_mpi(MPI_Type_commit(&type_), "cannot make a datatype");
  }
  ~ItemType() { MPI_Type_free(&type_); }
  ItemType(const ItemType&) = delete;
  ItemType& operator=(const ItemType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

}  // namespace

World::World(int& argc, char**& argv) {
  guard_open_mpi();
  need_no_daemon();
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
MPI_Comm World::comm() const { return impl_->communicator; }

std::string World::broadcast(std::string text) const { return sigmasweep::broadcast(comm(), std::move(text)); }
std::int64_t World::broadcast(std::int64_t number) const { return sigmasweep::broadcast(comm(), number); }
double World::broadcast(double number) const { return sigmasweep::broadcast(comm(), number); }

double World::crowding() const {
  constexpr const char* action = "cannot count the ranks of a machine";
  cpu_set_t cpus;  // the processors that any rank of this machine may use, however each rank is bound
  CPU_ZERO(&cpus);
  if (sched_getaffinity(0, sizeof cpus, &cpus) != 0) CPU_ZERO(&cpus);  // more than 1024 processors
  MPI_Comm machine = MPI_COMM_NULL;
  check_mpi(MPI_Comm_split_type(comm(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine), action);
  int ranks = 0;
  check_mpi(MPI_Comm_size(machine, &ranks), action);
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &cpus, sizeof cpus, MPI_BYTE, MPI_BOR, machine), action);
  check_mpi(MPI_Comm_free(&machine), action);
  double crowding = CPU_COUNT(&cpus) == 0 ? 1.0 : std::max(1.0, double(ranks) / CPU_COUNT(&cpus));
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &crowding, 1, MPI_DOUBLE, MPI_MAX, comm()), action);
  return crowding;
}

World::Block World::block(std::uint64_t total) const {
  return Blocks{total, static_cast<std::uint64_t>(size())}.of(static_cast<std::uint64_t>(rank()));
}

void World::scatter_bytes(const void* items, void* mine, std::size_t item_size, std::uint64_t total) const {
  const auto ranks = static_cast<std::uint64_t>(size());
  std::vector<int> counts, firsts;
  for (std::uint64_t rank = 0; rank < ranks; ++rank) {
    const Block block = Blocks{total, ranks}.of(rank);
    counts.push_back(static_cast<int>(block.count));
    firsts.push_back(static_cast<int>(block.first));
  }
  const ItemType type(item_size);
  check_mpi(MPI_Scatterv(items, counts.data(), firsts.data(), type, mine, static_cast<int>(block(total).count), type, 0,
                         comm()),
            "cannot deal out items");
}

}  // namespace sigmasweep
