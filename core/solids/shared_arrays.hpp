// Nodes that several patches have, with their slots, in a backend's memory.
#pragma once

#include <glisson/core/kernels/patch_view.hpp>
#include <glisson/core/loads/upload.hpp>
#include <glisson/core/solids/host_patches.hpp>

namespace glisson {

template <Backend B, class R>
class SharedArrays {
 public:
  SharedArrays(B& backend, const SharedNodes& shared)
      : count_(shared.count()),
        nodes_(detail::upload(backend, shared.nodes)),
        begin_(detail::upload(backend, shared.begin)),
        of_node_(detail::upload(backend, shared.shared_of_node)),
        force_(detail::zeros<Vec4<R>>(backend, static_cast<std::size_t>(shared.slot_count()))),
        bytes_((shared.nodes.size() + shared.begin.size() + shared.shared_of_node.size()) * sizeof(int) +
               static_cast<std::size_t>(shared.slot_count()) * sizeof(Vec4<R>)) {}

  void connect(PatchView<R>& view) const {
    view.slot_force = force_.get();
    view.shared_begin = begin_.get();
  }
  SharedForces<R> left() const { return {of_node_.get(), begin_.get(), force_.get()}; }
  void add(B& backend, Vec4<R>* f) const {
    backend.for_each(count_, AddSharedForces<R>{nodes_.get(), left(), f});
  }
  std::size_t bytes() const { return bytes_; }

 private:
  int count_;
  Buffer<int> nodes_, begin_, of_node_;
  Buffer<Vec4<R>> force_;
  std::size_t bytes_;
};

}  // namespace glisson
