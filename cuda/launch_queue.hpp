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
#include <cstring>
#include <type_traits>
#include <vector>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {

/// Launches in order, with copies of their arguments.
class LaunchSequence {
 public:
  template <class... Arguments>
  void add(const void* kernel, int blocks, int threads, std::size_t shared_bytes,
           const Arguments&... arguments) {
    static_assert((std::is_trivially_copyable_v<Arguments> && ...), "what travels to a device is plain data");
    static_assert(((alignof(Arguments) <= sizeof(Row)) && ...));
    launches_.push_back({kernel, blocks, threads, shared_bytes, first_row_.size(), sizeof...(Arguments)});
    (put(&arguments, sizeof(Arguments)), ...);
  }
  void clear() { launches_.clear(), first_row_.clear(), rows_.clear(); }
  std::size_t size() const { return launches_.size(); }

  /// The same kernels with the same sizes in the same order; their arguments may differ.
  bool like(const LaunchSequence& other) const {
    return launches_ == other.launches_ && first_row_ == other.first_row_;
  }
  /// Whether launch k has the same bytes as in a sequence that is like this one.
  bool same_arguments(std::size_t k, const LaunchSequence& other) const;
  /// As the runtime wants them; valid until the next change.
  std::vector<KernelCall> calls();

 private:
  struct alignas(32) Row {
    std::byte bytes[32];
  };
  struct Launch {
    const void* kernel;
    int blocks, threads;
    std::size_t shared_bytes, first_argument, argument_count;
    bool operator==(const Launch&) const = default;
  };
  void put(const void* argument, std::size_t bytes) {
    first_row_.push_back(rows_.size());
    rows_.resize(rows_.size() + (bytes + sizeof(Row) - 1) / sizeof(Row));
    std::memcpy(rows_.data() + first_row_.back(), argument, bytes);
  }

  std::vector<Launch> launches_;
  std::vector<std::size_t> first_row_;  ///< of each argument
  std::vector<Row> rows_;
  std::vector<void*> pointers_;
};

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

  template <class... Arguments>
  void add(const void* kernel, int blocks, int threads, std::size_t shared_bytes,
           const Arguments&... arguments) {
    waiting_.add(kernel, blocks, threads, shared_bytes, arguments...);
  }
  std::size_t size() const { return waiting_.size(); }
  /// Sends everything to the stream of the current device. Returns the status of the first call that failed;
  /// nothing waits afterwards in any case.
  int send(void* stream);

 private:
  struct Known {
    LaunchSequence sequence;  ///< as its graph, if there is one, holds it
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
