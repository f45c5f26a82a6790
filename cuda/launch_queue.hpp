// Launches that wait until they are sent together. Sending costs the host several microseconds a launch and
// the device one between two launches; a small mesh computes no longer than that. So a sequence of launches
// that comes again, as steps do, is sent as one CUDA graph.
//
// Nobody has to say what repeats, or what changes from step to step: each launch is kept as its kernel, its
// sizes and the bytes of its arguments. A sequence with the same kernels and sizes as an earlier one reuses
// that one's graph, in which the launches are replaced whose bytes have changed. Plain C++.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glisson/cuda/launch_sequence.hpp>

namespace glisson::cuda {

class LaunchQueue {
 public:
  /// Shorter sequences are sent one by one: a graph saves nothing there.
  static constexpr std::size_t shortest_graph = 8;
  /// Graphs that are kept; the one not used for the longest time goes first.
  static constexpr std::size_t most_graphs = 32;

  explicit LaunchQueue(const Runtime& runtime) : runtime_(runtime) {}
  ~LaunchQueue();
  LaunchQueue(const LaunchQueue&) = delete;
  LaunchQueue& operator=(const LaunchQueue&) = delete;

  /// What is to be sent; add to it.
  LaunchSequence& waiting() { return waiting_; }
  std::size_t size() const { return waiting_.size(); }
  /// Sends everything to the stream of the current device. Returns the status of the first call that failed;
  /// nothing waits afterwards in any case.
  int send(void* stream);

 private:
  struct Known {
    LaunchSequence sequence;  ///< as its graph holds it; only the shape while there is none
    void* graph = nullptr;
    std::int64_t last_use = 0;
  };
  int send_all(void* stream);
  int send_one_by_one(void* stream);
  int prepare(Known& known);
  Known* find();
  void remember();

  const Runtime& runtime_;
  LaunchSequence waiting_;
  std::vector<Known> known_;
  std::int64_t sent_ = 0;
  bool graphs_ = true;  ///< false after the runtime could not make or change one
};

}  // namespace glisson::cuda
