// plumb campaign-mpi: a campaign over the processes of mpirun. Rank 0 hands out chunks to whoever asks, itself among them; each
// writes what it has done into DIR/chunks, which all of them must see, and rank 0 adds that up.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "corpus/command/progress.hpp"
#include "fuzz/campaign/campaign_arguments.hpp"
#include "fuzz/campaign/out_folder.hpp"
#include "fuzz/campaign/workers.hpp"

namespace plumb {
namespace {

/// What a message says. All of them hold one number.
enum Tag {
  asks = 1,  ///< for a chunk; the number says nothing
  did,       ///< the chunk of that number
  answer,    ///< the number of the chunk to do; 0: it is over
  bye        ///< the last of a rank; the number says nothing
};

void send(std::uint64_t number, int rank, Tag tag) {
  MPI_Send(&number, 1, MPI_UINT64_T, rank, tag, MPI_COMM_WORLD);
}

std::uint64_t receive(int rank, int tag) {
  std::uint64_t number = 0;
  MPI_Recv(&number, 1, MPI_UINT64_T, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return number;
}

/// Rank and tag of a message that is there.
std::optional<std::pair<int, int>> arrived(int rank, int tag) {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(rank, tag, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  return std::pair{status.MPI_SOURCE, status.MPI_TAG};
}

/// From rank 0 to all.
std::uint64_t told_by_first(std::uint64_t number) {
  MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return number;
}

/// MPI from its start to its end. Safe from several threads as long as one at a time calls it.
class Session {
 public:
  Session(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    // A rank that died must not end those that send to it, where mpirun lets them live.
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  }
  /// The others are done, too, or dead. MPI_Finalize waits for all, in OpenMPI 4.1 with --enable-recovery now and then also for a
  /// rank that was killed; mpirun takes an end without it there.
  void end() {
    if (std::exchange(ended_, true)) return;
    if (!outlives_a_rank_) MPI_Finalize();
    if (outlives_a_rank_ && rank > 0) send(0, 0, bye);
    if (outlives_a_rank_ && rank == 0) wait_for_byes();
  }
  [[noreturn]] void leave(int code) {
    end();
    (void)std::fflush(nullptr);
    _exit(code);
  }
  int rank = 0, ranks = 1;

 private:
  /// A while: whoever is alive has only the case to end that it is at.
  void wait_for_byes() const {
    const auto start = std::chrono::steady_clock::now();
    for (int left = ranks - 1; left > 0 && std::chrono::steady_clock::now() - start < std::chrono::seconds(10);) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      while (const auto message = arrived(MPI_ANY_SOURCE, MPI_ANY_TAG)) {
        (void)receive(message->first, message->second);
        left -= message->second == bye ? 1 : 0;
      }
    }
  }

  bool ended_ = false;
  bool outlives_a_rank_ = std::getenv("OMPI_MCA_orte_enable_recovery") != nullptr;
};

/// How rank 0's folder is known again: a file there, and what is in it.
std::uint64_t new_token(const ChunkFolder& chunks) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  const auto token = static_cast<std::uint64_t>(now) ^ static_cast<std::uint64_t>(getpid()) << 48U;
  write_file(chunks.token(), std::to_string(token) + "\n");
  return token;
}

void require_token(const ChunkFolder& chunks, std::uint64_t token, int rank) {
  std::uint64_t found = 0;
  std::ifstream(chunks.token()) >> found;
  if (found != token)
    throw InputFailure(chunks.path().string(), 0, "--out",
                       fmt::format("rank {} does not find there what rank 0 wrote: all must see one folder", rank));
}

/// What each rank does with a chunk that it has judged, or has left because another was faster. The file may be there although
/// nobody said so: who wrote it may have died before it could.
Work work_of(const ChunkFolder& chunks, std::function<std::optional<Shard>()> next,
             std::function<void(const Shard&)> done) {
  const auto take = [&chunks, done = std::move(done)](const Shard& chunk, Results&& part) {
    if (!part.interrupted) chunks.put(chunk, part);
    if (!part.interrupted || chunks.has(chunk)) done(chunk);
  };
  // Rank 0 removes the token when all is done.
  const auto in_vain = [&chunks](const Shard& chunk) {
    return chunks.has(chunk) || !std::filesystem::exists(chunks.token());
  };
  return {std::move(next), take, in_vain};
}

/// Rank 0's side of what is said.
class Leader {
 public:
  Leader(ChunkQueue& queue, int ranks) : queue_(queue), ranks_(ranks) {}
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;
  ~Leader() {
    for (int rank = 1; rank < ranks_; ++rank) send(0, rank, answer);
  }
  /// Who asks when nothing is left gets its answer at the end.
  void serve(std::uint64_t of_chunks) {
    while (const auto message = arrived(MPI_ANY_SOURCE, MPI_ANY_TAG)) {
      const auto [rank, tag] = *message;
      const std::uint64_t number = receive(rank, tag);
      if (tag == did) queue_.done({number, of_chunks});
      if (tag != asks) continue;
      if (const auto chunk = queue_.next()) send(chunk->number, rank, answer);
    }
  }

