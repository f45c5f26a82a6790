// Copies from a device that share one wait: a list of what is wanted, then where it arrived. Plain C++.
#pragma once

#include <cstddef>
#include <vector>

namespace glisson::cuda {

class JointCopies {
 public:
  struct Copy {
    const void* from;
    std::size_t bytes;
  };
  enum class Phase { none, asks, reads };

  void begin() { copies_.clear(), bytes_ = 0, phase_ = Phase::asks; }
  bool asks() const { return phase_ == Phase::asks; }
  void ask(const void* from, std::size_t bytes) {
    copies_.push_back({from, bytes});
    bytes_ += padded(bytes);
  }

  /// A place for all copies one after the other has room for this [bytes].
  std::size_t bytes() const { return bytes_; }
  /// copy(from, place in words, bytes) for each.
  template <class F>
  void to(unsigned* place, F&& copy) const {
    for (const Copy& c : copies_) {
      copy(static_cast<const unsigned*>(c.from), place, c.bytes);
      place += padded(c.bytes) / sizeof(unsigned);
    }
  }

  /// They are at `place` and will be read in the order in which they were asked for.
  void arrived(const unsigned* place) { place_ = place, next_ = 0, phase_ = Phase::reads; }
  /// Where the next one is; nullptr if this is not the one that was asked for.
  const void* read(const void* from, std::size_t bytes) {
    if (phase_ != Phase::reads || next_ == copies_.size()) return nullptr;
    const Copy& c = copies_[next_];
    if (c.from != from || c.bytes != bytes) return nullptr;
    ++next_;
    const void* here = place_;
    place_ += padded(bytes) / sizeof(unsigned);
    return here;
  }
  void end() { phase_ = Phase::none; }

 private:
  static std::size_t padded(std::size_t bytes) { return (bytes + 15) / 16 * 16; }

  std::vector<Copy> copies_;
  std::size_t bytes_ = 0, next_ = 0;
  const unsigned* place_ = nullptr;
  Phase phase_ = Phase::none;
};

}  // namespace glisson::cuda
