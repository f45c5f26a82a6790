#include <glisson/cuda/launch_queue.hpp>

#include <algorithm>
#include <utility>

namespace glisson::cuda {

LaunchQueue::~LaunchQueue() {
  for (const Known& known : known_)
    if (known.graph) runtime_.destroy_graph(known.graph);
}

int LaunchQueue::send(void* stream) {
  if (waiting_.size() == 0) return status::done;
  const int code = send_all(stream);
  waiting_.clear();
  return code;
}

int LaunchQueue::send_all(void* stream) {
  if (!graphs_ || waiting_.size() < shortest_graph) return send_one_by_one(stream);
  Known* known = find();
  if (!known) {
    const int code = send_one_by_one(stream);
    remember();
    return code;
  }
  known->last_use = ++sent_;
  if (prepare(*known) != status::done) {
    runtime_.launch_status();  // forgets the error: all works without graphs, only slower
    graphs_ = false;
    return send_one_by_one(stream);
  }
  std::swap(known->sequence, waiting_);
  return runtime_.launch_graph(known->graph, stream);
}

int LaunchQueue::send_one_by_one(void* stream) {
  for (const KernelCall& call : waiting_.calls())
    if (const int code = runtime_.launch(call, stream)) return code;
  return status::done;
}

/// Makes the graph, or lets it hold the arguments of what waits.
int LaunchQueue::prepare(Known& known) {
  const auto& calls = waiting_.calls();
  if (!known.graph) return runtime_.make_graph(&known.graph, calls.data(), static_cast<int>(calls.size()));
  for (std::size_t k = 0; k < calls.size(); ++k) {
    if (waiting_.same_arguments(k, known.sequence)) continue;
    if (const int code = runtime_.replace_in_graph(known.graph, static_cast<int>(k), calls[k])) return code;
  }
  return status::done;
}

LaunchQueue::Known* LaunchQueue::find() {
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& known) { return known.sequence.like(waiting_); });
  return found == known_.end() ? nullptr : &*found;
}

/// A sequence that is seen for the first time may never come again: its graph is made when it does.
void LaunchQueue::remember() {
  if (known_.size() == most_graphs) {
    const auto oldest = std::min_element(
        known_.begin(), known_.end(), [](const Known& a, const Known& b) { return a.last_use < b.last_use; });
    if (oldest->graph) runtime_.destroy_graph(oldest->graph);
    known_.erase(oldest);
  }
  known_.push_back({waiting_.shape(), nullptr, ++sent_});
}

}  // namespace glisson::cuda
