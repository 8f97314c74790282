// The threads that judge: each takes a chunk after the other, from wherever they are handed out.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "fuzz/campaign/campaign.hpp"

namespace plumb {

/// All of it is called from several threads at once.
struct Work {
  std::function<std::optional<Shard>()> next;         ///< the next chunk, none when it is over
  std::function<void(const Shard&, Results&&)> take;  ///< what was found in it, `interrupted` where that is not all
  std::function<bool(const Shard&)> in_vain;          ///< another has done it
};

class Workers {
 public:
  /// options.threads of them, started at once. What is referred to must outlive them.
  Workers(const std::vector<Source>& sources, const CampaignOptions& options, Work work);
  /// Some of them may still ask for chunks.
  [[nodiscard]] bool busy() const { return busy_.load() > 0; }
  /// Cases judged so far.
  [[nodiscard]] std::uint64_t done() const { return done_.load(); }
  /// Waits for them, calling `meanwhile` with done() now and then; throws what one of them threw, after which all stop.
  void join(const std::function<void(std::uint64_t)>& meanwhile);

 private:
  void run();
  void work_through();
  const std::vector<Source>& sources_;
  const CampaignOptions& options_;
  Work work_;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<unsigned> busy_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;
};

}  // namespace plumb
