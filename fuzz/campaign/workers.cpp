#include "fuzz/campaign/workers.hpp"

#include <algorithm>
#include <chrono>

namespace plumb {

Workers::Workers(const std::vector<Source>& sources, const CampaignOptions& options, Work work)
    : sources_(sources), options_(options), work_(std::move(work)), busy_(std::max(1u, options.threads)) {
  for (unsigned i = busy_.load(); i > 0; --i) threads_.emplace_back([this] { run(); });
}

void Workers::run() {
  try {
    work_through();
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    failed_ = true;
  }
  --busy_;
}

void Workers::work_through() {
  while (!failed_ && !is_over(options_)) {
    const std::optional<Shard> chunk = work_.next();
    if (!chunk) return;
    const auto in_vain = [&] { return failed_ || work_.in_vain(*chunk); };
    work_.take(*chunk, judge_chunk(sources_, options_, *chunk, in_vain, done_));
  }
}

void Workers::join(const std::function<void(std::uint64_t)>& meanwhile) {
  while (busy()) {
    meanwhile(done());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  threads_.clear();
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace plumb
