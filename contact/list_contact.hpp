// What all contact of listed nodes with something rigid shares: the list, the work, the report and the
// restart.
#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <vector>

#include <glisson/contact/starting_behind.hpp>
#include <glisson/core/contact_report.hpp>
#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson::contact {

/// Part of a report from one chunk of nodes.
struct ContactPart {
  double depth = 0, largest_depth = 0;
  std::int64_t node_count = 0;  ///< not int: saved as bytes, where padding would be random
  Vec3<double> force;
};
/// Rule: penetration(i, n).depth.
template <class R, class Rule>
struct CollectReport {
  static constexpr int chunk = entries_per_sum;
  Rule now;              ///< body and nodes at t
  const Vec4<R>* force;  ///< just added, times `share` [N]  [count]
  double share;
  const int* nodes;  ///< [count]
  int count;
  ContactPart* parts;  ///< [ceil(count / chunk)]

  using Sum = ContactPart;
  GLISSON_HD int entry_count() const { return count; }
  GLISSON_HD void add(int i, Sum& sum) const {
    deepen(sum.depth, double(now.penetration(i, nodes[i]).depth));
    const Vec4<R> f = force[i];
    sum.force = sum.force + (1 / share) * Vec3<double>{double(f.x), double(f.y), double(f.z)};
    sum.node_count += f.x != R(0) || f.y != R(0) || f.z != R(0);
  }
  GLISSON_HD static void join(Sum& a, const Sum& b) {
    deepen(a.depth, b.depth);
    a.force = a.force + b.force;
    a.node_count += b.node_count;
  }
  GLISSON_HD void leave(int c, const Sum& sum) const {
    ContactPart part = sum;
    part.largest_depth = parts[c].largest_depth;
    deepen(part.largest_depth, part.depth);
    parts[c] = part;
  }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }

 private:
  GLISSON_HD static void deepen(double& deepest, double depth) {
    if (depth > deepest) deepest = depth;
  }
};

template <Backend B, class R>
class ListContact : public ForceProvider<R>, public ContactSource {
 public:
  std::string_view name() const override { return name_; }
  Space space() const override { return B::space; }
  bool needs_prediction() const override { return true; }
  std::vector<int> nodes_to_predict() const override {
    std::vector<int> nodes(static_cast<std::size_t>(count_));
    if (!nodes.empty()) backend_.copy_out(nodes_.get(), nodes.data(), nodes.size());
    return nodes;
  }
  double work() const override { return work_.total(); }
  ContactReport report() const override {
    std::vector<ContactPart> parts(std::size_t(work_.chunk_count()));
    if (!parts.empty()) backend_.copy_out(parts_.get(), parts.data(), parts.size());
    ContactReport sum;
    for (const ContactPart& part : parts) {
      sum.depth = std::max(sum.depth, part.depth);
      sum.largest_depth = std::max(sum.largest_depth, part.largest_depth);
      sum.node_count += static_cast<int>(part.node_count);
      sum.force = sum.force + part.force;
    }
    sum.start_depth = start_.deepest();
    sum.search.candidates = count_;
    sum.search.seconds = seconds_;
    return sum;
  }
  void add_node_forces(std::vector<Vec3<double>>& f) const override {
    std::vector<int> nodes(static_cast<std::size_t>(count_));
    std::vector<Vec4<R>> last(nodes.size());
    if (nodes.empty()) return;
    backend_.copy_out(nodes_.get(), nodes.data(), nodes.size());
    backend_.copy_out(last_.get(), last.data(), last.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Vec3<double>& sum = f[static_cast<std::size_t>(nodes[i])];
      sum = sum + Vec3<double>{double(last[i].x), double(last[i].y), double(last[i].z)};
    }
  }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    out.buffer(backend_, last_, std::size_t(count_))
        .buffer(backend_, parts_, std::size_t(work_.chunk_count()));
    work_.save(out);
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, name_);
    in.buffer(backend_, last_, std::size_t(count_));
    in.buffer(backend_, parts_, std::size_t(work_.chunk_count()));
    work_.load(in);
    in.end();
  }

 protected:
  using Entries = std::map<int, Vec4<R>>;
  /// Rest positions relative to a point, by internal node; w: the node's offset, if there are any.
  static Entries entries_of(const std::vector<int>& nodes, const Vec3<double>& reference, const Mesh& mesh,
                            const Numbering& numbering, const std::vector<double>& offset = {}) {
    return detail::by_node<Vec4<R>>(
        numbering, nodes,
        [&](std::size_t k) {
          Vec4<R> X = detail::narrow<R>(mesh.X[std::size_t(nodes[k])] - reference);
          X.w = offset.empty() ? R(0) : R(offset[std::size_t(nodes[k])]);
          return X;
        },
        [](Vec4<R>&, const Vec4<R>&) {});
  }
  ListContact(B& backend, std::string name, const Entries& entries, StartRelease<B, R> start)
      : backend_(backend),
        name_(std::move(name)),
        count_(static_cast<int>(entries.size())),
        nodes_(detail::upload(backend, detail::keys(entries))),
        X_(detail::upload(backend, values(entries))),
        last_(detail::zeros<Vec4<R>>(backend, entries.size())),
        start_(std::move(start)),
        work_(backend, count_),
        parts_(detail::zeros<ContactPart>(backend, std::size_t(work_.chunk_count()))) {}

  /// A caller that leaves t_next at 0 means t + dt.
  static double end_of(const StepView<R>& step) {
    return step.t_next >= step.t ? step.t_next : step.t + step.dt;
  }
  /// Adds next's forces; counts work and collects the report where the step asks for it.
  template <class Rule>
  void touch(const StepView<R>& step, const Rule& now, const Rule& next) {
    const auto start = std::chrono::steady_clock::now();
    work_.run(step, nodes_.get(), next);
    if (work_.counts(step))
      backend_.for_each(work_.chunk_count(), CollectReport<R, Rule>{now, last_.get(), work_.share(step),
                                                                    nodes_.get(), count_, parts_.get()});
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  int count() const { return count_; }
  AllowedDepth<R> allowed_depth(double t) const { return start_.at(t); }
  const Vec4<R>* X() const { return X_.get(); }
  Vec4<R>* last() const { return last_.get(); }

 private:
  static std::vector<Vec4<R>> values(const Entries& entries) {
    std::vector<Vec4<R>> result;
    for (const auto& [node, value] : entries) result.push_back(value);
    return result;
  }

  B& backend_;
  std::string name_;
  int count_;
  Buffer<int> nodes_;
  Buffer<Vec4<R>> X_, last_;
  StartRelease<B, R> start_;
  ListWork<B, R> work_;
  Buffer<ContactPart> parts_;
  double seconds_ = 0;
};

}  // namespace glisson::contact