 private:
  ChunkQueue& queue_;
  int ranks_;
};

/// The side of the others.
class Follower {
 public:
  std::optional<Shard> next(std::uint64_t of_chunks) {
    const std::scoped_lock lock(mutex_);
    if (over_) return std::nullopt;
    send(0, 0, asks);
    const std::uint64_t number = listen(std::chrono::minutes(1));
    return over_ ? std::nullopt : std::optional<Shard>({number, of_chunks});
  }
  void done(const Shard& chunk) {
    const std::scoped_lock lock(mutex_);
    send(chunk.number, 0, did);
  }
  /// For who stops before the end.
  void wait_for_end() {
    const std::scoped_lock lock(mutex_);
    while (!over_) (void)listen(std::chrono::hours(24 * 365));
  }

 private:
  /// Rank 0 answers at once, whatever there is to be judged: if not, it is gone, and with it who adds up. The processor is left to
  /// others meanwhile, which OpenMPI's own way to wait does not do.
  std::uint64_t listen(std::chrono::seconds patience) {
    const auto start = std::chrono::steady_clock::now();
    while (!arrived(0, answer)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (std::chrono::steady_clock::now() - start < patience) continue;
      fmt::print(stderr, "plumb campaign-mpi: rank 0: does not answer; start again with --resume\n");
      MPI_Abort(MPI_COMM_WORLD, exit_unusable);
    }
    const std::uint64_t number = receive(0, answer);
    over_ = number == 0;
    return number;
  }

  std::mutex mutex_;
  bool over_ = false;
};

/// Rank 0 works, too, and has one thread more, which does nothing but answer.
Results lead(const PreparedCampaign& campaign, const ChunkFolder& chunks, int ranks) {
  const double before = chunks.read().seconds;
  const std::vector<Shard> missing = chunks.missing();
  ChunkQueue queue(missing, true);
  Progress progress("chunks", missing.size());
  {
    Leader leader(queue, ranks);
    Workers workers(campaign.sources, campaign.options,
                    work_of(chunks, [&] { return queue.next(); }, [&](const Shard& chunk) { queue.done(chunk); }));
    workers.join([&](std::uint64_t) {
      leader.serve(chunks.of_chunks());
      progress.show(missing.size() - queue.left());
    });
  }
  progress.finish(missing.size() - queue.left());
  Results all = chunks.read();
  all.threads = static_cast<unsigned>(ranks) * campaign.options.threads;
  all.seconds = progress.seconds() + before / all.threads;
  return whole_campaign(std::move(all), campaign.sources, campaign.options, queue.left() == 0);
}

/// `told`: the others know whether there is work for them.
int campaign_of_first(const CampaignArguments& args, Session& session, bool& told) {
  const PreparedCampaign campaign = prepare_campaign(args);
  FolderLock lock = lock_out(args.out);
  if (const auto finished = finished_before(args, campaign)) return report_campaign(args, campaign, *finished);
  const ChunkFolder chunks = open_chunks(args, campaign);
  const std::uint64_t token = new_token(chunks);
  lock.let_in();
  told = true;
  (void)told_by_first(token);
  const Results results = lead(campaign, chunks, session.ranks);
  const int code = report_campaign(args, campaign, results);
  session.end();  // before what the others look into goes
  if (!results.incomplete()) chunks.remove();
  return code;
}

void follow(const CampaignArguments& args, std::uint64_t token, int rank, Follower& follower) {
  const PreparedCampaign campaign = prepare_campaign(args);
  const ChunkFolder chunks = chunks_in(args, campaign);
  require_token(chunks, token, rank);
  const FolderLock lock = FolderLock::beside_first(args.out);
  const std::uint64_t of_chunks = chunks.of_chunks();
  Workers workers(
      campaign.sources, campaign.options,
      work_of(chunks, [&] { return follower.next(of_chunks); }, [&](const Shard& chunk) { follower.done(chunk); }));
  workers.join([](std::uint64_t) {});
}

int campaign_of_other(const CampaignArguments& args, std::uint64_t token, int rank) {
  Follower follower;
  try {
    follow(args, token, rank, follower);
  } catch (...) {
    follower.wait_for_end();
    throw;
  }
  follower.wait_for_end();
  return exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Session session(argc, argv);
  plumb::CampaignArguments args;
  plumb::CommandLine app("plumb campaign over the processes of mpirun: rank 0 hands out its chunks",
                         "plumb campaign-mpi");
  plumb::declare_campaign(app, args, "of each rank; default: one")->required();
  if (session.rank > 0) {
    // What is wrong with the arguments is said once, by rank 0.
    const std::uint64_t token = plumb::told_by_first(0);
    const auto work = [&] { return plumb::campaign_of_other(args, token, session.rank); };
    session.leave(token == 0 ? plumb::exit_done : plumb::run_command(app, argc, argv, work));
  }
  bool told = false;
  const int code = plumb::run_command(app, argc, argv, [&] { return plumb::campaign_of_first(args, session, told); });
  if (!told) (void)plumb::told_by_first(0);
  session.leave(code);
}
