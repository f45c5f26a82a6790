// Launches as data: kernel, sizes and the bytes of the arguments, so that they can wait, be compared, and be
// merged with those of other members of an ensemble. Plain C++.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {

/// The twin of a kernel that does one launch of several members at once: blockIdx.y is the member, and in the
/// place of the last argument, a body, it takes an array with one body per member.
struct SeveralKernel {
  const void* kernel = nullptr;
  std::size_t body_bytes = 0;
  int capacity = 0;  ///< members that fit into the parameters of one launch
  /// Of all its parameters, with room for those in front of the bodies.
  std::size_t parameter_bytes() const { return room_in_front + std::size_t(capacity) * body_bytes; }
  static constexpr std::size_t room_in_front = 64;
};

/// A kernel, and its twin if it has one.
struct KernelPair {
  const void* one;
  const SeveralKernel* several = nullptr;
  // NOLINTNEXTLINE(google-explicit-constructor): a kernel without a twin is the usual argument
  KernelPair(const void* kernel, const SeveralKernel* twin = nullptr) : one(kernel), several(twin) {}
};

class LaunchSequence;
/// Launch k of a sequence.
struct LaunchPlace {
  const LaunchSequence* sequence;
  std::size_t launch;
};

/// Launches in order, with copies of their arguments.
class LaunchSequence {
 public:
  template <class... Arguments>
  void add(const KernelPair& kernel, int blocks, int threads, std::size_t shared_bytes,
           const Arguments&... arguments) {
    static_assert((std::is_trivially_copyable_v<Arguments> && ...), "what travels to a device is plain data");
    static_assert(((alignof(Arguments) <= sizeof(Row)) && ...));
    launches_.push_back({kernel.one, kernel.several, blocks, threads, 1, shared_bytes, first_row_.size(),
                         sizeof...(Arguments)});
    (put(&arguments, sizeof(Arguments)), ...);
  }
  /// The next launch belongs to another step of the simulation.
  void end_step() {
    if (size() > (step_ends_.empty() ? 0 : step_ends_.back())) step_ends_.push_back(size());
  }
  void clear() { launches_.clear(), first_row_.clear(), rows_.clear(), step_ends_.clear(); }
  std::size_t size() const { return launches_.size(); }

  /// Parts between two ends of a step, and what comes after the last one.
  std::size_t part_count() const {
    return step_ends_.size() + (step_ends_.empty() ? size() > 0 : step_ends_.back() < size());
  }
  struct Part {
    std::size_t first, last;
  };
  Part part(std::size_t p) const {
    return {p == 0 ? 0 : step_ends_[p - 1], p < step_ends_.size() ? step_ends_[p] : size()};
  }

  /// The same kernels with the same sizes in the same order; their arguments may differ.
  bool like(const LaunchSequence& other) const {
    return launches_ == other.launches_ && first_row_ == other.first_row_;
  }
  /// Whether launch k has the same bytes as in a sequence that is like this one.
  bool same_arguments(std::size_t k, const LaunchSequence& other) const;
  /// What like() compares, without the arguments.
  LaunchSequence shape() const;
  /// As the runtime wants them; valid until the next change.
  const std::vector<KernelCall>& calls();

  /// Whether launch k and that of another sequence differ in the bytes of their last argument at most.
  bool merges(std::size_t k, const LaunchPlace& other) const;
  /// Members of one launch if launch k is merged with others, 1 if it cannot be.
  int capacity(std::size_t k, std::size_t most_parameter_bytes) const;
  /// One launch for all of `same`, which merge with each other and are not more than fit.
  void add_merged(std::span<const LaunchPlace> same);

 private:
  struct alignas(32) Row {
    std::byte bytes[32];
  };
  struct Launch {
    const void* kernel;
    const SeveralKernel* several;
    int blocks, threads, members;
    std::size_t shared_bytes, first_argument, argument_count;
    bool operator==(const Launch&) const = default;
  };
  std::size_t row_of(std::size_t argument) const {
    return argument < first_row_.size() ? first_row_[argument] : rows_.size();
  }
  std::byte* make_room(std::size_t bytes) {
    first_row_.push_back(rows_.size());
    rows_.resize(rows_.size() + (bytes + sizeof(Row) - 1) / sizeof(Row));
    return rows_[first_row_.back()].bytes;
  }
  void put(const void* argument, std::size_t bytes) { std::memcpy(make_room(bytes), argument, bytes); }

  std::vector<Launch> launches_;
  std::vector<std::size_t> first_row_;  ///< of each argument
  std::vector<Row> rows_;
  std::vector<std::size_t> step_ends_;  ///< launches before each
  std::vector<void*> pointers_;
  std::vector<KernelCall> calls_;
};

/// Puts the launches of all members into one sequence, members in their order. Steps are aligned: of the
/// p-th parts, those whose launches all merge become one, whatever the other parts look like. Each member's
/// own launches keep their order; between members there is none to keep, because they share no memory that
/// anyone writes.
void merge(std::span<const LaunchSequence* const> members, std::size_t most_parameter_bytes,
           LaunchSequence& to);

}  // namespace glisson::cuda
